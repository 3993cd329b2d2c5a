"""Statics of plates that hang together in a tree: what feet, joints and cuts carry.

Shares nothing with core/physics: forces follow from the equilibrium of what is beyond a foot, a
joint or a cut, with moments about points in space. Lengths in mm, forces in N, masses in kg.
"""
import math

CUBIC_MM = 1e-9  # m3


def add(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def scaled(k, a):
    return [k * x for x in a]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return math.sqrt(dot(a, a))


def solved(rows, right):
    """Gauss with pivots."""
    n = len(rows)
    table = [list(row) + [b] for row, b in zip(rows, right)]
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(table[k][i]))
        table[i], table[best] = table[best], table[i]
        for k in range(n):
            if k != i:
                share = table[k][i] / table[i][i]
                table[k] = [x - share * y for x, y in zip(table[k], table[i])]
    return [table[i][n] / table[i][i] for i in range(n)]


def area_and_centre(polygon):
    """Counter-clockwise counts up."""
    whole, first = 0.0, [0.0, 0.0]
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        part = 0.5 * (x0 * y1 - x1 * y0)
        whole += part
        first = [first[0] + part * (x0 + x1) / 3.0, first[1] + part * (y0 + y1) / 3.0]
    return whole, ([first[0] / whole, first[1] / whole] if whole else [0.0, 0.0])


def beyond(polygon, at, way):
    """What of a polygon lies beyond a line through `at`, on the side of `way`."""
    kept = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        a, b = (dot(minus(p, at), way) for p in (p, q))
        if a >= 0:
            kept.append(p)
        if a * b < 0:
            kept.append(add(p, scaled(a / (a - b), minus(q, p))))
    return kept


class Plate:
    """taken: what slits and holes really take off the outline, which they do not reach beyond."""

    def __init__(self, name, origin, u, v, thickness, outline, taken=(), density=1190.0):
        self.name, self.origin, self.u, self.v = name, origin, u, v
        self.n = cross(u, v)
        self.thickness, self.density = thickness, density
        self.outline, self.taken = outline, list(taken)

    def at(self, p):
        return add(self.origin, scaled(p[0], self.u), scaled(p[1], self.v))

    def flat(self, point):
        return [dot(minus(point, self.origin), self.u), dot(minus(point, self.origin), self.v)]

    def mass(self, where=lambda polygon: polygon):
        """kg and centre in space of what `where` leaves of each polygon."""
        whole, first = 0.0, [0.0, 0.0]
        for sign, polygon in [(1, self.outline)] + [(-1, taken) for taken in self.taken]:
            left = where(polygon)
            if len(left) < 3:
                continue
            area, centre = area_and_centre(left)
            whole += sign * abs(area)
            first = add(first, scaled(sign * abs(area), centre))
        centre = scaled(1.0 / whole, first) if whole else [0.0, 0.0]
        return self.density * CUBIC_MM * self.thickness * whole, self.at(centre)


class Assembly:
    """joints: {name: (a, b, point)}; feet: [(plate, point)]; loads: [(plate, point, force,
    moment)]."""

    def __init__(self, plates, joints=None, feet=(), loads=(), up=(0, 0, 1), gravity=9.81):
        self.plates = {plate.name: plate for plate in plates}
        self.joints, self.feet, self.loads = joints or {}, list(feet), list(loads)
        self.up, self.gravity = list(up), scaled(-gravity, up)
        self.reactions = [[0.0, 0.0, 0.0] for _ in self.feet]

    def mass(self):
        parts = [plate.mass() for plate in self.plates.values()]
        whole = sum(mass for mass, _ in parts)
        return whole, scaled(1.0 / whole, add(*[scaled(mass, centre) for mass, centre in parts]))

    def acting(self, names):
        """(point, force, moment) of weights, loads and feet on these plates."""
        found = []
        for name in names:
            mass, centre = self.plates[name].mass()
            found.append((centre, scaled(mass, self.gravity), [0.0, 0.0, 0.0]))
        found += [(point, force, moment) for name, point, force, moment in self.loads
                  if name in names]
        found += [(point, force, [0.0, 0.0, 0.0])
                  for (name, point), force in zip(self.feet, self.reactions) if name in names]
        return found

    @staticmethod
    def total(acting, about):
        force, moment = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
        for point, f, m in acting:
            force = add(force, f)
            moment = add(moment, m, cross(minus(point, about), f))
        return force, moment

    def stand(self):
        """Three feet without friction: the vertical force, and moments about two level axes."""
        force, moment = self.total(self.acting(self.plates), [0, 0, 0])
        level = [axis for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1]) if not dot(axis, self.up)]
        rows = [[1.0] * 3] + [[dot(cross(point, self.up), axis) for _, point in self.feet]
                              for axis in level]
        right = [-dot(force, self.up)] + [-dot(moment, axis) for axis in level]
        self.reactions = [scaled(k, self.up) for k in solved(rows, right)]

    def side(self, start, without):
        """The plates that hang together with `start` but for one joint."""
        found, open_ = {start}, [start]
        while open_:
            here = open_.pop()
            for joint, (a, b, _) in self.joints.items():
                other = b if a == here else a if b == here else None
                if joint != without and other is not None and other not in found:
                    found.add(other)
                    open_.append(other)
        return found

    def wrench(self, joint):
        """Force and moment on a, about the joint's point."""
        a, _, point = self.joints[joint]
        force, moment = self.total(self.acting(self.side(a, joint)), point)
        return scaled(-1, force), scaled(-1, moment)

    def cut(self, name, p0, p1):
        """Of a plate, of which the line through both is in material between them only."""
        plate = self.plates[name]
        length = math.dist(p0, p1)
        way = scaled(1.0 / length, minus(p1, p0))
        m = [way[1], -way[0]]
        middle = scaled(0.5, add(p0, p1))
        mass, centre = plate.mass(lambda polygon: beyond(polygon, p0, m))
        acting = [(centre, scaled(mass, self.gravity), [0.0, 0.0, 0.0])]
        acting += [(point, force, moment) for on, point, force, moment in self.loads if on == name]
        acting += [(point, force, [0.0, 0.0, 0.0])
                   for (on, point), force in zip(self.feet, self.reactions) if on == name]
        for joint, (a, b, point) in self.joints.items():
            if name in (a, b):
                force, moment = self.wrench(joint)
                sign = 1 if name == a else -1
                acting.append((point, scaled(sign, force), scaled(sign, moment)))
        acting = [acting[0]] + [one for one in acting[1:]
                                if dot(minus(plate.flat(one[0]), p0), m) > 0]
        force, moment = self.total(acting, plate.at(middle))
        m3, v3 = ([a * x + b * y for x, y in zip(plate.u, plate.v)] for a, b in (m, way))
        found = {"N": dot(force, m3), "V": dot(force, v3), "Q": dot(force, plate.n),
                 "Mn": dot(moment, plate.n), "Mv": dot(moment, v3), "T": dot(moment, m3),
                 "l": length}
        t = plate.thickness
        found["sigma_lin"] = (abs(found["N"]) / (length * t)
                              + 6 * abs(found["Mn"]) / (t * length ** 2)
                              + 6 * abs(found["Mv"]) / (length * t ** 2))
        return found
