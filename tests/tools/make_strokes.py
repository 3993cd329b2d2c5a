#!/usr/bin/env python3
"""Writes the replay scripts of tst_strokes (tests/data/strokes/stroke_*.json).

A script is made of a body, a rectangle of 480 x 300 px drawn from the front, and what is done with
it. Run it from the repository's root after a change; the scripts are kept under version control, so
that a test never depends on this.
"""
import json
import math
import os

FOLDER = os.path.join(os.path.dirname(__file__), "..", "data", "strokes")
TURN = 800  # ms


class Script:
    def __init__(self, viewport=(1280, 800)):
        self.viewport = list(viewport)
        self.events = []
        self.at = (0.0, 0.0)

    def add(self, **event):
        self.events.append(event)
        return self

    def view(self, name):
        return self.add(type="view", name=name)

    def command(self, name, **parameters):
        return self.add(type="command", name=name, parameters=parameters)

    def key(self, key, *modifiers):
        return self.add(type="key", key=key, modifiers=list(modifiers))

    def wait(self, ms):
        return self.add(type="wait", ms=ms)

    def wheel(self, x, y, steps):
        return self.add(type="wheel", x=x, y=y, steps=steps)

    def pointer(self, kind, x, y, modifiers=(), **more):
        event = dict(type=kind, x=round(x, 3), y=round(y, 3), **more)
        if modifiers:
            event["modifiers"] = list(modifiers)
        self.events.append(event)
        self.at = (x, y)
        return self

    def press(self, x, y, *modifiers, **more):
        return self.pointer("press", x, y, modifiers, **more)

    def release(self, *modifiers):
        return self.pointer("release", *self.at, modifiers)

    def click(self, x, y, *modifiers):
        return self.press(x, y, *modifiers).release(*modifiers)

    def to(self, *points, step=12.0, modifiers=()):
        for x, y in points:
            x0, y0 = self.at
            count = max(1, round(math.hypot(x - x0, y - y0) / step))
            for i in range(1, count + 1):
                self.pointer("move", x0 + (x - x0) * i / count, y0 + (y - y0) * i / count,
                             modifiers)
        return self

    def by(self, *ways, **more):
        x, y = self.at
        return self.to(*((x + dx, y + dy) for dx, dy in ways), **more)

    def arc(self, centre, radius, start, end, count):
        for i in range(count + 1):
            angle = math.radians(start + (end - start) * i / count)
            self.pointer("move", centre[0] + radius * math.cos(angle),
                         centre[1] + radius * math.sin(angle))
        return self

    def body(self):
        return (self.view("front").press(400, 260).to((880, 260), (880, 560), (400, 560),
                                                     (400, 268)).release())

    def slit(self, start, end, wait=TURN):
        """Presses inside of the body, drags out of it and waits until the view has just turned.

        One move leaves the body, so that the turn begins with it and ends with the wait.
        """
        inside = tuple(a + 0.3 * (b - a) for a, b in zip(start, end))
        return self.press(*start).to(inside).to(end, step=10000).wait(wait)

    def blob(self, size=110):
        """From where the cursor is, about as large to all sides."""
        return self.by((size, 0.4 * size), (size, -0.6 * size), (-0.5 * size, -size),
                       (-size, 0.3 * size), (-0.6 * size, size))

    def save(self, name):
        events = ",\n    ".join(json.dumps(e) for e in self.events)
        text = '{"viewport": %s, "events": [\n    %s\n]}\n' % (json.dumps(self.viewport), events)
        with open(os.path.join(FOLDER, "stroke_%s.json" % name), "w") as file:
            file.write(text)


def body():
    return Script().body()


def plain():
    return body().command("section.symmetry", on=False)


def mirrored(reach, *modifiers):
    """Up out of the body; 10 px to the left of the slit's axis, `reach` px to the right."""
    script = body().slit((640, 400), (640, 230))
    return script.to((630, 190), (640 + reach, 250), (640 + reach, 350), (632, 420),
                     modifiers=modifiers).release(*modifiers)


def main():
    up, over = (640, 400), (640, 200)

    # A slit out of each side, slanted, and from other views.
    for name, start, end in (("slit_right", (700, 400), (940, 400)),
                             ("slit_left", (560, 400), (340, 400)),
                             ("slit_up", up, over),
                             ("slit_down", (640, 450), (640, 610)),
                             ("slit_slanted", (600, 450), (520, 210))):
        body().slit(start, end).blob().release().save(name)
    body().view("back").slit(up, over).blob().release().save("slit_from_behind")
    body().view("iso1").slit((640, 400), (640, 120)).blob().release().save("slit_from_a_corner")
    body().press(*up).to(over, step=1000).wait(TURN).blob().release().save("slit_in_one_jump")
    moving = body().press(*up).to(over, step=5)
    moving.by((60, -30), (-40, 50), step=4).wait(TURN).blob().release().save("moves_in_the_turn")
    # Slit and outline in one go.
    hasty = body().press(*up).to(over, step=20)
    hasty.blob(130).release().wait(TURN).save("in_haste")
    hasty = body().press(640, 400).to((640, 230), step=20)
    hasty.to((660, 170), (740, 200), (760, 300), (720, 390), (641, 420)).release()
    hasty.wait(TURN).save("in_haste_mirrored")

    # Through a hole.
    hole = body().click(480, 320).command("section.addHole").wait(TURN)
    hole.press(600, 370).to((680, 370), (680, 450), (600, 450), (600, 378)).release().wait(50)
    hole.slit((520, 410), (640, 410)).blob(150).release().save("hole_is_left_into")
    jump = body().click(480, 320).command("section.addHole").wait(TURN)
    jump.press(600, 370).to((680, 370), (680, 450), (600, 450), (600, 378)).release().wait(50)
    jump.press(520, 410).to((760, 410), step=500).wait(TURN).blob(150).release()
    jump.save("hole_is_jumped_over")

    # What comes to nothing, or nearly.
    body().press(640, 400).release().save("press_without_drag")
    body().press(640, 400).to((643, 402), step=1).release().save("drag_below_the_threshold")
    body().slit(up, over).by((36, 0), (36, 2), step=1).release().save("tiny_contour")
    body().slit(up, over).to((760, 200), (700, 200)).release().save("there_and_back")
    plain().slit(up, over).to((760, 100), (900, 300), (720, 330), (900, 90),
                             (760, 360)).release().save("self_crossing")
    leaving = plain().slit(up, over)
    leaving.to((900, 100), (1400, -80), (1500, 600), (760, 420)).release()
    leaving.save("leaves_the_window")
    outside = body().view("front").press(*up).to((640, -300), step=10000).wait(TURN)
    outside.blob(150).release().save("slit_leaves_the_window")

    # Local symmetry.
    mirrored(61).save("mirrored_at_6_1")
    mirrored(59).save("starts_past_the_axis")
    mirrored(61, "shift").save("shift_keeps_one_side")
    off = body().command("section.symmetry", on=False).slit((640, 400), (640, 230))
    off.to((630, 190), (701, 250), (701, 350), (632, 420)).release().save("symmetry_is_off")
    first = Script().view("front").press(640, 300, "shift")
    first.to((760, 340), (740, 480), (640, 520), modifiers=("shift",)).release("shift")
    first.save("first_mirrored_by_shift")
    deep = body().slit((640, 500), (640, 580))
    deep.to((700, 500), (820, 560), (820, 640), (650, 650)).release().save("mirrored_downwards")

    # Other views.
    for name, steps, end in (("zoomed_in", 3, (640, 20)), ("zoomed_out", -4, over)):
        body().wheel(640, 400, steps).slit(up, end).blob().release().save(name)
    body().wheel(640, 260, 6).slit((640, 400), (640, 120)).blob().release().save("zoomed_close")
    perspective = body().command("view.perspective", on=True)
    perspective.slit(up, over).blob().release().save("perspective")
    perspective = body().command("view.perspective", on=True).view("iso2")
    perspective.slit((640, 400), (640, 100)).blob().release().save("perspective_from_a_corner")
    edge = body().wheel(1200, 700, -3)
    edge.slit((980, 560), (980, 400))
    edge.wait(1500).blob(80).release().save("room_is_made")

    # Undo and Esc in the middle of each phase.
    phases = {"slit": lambda s: s.press(*up).to((640, 330)),
              "turn": lambda s: s.slit(up, over, wait=300),
              "dead_zone": lambda s: s.slit(up, over).by((5, 5)),
              "contour": lambda s: s.slit(up, over).blob()}
    for phase, go in phases.items():
        go(body()).key("Escape").by((20, 20)).release().save("escape_in_" + phase)
        go(body()).key("Z", "control").by((20, 20)).release().save("undo_in_" + phase)

    # The ground.
    def leg():
        script = body().slit((640, 500), (640, 600))
        return script.to((720, 560), (760, 700), (800, 1100), (560, 1100), (600, 640)).release()
    leg().save("cut_at_the_ground")
    off = body().command("section.ground", on=False).slit((640, 500), (640, 600))
    off.to((720, 560), (760, 700), (800, 1100), (560, 1100), (600, 640)).release()
    off.save("below_the_ground_on_purpose")
    under = body().click(480, 320).command("section.planeFront").wait(TURN)
    under.press(560, 1000).to((760, 1000), (760, 1200), (560, 1200), (560, 1010)).release()
    under.save("all_below_the_ground")

    # Canvases that were asked for.
    for plane in ("Ground", "Front", "Side"):
        script = body().command("section.plane" + plane).wait(TURN)
        script.press(600, 360).to((700, 360), (700, 460), (600, 460), (600, 368)).release()
        script.save("plane_" + plane.lower())
    script = body().click(640, 400).command("section.planeParallel", distance=25.4).wait(TURN)
    script.press(560, 350).to((700, 350), (700, 460), (560, 460), (560, 358)).release()
    script.save("plane_parallel")
    script = body().click(640, 400).command("section.redraw").wait(TURN)
    script.press(440, 300).to((840, 300), (800, 520), (440, 520), (440, 308)).release()
    script.save("redrawn")
    for name, points in (("hole", ((560, 350), (700, 350), (700, 460), (560, 460), (560, 358))),
                         ("hole_outside", ((900, 350), (990, 350), (990, 460), (900, 460),
                                           (900, 358))),
                         ("hole_over_the_edge", ((820, 350), (950, 350), (950, 460), (820, 460),
                                                 (820, 358)))):
        script = body().click(640, 400).command("section.addHole").wait(TURN)
        script.press(*points[0]).to(*points[1:]).release().save(name)

    # Shapes with a known answer, on the canvas of a slit.
    plain().slit(up, over).to((900, 200), (900, 420), (672, 420), (672, 208)).release().save(
        "rectangle")
    plain().slit(up, over).arc((782, 200), 110, 180, 538, 160).release().save("circle")
    # Ends that go too far, stop short or hook back; what is offered, and what is too small.
    star = [(782 + r * math.cos(a), 200 + r * math.sin(a)) for k in range(11)
            for r, a in [((150 if k % 2 == 0 else 66), math.pi * (1 + k / 5))]]
    for name, end in (("spiky_overshot", (star[10][0] - 28, star[10][1] - 9)),
                      ("spiky_short", tuple(0.75 * a + 0.25 * b
                                            for a, b in zip(star[10], star[9]))),
                      ("spiky_hooked", (star[10][0] + 12, star[10][1] + 22))):
        script = plain().slit(up, over).to(star[0], *star[1:10], step=5)
        if name != "spiky_short":
            script.to(star[10], step=5)
        script.to(end, step=5).release().save(name)
    plain().slit(up, over).arc((782, 200), 110, 180, 560, 120).release().save("circle_overshot")
    plain().slit(up, over).arc((782, 200), 110, 180, 560, 120).release().key("B").save(
        "circle_taken")
    script = plain().slit(up, over).arc((782, 200), 110, 180, 560, 120).release().key("B")
    script.wait(50).key("Z", "control").save("circle_taken_back")
    plain().slit(up, over).arc((782, 200), 110, 180, 540, 9).release().save("circle_in_a_moment")
    script = body().click(480, 320).command("section.addHole").wait(TURN)
    script.press(605, 400).arc((600, 400), 5, 0, 370, 18).release().save("eye")
    body().slit(up, over).by((36, 0), (22, 6), step=2).release().save("twitch")
    body().view("front").click(640, 400).command("view.top").wait(500).command(
        "view.previous").wait(500).save("previous_view")
    band = body().press(380, 240, "shift").to((900, 580), modifiers=("shift",)).release("shift")
    band.save("rubber_band")
    script = body().command("section.dropToGround")
    script.save("dropped_to_the_ground")


if __name__ == "__main__":
    main()
