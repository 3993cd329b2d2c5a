"""A hand that draws: how it moves, and how its lines end. Used by make_hands.py.

Speeds follow the two-thirds power law (F. Lacquaniti, C. Terzuolo, P. Viviani 1983) between a
start and an end without a jerk (T. Flash, N. Hogan 1985): slow at corners, fast on the straight.
Muscles lag behind what is meant, which cuts corners short; a tremor of 8 to 12 Hz and a slow drift
lie over it. A mouse tells of the place every so often, in whole pixels, and of none twice.

Lengths are px, times ms; y goes down.
"""
import math
import random

STRAIGHT = 150.0  # px, radius from which on a bend slows nobody down
BEND_WAY = 6  # px to each side, over which a bend is judged


def lerp(a, b, u):
    return (a[0] + (b[0] - a[0]) * u, a[1] + (b[1] - a[1]) * u)


def dense(points):
    """The same line with a place every pixel."""
    line = [points[0]]
    for a, b in zip(points, points[1:]):
        count = max(1, math.ceil(math.dist(a, b)))
        line += [lerp(a, b, i / count) for i in range(1, count + 1)]
    return line


def direction(a, b):
    length = math.dist(a, b) or 1.0
    return ((b[0] - a[0]) / length, (b[1] - a[1]) / length)


def turned(way, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return (c * way[0] - s * way[1], s * way[0] + c * way[1])


# How a line ends. Each takes a closed line, its first place once more at its end.

def along(line, length):
    """What comes after the start, once more."""
    return dense(line)[1:round(length) + 1]


def overshot(line, length):
    return line + along(line, length)


def straight_on(line, length):
    way = direction(line[-2], line[-1])
    return line + [(line[-1][0] + way[0] * length, line[-1][1] + way[1] * length)]


def short(line, length):
    return dense(line)[:-round(length)]


def hooked(line, length, degrees=150):
    way = turned(direction(line[-2], line[-1]), degrees)
    return line + [(line[-1][0] + way[0] * length, line[-1][1] + way[1] * length)]


def beside(line, distance, part=0.25):
    """It drifts away to one side towards its end."""
    places = dense(line)
    first = round(len(places) * (1 - part))
    result = places[:first]
    for i in range(first, len(places)):
        u = (i - first) / (len(places) - 1 - first)
        x, y = direction(places[i - 1], places[i])
        off = distance * u * u * (3 - 2 * u)
        result.append((places[i][0] - y * off, places[i][1] + x * off))
    return result


def crossed(line, distance, length):
    """It comes in on one side of its start and goes on across it to the other."""
    inside = beside(line, distance)
    ahead = along(line, length)
    x, y = direction(ahead[0], ahead[-1])
    return inside + [(p[0] - y * distance * (1 - 2 * (i + 1) / len(ahead)),
                      p[1] + x * distance * (1 - 2 * (i + 1) / len(ahead)))
                     for i, p in enumerate(ahead)]


class Hand:
    """tremor, drift: px to each side, nearly always; noise: px, standard deviation of the device;
    lag: ms; every: ms from one event to the next; grid: px; dips: how often some events are left
    out."""

    def __init__(self, seed, tremor=0.6, drift=1.0, noise=0.0, lag=16, every=8, grid=1.0, dips=0.0):
        self.rng = random.Random(seed)
        self.noise, self.lag, self.every, self.grid, self.dips = noise, lag, every, grid, dips
        self.places = []  # that it means to be at, one a ms
        self.waves = []  # of each axis: amplitude, cycles a ms, phase
        for _ in range(2):
            self.waves.append(
                [(tremor / 2.4, self.rng.uniform(0.008, 0.012), self.rng.uniform(0, math.tau))
                 for _ in range(3)] +
                [(drift / 1.6, self.rng.uniform(0.0002, 0.0007), self.rng.uniform(0, math.tau))
                 for _ in range(2)])

    def go(self, points, ms):
        """Along them in so much time; from where it is, if it is anywhere."""
        line = dense(([self.places[-1]] if self.places else []) + points)
        last = len(line) - 1
        times = [0.0]
        for i in range(last):
            before, after = line[max(0, i - BEND_WAY)], line[min(last, i + BEND_WAY)]
            a, b = direction(before, line[i]), direction(line[i], after)
            turn = abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]))
            speed = (turn / BEND_WAY + 1 / STRAIGHT) ** (-1 / 3)
            ends = min(i + 0.5, last - i - 0.5) / max(1.0, 0.12 * last)
            speed *= min(1.0, ends ** 0.6 + 0.03)
            times.append(times[-1] + math.dist(line[i], line[i + 1]) / speed)
        scale, k = ms / (times[-1] or 1.0), 0
        for now in range(1, round(ms) + 1):
            while k < last - 1 and times[k + 1] * scale < now:
                k += 1
            whole = (times[k + 1] - times[k]) * scale
            u = min(1.0, (now - times[k] * scale) / whole) if whole else 1.0
            self.places.append(lerp(line[k], line[k + 1], u))
        return self

    def rest(self, ms):
        self.places += [self.places[-1]] * round(ms)
        return self

    def lagging(self):
        reach = round(2.5 * self.lag)
        weights = [math.exp(-0.5 * (k / self.lag) ** 2) if self.lag else 1.0
                   for k in range(-reach, reach + 1)]
        total, last = sum(weights), len(self.places) - 1
        for i in range(len(self.places)):
            near = [self.places[min(max(i + k, 0), last)] for k in range(-reach, reach + 1)]
            yield (sum(w * p[0] for w, p in zip(weights, near)) / total,
                   sum(w * p[1] for w, p in zip(weights, near)) / total)

    def events(self):
        """Time and place of what a mouse tells."""
        told, due = [], 0.0
        for now, place in enumerate(self.lagging()):
            if now < due and now + 1 < len(self.places):
                continue
            due = now + self.every
            if self.rng.random() < self.dips:
                due += self.rng.uniform(30, 70)
            at = []
            for axis in range(2):
                off = sum(a * math.sin(math.tau * f * now + phase)
                          for a, f, phase in self.waves[axis])
                value = place[axis] + off + self.rng.gauss(0, self.noise)
                at.append(round(round(value / self.grid) * self.grid, 1))
            if not told or told[-1][1] != at:
                told.append((now, at))
        return told
