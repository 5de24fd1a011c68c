# SPDX-License-Identifier: GPL-2.0-or-later
"""Usage: report_browser.py RODPACK EXAMPLE FOLDER

Makes the reports of a made-up run and study in FOLDER, opens them in headless Chromium from their
files, and checks that they are shown without errors, that packings are zoomed and moved, and that
they answer what the dumps hold."""

import math
import pathlib
import shutil
import subprocess
import sys

from browser import Browser, fail, require_browser

VIEWER = "const viewer = document.querySelector('.viewer').viewer; "


def check(holds, line):
    if not holds:
        fail(line)


def rows_of(dump):
    """Rows of a dump of one frame, as dictionaries of numbers."""
    lines = dump.read_text().splitlines()
    head = next(k for k, line in enumerate(lines) if line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES")))
    names = lines[head].split()[2:]
    return [dict(zip(names, map(float, line.split()))) for line in lines[head + 1:]]


def last_dump(run, kind):
    return max((run / "dumps").glob(kind + ".*.dump"), key=lambda file: int(file.name.split(".")[1]))


def silent(browser):
    messages = browser.console()
    check(messages == [], f"in the console: {messages}")


def shows_without_errors(browser):
    silent(browser)
    pictures = browser.run("return [...document.images].map(i => [i.alt, i.complete, i.naturalWidth])")
    check(len(pictures) > 10, f"expected the figures of the analysis, found {len(pictures)}")
    for alt, complete, width in pictures:
        check(complete and width > 0, f"the figure '{alt}' is not shown")


def place_on_screen(browser, particle):
    """Where a particle's centre is in the window, pixels; `particle`: counted from 0."""
    return browser.run(VIEWER + """
        viewer.canvas.scrollIntoView({ block: 'center' });
        const box = viewer.canvas.getBoundingClientRect();
        const [x, y] = viewer.view.toScreen(viewer.packing.x[arguments[0]], viewer.packing.y[arguments[0]]);
        return [box.left + x, box.top + y];""", particle)


def scale(browser):
    return browser.run(VIEWER + "return viewer.view.scale;")


def dark_pixels(browser):
    """Pixels of the canvas that are not white: the packing is drawn."""
    return browser.run(VIEWER + """
        viewer.drawNow();
        const { width, height } = viewer.canvas;
        const data = viewer.canvas.getContext('2d').getImageData(0, 0, width, height).data;
        let count = 0;
        for (let k = 0; k < data.length; k += 4) if (data[k] < 200) ++count;
        return count / (width * height);""")


def zooms_and_moves(browser):
    check(dark_pixels(browser) > 0.3, "the packing is not drawn")
    fitted = scale(browser)
    before = place_on_screen(browser, 150)
    browser.mouse("mouseWheel", *before, deltaX=0, deltaY=-240)
    check(scale(browser) > 1.5 * fitted, "the wheel does not zoom in")
    after = place_on_screen(browser, 150)
    check(math.dist(before, after) < 1, "what is below the pointer does not stay there when zoomed")
    wheeled = scale(browser)
    browser.run("document.querySelector('[data-do=in]').click()")
    check(math.isclose(scale(browser), 1.5 * wheeled), "the button does not zoom in")

    x, y = browser.run(VIEWER + """const box = viewer.canvas.getBoundingClientRect();
        return [box.left + box.width / 2, box.top + box.height / 2];""")
    view = browser.run(VIEWER + "return [viewer.view.x, viewer.view.y, viewer.view.scale];")
    browser.mouse("mousePressed", x, y, button="left", clickCount=1)
    browser.mouse("mouseMoved", x + 30, y, button="left", buttons=1)
    browser.mouse("mouseMoved", x + 60, y - 20, button="left", buttons=1)
    browser.mouse("mouseReleased", x + 60, y - 20, button="left", clickCount=1)
    moved = browser.run(VIEWER + "return [viewer.view.x, viewer.view.y];")
    check(math.isclose(moved[0], view[0] - 60 / view[2], rel_tol=1e-6)
          and math.isclose(moved[1], view[1] - 20 / view[2], rel_tol=1e-6),
          f"dragging by 60 and 20 pixels moves the view from {view} to {moved}")
    check(browser.run(VIEWER + "return viewer.chosen === null;"), "dragging chooses a particle")

    browser.run("document.querySelector('[data-do=fit]').click()")
    check(math.isclose(scale(browser), fitted), "'Show all' does not show all")
    browser.run(VIEWER + "viewer.canvas.focus(); viewer.canvas.dispatchEvent("
                "new KeyboardEvent('keydown', { key: '+', bubbles: true }));")
    check(scale(browser) > fitted, "the key + does not zoom in")
    browser.run(VIEWER + "viewer.act('fit');")


def details(browser):
    """What the panel says: heading, facts by name, and the list of contacts."""
    return browser.run("""
        const panel = document.querySelector('.viewer-details');
        const facts = {};
        for (const dt of panel.querySelectorAll('dt')) facts[dt.textContent] = dt.nextSibling.textContent;
        const rows = [...panel.querySelectorAll('tbody tr')].map(r => [...r.cells].map(c => c.textContent));
        return [panel.querySelector('h3').textContent, facts, rows];""")


def newtons(text):
    number, unit = text.split()
    return float(number) * {"N": 1, "mN": 1e-3, "µN": 1e-6, "nN": 1e-9, "pN": 1e-12}[unit]


def expected_contacts(contacts, particle):
    """Force by neighbour, N, the vectors of all contacts of a pair summed."""
    sums = {}
    for row in contacts:
        if particle in (row["body_i"], row["body_j"]) and not row["wall"]:
            sign = 1 if row["body_i"] == particle else -1
            other = row["body_j"] if row["body_i"] == particle else row["body_i"]
            x, y = sums.get(int(other), (0, 0))
            sums[int(other)] = (x + sign * row["fx"], y + sign * row["fy"])
    return {other: math.hypot(*force) for other, force in sums.items()}


def answers_what_the_dumps_hold(browser, run):
    bodies, contacts = rows_of(last_dump(run, "bodies")), rows_of(last_dump(run, "contacts"))
    for place in (7, 150, 261):
        body = bodies[place]
        browser.click(*place_on_screen(browser, place))
        heading, facts, rows = details(browser)
        check(heading == f"Particle {int(body['id'])}", f"clicked on particle {body['id']}, got '{heading}'")
        gamma = math.degrees(body["angle"]) % 180
        shown = float(facts["angle γ"].rstrip("°"))
        # One decimal is shown, of an angle that is kept to 0.006°.
        check(abs((shown - gamma + 90) % 180 - 90) < 0.056, f"expected the angle {gamma}°, found {shown}°")
        for name, coordinate in (("from the left wall", "x"), ("above the floor", "y")):
            millimetres = float(facts[name].split()[0])
            check(abs(millimetres - 1e3 * body[coordinate]) < 0.011, f"{coordinate}: {facts[name]}")
        expected = expected_contacts(contacts, body["id"])
        check(facts["touching neighbours"] == str(len(expected)), f"neighbours: {facts}, {expected}")
        check(len(expected) > 0 and {int(row[0]) for row in rows} == set(expected), f"neighbours: {rows}, {expected}")
        for row in rows:
            check(math.isclose(newtons(row[1]), expected[int(row[0])], rel_tol=6e-3), f"force: {row}, {expected}")
        check(math.isclose(newtons(facts["sum of contact forces"]), sum(expected.values()), rel_tol=6e-3),
              f"sum of forces: {facts}, {expected}")
    # From neighbour to neighbour, and by number.
    browser.run("document.querySelector('.viewer-details tbody button').click()")
    check(details(browser)[0] == "Particle " + rows[0][0], "a neighbour in the list cannot be chosen")
    browser.run("""const input = document.querySelector('.viewer input');
        input.value = 12; input.dispatchEvent(new Event('change'));""")
    check(details(browser)[0] == "Particle 12", "a particle cannot be chosen by its number")
    browser.run("""const input = document.querySelector('.viewer input');
        input.value = 99999; input.dispatchEvent(new Event('change'));""")
    check("no particle 99999" in browser.run("return document.querySelector('.viewer-details').textContent"),
          "an unknown number is not answered")


def fits_a_phone(browser, page):
    browser.open(page, 390, 844)
    width, wide = browser.run("return [document.documentElement.scrollWidth, document.documentElement.clientWidth]")
    check(width <= 390 and wide == 390, f"the page is {width} pixels wide in a window of 390")
    place = place_on_screen(browser, 150)
    touch = [{"x": place[0], "y": place[1]}]
    browser.command("Emulation.setTouchEmulationEnabled", enabled=True)
    browser.command("Input.dispatchTouchEvent", type="touchStart", touchPoints=touch)
    browser.command("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    check(details(browser)[0] == "Particle 151", "a tap does not choose a particle")
    fitted, (x, y) = scale(browser), place_on_screen(browser, 150)
    pinch = lambda kind, apart: browser.command("Input.dispatchTouchEvent", type=kind, touchPoints=[
        {"x": x - apart, "y": y, "id": 0}, {"x": x + apart, "y": y, "id": 1}])
    pinch("touchStart", 20)
    pinch("touchMove", 40)
    browser.command("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    check(scale(browser) > 1.5 * fitted, "two fingers do not zoom")
    browser.command("Emulation.setTouchEmulationEnabled", enabled=False)


def shows_every_case(browser, folder):
    """The study's page: the packing of the other case, whose particles are curved."""
    browser.open(folder / "report.html", 1280, 900)
    cases = browser.run("return [...document.querySelector('.viewer select').options].map(o => o.text)")
    check(cases == ["smooth-AR5, seed 1", "curved-AR5-theta60, seed 1"], f"packings to choose: {cases}")
    browser.run("""const select = document.querySelector('.viewer select');
        select.selectedIndex = 1; select.dispatchEvent(new Event('change'));""")
    check(dark_pixels(browser) > 0.3, "the second packing is not drawn")
    bodies = rows_of(last_dump(folder / "runs" / "curved-AR5-theta60" / "seed-1", "bodies"))
    upside_down = next(k for k, body in enumerate(bodies) if math.degrees(body["angle"]) > 185)
    browser.click(*place_on_screen(browser, upside_down))
    shown = float(details(browser)[1]["angle γ"].rstrip("°"))
    gamma = math.degrees(bodies[upside_down]["angle"]) % 360
    check(abs(shown - gamma) < 0.056, f"curved: expected the angle {gamma}°, found {shown}°")
    browser.open(folder / "report.html", 390, 844)
    width = browser.run("return document.documentElement.scrollWidth")
    check(width <= 390, f"the study's page is {width} pixels wide in a window of 390")


def prints(browser, folder):
    pdf = browser.print_pdf(folder / "report.pdf")
    check(pdf.startswith(b"%PDF") and len(pdf) > 50000, "the page cannot be printed")


def main():
    if len(sys.argv) != 4:
        sys.exit("usage: report_browser.py RODPACK EXAMPLE FOLDER")
    require_browser()
    rodpack, example, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    run = folder / "runs" / "smooth-AR5" / "seed-1"
    subprocess.run([example, folder], check=True)
    subprocess.run([rodpack, "analyse", run], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([rodpack, "report", folder], check=True, stdout=subprocess.DEVNULL)
    page = run / "analysis" / "report.html"
    with Browser() as browser:
        browser.open(page, 1280, 900)
        shows_without_errors(browser)
        zooms_and_moves(browser)
        answers_what_the_dumps_hold(browser, run)
        fits_a_phone(browser, page)
        prints(browser, folder)
        shows_every_case(browser, folder)
        silent(browser)
    print("the reports open and answer")


main()
