# SPDX-License-Identifier: MIT
"""Pages in Debian's chromium, without a window, drawing by software: what is seen, and what a user
does by mouse, finger and keys."""
import json
import os
import time

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    MISSING = "" if os.path.exists("/usr/bin/chromedriver") else "chromium-driver"
except ImportError:
    MISSING = "python3-selenium"

SECONDS = 60 # after which a page or a script counts as hanging
FLAGS = ("--headless=new", "--no-sandbox", "--hide-scrollbars", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--force-color-profile=srgb", "--disable-dev-shm-usage")


class Browser:
    """A browser of its own, closed at the end of `with`."""

    def __init__(self, *flags, width=1200, height=850, preferences=None, touch=False):
        options = Options()
        for flag in (*FLAGS, *flags, f"--window-size={width},{height}"):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        if preferences:
            options.add_experimental_option("prefs", preferences)
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.driver.set_page_load_timeout(SECONDS)
        self.driver.set_script_timeout(SECONDS)
        if width < 500 or touch: # windows are not that narrow
            self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                "width": width, "height": height, "deviceScaleFactor": 1, "mobile": touch})
        if touch:
            self.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def state(self):
        return self.run("return document.body.dataset.state")

    def open(self, path, state="ready", seconds=SECONDS):
        self.driver.get(f"file://{path}")
        self.wait(lambda: self.state() == state, seconds)
        if state == "ready":
            self.frames(seconds)

    def wait(self, is_so, seconds=20):
        deadline = time.monotonic() + seconds
        while not is_so():
            if time.monotonic() > deadline:
                raise TimeoutError(f"the page does not get there: {self.state()}, "
                                   f"{self.text('message')}")
            time.sleep(0.02)

    def frames(self, seconds=20):
        """Waits for what was asked for to be drawn, and finely unless steps are played."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => "
            "requestAnimationFrame(done)))")
        self.wait(lambda: self.run(
            "return document.getElementById('canvas').dataset.drawing !== 'coarse' || "
            "document.getElementById('play').textContent.includes('Pause')"), seconds)

    def run_after_frames(self, script, then):
        """What is found right after what a script asks for is drawn; then waits as `frames` does."""
        found = self.driver.execute_async_script(
            script + f"; const done = arguments[0]; requestAnimationFrame(() => "
            f"requestAnimationFrame(() => done((() => {{ {then} }})())))")
        self.frames()
        return found

    def set(self, **controls):
        self.run("""for (const [id, value] of Object.entries(arguments[0])) {
            const control = document.getElementById(id);
            if (typeof value === "boolean") control.checked = value;
            else control.value = String(value);
            control.dispatchEvent(new Event("input", {bubbles: true}));
        }""", controls)
        self.frames()

    def plain(self):
        """Nothing but the colors of values."""
        self.set(shade=False, edges=False, removed=False, dual=False, levels=False, arrows=False,
                 flow=False)

    def text(self, identity):
        return self.run("return document.getElementById(arguments[0])?.textContent", identity)

    def pixel(self, x, y):
        """Of the canvas, counted from its left upper corner: red, green, blue."""
        return tuple(self.run("""
            const canvas = document.getElementById("canvas"), gl = canvas.getContext("webgl2");
            const pixel = canvas.width / canvas.clientWidth, color = new Uint8Array(4);
            gl.readPixels((arguments[0] + .5) * pixel, canvas.height - (arguments[1] + .5) * pixel,
                1, 1, gl.RGBA, gl.UNSIGNED_BYTE, color);
            return [...color].slice(0, 3);""", x, y))

    def picture(self):
        """All of the canvas, as bytes of a PNG in base64."""
        return self.run("return document.getElementById('canvas').toDataURL()")

    def size(self):
        return self.run("const c = document.getElementById('canvas'); "
                        "return [c.clientWidth, c.clientHeight]")

    def spots(self, count=5):
        """Places all over the canvas."""
        width, height = self.size()
        return [(width * (i + 1) // (count + 1), height * (j + 1) // (count + 1))
                for i in range(count) for j in range(count)]

    def click(self, x, y):
        """On the canvas; what is picked then, by name, or None."""
        width, height = self.size()
        canvas = self.driver.find_element("id", "canvas")
        self.run("arguments[0].scrollIntoView({block: 'center'})", canvas)
        ActionChains(self.driver, duration=0).move_to_element_with_offset(
            canvas, x - width // 2, y - height // 2).click().perform()
        return self.picked()

    def picked(self):
        found = self.run("const p = document.getElementById('picked'); "
                         "return p.hidden ? null : {...p.dataset}")
        return found and {name: float(value) for name, value in found.items() if value}

    def keys(self, *keys):
        ActionChains(self.driver, duration=0).send_keys(*keys).perform()
        self.frames()

    def complaints(self):
        """What the console says, but of graphics in software."""
        return [entry["message"] for entry in self.driver.get_log("browser")
                if "GPU stall" not in entry["message"]]

    def requests(self):
        """Addresses that were asked for."""
        events = [json.loads(entry["message"])["message"]
                  for entry in self.driver.get_log("performance")]
        return [event["params"]["request"]["url"] for event in events
                if event["method"] == "Network.requestWillBeSent"]
