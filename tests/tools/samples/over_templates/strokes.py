"""What a person does in the window, written down for `replay`."""

import json

VIEWPORT = (1280, 800)
FILLED = 0.84  # of the view, by what is fitted into it


class Script:
    """Looks from the front at something so wide and high, mm, that stands on the ground above the origin. Places are
    mm in the plane of the front, from the origin."""

    def __init__(self, size):
        self.events = []
        self.middle = (0.0, 0.5 * size[1])
        self.scale = max(mm / (FILLED * px) for mm, px in zip(size, VIEWPORT))

    def look(self):
        self.events += [{"type": "view", "name": "front"}, {"type": "view", "name": "fit"}]

    def command(self, name, **parameters):
        self.events.append({"type": "command", "name": name, "parameters": parameters})

    def wait(self, ms):
        self.events.append({"type": "wait", "ms": ms})

    def pointer(self, kind, place):
        x = 0.5 * VIEWPORT[0] + (place[0] - self.middle[0]) / self.scale
        y = 0.5 * VIEWPORT[1] - (place[1] - self.middle[1]) / self.scale
        self.events.append({"type": kind, "x": round(x, 2), "y": round(y, 2)})

    def whole(self, plane):
        """All that a plane of the world cuts."""
        self.command("section.plane" + plane)
        self.wait(1000)
        self.command("section.takeGuide")
        self.wait(1000)

    def across(self, start, end):
        """From inside a section over its edge; then the whole guide of the plane that stands on it there."""
        self.look()
        self.pointer("press", start)
        for i in range(1, 21):
            self.pointer("move", [a + (b - a) * i / 20 for a, b in zip(start, end)])
        self.wait(2000)
        self.command("section.takeGuide")
        self.pointer("release", end)
        self.wait(2000)

    def text(self):
        return json.dumps({"viewport": VIEWPORT, "events": self.events}, indent=1) + "\n"
