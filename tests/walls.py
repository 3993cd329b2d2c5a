#!/usr/bin/env python3
"""Whether each room uses only those above it: walls.py SOURCES

The order is that of core/README.md and ui/README.md. A room that is in none of these lists is a fault, too."""
import pathlib
import re
import sys

CORE = ["base", "values", "geometry", "nesting", "model", "templates", "assembly", "operations", "physics", "fabrication", "skin", "analysis",
        "stroke", "interaction", "io", "session"]
UI = ["view", "settings", "base", "bench", "actions", "properties", "cards", "docks", "dialogs", "sheets", "files", "start", "steps", "tour", "help",
      "window"]
# In what order whole folders stand; a file of one of these may use all of those before.
HOUSES = ["core", "ui", "app"]
INCLUDE = re.compile(r'^\s*#\s*include\s+"((?:core|ui|app)/[^"]+)"', re.M)


def rank(path):
    """Of a file, by its folders; None for one that is in no room."""
    house, *rest = path.split("/")
    rooms = {"core": CORE, "ui": UI}.get(house)
    if rooms is None:
        return (HOUSES.index(house), 0)
    if len(rest) < 2 or rest[0] not in rooms:
        return None
    return (HOUSES.index(house), rooms.index(rest[0]))


def main(sources):
    faults = []
    for file in sorted(p for house in HOUSES for p in (sources / house).rglob("*") if p.suffix in (".h", ".cpp")):
        name = file.relative_to(sources).as_posix()
        own = rank(name)
        if own is None:
            faults.append(f"{name} is in no room")
            continue
        for used in INCLUDE.findall(file.read_text()):
            of = rank(used)
            if of is None or of > own:
                faults.append(f"{name} uses {used}, which is below it")
    print("\n".join(faults) if faults else "every room uses only those above it")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
