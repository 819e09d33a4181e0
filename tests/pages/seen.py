# SPDX-License-Identifier: MIT
"""What a page shows in a browser: colors are those of values, values those of files."""
import math

from browser_test import ROUNDING, BrowserTest, distance
from command import golden
from motions import pvd, vtu
from page_file import PageFile, map_color


class Seen(BrowserTest):
    def check_colors(self, page, name, choice, colors, ends):
        """At places where a cell is hit, the color is that of the value there."""
        tab, field = self.browser, page.fields[name]
        values = page.values(name)
        tab.plain()
        tab.set(field=list(page.fields).index(name), map=choice,
                values=field["place"] in ("edge", "face"))
        hits = 0
        seen = {place: tab.pixel(*place) for place in tab.spots()} # before one is marked
        for (x, y), color in seen.items():
            found = tab.click(x, y)
            if not found:
                continue
            value = found["here"] if field["place"] == "vertex" else found["value"]
            number = int(found["number"])
            self.assertLess(abs(found["value"] - values[number]),
                            1e-6 * max(map(abs, values)) + 1e-300)
            t = (value - ends[0]) / ((ends[1] - ends[0]) or 1)
            self.assertLess(distance(color, map_color(colors, t)), ROUNDING, (name, x, y, found))
            wrong = (t + 0.4) % 1
            self.assertGreater(distance(color, map_color(colors, wrong)), ROUNDING)
            hits += 1
        self.assertGreater(hits, 5)

    def check_all_maps(self, page, name):
        values, maps = page.values(name), page.header["maps"]
        largest = max(map(abs, values))
        own = (min(values), max(values))
        self.check_colors(page, name, "sequential", maps["sequential"], own)
        self.check_colors(page, name, "diverging", maps["diverging"], (-largest, largest))
        self.check_colors(page, name, "gray", ["#f2f2f2", "#1c1c1c"], own)

    def test_colors_of_vertices(self):
        page = self.page("spectrum", golden("uv8.off"), "--side", "primal", "--degree", 0, "--count",
                         4)
        self.check_all_maps(page, "mode_3")

    def test_colors_of_cells(self):
        page = self.page("spectrum", golden("uv8.off"), "--side", "dual", "--degree", 0, "--count", 4)
        self.check_colors(page, "mode_2", "gray", ["#f2f2f2", "#1c1c1c"],
                          (min(page.values("mode_2")), max(page.values("mode_2"))))

    def test_colors_of_solids(self):
        for mesh, side in (("kuhn3.nsc", "dual"), ("fcc1.nsc", "dual"), ("kuhn3.nsc", "primal")):
            page = self.page("poisson", golden(mesh), "--side", side, "--rhs", "x-y+2*z",
                             "--natural")
            self.check_colors(page, "u", "sequential", page.header["maps"]["sequential"],
                              (min(page.values("u")), max(page.values("u"))))

    def test_colors_of_faces_of_solids(self):
        page = self.page("spectrum", golden("kuhn3.nsc"), "--side", "primal", "--degree", 2,
                         "--count", 2)
        largest = max(map(abs, page.values("mode_1")))
        self.check_colors(page, "mode_1", "diverging", page.header["maps"]["diverging"],
                          (-largest, largest))

    def test_edges_carry_the_colors_of_their_values(self):
        page = self.page("spectrum", golden("grid4.nsc"), "--side", "primal", "--degree", 1,
                         "--count", 2)
        tab, values = self.browser, page.values("mode_1")
        tab.plain()
        tab.set(field=1, map="diverging", values=True)
        largest, colors = max(map(abs, values)), page.header["maps"]["diverging"]
        wanted = {tuple(map(round, map_color(colors, (v / largest + 1) / 2))) for v in values}
        width, height = tab.size()
        seen = {tab.pixel(x, height // 2 + 7) for x in range(width // 5, 4 * width // 5)}
        self.assertTrue(any(distance(a, b) < ROUNDING for a in seen for b in wanted))
        self.assertFalse(any(distance(a, (9, 200, 9)) < ROUNDING for a in seen))

    def test_lines_run_along_the_arrows(self):
        page = self.page("spectrum", golden("uv8.off"), "--side", "dual", "--degree", 1, "--count", 2)
        tab, arrays = self.browser, page.arrays

        def rows(name):
            numbers = arrays[name]
            return [numbers[i:i + 3] for i in range(0, len(numbers), 3)]

        def cosine(a, b):
            return (sum(x * y for x, y in zip(a, b))
                    / math.sqrt(sum(x * x for x in a) * sum(x * x for x in b)))

        sites, vectors, points = rows("sites0"), rows("vectors0"), rows("flow0_points")
        ends, along = arrays["flow0"], []
        for tail, head in zip(ends[::2], ends[1::2]):
            if points[tail] == points[head]:
                continue # by rounding
            middle = [(a + b) / 2 for a, b in zip(points[tail], points[head])]
            nearest = min(range(len(sites)), key=lambda i: math.dist(sites[i], middle))
            along.append(cosine([b - a for a, b in zip(points[tail], points[head])],
                                vectors[nearest]))
        self.assertGreater(len(along), 100)
        self.assertGreater(sorted(along)[len(along) // 2], 0.9)
        self.assertGreater(sum(c > 0 for c in along), 0.95 * len(along))
        tab.plain()
        tab.set(field=1)
        before = tab.picture()
        tab.keys("f")
        self.assertNotEqual(tab.picture(), before)
        tab.keys("f")
        self.assertEqual(tab.picture(), before)

    def test_a_cut_takes_cells_away_and_shows_those_behind(self):
        page = self.page("view", golden("kuhn3.nsc"))
        tab = self.browser
        tab.plain()
        before = [tab.click(*spot) for spot in tab.spots()]
        tab.set(axis=2, cut=100)
        self.assertEqual([tab.click(*spot) for spot in tab.spots()], before)
        tab.set(axis=2, cut=40)
        cells = {found["cell"] for found in map(lambda s: tab.click(*s), tab.spots())
                 if found}
        points, corners = page.points(), page.arrays["corners"]
        owners = page.arrays["owners"]
        for cell in cells:
            mine = [points[v][2] for t in range(len(corners) // 3)
                    if cell in owners[2 * t:2 * t + 2] for v in corners[3 * t:3 * t + 3]]
            self.assertLess((min(mine) + max(mine)) / 2, 0.5, "a cell above the cut is seen")
        self.assertGreater(len(cells), 2)

    def test_where_drawing_is_slow_pictures_are_coarse_until_nothing_changes(self):
        self.page("view", golden("kuhn3.nsc"))
        tab = self.browser

        def moved(milliseconds):
            """What is seen right after a change, and at last, where drawing takes that long."""
            tab.run("""const times = arguments[0]; let now = 0;
                performance.now = () => now += times;""", milliseconds)
            for cut in (60, 50): # the first one tells how long it takes
                tab.set(axis=0, cut=cut)
            return tab.run_after_frames("""
                const canvas = document.getElementById("canvas"), cut = document.getElementById("cut");
                cut.dispatchEvent(new Event("input", {bubbles: true}));""",
                "return [canvas.dataset.drawing, canvas.width / canvas.clientWidth]"), tab.picture()

        (first, width), seen = moved(0)
        self.assertEqual((first, width), ("fine", 1))
        (first, width), after = moved(1000)
        self.assertEqual(first, "coarse")
        self.assertLess(abs(width - 0.5), 0.01)
        self.assertEqual(after, seen)

    def test_steps_of_a_series_are_shown(self):
        self.succeed("spectrum", golden("uv8.off"), "--side", "primal", "--degree", 0, "--count", 3,
                     "-o", "a.vtu")
        text = self.read("a.vtu")
        for step in (1, 2):
            one = text.replace(f'"mode_{step}"', '"u"').replace(f'"mode_{3 - step}"', '"v"')
            self.write(f"s{step}.vtu", one)
        self.write("s.pvd", pvd({0.5: "s1.vtu", 0.75: "s2.vtu"}))
        self.assertSays(self.fail_with(2, "view", "s.pvd", "-o", "s.html"), "step 1",
                        "arrays", "expected")
        order = self.read("s2.vtu").replace('"u"', '"w"').replace('"v"', '"u"').replace('"w"', '"v"')
        self.write("s2.vtu", order)
        page = self.page("view", "s.pvd")
        tab = self.browser
        tab.set(field=list(page.fields).index("u"))
        for step, time in ((1, "0.75"), (0, "0.5")):
            tab.set(step=step)
            self.assertEqual(tab.text("time"), f"t = {time}")
            found = tab.click(*(n // 2 for n in tab.size()))
            self.assertAlmostEqual(found["value"], page.values("u", step)[int(found["number"])],
                                   delta=1e-6)

    def extent_of_arrows(self):
        """Width and height of what the switch of arrows changes."""
        read = """
            const canvas = document.getElementById("canvas"), gl = canvas.getContext("webgl2");
            const {width, height} = canvas, bytes = new Uint8Array(4 * width * height);
            gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        """
        self.browser.set(arrows=False)
        self.browser.run(read + "window.bare = bytes;")
        self.browser.set(arrows=True)
        return self.browser.run(read + """
            const columns = new Set(), rows = new Set();
            for (let i = 0; i < width * height; ++i)
                if (Math.abs(bytes[4 * i] - window.bare[4 * i]) > 30) {
                    columns.add(i % width);
                    rows.add(Math.floor(i / width));
                }
            return [columns.size, rows.size];""")

    def vector_series(self, vectors, times):
        """A square of two triangles with one vector at every step."""
        for step, vector in enumerate(vectors):
            self.write(f"s{step}.vtu", vtu([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
                                           [(0, 1, 2), (0, 2, 3)], {"wind": [vector, (0, 0, 0)]}))
        self.write("s.pvd", pvd({time: f"s{step}.vtu" for step, time in enumerate(times)}))

    def test_arrows_turn_with_the_steps(self):
        self.vector_series(((1, 0, 0), (0, 3, 0), (2, 0, 0)), ("0", "0.1162790697674", "0.2325581395"))
        self.page("view", "s.pvd")
        tab = self.browser
        self.assertEqual((tab.run("return document.getElementById('step').value"), tab.text("time")),
                         ("1", "t = 0.12"), "opens where the range is largest, in few digits")
        tab.plain()
        for step, along in ((0, 0), (1, 1), (2, 0), (1, 1)):
            tab.set(step=step)
            extent = self.extent_of_arrows()
            self.assertGreater(extent[along], 2 * extent[1 - along], (step, extent))

    def test_arrows_of_forms_are_there_at_every_step(self):
        page = self.page("wave", golden("torus8x6.off"), "--degree", 1, "--initial", "-y; x; z*z",
                         "--until", 1, "--frames", 4)
        self.assertEqual([each["field"] for each in page.header["arrows"]], ["u"])
        vectors = [page.arrays[f"vectors0.{step}"] for step in range(5)]
        lengths = {len(numbers) for numbers in vectors}
        self.assertEqual(lengths, {len(page.arrays["sites0"])})
        self.assertEqual(len({tuple(numbers) for numbers in vectors}), 5)
        for step in range(5):
            sizes = page.arrays[f"sizes0.{step}"]
            lengths = [math.hypot(*vectors[step][i:i + 3]) for i in range(0, len(vectors[step]), 3)]
            self.assertLess(max(abs(a - b) for a, b in zip(sizes, lengths, strict=True)), 1e-6)
        tab, seen = self.browser, []
        tab.plain()
        tab.set(field=-1, arrows=True)
        nothing = tab.picture()
        tab.set(field=list(page.fields).index("u"))
        self.assertEqual(tab.text("legend-name"), "|u|")
        for step in (0, 2, 4, 2):
            tab.set(step=step)
            seen.append(tab.picture())
        self.assertEqual(len({nothing, *seen}), 4)
        self.assertEqual(seen[1], seen[3])

    def test_pages_of_a_flow_begin_with_its_velocity(self):
        line = ("flow", golden("uv8.off"), "--vorticity", "z", "--until", 0.5, "--frames", 2)
        self.succeed(*line, "-o", "f.pvd")
        page = self.page(*line)
        self.assertEqual(self.browser.text("legend-name"), "velocity [length/time]")
        self.assertEqual(set(page.fields), {"velocity", "vorticity", "pressure"})
        self.browser.plain()
        self.assertGreater(max(self.extent_of_arrows()), 100)
        self.succeed("view", "f.pvd", "-o", "g.html")
        again = PageFile(self.path("g.html"))
        for name in page.fields:
            for step in range(3):
                first, second = page.values(name, step), again.values(name, step)
                self.assertLess(max(abs(a - b) for a, b in zip(first, second, strict=True)),
                                1e-6 * max(map(abs, second)))

    def test_no_request_leaves_the_page_and_nobody_complains(self):
        self.browser.requests()
        self.page("spectrum", golden("uv8.off"), "--side", "primal", "--degree", 1, "--count", 3)
        self.browser.click(*(n // 2 for n in self.browser.size()))
        addresses = [each for each in self.browser.requests() if not each.startswith("data:")]
        self.assertEqual(len(addresses), 1, addresses)
        self.assertEqual(self.browser.complaints(), [])
        self.browser.run("const i = new Image(); i.src = 'https://example.org/a.png'")
        self.browser.frames()
        self.assertIn("Content Security Policy", " ".join(self.browser.complaints()),
                      "a request is forbidden, and told")

    def test_pages_of_few_cells(self):
        for name, text in (("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                           ("two.off", "OFF\n4 2 0\n0 0 0\n4 0 0\n3 1 0\n1 1 0\n3 0 1 2\n3 0 2 3\n"),
                           ("curve.nsc", "3 1 4 3\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n0 1\n1 2\n2 3\n"),
                           ("tet.nsc", "3 3 4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 2 3\n")):
            with self.subTest(name):
                self.write(name, text)
                self.page("view", name)
                self.assertEqual(self.browser.complaints(), [])
                width, height = self.browser.size()
                places = ((x, y) for y in range(height // 4, height, height // 4)
                          for x in range(50, width, 50))
                self.assertTrue(any(self.browser.click(*place) for place in places), name)

    def test_albums_show_one_page_at_a_time(self):
        for name in ("uv8.off", "kuhn3.nsc"):
            self.succeed("view", golden(name), "-o", f"{name}.html")
        self.succeed("view", "uv8.off.html", "kuhn3.nsc.html", "-o", "both.html")
        tab = self.browser
        tab.driver.get(f"file://{self.path('both.html')}")
        shown = "return [...document.querySelectorAll('iframe')].map(f => f.offsetHeight > 99)"
        self.assertEqual(sorted(tab.run(shown)), [False, True])
        tab.driver.find_element("id", "to-1").click()
        after = tab.run(shown)
        tab.driver.find_element("id", "to-0").click()
        self.assertEqual(tab.run(shown), after[::-1])
        tab.driver.switch_to.frame(tab.driver.find_element("css selector", "#page-0 iframe"))
        tab.wait(lambda: tab.state() == "ready")
        tab.driver.switch_to.default_content()
        self.assertEqual(tab.complaints(), [])
