# SPDX-License-Identifier: MIT
"""Pages by other ways than a mouse on a desk: keys alone, fingers, a narrow screen, paper, and
browsers that cannot do all."""
import base64
import re

from browser_test import Browser, BrowserTest
from command import golden
from motions import pvd, vtu
from selenium.webdriver.common.keys import Keys

HOSTILE = "</script><script>document.title='bad'</script><img src=x onerror=document.title='bad'>"
FOCUS = "const e = document.activeElement; return e.id || e.dataset.field || e.tagName"

# Of every element with text of its own: how its color stands out from what is behind it.
CONTRASTS = """
const rgba = text => (text.match(/[\\d.]+/g) ?? []).map(Number);
const light = ([r, g, b]) => [r, g, b].map(x => x / 255)
    .map(x => x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4)
    .reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0);
const behind = e => {
    for (; e; e = e.parentElement) {
        const color = rgba(getComputedStyle(e).backgroundColor);
        if (color.length === 3 || color[3] > 0)
            return color;
    }
    return [255, 255, 255];
};
const hasText = e => [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim());
return [...document.querySelectorAll("body *")].filter(e => e.offsetHeight && hasText(e)).map(e => {
    const [a, b] = [light(rgba(getComputedStyle(e).color)), light(behind(e))];
    return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), `${e.tagName} ${e.textContent.slice(0, 30)}`];
});
"""


class Users(BrowserTest):
    """Each test opens one page, in a browser that all share unless it needs one of its own."""

    def modes(self, mesh="uv8.off", side="primal", degree=0):
        self.succeed("spectrum", golden(mesh), "--side", side, "--degree", degree, "--count", 3,
                     "-o", "a.html")
        return self.path("a.html")

    def series(self, steps=3):
        """A field that is `step` everywhere."""
        for step in range(steps):
            self.write(f"s{step}.vtu", vtu([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)], u=3 * [step]))
        self.write("s.pvd", pvd({step: f"s{step}.vtu" for step in range(steps)}))
        self.succeed("view", "s.pvd", "-o", "s.html")
        return self.path("s.html")

    # Keys

    def test_everything_is_reached_by_tab(self):
        self.browser.open(self.modes("kuhn3.nsc"))
        wanted = set(self.browser.run("""
            return [...document.querySelectorAll("button, select, input, #canvas, tr[data-field]")]
                .filter(e => e.offsetHeight).map(e => e.id || e.dataset.field)"""))
        self.assertLessEqual({"theme", "canvas", "field", "map", "edges", "axis", "cut", "0", "2"},
                             wanted)
        reached = set()
        for _ in range(len(wanted) + 3):
            self.browser.keys(Keys.TAB)
            reached.add(self.browser.run(FOCUS))
            self.assertGreaterEqual(self.browser.run("""
                const e = document.activeElement, s = getComputedStyle(e);
                return e === document.body ? 9 : parseFloat(s.outlineWidth) *
                    (s.outlineStyle !== "none")"""), 2, "the focus is seen")
        self.assertEqual(wanted - reached, set())
        self.browser.run("document.getElementById('map').tabIndex = -1; document.body.focus()")
        for _ in range(len(wanted) + 3):
            self.browser.keys(Keys.TAB)
            self.assertNotEqual(self.browser.run(FOCUS), "map")

    def test_keys_do_what_they_say(self):
        tab = self.browser
        tab.open(self.modes("kuhn3.nsc"))
        checked = "return document.getElementById(arguments[0]).checked"
        for key, switch in (("e", "edges"), ("d", "dual"), ("l", "levels"), ("s", "shade")):
            before = tab.run(checked, switch)
            tab.keys(key)
            self.assertEqual(tab.run(checked, switch), not before, switch)
            tab.keys(key)
            self.assertEqual(tab.run(checked, switch), before, switch)
        chosen = "return document.getElementById('field').value"
        before = tab.run(chosen)
        tab.keys("n")
        self.assertNotEqual(tab.run(chosen), before)
        self.assertEqual(tab.run("return document.querySelectorAll('tr[aria-selected=true]').length"),
                         1)
        tab.keys("c", Keys.ARROW_LEFT)
        self.assertEqual(tab.text("cut-at"), "99 %")

    def test_arrows_turn_and_enter_picks(self):
        tab = self.browser
        tab.open(self.modes())
        tab.run("document.getElementById('canvas').focus()")
        seen = {tab.picture()}
        for keys in ((Keys.ARROW_LEFT,), (Keys.ARROW_UP,), ("+",), ("-", "-"),
                     (Keys.SHIFT, Keys.ARROW_RIGHT, Keys.NULL)):
            tab.keys(*keys)
            seen.add(tab.picture())
        self.assertEqual(len(seen), 6)
        tab.keys("0")
        self.assertIn(tab.picture(), seen)
        tab.keys(Keys.ENTER)
        by_key = tab.picked()
        width, height = tab.size()
        self.assertEqual(by_key["cell"], tab.click(width // 2, height // 2)["cell"])
        tab.keys(Keys.ESCAPE)
        self.assertIsNone(tab.picked())

    def test_rows_of_the_table_choose_fields(self):
        tab = self.browser
        tab.open(self.modes())
        tab.run("document.querySelector('tr[data-field=\"1\"]').focus()")
        tab.keys(Keys.ARROW_DOWN, Keys.ENTER)
        self.assertEqual(tab.run("return document.getElementById('field').value"), "2")
        self.assertEqual(tab.text("legend-name"), "mode_2")

    def test_what_is_seen_is_said(self):
        tab = self.browser
        tab.open(self.modes())
        self.assertEqual(tab.run("""
            return [...document.querySelectorAll("#canvas, select, input, button, tr[data-field]")]
                .filter(e => e.offsetHeight && !(e.getAttribute("aria-label") || e.labels?.length ||
                    e.textContent.trim())).map(e => e.id)"""), [])
        self.assertIn("mode_1", tab.run(
            "return document.getElementById('canvas').getAttribute('aria-label')"))
        self.assertEqual(tab.run("return document.documentElement.lang"), "en")
        self.assertEqual(tab.run("""const ids = [...document.querySelectorAll("[id]")].map(e => e.id);
            return ids.filter((id, i) => ids.indexOf(id) !== i)"""), [])

    # Time

    def test_space_plays_and_pauses(self):
        tab = self.browser
        tab.open(self.series())
        step = "return document.getElementById('step').value"
        tab.run("document.getElementById('speed').value = 20")
        self.assertEqual(tab.run(step), "0")
        tab.keys(" ")
        tab.wait(lambda: tab.run(step) == "2")
        self.assertIn("Pause", tab.text("play"))
        tab.keys(" ")
        self.assertIn("Play", tab.text("play"))
        now = tab.run(step)
        tab.driver.find_element("id", "play").click()
        tab.wait(lambda: tab.run(step) != now)
        tab.driver.find_element("id", "play").click()
        self.assertIn("Play", tab.text("play"))
        kept = tab.run(step)
        tab.driver.execute_async_script("setTimeout(arguments[0], 300)")
        self.assertEqual(tab.run(step), kept)

    def test_nothing_moves_by_itself_where_that_is_not_wanted(self):
        tab = self.browser
        tab.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-reduced-motion", "value": "reduce"}]})
        self.addCleanup(tab.driver.execute_cdp_cmd, "Emulation.setEmulatedMedia", {"features": []})
        tab.open(self.series())
        tab.run("document.getElementById('speed').value = 20")
        tab.keys(" ")
        tab.driver.execute_async_script("setTimeout(arguments[0], 300)")
        self.assertEqual(tab.run("return document.getElementById('step').value"), "1")
        tab.keys(" ")
        self.assertEqual(tab.run("return document.getElementById('step').value"), "2")

    # Hostile input

    def test_names_stay_text(self):
        marks = "\u202e\u200f\"'&<b>"
        name = "<img src=x onerror=document.title='bad'>\"'&.off"
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(self.golden_text("uv8.off"))
        with open(self.path("a.obj"), "w", encoding="utf-8") as file:
            file.write(f"o {HOSTILE}{marks}\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng {HOSTILE}\nf 1 2 3\n")
        with open(self.series(), encoding="ascii"):
            text = self.read("s0.vtu").replace('Name="u"', 'Name="' + (HOSTILE + marks).replace(
                "&", "&amp;").replace("<", "&lt;").replace('"', "&quot;") + '"')
        with open(self.path("n.vtu"), "w", encoding="utf-8") as file:
            file.write(text)
        for mesh in (name, "a.obj", "n.vtu"):
            with self.subTest(mesh):
                self.succeed("view", mesh, "-o", "h.html")
                self.browser.open(self.path("h.html"))
                self.assertEqual(self.browser.run("return document.querySelectorAll('img:not(#still img)').length"), 0)
                self.assertEqual(self.browser.run("return document.scripts.length"), 3)
                self.assertNotEqual(self.browser.run("return document.title"), "bad")
                self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.run("return document.getElementById('field').options[1].text"),
                         HOSTILE + "\\u202e\\u200f\"'&<b> (vertex)")
        self.browser.open(self.path("s.html"))
        self.browser.run("document.body.insertAdjacentHTML('beforeend', arguments[0])", HOSTILE)
        self.assertEqual(self.browser.run("return document.querySelectorAll('img:not(#still img)').length"), 1)

    def golden_text(self, name):
        with open(golden(name), encoding="ascii") as file:
            return file.read()

    # Screens and fingers

    def test_a_phone_shows_all_and_two_fingers_zoom(self):
        with Browser(width=390, height=800, touch=True) as tab:
            tab.open(self.modes("kuhn3.nsc"))
            wide = "return document.documentElement.scrollWidth"
            self.assertLessEqual(tab.run(wide), 390)
            width, height = tab.size()
            self.assertGreater(width, 340)
            before = tab.picture()
            middle = self.middle(tab)
            self.touch(tab, [[middle], [(middle[0] + 60, middle[1])]])
            turned = tab.picture()
            self.assertNotEqual(turned, before)
            self.touch(tab, [[(middle[0] - 30, middle[1]), (middle[0] + 30, middle[1])],
                             [(middle[0] - 60, middle[1]), (middle[0] + 60, middle[1])]])
            self.assertNotEqual(tab.picture(), turned)
            self.assertIsNone(tab.picked())
            self.touch(tab, [[middle]])
            self.assertIsNotNone(tab.picked())
            self.assertLessEqual(tab.run(wide), 390)
            tab.run("document.querySelector('h1').style.minWidth = '500px'")
            self.assertGreater(tab.run(wide), 390)

    def middle(self, tab):
        return tab.run("const b = document.getElementById('canvas').getBoundingClientRect(); "
                       "return [b.left + b.width / 2, b.top + b.height / 2]")

    def touch(self, tab, stages):
        """Fingers at the places of the first stage, then at those of the next ones, then none."""
        for kind, places in [("touchStart", stages[0]), *[("touchMove", s) for s in stages[1:]],
                             ("touchEnd", [])]:
            tab.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": kind, "touchPoints": [{"x": x, "y": y, "id": i}
                                              for i, (x, y) in enumerate(places)]})
        tab.frames()

    def test_text_stands_out_in_both_themes(self):
        for theme in ("light", "dark"):
            for page in (self.modes("kuhn3.nsc"), self.series()):
                self.browser.open(page)
                self.browser.run("document.documentElement.dataset.theme = arguments[0]", theme)
                self.browser.frames()
                self.browser.click(*(n // 2 for n in self.browser.size()))
                contrasts = self.browser.run(CONTRASTS)
                self.assertGreater(len(contrasts), 15)
                self.assertEqual([each for each in contrasts if each[0] < 4.5], [], theme)
        self.browser.run("document.body.style.color = '#888'; document.body.style.background = '#999'")
        self.assertLess(min(self.browser.run(CONTRASTS))[0], 4.5)

    # What may fail

    def test_a_lost_picture_comes_back(self):
        tab = self.browser
        tab.open(self.modes("kuhn3.nsc", "dual"))
        before = tab.picture()
        tab.run("window.lost = document.getElementById('canvas').getContext('webgl2')"
                ".getExtension('WEBGL_lose_context'); window.lost.loseContext()")
        tab.wait(lambda: "taken away" in tab.text("message"))
        tab.run("window.lost.restoreContext()")
        tab.wait(lambda: tab.text("message") == "")
        tab.frames()
        self.assertEqual(tab.picture(), before)
        tab.set(edges=False)
        self.assertNotEqual(tab.picture(), before)

    def check_still(self, tab, path):
        text = tab.driver.find_element("tag name", "body").text
        with open(path, encoding="utf-8") as file:
            table = re.findall("<td>(.*?)</td>", file.read())
        self.assertEqual(len(table), 12)
        for entry in table:
            self.assertIn(entry, text)
        for words in ("Made by", "certified", "mode_1", "still picture"):
            self.assertIn(words, text)
        self.assertFalse(tab.driver.find_element("id", "canvas").is_displayed())
        self.assertFalse(tab.driver.find_element("id", "controls").is_displayed())
        still = tab.driver.find_element("css selector", "#still img")
        self.assertGreater(still.size["height"], 200)
        self.assertTrue(still.is_displayed())

    def test_without_webgl_there_is_a_still_picture_and_all_text(self):
        with Browser("--disable-3d-apis") as tab:
            path = self.modes()
            tab.open(path, "still")
            tab.wait(lambda: "WebGL" in tab.text("message"))
            self.check_still(tab, path)

    def test_without_scripts_there_is_a_still_picture_and_all_text(self):
        with Browser(preferences={"profile.managed_default_content_settings.javascript": 2}) as tab:
            path = self.modes()
            tab.driver.get(f"file://{path}")
            self.assertIn("Scripts are off", tab.driver.find_element("tag name", "body").text)
            self.check_still(tab, path)
        with self.assertRaises(AssertionError):
            self.browser.open(path)
            self.check_still(self.browser, path)

    def test_paper_shows_the_last_picture(self):
        tab = self.browser
        tab.open(self.modes())
        pages = []
        for field in (1, 2):
            tab.set(field=field)
            pages.append(base64.b64decode(tab.driver.execute_cdp_cmd(
                "Page.printToPDF", {"printBackground": True})["data"]))
            self.assertTrue(pages[-1].startswith(b"%PDF"))
            images = [tuple(map(int, size)) for size in re.findall(
                rb"/Width (\d+)\s*/Height (\d+)", pages[-1])]
            self.assertTrue(any(min(size) > 200 for size in images), images)
        streams = [re.findall(rb"/Width \d+\s*/Height \d+.*?endstream", page, re.DOTALL)
                   for page in pages]
        self.assertNotEqual(*streams)
