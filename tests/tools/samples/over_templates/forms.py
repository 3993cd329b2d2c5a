"""Soft forms as functions of a place, below 0 inside, and their surface as a mesh. Lengths in mm, y upwards."""

from itertools import product
from math import sqrt

CORNERS = list(product((0, 1), repeat=3))
EDGES = [(a, b) for a in CORNERS for b in CORNERS if a < b and sum(p != q for p, q in zip(a, b)) == 1]


def ellipsoid(middle, radii):
    """About as far as it is to the surface, near it. In a plane an ellipse."""
    def at(*p):
        scaled = [(c - m) / r for c, m, r in zip(p, middle, radii)]
        k0 = sqrt(sum(c * c for c in scaled))
        k1 = sqrt(sum((c / r) ** 2 for c, r in zip(scaled, radii)))
        return k0 * (k0 - 1.0) / k1 if k1 > 0.0 else -min(radii)
    return at


def capsule(one, other, radius, other_radius):
    """From one place to another, as thick at each as its radius says."""
    along = [b - a for a, b in zip(one, other)]
    square = sum(d * d for d in along)

    def at(*p):
        way = [c - a for c, a in zip(p, one)]
        share = min(1.0, max(0.0, sum(a * b for a, b in zip(way, along)) / square))
        gap = sum((a - share * b) ** 2 for a, b in zip(way, along))
        return sqrt(gap) - radius - share * (other_radius - radius)
    return at


def mirrored(form, axis):
    """On both sides of the middle, without a crease where they meet."""
    return lambda *p: form(*[sqrt(c * c + 9.0) if i == axis else c for i, c in enumerate(p)])


def joined(parts):
    """The parts one after the other, each run into those before it over so many mm: (form, mm)."""
    def at(*p):
        d = None
        for form, soft in parts:
            e = form(*p)
            if d is None:
                d = e
                continue
            h = max(0.0, soft - abs(d - e)) / soft
            d = min(d, e) - 0.25 * h * h * soft
        return d
    return at


def without(form, hollow):
    return lambda *p: max(form(*p), -hollow(*p))


def on_ground(form):
    """What is above the ground, with flat soles."""
    return lambda *p: max(form(*p), -p[1])


def slope(form, p):
    e = 1e-3
    return [(form(*[c + (e if i == k else 0.0) for k, c in enumerate(p)]) -
             form(*[c - (e if i == k else 0.0) for k, c in enumerate(p)])) / (2.0 * e)
            for i in range(3)]


def onto(form, p, most):
    """The place moved onto the surface, by at most so much."""
    q = list(p)
    for _ in range(4):
        g = slope(form, q)
        square = sum(c * c for c in g)
        if square < 1e-6:
            break
        d = form(*q) / square
        q = [c - d * s for c, s in zip(q, g)]
    return q if sum((a - b) ** 2 for a, b in zip(p, q)) <= most * most else p


def near(form, low, size, step):
    """The form at the corners of a grid, as far as they are near its surface."""
    block = 4
    value = {}
    for first in product(*(range(0, n, block) for n in size)):
        middle = [a + (i + 0.5 * block) * step for a, i in zip(low, first)]
        if abs(form(*middle)) > 1.3 * block * step:
            continue
        for corner in product(*(range(i, min(i + block + 1, n)) for i, n in zip(first, size))):
            if corner not in value:
                value[corner] = form(*[a + i * step for a, i in zip(low, corner)])
    return value


def crossings(value, cell, low, step):
    """Where the surface goes through the edges of a cell; none of cells that are off it."""
    at = {o: tuple(c + d for c, d in zip(cell, o)) for o in CORNERS}
    if not all(c in value for c in at.values()):
        return []
    found = []
    for a, b in EDGES:
        u, v = value[at[a]], value[at[b]]
        if (u < 0.0) != (v < 0.0):
            t = u / (u - v)
            found.append([l + (p + t * (q - p)) * step for l, p, q in zip(low, at[a], at[b])])
    return found


def surface(form, low, high, step):
    """Vertices and triangles, outwards counter-clockwise: a vertex in each cell that the surface goes through
    (S. Gibson 1998, "Constrained elastic surface nets"), moved onto it."""
    size = [int((b - a) / step + 0.5) + 1 for a, b in zip(low, high)]
    value = near(form, low, size, step)
    vertices, of_cell = [], {}
    for cell in sorted(value):
        crossed = crossings(value, cell, low, step)
        if crossed:
            of_cell[cell] = len(vertices)
            middle = [sum(c) / len(crossed) for c in zip(*crossed)]
            vertices.append(onto(form, middle, 0.6 * step))
    triangles = []
    for corner in sorted(value):
        for axis in range(3):
            other = tuple(c + (i == axis) for i, c in enumerate(corner))
            if other in value and (value[corner] < 0.0) != (value[other] < 0.0):
                around = [of_cell[c] for c in beside(corner, axis)]
                if value[corner] >= 0.0:
                    around.reverse()
                triangles += halves([vertices[i] for i in around], around)
    return vertices, triangles


def halves(corners, four):
    """Along the shorter diagonal, so that what is mirrored is cut in two alike."""
    one, other = (sum((p - q) ** 2 for p, q in zip(corners[i], corners[i + 2])) for i in (0, 1))
    a, b, c, d = four if one <= other else four[1:] + four[:1]
    return [(a, b, c), (a, c, d)]


def beside(corner, axis):
    """The four cells round the edge from a corner along an axis, in their order about it."""
    b, c = (axis + 1) % 3, (axis + 2) % 3
    for db, dc in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
        cell = list(corner)
        cell[b] += db
        cell[c] += dc
        yield tuple(cell)


def merged(vertices, triangles):
    """Without triangles whose corners have come together."""
    places = {tuple(v): i for i, v in reversed(list(enumerate(vertices)))}
    kept = [[places[tuple(vertices[i])] for i in t] for t in triangles]
    return vertices, [t for t in kept if len(set(t)) == 3]


def standing(mesh):
    """Its box's middle above the origin, on the ground; and how wide, high and deep it is."""
    vertices, triangles = mesh
    low, high = ([f(c) for c in zip(*vertices)] for f in (min, max))
    by = [0.5 * (low[0] + high[0]), low[1], 0.5 * (low[2] + high[2])]
    moved = [[round(c - d, 2) for c, d in zip(v, by)] for v in vertices]
    return merged(moved, triangles), [max(c) - min(c) for c in zip(*moved)]


def write_obj(path, mesh):
    """To a hundredth of a mm."""
    vertices, triangles = mesh
    with open(path, "w", encoding="ascii", newline="\n") as file:
        for v in vertices:
            file.write("v " + " ".join(f"{c + 0.0:g}" for c in v) + "\n")
        for t in triangles:
            file.write("f " + " ".join(str(i + 1) for i in t) + "\n")
