"""A hedgehog in slices: they stand on the ground, so that none of them hangs in its slits alone."""

from forms import capsule, ellipsoid, joined, on_ground, standing, surface


def form():
    return on_ground(joined([
        (ellipsoid((-14, 2, 0), (62, 76, 52)), 0),
        (ellipsoid((-14, 2, 0), (74, 30, 66)), 22),         # where the spines end
        (capsule((34, 16, 0), (74, 16, 0), 30, 11), 26),
        (ellipsoid((88, 19, 0), (8, 8, 8)), 4),
    ]))


def make():
    return standing(surface(form(), (-96, -8, -72), (104, 88, 72), 4.0))
