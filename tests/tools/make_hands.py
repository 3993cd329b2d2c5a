#!/usr/bin/env python3
"""Writes the replay scripts of tst_hands (tests/data/hands/NN_name.json).

Each is a hand (human_hand.py) that means a shape and draws it as people do: with too few places or
too many, a tremor, ends that overshoot, stop short, hook or miss. Beside its events a script has
the outline that was meant, as places on the screen once the view rests: {"meant": [[x, y], ...]}.
Run it from anywhere after a change; the scripts are kept under version control, so that a test
never depends on this. All of it is the same with each run.
"""
import json
import math
import os

import human_hand as hand
from human_hand import Hand, beside, crossed, hooked, overshot, short, straight_on

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "hands")
TURN = 800  # ms
UP, OVER = (640, 400), (640, 228)  # out of the body's upper edge, which is at y = 260


# Shapes, as closed lines, their first place once more at their end.

def oval(centre, a, b, start=0.0, sweep=360.0, tilt=0.0):
    line = []
    for i in range(241):
        angle = math.radians(start + sweep * i / 240)
        x, y = hand.turned((a * math.cos(angle), b * math.sin(angle)), tilt)
        line.append((centre[0] + x, centre[1] + y))
    return line


def circle(centre, radius, start=0.0, sweep=360.0):
    return oval(centre, radius, radius, start, sweep)


def polygon(*corners):
    return list(corners) + [corners[0]]


def box(x, y, width, height):
    return polygon((x, y), (x + width, y), (x + width, y + height), (x, y + height))


def star(centre, outer, inner, points=5):
    return polygon(*((centre[0] + r * math.sin(math.pi * k / points),
                      centre[1] - r * math.cos(math.pi * k / points))
                     for k in range(2 * points) for r in [outer if k % 2 == 0 else inner]))


def polar(centre, radius, start=-90.0):
    """radius: of an angle in degrees."""
    return [(centre[0] + radius(t) * math.cos(math.radians(t + start)),
             centre[1] + radius(t) * math.sin(math.radians(t + start)))
            for t in range(361)]


def bends(*beziers):
    """Cubics, each from where the one before ends: (start), then control, control, end."""
    line = [beziers[0]]
    for c1, c2, end in beziers[1:]:
        start = line[-1]
        line += [tuple((1 - u) ** 3 * start[k] + 3 * (1 - u) ** 2 * u * c1[k] +
                       3 * (1 - u) * u * u * c2[k] + u ** 3 * end[k] for k in range(2))
                 for u in (i / 40 for i in range(1, 41))]
    return line


def rounded_box(x, y, width, height, r):
    line = [(x + width / 2, y)]
    for cx, cy, start in ((x + width - r, y + r, -90), (x + width - r, y + height - r, 0),
                          (x + r, y + height - r, 90), (x + r, y + r, 180)):
        line += [(cx + r * math.cos(math.radians(start + k * 6)),
                  cy + r * math.sin(math.radians(start + k * 6))) for k in range(16)]
    return line + [line[0]]


def from_middle(line):
    """A polygon, from the middle of its first side."""
    middle = hand.lerp(line[0], line[1], 0.5)
    return [middle] + line[1:] + [middle]


def placed(line, x, y, across, down=None):
    """A line around the origin: larger, and with its origin at a place."""
    return [(x + across * px, y + (down or across) * py) for px, py in line]


def heart(x, y, size):
    """From the notch on top."""
    return placed(bends((0, 0), ((0.25, -0.45), (1.05, -0.35), (0.85, 0.25)),
                        ((0.75, 0.6), (0.25, 0.9), (0, 1.25)),
                        ((-0.25, 0.9), (-0.75, 0.6), (-0.85, 0.25)),
                        ((-1.05, -0.35), (-0.25, -0.45), (0, 0))), x, y, size)


def leaf(x, y, length, width):
    """From its tip on top; slim at both."""
    return placed(bends((0, 0), ((1, 0.3), (1, 0.7), (0, 1)), ((-1, 0.7), (-1, 0.3), (0, 0))),
                  x, y, width, length)


def crescent(x, y, r):
    """From its upper tip, round the outside, back along the inside."""
    outer = [(x + r * math.cos(math.radians(t)), y + r * math.sin(math.radians(t)))
             for t in range(-60, -301, -4)]
    tip, low = outer[0], outer[-1]
    return outer + bends(low, ((x - 0.25 * r, y + 0.5 * r), (x - 0.25 * r, y - 0.5 * r), tip))[1:]


def fin(x, y, size):
    """Wavy at its back, from its root."""
    return placed(bends((0, 0), ((-0.2, -0.5), (-0.1, -1), (0.5, -1.2)),
                        ((0.9, -1.3), (0.75, -0.8), (1, -0.6)),
                        ((1.3, -0.35), (0.95, -0.1), (1.1, 0.2)),
                        ((1.25, 0.6), (0.15, 0.8), (0, 0))), x, y, size)


def cat(x, y, radius):
    """A head with two ears, from between them."""
    def at(*degrees, k=1.0):
        return [(x + k * radius * math.sin(math.radians(t)),
                 y - k * radius * math.cos(math.radians(t))) for t in degrees]
    return (at(*range(0, 27, 2)) + at(38, k=1.6) + at(*range(50, 311, 4)) + at(322, k=1.6) +
            at(*range(334, 361, 2)))


def leg(x, y, size):
    """From the hip down to a foot and back."""
    shin = bends((0, 0), ((0.5, 0), (0.55, 0.5), (0.25, 1.2)))
    foot = [(0.75, 1.3), (0.75, 1.55), (-0.15, 1.55)]
    calf = bends(foot[-1], ((-0.1, 1.1), (-0.5, 0), (0, 0)))
    return placed(shin + foot + calf[1:], x, y, size)


def angle_piece(x, y, w, h, t):
    """An L."""
    return polygon((x, y), (x + t, y), (x + t, y + h - t), (x + w, y + h - t), (x + w, y + h),
                   (x, y + h))


class Script:
    def __init__(self):
        self.events, self.now = [], 0

    def add(self, ms=8, **event):
        self.now += ms
        self.events.append(dict(event, t=self.now))
        return self

    def view(self, name):
        return self.add(type="view", name=name)

    def command(self, name, **parameters):
        return self.add(type="command", name=name, parameters=parameters)

    def wait(self, ms):
        self.events.append(dict(type="wait", ms=ms, t=self.now))
        self.now += ms
        return self

    def clean(self, *points):
        """A line that no hand drew: press, far moves, release."""
        for i, (x, y) in enumerate(points):
            self.add(type="move" if i else "press", x=x, y=y)
        return self.add(type="release", x=x, y=y).wait(500)

    def body(self):
        return self.view("front").clean((400, 260), (880, 260), (880, 560), (400, 560), (400, 268))

    def stroke(self, drawing, *modifiers):
        """All that the hand does between a press and a release, and until the view rests. Keys are
        held once it moves."""
        told, start = drawing.events(), self.now
        keys = {"modifiers": list(modifiers)} if modifiers else {}
        self.add(type="press", x=told[0][1][0], y=told[0][1][1])
        for ms, (x, y) in told[1:]:
            self.add(start + 8 + ms - self.now, type="move", x=x, y=y, **keys)
        x, y = told[-1][1]
        self.add(start + 8 + len(drawing.places) - self.now, type="release", x=x, y=y, **keys)
        return self.wait(1500)

    def save(self, name, meant):
        places = [[round(x, 1), round(y, 1)] for x, y in meant[:-1]]
        events = ",\n    ".join(json.dumps(self.in_short(e)) for e in self.events)
        text = '{"viewport": [1280, 800],\n "meant": %s,\n "events": [\n    %s\n]}\n' % (
            json.dumps(places), events)
        with open(os.path.join(FOLDER, name + ".json"), "w") as file:
            file.write(text)

    @staticmethod
    def in_short(event):
        return {k: int(v) if isinstance(v, float) and v == int(v) else v for k, v in event.items()}


# Hands.

def patient(seed, **more):
    return Hand(seed, **{"tremor": 0.5, "drift": 1.0, **more})


def sloppy(seed, **more):
    return Hand(seed, **{"tremor": 1.5, "drift": 2.5, "lag": 26, **more})


def hasty(seed, **more):
    return Hand(seed, **{"tremor": 0.8, "drift": 1.5, "lag": 14, **more})


class Book:
    """Numbers the scripts."""

    def __init__(self):
        self.count = 0

    def save(self, script, name, meant=()):
        self.count += 1
        script.save("%02d_%s" % (self.count, name), meant)

    def first(self, name, drawing, line, ms, meant=()):
        """A first section, drawn on nothing."""
        drawing.go(line, ms).rest(24)
        self.save(Script().view("front").stroke(drawing), name, meant)

    def hole(self, name, drawing, line, ms, meant, view="front", at=(640, 500)):
        script = Script().body().view(view).clean(at).command("section.addHole").wait(TURN)
        self.save(script.stroke(drawing.go(line, ms).rest(24)), name, meant)

    def across(self, name, drawing, slit, line, ms, meant, script=None, modifiers=(), rest=1000):
        """With a slit: the hand pulls it, rests while the view turns, and draws."""
        drawing.go([slit[0], slit[1]], 450).rest(rest).go(line, ms).rest(24)
        self.save((script or Script().body()).stroke(drawing, *modifiers), name, meant)

    def at_once(self, name, drawing, line, meant, ms=800, script=None):
        drawing.go(line, ms).rest(16)
        self.save((script or Script().body()).stroke(drawing), name, meant)


def first_sections(book):
    middle = (640, 400)
    round_one = circle(middle, 110, -100)
    book.first("circle_patient", patient(1), round_one, 2200, round_one)
    book.first("circle_hasty", hasty(2), overshot(round_one, 25), 600, round_one)
    book.first("circle_trembling", Hand(3, tremor=2.0, drift=3.0), round_one, 20000, round_one)
    book.first("circle_overshot", patient(4), overshot(round_one, 60), 1800, round_one)
    book.first("circle_short", patient(5), short(round_one, 35), 1500, round_one)
    book.first("circle_hooked", patient(6, lag=8), hooked(round_one, 16), 1500, round_one)
    book.first("circle_ten_places", hasty(7, every=70), round_one, 700, round_one)
    book.first("circle_past_its_start", patient(8), beside(overshot(round_one, 30), -9, 0.3), 1500,
               round_one)
    book.first("circle_crossed_at_its_start", patient(9), crossed(round_one, 8, 50), 1500,
               round_one)

    nine = oval(middle, 150, 70, 160)
    book.first("ellipse_nine_places", hasty(11, every=80), nine, 720, nine)
    leaning = oval(middle, 140, 80, 30, -360, 35)
    book.first("ellipse_leaning", sloppy(12), overshot(leaning, 15), 1600, leaning)

    sides = box(520, 310, 240, 170)
    book.first("box_patient", patient(13), sides, 2600, sides)
    book.first("box_noisy", patient(14, noise=1.5, grid=0.1), sides, 2600, sides)
    book.first("box_hasty", hasty(15), sides, 800, sides)
    book.first("box_overshot", patient(16), straight_on(sides, 22), 2200, sides)
    side = from_middle(sides)
    book.first("box_from_a_side", sloppy(17), overshot(side, 18), 2400, side)
    soft = rounded_box(520, 310, 240, 170, 40)
    book.first("box_rounded", patient(18), soft, 2400, soft)

    spikes = star((640, 420), 150, 66)
    book.first("star_patient", patient(19), spikes, 4500, spikes)
    book.first("star_noisy", patient(20, noise=1.5, grid=0.1), spikes, 4500, spikes)
    book.first("star_hasty", hasty(21), straight_on(spikes, 12), 2200, spikes)
    three = polygon((640, 290), (770, 490), (510, 480))
    book.first("triangle_sloppy", sloppy(22), three, 1800, three)
    book.first("triangle_short", patient(23), short(three, 30), 1600, three)
    love = heart(640, 350, 110)
    book.first("heart", sloppy(24, tremor=1.0), love, 2400, love)
    slim = leaf(640, 260, 260, 75)
    book.first("leaf_beside_its_tip", patient(25), beside(slim, -7, 0.2), 1600, slim)
    moon = crescent(640, 400, 120)
    book.first("crescent", patient(26), moon, 2400, moon)
    head = cat(640, 420, 105)
    book.first("cat", patient(27), head, 3200, head)
    clover = polar((640, 400), lambda t: 105 + 33 * math.cos(math.radians(3 * t)))
    book.first("trefoil", sloppy(28, tremor=1.0), clover, 2200, clover)
    corner = angle_piece(540, 300, 200, 210, 70)
    book.first("angle_piece", patient(29), corner, 3600, corner)
    spine = rounded_box(820, 380, 500, 44, 20)
    book.first("spine_beyond_the_window", patient(30, dips=0.05), spine, 2400, spine)
    book.first("twitch", hasty(31), [middle, (648, 404)], 120)
    book.first("there_and_back", patient(32), [middle, (760, 400), (644, 401)], 900)


def holes(book):
    eye = circle((600, 380), 10, 0)
    book.hole("eye", patient(33, tremor=0.4, drift=0.4), overshot(eye, 6), 700, eye)
    book.hole("eye_hasty", hasty(34, tremor=0.4, drift=0.4, every=24), eye, 180, eye)
    window = box(560, 330, 160, 110)
    book.hole("hole_box_from_behind", patient(35), window, 2000, window, "back")
    edge = oval((640, 316), 120, 40, 200)
    book.hole("hole_near_the_edge", patient(36), edge, 1600, edge)


def sections(book):
    # The zone in which nothing is drawn yet reaches 32 px round the slit.
    ring = circle((640, 290), 104, -90)
    lean = (648, 228)  # 2.7 degrees off the upright
    book.across("slit_nearly_upright", patient(37), (UP, lean), ring, 1800, ring)
    book.across("slit_left_free", patient(38), (UP, lean), ring, 1800, ring, modifiers=("control",))
    slanted = Script().body()
    pulled = patient(39).go([(500, 450), (590, 226)], 450).rest(1000)
    slanted.stroke(pulled.go(circle((590, 290), 90, -90), 1500))
    slanted.command("view.previous").wait(500)
    book.across("slit_along_the_last", patient(10), ((600, 450), (702, 226)), ring, 1600, ring,
                script=slanted)
    gable = Script().view("front").clean((400, 320), (880, 200), (880, 560), (400, 560), (400, 328))
    book.across("slit_square_to_the_edge", patient(51), ((640, 400), (590, 228)), ring, 1600, ring,
                script=gable)
    lying = oval((880, 400), 120, 70, -180)
    book.across("slit_nearly_level", patient(40), ((720, 400), (912, 412)), lying, 1800, lying)
    book.across("fin", patient(41), (UP, OVER), fin(602, 350, 110), 2200, fin(602, 350, 110))
    half = leaf(640, 186, 200, 60)
    book.across("leaf_by_half", patient(42), (UP, OVER), half[:41], 1300, half)
    book.across("leg_downwards", patient(43), ((640, 470), (640, 592)), leg(640, 440, 110), 2000,
                leg(640, 440, 110))
    wide = box(560, 180, 170, 190)
    book.across("box_on_a_slit", sloppy(44, tremor=1.0), (UP, OVER), wide, 2400, wide)
    iso = Script().body().view("iso1")
    lower = circle((640, 300), 104, -90)
    book.across("from_a_corner", patient(45), ((640, 400), (640, 238)), lower, 1800, lower,
                script=iso)
    book.across("from_behind", sloppy(46, tremor=1.0), (UP, OVER), ring, 1600, ring,
                script=Script().body().view("back"))
    book.across("twitch_on_a_slit", patient(47), (UP, OVER), [(640, 190), (644, 182)], 300, ())

    # At once, without waiting for the turn.
    loop = circle((640, 300), 96, -125, -360)
    tangent = hand.direction(loop[0], loop[1])
    before = (loop[0][0] - 25 * tangent[0], loop[0][1] - 25 * tangent[1])
    lead = bends((640, 262), ((640, 225), before, loop[0]))
    book.at_once("ring_at_once", hasty(48), [UP] + lead + loop[1:], loop)
    drop = bends((640, 230), ((650, 150), (770, 170), (745, 270)),
                 ((730, 320), (668, 330), (640, 376)))
    whole = drop + [(1280 - x, y) for x, y in reversed(drop[:-1])]
    book.at_once("drop_at_once", hasty(49), [UP] + drop, whole)
    book.at_once("drop_at_once_sloppy", sloppy(50, tremor=1.0, lag=14, every=12), [UP] + drop,
                 whole, ms=900)


def main():
    os.makedirs(FOLDER, exist_ok=True)
    book = Book()
    first_sections(book)
    holes(book)
    sections(book)


if __name__ == "__main__":
    main()
