#!/usr/bin/env python3
"""The schema of .fff says what the reader does. If this fails, other programs write files by the
schema that do not open here, or turn files away that do.

    check_schema.py SCHEMA VERDICTS FILE...      VERDICTS: the program made of fff_verdicts.cpp
"""
import copy
import json
import subprocess
import sys
import zipfile

import jsonschema

# What a schema cannot say: the reader may refuse these where the schema does not. Every other
# refusal of a single value (BadValue) has to be the schema's, too.
BEYOND_SCHEMA = ("an id below nextId", "a parent that does not descend from its child",
                 "a direction of length 1", "something wanted of two sections, pairs ascending",
                 "something other than made, each instance once", "more than minus the thickness",
                 "nothing: only meshes are pulled", "nothing: a mesh lies on no section")
VARIED = ("data/fff/two_sections.fff", "data/fff/annotated.fff", "data/fff/with_blobs.fff", "data/fff/with_templates.fff",
          "seeds/fff/generated.fff", "seeds/fff/joints.fff", "seeds/fff/operations.fff")
OTHER_VALUES = [None, True, "text", "", -1, 0, 0.5, 1, 2.0, 7, 1e7, -1e7, 2**53 + 2, [], [1], {}]


def text_of(name):
    """Of one that holds other files the document among them."""
    if zipfile.is_zipfile(name):
        with zipfile.ZipFile(name) as archive:
            return archive.read("document.json")
    with open(name, "rb") as file:
        return file.read()


def places(value, path=()):
    """Paths of all values; of long lists only the first and last items."""
    yield path
    if isinstance(value, dict):
        for key in value:
            yield from places(value[key], path + (key,))
    elif isinstance(value, list):
        for index in sorted({0, len(value) - 1} & set(range(len(value)))):
            yield from places(value[index], path + (index,))


def changed(document, path, change):
    result = copy.deepcopy(document)
    place = result
    for key in path[:-1]:
        place = place[key]
    change(place, path[-1])
    return result


def variants(document):
    """(what was done, document) with one value changed each."""
    for path in places(document):
        if not path:
            continue
        name = "$" + "".join(f"[{k}]" if isinstance(k, int) else f".{k}" for k in path)
        yield f"{name} taken out", changed(document, path, lambda p, k: p.pop(k))
        for value in OTHER_VALUES:
            yield (f"{name} = {json.dumps(value)}",
                   changed(document, path, lambda p, k: p.__setitem__(k, copy.deepcopy(value))))


def main():
    schema_file, verdicts, *files = sys.argv[1:]
    with open(schema_file, encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    failures = 0

    documents = []
    for name in files:
        documents.append(json.loads(text_of(name)))
        for error in validator.iter_errors(documents[-1]):
            failures += 1
            print(f"{name}: {error.json_path}: {error.message}")

    # Models that are drawn differ in their numbers only: these have all that there is.
    cases = [case for name, document in zip(files, documents) if name.endswith(VARIED)
             for case in variants(document)]
    lines = "".join(json.dumps(document) + "\n" for _, document in cases)
    answers = subprocess.run([verdicts], input=lines, capture_output=True, text=True, check=True)
    verdict_lines = answers.stdout.splitlines()
    if len(verdict_lines) != len(cases) or len(cases) < 1000:
        print(f"{len(verdict_lines)} verdicts on {len(cases)} documents")
        return 1
    for (what, document), verdict in zip(cases, verdict_lines):
        error = next(validator.iter_errors(document), None)
        kind, _, expected = (verdict.split("\t") + ["", ""])[:3]
        if verdict == "ok" and error:
            failures += 1
            print(f"{what}: the reader takes it, the schema does not: {error.message}")
        elif kind == "value" and not error and expected not in BEYOND_SCHEMA:
            failures += 1
            print(f"{what}: the schema takes it, the reader does not: {verdict}")
    print(f"{len(files)} files, {len(cases)} changed documents, {failures} disagreements")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
