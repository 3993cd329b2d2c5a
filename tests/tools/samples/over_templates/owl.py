"""An owl, from pictures of its front and its side."""

from forms import capsule, ellipsoid, joined, mirrored, on_ground, without
from picture import drawn
from strokes import Script

WIDE, HIGH = 124, 168
BROWN, LIGHT, CREAM, AMBER, ORANGE, DARK = ((160, 118, 80), (190, 152, 110), (238, 216, 178), (250, 190, 60),
                                            (232, 140, 50), (58, 38, 28))


def both(form):
    return mirrored(form, 0)


def front():
    body = ellipsoid((0, 64), (45, 56))
    head = ellipsoid((0, 118), (43, 33))
    outline = on_ground(joined([
        (body, 0), (head, 12),
        (both(capsule((27, 138), (35, 160), 11, 3)), 10),   # ears
        (both(ellipsoid((40, 68), (16, 35))), 8),           # wings
        (both(ellipsoid((22, 4), (17, 11))), 5),            # feet
    ]))
    feathers = [(without(ellipsoid((x, y), (6, 7)), ellipsoid((x, y + 2.4), (6.4, 7))), DARK)
                for row, y in enumerate((76, 63, 50, 37)) for x in
                ((-24, -12, 12, 24) if row % 2 == 0 else (-18, 18, -30, 30))]
    ring = without(ellipsoid((18, 120), (16, 16)), ellipsoid((18, 120), (14.5, 14.5)))
    return [(outline, BROWN),
            (ellipsoid((0, 58), (34, 43)), CREAM), *feathers,
            (both(ellipsoid((20, 120), (21, 22))), LIGHT),
            (both(ellipsoid((18, 120), (15.5, 15.5))), AMBER),
            (both(ring), DARK), (both(ellipsoid((16, 119), (7.5, 8.5))), DARK),
            (both(ellipsoid((14, 122.5), (2.4, 2.4))), (255, 255, 255)),
            (capsule((0, 110), (0, 99), 6, 1.5), ORANGE),
            (both(capsule((22, 4), (22, 5), 12, 9)), ORANGE)]


def side():
    """It looks to the left."""
    outline = on_ground(joined([
        (ellipsoid((2, 64), (41, 55)), 0), (ellipsoid((-4, 118), (36, 33)), 14),
        (capsule((20, 50), (47, 8), 20, 9), 10),            # the tail
        (capsule((-36, 113), (-47, 103), 7, 1.5), 5),       # the beak
        (ellipsoid((-14, 3), (27, 10)), 6),                 # a foot
    ]))
    return [(outline, BROWN), (ellipsoid((-12, 58), (24, 42)), CREAM), (ellipsoid((-20, 119), (15, 17)), LIGHT),
            (ellipsoid((-24, 120), (7, 11)), AMBER), (ellipsoid((-25, 120), (3.5, 6)), DARK),
            (capsule((-38, 112), (-47, 103), 5, 1.5), ORANGE), (ellipsoid((-16, 4), (24, 6)), ORANGE)]


def wing():
    outline = joined([(ellipsoid((3, 84), (18, 24)), 0), (capsule((6, 74), (40, 24), 20, 4), 14)])
    return [(outline, BROWN)] + [
        (without(ellipsoid((5 + 7 * i, 84 - 13 * i), (12 - 1.5 * i, 14 - i)),
                 ellipsoid((4.4 + 7 * i, 87 - 13 * i), (12.4 - 1.5 * i, 14 - i))), DARK) for i in range(4)]


def foot():
    outline = on_ground(joined([(capsule((-28, 3), (22, 2), 8, 7), 0), (ellipsoid((2, 10), (12, 12)), 8)]))
    return [(outline, ORANGE)]


PICTURES = {"Front": front, "Side": side, "Wing": wing, "Foot": foot}


def pictures():
    return {name: drawn(layers(), WIDE, HIGH) for name, layers in PICTURES.items()}


def traced():
    script = Script((WIDE, HIGH))

    def trace(name, section):
        """Its outline, and on that its dark lines."""
        script.command("template.trace", template=name, by="opacity")
        script.command("template.trace", template=name, section=section, threshold="38", smoothing="100",
                       **{"as": "engraved"})

    script.command("template.align", front="Front", side="Side", by="all")
    trace("Front", "Section 1")
    script.command("template.trace", template="Side", by="opacity")
    section = 2
    for name, x in (("Wing", 40), ("Foot", 22)):
        script.command("template.lay", template=name, plane="side")
        for at in (x, -x):
            section += 1
            script.command("template.set", template=name, x=str(at))
            if name == "Wing":
                trace(name, f"Section {section}")
            else:
                script.command("template.trace", template=name, by="opacity")
        script.command("template.set", template=name, hidden="true")
    return script


NAMES = ["Front", "Side", "Right wing", "Left wing", "Right foot", "Left foot"]
