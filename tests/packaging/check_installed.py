#!/usr/bin/env python3
"""Installs a build to a folder and looks at what came there: check_installed.py CMAKE BUILD SOURCES VERSION

Programs run from there and say their version; what a model is exported to is the same as from the build; each file for
the desktop is what its checker wants; models are told from plain texts. Needs a display for the picture of a model."""
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

FLATFAB = "HeaderParameters 1\nPlaneSketch 1\nP 0 0 0\n"
KINDS = {"model.fff": ('{\n  "format": "FlatFitFab",\n', "application/x-flatfitfab"),
         "beast.txt": (FLATFAB, "x-model/x-flatfab"),
         "letter.txt": ("Dear all,\nHeaderParameters 1 is what FlatFab writes first.\n", "text/plain"),
         "list.txt": ('{"a": 1}\n', "text/plain"),
         "nothing.txt": ("", "text/plain")}


def run(*command, **more):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    if done.returncode:
        sys.exit(f"{shlex.join(map(str, command))}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: found {found!r}, expected {wanted!r}")


def check_programs(prefix, build, sources, version, environment):
    run_there = dict(env=environment, cwd=prefix)
    cli, window = prefix / "bin/flatfitfab-cli", prefix / "bin/flatfitfab"
    expect("flatfitfab-cli --version", run(cli, "--version", **run_there).strip(), f"FlatFitFab {version}")
    expect("flatfitfab --version", run(window, "--version", **run_there).strip(), f"flatfitfab {version}")
    sample = sources / "resources/samples/bridge.fff"
    for program, out in ((cli, prefix / "there.svg"), (build / "app/flatfitfab-cli", prefix / "here.svg")):
        run(program, "export", sample, "-o", out, **run_there)
    expect("export", (prefix / "there.svg").read_bytes(), (prefix / "here.svg").read_bytes())
    # As a file manager asks for the picture of a model.
    entry = (prefix / "share/thumbnailers/flatfitfab.thumbnailer").read_text()
    line = entry.partition("\nExec=")[2].partition("\n")[0]
    for mark, value in (("%i", shlex.quote(str(sample))), ("%o", shlex.quote(str(prefix / "there.png"))), ("%s", "128")):
        line = line.replace(mark, value)
    path = f"{prefix / 'bin'}:{environment['PATH']}"
    run(*shlex.split(line), env=dict(environment, PATH=path), cwd=prefix)
    expect("picture", (prefix / "there.png").read_bytes()[16:24], b"\0\0\0\x80\0\0\0\x80")


def check_desktop(prefix, version, environment):
    share, name = prefix / "share", "org.flatfitfab.FlatFitFab"
    said = run("desktop-file-validate", share / f"applications/{name}.desktop")
    # The one thing that it finds strange: it has to come after text/plain (flatfitfab.mime.xml).
    strange = [line for line in said.splitlines() if "x-model" not in line]
    expect("desktop-file-validate", strange, [])
    run("appstreamcli", "validate", "--no-net", share / f"metainfo/{name}.metainfo.xml")
    metainfo = (share / f"metainfo/{name}.metainfo.xml").read_text()
    expect("metainfo names the version", f'<release version="{version}"' in metainfo, True)
    run("xmllint", "--noout", share / "mime/packages/flatfitfab.xml", share / f"icons/hicolor/scalable/apps/{name}.svg")
    for page in sorted((share / "man/man1").iterdir()):
        said = run("man", "--warnings", "-E", "UTF-8", "-Tutf8", "-Z", "-l", page, stdin=subprocess.DEVNULL,
                   env=dict(environment, LC_ALL="C.UTF-8", MANWIDTH="80"))
        expect(f"warnings of {page.name}", [line for line in said.splitlines() if "warning" in line.lower()], [])
        expect(f"{page.name} names the version", version in said.replace("\\-", "-"), True)
    run("bash", "-n", share / "bash-completion/completions/flatfitfab-cli")


def check_lessons(prefix, sources):
    there = {file.name: file.read_bytes() for file in (prefix / "share/doc/flatfitfab/lessons").iterdir()}
    expect("lessons", there, {file.name: file.read_bytes() for file in (sources / "resources/lessons").glob("*.fff")})


def check_kinds(prefix, environment):
    subprocess.run(["update-mime-database", prefix / "share/mime"], capture_output=True, check=True)
    for name, (text, kind) in KINDS.items():
        (prefix / name).write_text(text)
        said = run("gio", "info", "-a", "standard::content-type", prefix / name,
                   env=dict(environment, XDG_DATA_HOME=str(prefix / "share")))
        expect(f"kind of {name}", said.split()[-1], kind)


def main(cmake, build, sources, version):
    build, sources = pathlib.Path(build), pathlib.Path(sources)
    with tempfile.TemporaryDirectory(prefix="flatfitfab installed ") as folder:
        prefix = pathlib.Path(folder)
        run(cmake, "--install", build, "--prefix", prefix)
        home = {name: folder for name in ("HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME")}
        environment = dict(os.environ, LC_ALL="C.UTF-8", LANGUAGE="", **home)
        check_programs(prefix, build, sources, version, environment)
        check_desktop(prefix, version, environment)
        check_lessons(prefix, sources)
        check_kinds(prefix, environment)
    print("installs, runs and is known to the system")


if __name__ == "__main__":
    main(*sys.argv[1:])
