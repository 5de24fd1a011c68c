# SPDX-License-Identifier: GPL-2.0-or-later
"""Headless Chromium for the tests of the pages."""

import base64
import shutil
import sys
import tempfile


def fail(line):
    """Ends the test with one line that says why."""
    sys.exit("FAILED: " + line)


try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    fail("no Python package selenium: install python3-selenium (docker/packages-tests.txt)")

SWITCHES = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync
--disable-dev-shm-usage""".split()


def require_browser():
    """Fails where there is no browser; returns its program and its driver's."""
    programs = shutil.which("chromium"), shutil.which("chromedriver")
    if None in programs:
        fail("no browser: install chromium and chromium-driver (docker/packages-tests.txt)")
    return programs


class Browser:
    """A browser with a fresh profile; `with Browser() as browser` ends it."""

    def __enter__(self):
        chromium, driver = require_browser()
        self.profile = tempfile.mkdtemp(prefix="rodpack-browser-")
        options = webdriver.ChromeOptions()
        options.binary_location = chromium
        for switch in SWITCHES + ["--user-data-dir=" + self.profile]:
            options.add_argument(switch)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(driver), options=options)
        return self

    def __exit__(self, *_):
        self.driver.quit()
        shutil.rmtree(self.profile, ignore_errors=True)

    def open(self, file, width, height):
        """Opens a file in a window whose page is so many pixels wide and high."""
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500})
        self.driver.get("file://" + str(file))

    def run(self, script, *arguments):
        """What a JavaScript function body returns."""
        return self.driver.execute_script(script, *arguments)

    def command(self, name, **parameters):
        """A command of the browser's own protocol."""
        return self.driver.execute_cdp_cmd(name, parameters)

    def mouse(self, kind, x, y, **more):
        """A mouse event at a place of the window, pixels."""
        self.command("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)

    def console(self):
        """Messages since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def print_pdf(self, file):
        pdf = base64.b64decode(self.command("Page.printToPDF", preferCSSPageSize=True)["data"])
        file.write_bytes(pdf)
        return pdf
