"""A bear on all fours: a mesh, and sections that are drawn over it."""

from forms import capsule, ellipsoid, joined, mirrored, on_ground, standing, surface
from strokes import Script


def form():
    return on_ground(joined([
        (ellipsoid((-14, 84, 0), (62, 42, 40)), 0),
        (ellipsoid((32, 92, 0), (34, 39, 36)), 26),      # the hump of the shoulders
        (ellipsoid((-58, 78, 0), (36, 40, 39)), 26),
        (ellipsoid((-99, 92, 0), (9, 9, 9)), 8),         # the tail
        (capsule((52, 98, 0), (82, 112, 0), 31, 28), 24),
        (ellipsoid((92, 116, 0), (31, 30, 34)), 14),     # the head
        (ellipsoid((119, 104, 0), (22, 16, 18)), 14),
        (ellipsoid((138, 109, 0), (6.5, 6, 8)), 4),      # the nose
        (mirrored(ellipsoid((84, 144, 25), (8, 13, 13.5)), 2), 6),
        (mirrored(capsule((34, 66, 25), (38, 14, 27), 18, 15.5), 2), 12),
        (mirrored(ellipsoid((45, 8, 27), (22, 14, 18)), 2), 8),
        (mirrored(capsule((-62, 66, 26), (-66, 14, 27), 20, 16.5), 2), 12),
        (mirrored(ellipsoid((-58, 8, 27), (23, 14, 18)), 2), 8),
    ]))


def make():
    mesh, size = standing(surface(form(), (-114, -6, -57.6), (152, 168, 57.6), 3.6))
    return mesh, size


def drawn(size):
    """Each slides in from where its stroke left."""
    script = Script(size)
    script.whole("Front")
    script.across((18, 80), (18, 20))      # fore legs
    script.across((-82, 80), (-82, 10))    # hind legs
    script.across((-51, 80), (-55, 140))    # ribs
    script.across((-16, 80), (-17, 150))
    script.across((46, 100), (24, 150))    # neck
    script.across((70, 118), (64, 160))    # head with its ears
    script.across((96, 92), (114, 128))    # muzzle
    return script


NAMES = ["Body", "Fore legs", "Hind legs", "Rear rib", "Middle rib", "Neck", "Head", "Muzzle"]
