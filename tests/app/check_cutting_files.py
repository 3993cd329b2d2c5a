#!/usr/bin/env python3
"""Cutting files as other programs read them: check_cutting_files.py FLATFITFAB_CLI MODEL…

Each model is exported in every format, and read by what did not write it: Inkscape (where each part is, how large) and
rsvg (what is drawn where), ezdxf (its audit, lengths, extents), poppler (page sizes, what is drawn on them, that tiles
have the same where they overlap), admesh (closed solids), a XML parser and a G-code interpreter of this file. Lengths
of cuts and boxes are those of the SVG, whose curves are walked along in small chords here.
"""
import csv
import itertools
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile
from collections import Counter

import ezdxf

CHORDS = 80  # of a curve
CURVE_ERROR = 0.0031  # mm, of arcs
LENGTH_ERROR = 2e-4  # share
ENGRAVED, SCORED, CUT = "engraved", "scored", "cut"
SVG_COLOURS = {"#0000ff": ENGRAVED, "#000000": ENGRAVED, "#00ff00": SCORED, "#ff0000": CUT}
SVG = "{http://www.w3.org/2000/svg}"
faults = []


def check(holds, text):
    if not holds:
        faults.append(text)
    return holds


def along(p0, p1, p2, p3):
    for i in range(CHORDS + 1):
        t = i / CHORDS
        s = 1 - t
        yield tuple(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d for a, b, c, d in zip(p0, p1, p2, p3))


def length(points):
    return sum(math.dist(a, b) for a, b in itertools.pairwise(points))


class Drawing:
    """Lines by what is done along them, as points."""

    def __init__(self):
        self.lines = {ENGRAVED: [], SCORED: [], CUT: []}

    def add(self, kind, points):
        self.lines[kind].append(list(points))

    def length(self, kind):
        return sum(length(line) for line in self.lines[kind])

    def boxes(self):
        """Width and height of each cut, by which parts are found again."""
        def box(line):
            xs, ys = zip(*line)
            return (max(xs) - min(xs), max(ys) - min(ys))
        return [box(line) for line in self.lines[CUT]]


def read_svg(path):
    return read_paths(ElementTree.parse(path).iter(f"{SVG}path"))


def read_paths(elements):
    drawing = Drawing()
    for element in elements:
        kind = SVG_COLOURS[element.get("stroke")]
        line, words = [], re.findall(r"[A-Z]|-?[0-9.]+", element.get("d"))
        i = 0
        while i < len(words):
            command = words[i]
            count = {"M": 2, "L": 2, "C": 6, "Z": 0}[command]
            numbers = [float(word) for word in words[i + 1:i + 1 + count]]
            points = list(zip(numbers[::2], numbers[1::2]))
            if command == "M":
                if line:
                    drawing.add(kind, line)
                line = points
            elif command == "C":
                line += list(along(line[-1], *points))[1:]
            elif command == "Z":
                line.append(line[0])
            else:
                line += points
            i += 1 + count
        drawing.add(kind, line)
    return drawing


def arc_points(start, end, bulge):
    if bulge == 0:
        return [start, end]
    sweep = 4 * math.atan(bulge)
    away = (1 / bulge - bulge) / 4
    chord = (end[0] - start[0], end[1] - start[1])
    centre = ((start[0] + end[0]) / 2 - away * chord[1], (start[1] + end[1]) / 2 + away * chord[0])
    radius, first = math.dist(start, centre), math.atan2(start[1] - centre[1], start[0] - centre[0])
    return [start] + [(centre[0] + radius * math.cos(first + sweep * i / CHORDS),
                       centre[1] + radius * math.sin(first + sweep * i / CHORDS)) for i in range(1, CHORDS)] + [end]


def read_dxf(path, version):
    document = ezdxf.readfile(path)
    auditor = document.audit()
    check(not auditor.errors and not auditor.fixes, f"{path}: {[e.message for e in auditor.errors + auditor.fixes][:3]}")
    check(document.dxfversion == version, f"{path}: version {document.dxfversion}")
    check(document.header["$INSUNITS"] == 4 and document.header["$MEASUREMENT"] == 1, f"{path}: units")
    for layer in ("CUT", "CUT_INNER", "SCORE", "ENGRAVE", "GUIDE"):
        check(layer in document.layers, f"{path}: no layer {layer}")
    drawing, seen, low, high = Drawing(), set(), [math.inf] * 2, [-math.inf] * 2
    for entity in document.modelspace():
        if not check(entity.dxftype() in ("LWPOLYLINE", "POLYLINE"), f"{path}: a {entity.dxftype()}"):
            continue
        if entity.dxftype() == "LWPOLYLINE":
            vertices, closed = [((x, y), b) for x, y, b in entity.get_points("xyb")], entity.closed
        else:
            vertices = [((v.dxf.location.x, v.dxf.location.y), v.dxf.get("bulge", 0)) for v in entity.vertices]
            closed = entity.is_closed
        kind = {"CUT": CUT, "CUT_INNER": CUT, "SCORE": SCORED, "ENGRAVE": ENGRAVED}.get(entity.dxf.layer)
        check(closed or kind in (ENGRAVED, SCORED), f"{path}: an open cut")
        points = []
        for (start, bulge), (end, _) in itertools.pairwise(vertices + vertices[:1] * closed):
            check(math.dist(start, end) > 0, f"{path}: an edge without length")
            step = arc_points(start, end, bulge)
            points += step[1:] if points else step
        for axis in (0, 1):
            low[axis] = min(low[axis], *(p[axis] for p in points))
            high[axis] = max(high[axis], *(p[axis] for p in points))
        key = (entity.dxf.layer, frozenset((round(p[0], 5), round(p[1], 5)) for p, _ in vertices), len(vertices))
        check(key not in seen, f"{path}: a line is there twice")
        seen.add(key)
        if kind:
            drawing.add(kind, points)
    for name, corner in (("$EXTMIN", low), ("$EXTMAX", high)):
        check(math.dist(document.header[name][:2], corner) < 0.01, f"{path}: {name} {document.header[name]}, not {corner}")
    return drawing


def read_lbrn2(path):
    root, drawing = ElementTree.parse(path).getroot(), Drawing()
    kinds = {}
    for setting in root.iter("CutSetting"):
        name = setting.find("name").get("Value")
        kinds[setting.find("index").get("Value")] = (ENGRAVED if name in ("Engrave", "Numbers")
                                                     else SCORED if name == "Score" else CUT)
    number = r"-?[0-9.]+(?:e-?[0-9]+)?"
    for shape in root.iter("Shape"):
        vertices = []
        for text in re.split("V", shape.find("VertList").text)[1:]:
            x, y = map(float, re.match(f"({number}) ({number})", text).groups())
            controls = {}
            for key in ("c0", "c1"):
                found = re.search(f"{key}x({number}){key}y({number})", text)
                controls[key] = tuple(map(float, found.groups())) if found else None
            vertices.append(((x, y), controls))
        points = []
        for bend, first, second in re.findall(r"([LB])(\d+) (\d+)", shape.find("PrimList").text):
            (a, leaving), (b, arriving) = vertices[int(first)], vertices[int(second)]
            step = [a, b] if bend == "L" else list(along(a, leaving["c0"] or a, arriving["c1"] or b, b))
            check(not points or points[-1] == a, f"{path}: a gap")
            points += step[1:] if points else step
        kind = kinds.get(shape.get("CutIndex"))
        if kind:
            check(kind != CUT or points[0] == points[-1], f"{path}: an open cut")
            drawing.add(kind, points)
    return drawing


def read_gcode(path):
    """By the power: what is burnt with all of it is cut."""
    drawing, at, line, power, ranks = Drawing(), (0.0, 0.0), [], 0.0, []
    for text in open(path, encoding="ascii"):
        check(len(text) < 128, f"{path}: a line of {len(text)}")
        words = dict((w[0], float(w[1:])) for w in text.split(";")[0].split())
        if "S" in words:
            power = words["S"]
        if words.get("M") == 4:
            line = [at]
        elif words.get("M") == 5 and len(line) > 1:
            drawing.add(CUT if power > 500 else ENGRAVED, line)
            ranks.append(power > 500)
            line = []
        elif words.get("M") == 0:
            ranks = []
        if words.get("G") not in (0, 1, 2, 3):
            continue
        end = (words.get("X", at[0]), words.get("Y", at[1]))
        if words["G"] == 0:
            check(not line or len(line) == 1, f"{path}: moves with the laser on")
            line = []
        elif words["G"] == 1:
            line.append(end)
        else:
            centre = (at[0] + words["I"], at[1] + words["J"])
            radius = math.dist(at, centre)
            check(abs(radius - math.dist(end, centre)) < 0.005, f"{path}: an arc that GRBL refuses")
            first = math.atan2(at[1] - centre[1], at[0] - centre[0])
            last = math.atan2(end[1] - centre[1], end[0] - centre[0])
            turn = (last - first) % math.tau if words["G"] == 3 else -((first - last) % math.tau)
            line += [(centre[0] + radius * math.cos(first + turn * i / CHORDS),
                      centre[1] + radius * math.sin(first + turn * i / CHORDS)) for i in range(1, CHORDS)] + [end]
        at = end
        check(ranks == sorted(ranks), f"{path}: engraves after it cut")
    return drawing


def compare(name, drawing, svg, kinds):
    for kind in kinds:
        wanted, found = svg.length(kind), drawing.length(kind)
        check(abs(found - wanted) <= LENGTH_ERROR * wanted + 1e-3, f"{name}: {found:.4f} mm {kind}, not {wanted:.4f}")
        check(len(drawing.lines[kind]) == len(svg.lines[kind]),
              f"{name}: {len(drawing.lines[kind])} lines {kind}, not {len(svg.lines[kind])}")
    left = svg.boxes()
    for box in drawing.boxes():
        nearest = min(left, key=lambda other: math.dist(box, other), default=(0, 0))
        if check(math.dist(box, nearest) < 4 * CURVE_ERROR, f"{name}: a part of {box}, which none is like"):
            left.remove(nearest)


def check_pdf(path, sizes, most=0.02):
    text = subprocess.run(["pdfinfo", "-l", "9999", path], capture_output=True, text=True, check=True).stdout
    found = [tuple(map(float, m)) for m in re.findall(r"size:\s+([0-9.]+) x ([0-9.]+) pts", text)]
    for (width, height), size in itertools.zip_longest(found, sizes, fillvalue=(0, 0)):
        wanted = [mm * 72 / 25.4 for mm in size]
        check(math.dist((width, height), wanted) < most, f"{path}: a page of {width} x {height} pt, not {wanted}")


def dark_columns(path, page, dpi):
    """x of the first and the last dark pixel, and the picture's lines."""
    picture = subprocess.run(["pdftoppm", "-r", str(dpi), "-f", str(page), "-l", str(page), "-gray", path],
                             capture_output=True, check=True).stdout
    width, height = map(int, picture.split(b"\n", 3)[1].split())
    data = picture[-width * height:]
    return width, height, data


def check_measuring_box(path, page):
    """The box in the last page's middle is 100 mm long."""
    dpi = 254
    width, height, data = dark_columns(path, page, dpi)
    row = data[height // 2 * width:(height // 2 + 1) * width]
    dark = [x for x, value in enumerate(row) if value < 128]
    check(dark and abs((dark[-1] - dark[0]) * 25.4 / dpi - 100) < 0.2, f"{path}: a measuring box of other size")


def extent(lines):
    xs, ys = zip(*itertools.chain.from_iterable(lines))
    return min(xs), min(ys), max(xs), max(ys)


def check_inkscape(path):
    """Boxes of the parts as Inkscape sees them: in its pixels, with half a stroke around them."""
    run = subprocess.run(["inkscape", "--query-all", path], capture_output=True, text=True)
    if not check(run.returncode == 0, f"{path}: Inkscape: {run.stderr}"):
        return
    found = {words[0]: [float(word) * 25.4 / 96 for word in words[1:]]
             for words in (line.split(",") for line in run.stdout.splitlines()) if len(words) == 5}
    root = ElementTree.parse(path).getroot()
    parts = [group for group in root.iter(f"{SVG}g") if group.get("id", "").startswith("part-")]
    check(parts, f"{path}: no parts")
    stroke = float(next(g for g in root.iter(f"{SVG}g") if g.get("stroke-width")).get("stroke-width"))
    for group in parts:
        left, top, right, bottom = extent(read_paths(group.iter(f"{SVG}path")).lines[CUT])
        wanted = (left - stroke / 2, top - stroke / 2, right - left + stroke, bottom - top + stroke)
        # Corners are mitred there, so that acute ones reach farther.
        box = found.get(group.get("id"))
        check(box and all(abs(a - b) < 0.02 + 5 * stroke for a, b in zip(box, wanted)),
              f"{path}: {group.get('id')} is at {box} in Inkscape, not at {wanted}")


def check_rsvg(path, svg, size):
    """Its page, and how far what it draws reaches."""
    page = path + ".pdf"
    subprocess.run(["rsvg-convert", "-f", "pdf", "-o", page, path], check=True)
    check_pdf(page, [size], 1.0)
    dpi, inked = 254, 250
    width, height, data = dark_columns(page, 1, dpi)
    rows = [y for y in range(height) if min(data[y * width:(y + 1) * width]) < inked]
    columns = [x for x in range(width) if min(data[x::width]) < inked]
    found = [v * 25.4 / dpi for v in (columns[0], rows[0], columns[-1] + 1, rows[-1] + 1)]
    wanted = extent(itertools.chain.from_iterable(svg.lines.values()))
    check(all(abs(a - b) < 0.35 for a, b in zip(found, wanted)), f"{path}: rsvg draws {found}, not {wanted}")


def check_tiles(path):
    """Neighbours have the same on the strip where they are glued over each other: to the pixel."""
    dpi, margin, foot, overlap = 254, 100, 60, 100  # px of 0.1 mm
    text = subprocess.run(["pdftotext", path, "-"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"Sheet (\d+), page ([A-Z]+)(\d+)", text)
    compared = 0
    for page, (sheet, column, row) in enumerate(names[:-1]):
        following = (sheet, chr(ord(column) + 1), row)
        if len(column) > 1 or following not in names or compared == 3:
            continue
        width, height, left = dark_columns(path, page + 1, dpi)
        right = dark_columns(path, names.index(following) + 1, dpi)[2]
        strips = []
        for data, first in ((left, width - margin - overlap), (right, margin)):
            strips.append([data[y * width + first:y * width + first + overlap] for y in range(margin, height - margin - foot)])
        differing = sum(abs(a - b) > 64 for one, other in zip(*strips) for a, b in zip(one[2:-2], other[2:-2]))
        inked = sum(value < 128 for line in strips[0] for value in line)
        check(inked > 0 and differing <= 0.02 * inked, f"{path}: pages {column}{row} and {following[1]}{row} differ at {differing} of {inked} pixels")
        compared += 1
    return compared


def edges_close(triangles):
    edges = Counter()
    for triangle in triangles:
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            edges[a, b] += 1
    return all(count == 1 and edges[b, a] == 1 for (a, b), count in edges.items())


def check_3mf(path, parts):
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    with zipfile.ZipFile(path) as archive:
        check(set(archive.namelist()) == {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"}, f"{path}: {archive.namelist()}")
        root = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
    check(root.get("unit") == "millimeter", f"{path}: unit")
    objects = root.findall(f".//{space}object")
    check(len(objects) == parts == len(root.findall(f".//{space}item")), f"{path}: {len(objects)} objects, not {parts}")
    for one in objects:
        points = [tuple(float(v.get(c)) for c in "xyz") for v in one.iter(f"{space}vertex")]
        triangles = [[int(t.get(v)) for v in ("v1", "v2", "v3")] for t in one.iter(f"{space}triangle")]
        check(edges_close(triangles), f"{path}: {one.get('name')} is not closed")
        volume = sum(sum(points[a][i] * (points[b][(i + 1) % 3] * points[c][(i + 2) % 3] - points[b][(i + 2) % 3] * points[c][(i + 1) % 3])
                         for i in range(3)) for a, b, c in triangles) / 6
        check(volume > 0, f"{path}: {one.get('name')} is inside out")


def check_stl(path):
    text = subprocess.run(["admesh", path], capture_output=True, encoding="latin-1", check=True).stdout
    for name in ("Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges"):
        found = re.search(rf"{name}\s*:\s*(\d+)", text)
        check(found and int(found.group(1)) == 0, f"{path}: {name} {found and found.group(1)}")


def check_model(cli, model, folder):
    name = pathlib.Path(model).stem
    def export(suffix, *options):
        path = str(pathlib.Path(folder) / f"{name}{len(options)}{'-'.join(options).strip('-')}.{suffix}")
        run = subprocess.run([cli, "export", model, "-o", path, *options], capture_output=True, text=True)
        check(run.returncode == 0, f"{model} as {suffix}: {run.stderr}")
        return path if run.returncode == 0 else None
    svg_path = export("svg", "--no-reference")
    if not svg_path:
        return
    svg = read_svg(svg_path)
    check_inkscape(svg_path)
    for options, version in (((), "AC1015"), (("--dxf", "r12"), "AC1009")):
        compare(f"{name} {version}", read_dxf(export("dxf", *options), version), svg, (ENGRAVED, SCORED, CUT))
    compare(f"{name} lbrn2", read_lbrn2(export("lbrn2")), svg, (ENGRAVED, SCORED, CUT))
    gcode = read_gcode(export("gcode"))
    compare(f"{name} gcode", gcode, svg, (CUT,))
    with open(export("csv"), newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    check(len(rows) == len({row["number"] for row in rows}), f"{name}: parts list")
    total = sum(float(row["cut_mm"]) for row in rows)
    check(abs(total - svg.length(CUT)) <= LENGTH_ERROR * total + 0.01 * len(rows), f"{name}: {total} mm in the parts list, not {svg.length(CUT)}")
    check(all(float(row["area_mm2"]) > 0 and float(row["seconds"]) > 0 for row in rows), f"{name}: a part without area or time")
    sheets = len({row["sheet"] for row in rows})
    size = [float(v.strip("m")) for v in (ElementTree.parse(svg_path).getroot().get(k) for k in ("width", "height"))]
    if sheets == 1:
        check_rsvg(svg_path, svg, size)
        check_pdf(export("pdf", "--no-reference"), [size])
        with_box = export("pdf")
        check_pdf(with_box, [size, (120, 30)])
        check_measuring_box(with_box, 2)
    tiled = export("pdf", "--paper", "a4")
    pages = int(re.search(r"Pages:\s+(\d+)", subprocess.run(["pdfinfo", tiled], capture_output=True, text=True).stdout).group(1))
    text = subprocess.run(["pdftotext", tiled, "-"], capture_output=True, text=True, check=True).stdout
    check(len(re.findall(r"page [A-Z]+[0-9]+", text)) == pages, f"{name}: tiles without names")
    check(len(re.findall(r"50 mm", text)) == pages, f"{name}: tiles without a measuring box")
    check(check_tiles(tiled) > 0 or pages < 2, f"{name}: no neighbours among the tiles")
    with zipfile.ZipFile(export("zip")) as archive:
        for suffix, entry in (("svg", "sheets.svg"), ("dxf", "sheets.dxf"), ("csv", "parts.csv"), ("gcode", "sheets.gcode")):
            check(archive.read(entry) == pathlib.Path(export(suffix)).read_bytes(), f"{name}: {entry} is another one")
    check(pathlib.Path(export("png")).read_bytes().startswith(b"\x89PNG"), f"{name}: no picture")
    check_3mf(export("3mf"), len(rows))
    check_3mf(export("3mf", "--parts", "flat"), len(rows))
    check_stl(export("stl"))
    check_stl(export("stl", "--parts", "flat"))


def main(cli, *models):
    with tempfile.TemporaryDirectory() as folder:
        for model in models:
            check_model(cli, model, folder)
    print("\n".join(faults[:40]) if faults else f"{len(models)} models read as they were meant")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
