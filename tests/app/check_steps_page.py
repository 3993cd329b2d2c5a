#!/usr/bin/env python3
"""The page of steps in a real browser, from a file and without a network: check_steps_page.py CLI MODEL CHROMIUM [PICTURES]

PICTURES: a folder for what was seen, to be looked at."""
import json
import pathlib
import subprocess
import sys
import tempfile

from browser import Browser

SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
MOST_BYTES = 2_000_000  # of the model's page: what a phone gets by mail
EVIL = "</script><script>document.title = 'harmed'</script><img src=x onerror=\"document.title='harmed'\">"
SCREENS = {"desk": (1280, 800, 1, False), "phone": (390, 844, 2, True), "narrow": (360, 640, 2, True)}


class Check:
    def __init__(self, browser, pictures):
        self.browser, self.pictures, self.faults = browser, pictures, []

    def that(self, holds, sentence):
        if not holds:
            self.faults.append(sentence)

    def quiet(self, where):
        for complaint in self.browser.complaints():
            self.faults.append(f"{where}: the page is not quiet: {complaint}")

    def keep(self, name):
        if self.pictures:
            (self.pictures / f"{name}.png").write_bytes(self.browser.picture().png)

    def stage(self):
        self.browser.rest_a_while()
        return self.browser.picture(self.browser.box("#stage"))

    def title(self):
        return self.browser.run("document.getElementById('step-title').textContent")

    def slide(self, time):
        self.browser.run(f"(s => {{ s.value = {time}; s.dispatchEvent(new Event('input', {{bubbles: true}})); }})"
                         "(document.getElementById('time'))")


def steps_are_gone_through(check, count):
    browser = check.browser
    finished = check.stage()
    check.that(check.title() == "Finished", f"the page begins with {check.title()}")
    check.slide(count // 2 + 0.4)
    check.that(check.title() == f"Step {count // 2 + 1} of {count}", f"the slider leads to {check.title()}")
    check.that(browser.run("document.querySelectorAll('tr.is-moving').length") > 0, "the list does not show which part moves")
    middle = check.stage()
    check.that(finished.differing(middle) > 500, "the slider changes nothing to see")
    check.slide(count // 2 + 0.6)
    check.that(middle.differing(check.stage()) > 20, "a part does not move within its step")
    browser.key("ArrowRight")
    browser.until(f"Number(document.getElementById('time').value) === {count // 2 + 1}")
    browser.key("ArrowLeft")
    browser.until(f"Number(document.getElementById('time').value) === {count // 2}")
    browser.click("#next")
    browser.until(f"Number(document.getElementById('time').value) === {count // 2 + 1}")
    browser.click("#play")
    browser.until(f"Number(document.getElementById('time').value) > {count // 2 + 1.2}")
    check.that(browser.run("document.getElementById('play').title") == "Pause", "the button does not say that it pauses")
    browser.click("#play")
    still = browser.run("document.getElementById('time').value")
    browser.rest_a_while()
    check.that(still == browser.run("document.getElementById('time').value"), "it cannot be paused")


def tap_twice(browser, is_phone):
    browser.pause(1.0)
    for _ in range(2):
        if is_phone:
            browser.fingers("touchStart", browser.middle("#stage"))
            browser.fingers("touchEnd")
        else:
            browser.click("#stage")


def the_model_turns(check, is_phone):
    browser = check.browser
    check.slide(10_000)
    tap_twice(browser, is_phone)  # and what to do with fingers need not be said any more
    browser.until("getComputedStyle(document.getElementById('hint')).opacity === '0'")
    before = check.stage()
    x, y = browser.middle("#stage")
    if is_phone:
        browser.fingers("touchStart", (x, y))
        for step in range(1, 9):
            browser.fingers("touchMove", (x + 10 * step, y + 3 * step))
        browser.fingers("touchEnd")
    else:
        browser.mouse("mousePressed", x, y)
        for step in range(1, 9):
            browser.mouse("mouseMoved", x + 10 * step, y + 3 * step)
        browser.mouse("mouseReleased", x + 80, y + 24)
    turned = check.stage()
    check.that(before.differing(turned) > 500, "dragging does not turn the model")
    if is_phone:
        browser.fingers("touchStart", (x - 30, y), (x + 30, y))
        for step in range(1, 9):
            browser.fingers("touchMove", (x - 30 - 5 * step, y), (x + 30 + 5 * step, y))
        browser.fingers("touchEnd")
    else:
        browser.ask("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-300)
    nearer = check.stage()
    check.that(turned.differing(nearer) > 500, "two fingers or the wheel do not zoom")
    check.that(browser.run("scrollY") == 0, "the page scrolls under the fingers")
    tap_twice(browser, is_phone)
    check.that(before.differing(check.stage()) < 50, "two taps do not lead back")


def with_a_model(program, page, count, pictures):
    faults = []
    browser = Browser(program, *SOFTWARE)
    try:
        for name, (width, height, ratio, is_phone) in SCREENS.items():
            for is_dark in (False, True):
                check = Check(browser, pictures)
                where = f"{name}{'-dark' if is_dark else ''}"
                browser.screen(width, height, ratio, is_phone, is_dark)
                browser.open(page)
                check.that(browser.run("document.title") == page.stem, "the title is not the model's name")
                check.that(browser.run("getComputedStyle(document.getElementById('pictures')).display") == "none",
                           "pictures are shown beside the model")
                check.that(browser.run("document.documentElement.scrollWidth") <= width, "the page is wider than the screen")
                check.that(browser.run("document.querySelectorAll('#parts tbody tr').length") == count, "parts are missing in the list")
                check.keep(f"{where}-finished")
                if is_dark:
                    check.slide(count // 2 + 0.4)
                else:
                    steps_are_gone_through(check, count)
                browser.rest_a_while()
                check.keep(f"{where}-step")
                if not is_dark:
                    the_model_turns(check, is_phone)
                check.quiet("with WebGL")
                faults += [f"{where}: {fault}" for fault in check.faults]
    finally:
        browser.close()
    return faults


def without_webgl(program, page, count, pictures):
    browser = Browser(program, "--disable-3d-apis")
    check = Check(browser, pictures)
    try:
        for is_scripted in (True, False):
            browser.screen(390, 844, 2, True)
            browser.ask("Emulation.setScriptExecutionDisabled", value=not is_scripted)
            browser.ask("Page.navigate", url="about:blank")
            browser.open(page) if is_scripted else browser.show(page)
            where = "without WebGL" if is_scripted else "without scripts"
            if is_scripted:
                check.that(browser.run("document.getElementById('viewer').hidden"), "an empty stage is shown " + where)
                check.that(browser.run("[...document.images].filter(i => i.naturalWidth > 0 && i.getBoundingClientRect().height > 0).length")
                           == count, "pictures are missing " + where)
            seen = browser.picture((0, 0, 390, 844))
            colours = {seen.pixel(x, y) for y in range(seen.height) for x in range(seen.width)}
            check.that(len(colours) > 200, "no pictures are to be seen " + where)
            check.keep(where.replace(" ", "-"))
            check.quiet(where)
    finally:
        browser.close()
    return check.faults


def with_evil_names(cli, model, program, folder):
    document = json.loads(model.read_text())
    for section in document["sections"]:
        section["name"] = EVIL
    source, page = folder / "evil.fff", folder / "evil.html"
    source.write_text(json.dumps(document))
    subprocess.run([cli, "steps", source, "-o", page], check=True)
    browser = Browser(program, *SOFTWARE)
    check = Check(browser, None)
    try:
        browser.screen(1280, 800)
        browser.open(page)
        check.that(browser.run("document.title") == "evil", "a name of a section was run as code")
        check.that(browser.run("document.querySelector('#parts td:nth-child(2)').textContent") == EVIL, "a name is not shown as it is")
        check.quiet("with evil names")
    finally:
        browser.close()
    return check.faults


def main(cli, model, program, pictures=None):
    model, pictures = pathlib.Path(model), pictures and pathlib.Path(pictures)
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        page = folder / (model.stem + ".html")
        subprocess.run([cli, "steps", model, "-o", page], check=True)
        faults = []
        if page.stat().st_size >= MOST_BYTES:
            faults.append(f"the page has {page.stat().st_size} bytes")
        count = len(json.loads(subprocess.run([cli, "parts", model, "--json"], capture_output=True, check=True).stdout)["parts"])
        faults += with_a_model(program, page, count, pictures)
        faults += without_webgl(program, page, count, pictures)
        faults += with_evil_names(cli, model, program, folder)
        print("\n".join(faults) if faults else f"{page.name}: {page.stat().st_size} bytes, {count} parts; it works")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
