# SPDX-License-Identifier: MIT
"""How a page looks at first, and what may be changed: vectors, cuts, directions, lengths, ranges of
colors, heights and the picture as a file. All by numbers."""
import json
import math

from browser_test import ROUNDING, BrowserTest, distance
from command import golden
from page_file import map_color

# All pixels of the canvas, from the row at the bottom; then how a second picture differs: patches of
# neighbors that changed, and changed pixels that were ground before.
KEEP = """
const canvas = document.getElementById("canvas"), gl = canvas.getContext("webgl2");
window.pixels = () => {
    const bytes = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return new Uint32Array(bytes.buffer);
};
window.before = window.pixels();"""
COMPARE = """
const after = window.pixels(), width = document.getElementById("canvas").width;
const ground = window.before[0], todo = new Set();
after.forEach((color, i) => { if (color !== window.before[i]) todo.add(i); });
const outside = [...todo].filter(i => window.before[i] === ground).length, all = todo.size;
let patches = 0;
while (todo.size) {
    ++patches;
    const next = [todo.values().next().value];
    todo.delete(next[0]);
    while (next.length) {
        const i = next.pop();
        for (const j of [-1, 0, 1].flatMap(y => [-1, 0, 1].map(x => i + y * width + x)))
            if (todo.delete(j))
                next.push(j);
    }
}
return {all, outside, patches};"""
CATCH = """
const done = arguments[0];
URL.createObjectURL = blob => {
    createImageBitmap(blob).then(image => {
        const canvas = new OffscreenCanvas(image.width, image.height);
        const draw = canvas.getContext("2d", {willReadFrequently: true});
        draw.drawImage(image, 0, 0);
        const at = (x, y) => [...draw.getImageData(x, y, 1, 1).data].slice(0, 3);
        done({type: blob.type, size: [image.width, image.height],
            middle: at(image.width >> 1, document.getElementById("canvas").height >> 1),
            bar: [20, image.width - 20].map(x => at(x, image.height - 33))});
    });
    return "blob:x";
};
HTMLAnchorElement.prototype.click = () => {};
document.getElementById("save").click();"""


class Look(BrowserTest):
    def is_checked(self, identity):
        return self.browser.run("return document.getElementById(arguments[0]).checked", identity)

    def picks(self, count=7):
        """Places of the canvas that hit a cell, their colors and those one pixel on before a click,
        and what it reports."""
        spots = self.browser.spots(count)
        colors = [[self.browser.pixel(x + i, y + j) for i, j in ((0, 0), (1, 1), (-1, -1))]
                  for x, y in spots]
        found = [(spot, color, self.browser.click(*spot)) for spot, color in zip(spots, colors)]
        return [each for each in found if each[2]]

    def check_colors(self, page, values, name, part):
        """At every hit, the color is the map's at the part of the value. A click reports the value
        at the corner of its pixel: the color may be off by what changes to the next pixel."""
        colors, hits = page.header["maps"][name], 0
        for spot, (color, *others), found in self.picks():
            off = ROUNDING + max(distance(color, other) for other in others)
            value = found.get("here", values[int(found["number"])])
            self.assertLess(distance(color, map_color(colors, part(value))), off, (spot, found))
            hits += distance(color, map_color(colors, (part(value) + 0.4) % 1)) > off
        self.assertGreater(hits, 5)

    def marks(self):
        """Extreme values, once it is known which are behind the mesh."""
        found = {}

        def is_settled():
            found.update(self.browser.run(
                "return {...document.getElementById('overlay').dataset}"))
            return "settled" in found

        self.browser.wait(is_settled)
        return json.loads(found["marks"])

    # Vectors

    def test_one_forms_are_shown_by_the_lengths_of_their_vectors(self):
        for mesh, side in (("torus8x6.off", "primal"), ("uv8.off", "dual"), ("kuhn3.nsc", "primal")):
            with self.subTest(mesh):
                page = self.page("spectrum", golden(mesh), "--side", side, "--degree", 1, "--count", 2)
                sizes, vectors = page.arrays["sizes0"], page.arrays["vectors0"]
                self.assertEqual(len(sizes), page.header["cells"])
                for i, size in enumerate(sizes):
                    self.assertAlmostEqual(size, math.hypot(*vectors[3 * i:3 * i + 3]),
                                           delta=1e-6 * max(sizes))
                self.assertEqual(self.browser.text("legend-name"), "|mode_0|")
                self.browser.plain()
                low, high = min(sizes), max(sizes)
                if high - low > 1e-5 * high:
                    self.check_colors(page, sizes, "sequential", lambda v: (v - low) / (high - low))
                self.browser.keys("v")
                self.assertEqual(self.browser.text("legend-name"), "mode_0")

    def test_lines_with_arrows_run_along_one_forms_of_surfaces(self):
        self.page("spectrum", golden("torus8x6.off"), "--degree", 1, "--count", 2)
        tab = self.browser
        self.assertTrue(self.is_checked("flow") and self.is_checked("arrows"))
        for key in "af":
            tab.run(KEEP)
            tab.keys(key)
            self.assertGreater(tab.run(COMPARE)["all"], 500, key)

    def plane_vectors(self):
        """A page of one vector at every vertex of a square with a hole."""
        n, points, cells = 12, [], []
        for i in range(n + 1):
            points += [(i, j, 0) for j in range(n + 1)]
        for i in range(n):
            cells += [(i * (n + 1) + j, (i + 1) * (n + 1) + j, (i + 1) * (n + 1) + j + 1,
                       i * (n + 1) + j + 1) for j in range(n) if not (4 <= i < 8 and 4 <= j < 8)]
        self.write("a.off", f"OFF\n{len(points)} {len(cells)} 0\n"
                   + "".join("{} {} {}\n".format(*p) for p in points)
                   + "".join("4 {} {} {} {}\n".format(*c) for c in cells))
        self.succeed("merge", "a.off", "-o", "a.vtu")
        text = self.read("a.vtu")
        count = int(text.split('NumberOfCells="')[1].split('"')[0])
        data = ('<CellData><DataArray type="Float64" Name="v" NumberOfComponents="3" format="ascii">'
                + "1 2 0 " * count + "</DataArray></CellData>")
        begin = text.find("<CellData")
        if begin >= 0:
            text = text[:begin] + text[text.find("</CellData>") + len("</CellData>"):]
        end = text.find("</Piece>")
        self.write("b.vtu", text[:end] + data + text[end:])
        return self.page("view", "b.vtu")

    def test_arrows_neither_meet_nor_leave_the_mesh(self):
        page = self.plane_vectors()
        tab = self.browser
        tab.set(edges=False, arrows=False, field=list(page.fields).index("v"))
        tab.run(KEEP)
        tab.set(arrows=True)
        found = tab.run(COMPARE)
        arrows = int(tab.run("return document.getElementById('canvas').dataset.arrows"))
        self.assertGreater(arrows, 50)
        self.assertEqual(found["patches"], arrows)
        self.assertEqual(found["outside"], 0)

    def test_one_forms_of_solids_open_cut_with_arrows_inside(self):
        page = self.page("spectrum", golden("kuhn3.nsc"), "--degree", 1, "--count", 2)
        tab = self.browser
        self.assertEqual(tab.text("cut-at"), "50 %")
        tab.run(KEEP)
        tab.keys("a")
        self.assertGreater(tab.run(COMPARE)["all"], 100)
        points, corners, owners = page.points(), page.arrays["corners"], page.arrays["owners"]
        middle = (min(p[1] for p in points) + max(p[1] for p in points)) / 2
        hits = self.picks()
        for _, _, found in hits:
            mine = [points[v][1] for t in range(len(corners) // 3)
                    if found["cell"] in owners[2 * t:2 * t + 2] for v in corners[3 * t:3 * t + 3]]
            self.assertGreater((min(mine) + max(mine)) / 2, middle - 1e-6, "a cell before the cut")
        self.assertGreater(len(hits), 5)
        self.page("spectrum", golden("kuhn3.nsc"), "--degree", 0, "--count", 2)
        self.assertEqual(tab.text("cut-at"), "100 %")

    # Directions and lengths

    def heights(self, page, axis):
        """How far the picture's upper half lies above the lower one along an axis, the right half
        above the left one; in parts of the extent."""
        points, (width, height) = page.points(), self.browser.size()
        extent = max(p[axis] for p in points) - min(p[axis] for p in points)
        hits = [(x, y, points[int(found["vertex"])][axis]) for (x, y), _, found in self.picks(9)]

        def mean(numbers):
            return sum(numbers) / len(numbers)

        return [(mean([p for x, y, p in hits if is_first(x, y)])
                 - mean([p for x, y, p in hits if not is_first(x, y)])) / extent
                for is_first in (lambda x, y: y < height / 2, lambda x, y: x > width / 2)]

    def check_up(self, page, axis):
        upward, sideways = self.heights(page, axis)
        self.assertGreater(upward, 0.2)
        self.assertLess(abs(sideways), 0.12)

    def test_up_is_up(self):
        self.succeed("generate", "icosphere", "--frequency", 5, "-o", "s.obj")
        self.succeed("generate", "icosphere", "--frequency", 5, "-o", "s.stl")
        for mesh, axis, more in (("s.obj", 1, ()), ("s.stl", 2, ()), ("s.obj", 0, ("--up", "x")),
                                 ("s.stl", 1, ("--up", "y")), ("s.obj", 2, ("--up", "z"))):
            with self.subTest(mesh, more=more):
                self.check_up(self.page("view", mesh, *more), axis)
        page = self.page("view", "s.obj")
        self.browser.keys("u")
        self.check_up(page, 2)
        with self.assertRaises(AssertionError):
            self.check_up(page, 1)
        self.assertSays(self.fail_with(1, "view", "s.obj", "--up", "w"), "--up", "w")

    def test_the_scale_bar_is_as_long_as_it_says(self):
        self.plane_vectors()
        tab = self.browser
        tab.set(edges=False, arrows=False)
        bar = tab.run("return {...document.getElementById('overlay').dataset}")
        width, height = tab.size()
        rows = [y for y in range(height) if tab.pixel(width // 2 - height // 4, y) != (255, 255, 255)]
        self.assertAlmostEqual(len(rows) * float(bar["length"]) / float(bar["pixels"]) / 12, 1,
                               delta=0.01)

    # Colors

    def test_ranges_are_chosen_by_hand_and_forgotten_with_the_field(self):
        page = self.page("view", golden("uv8.off"))
        tab, areas = self.browser, page.values("area")
        tab.plain()
        tab.set(field=list(page.fields).index("area"))
        low, high = min(areas) / 2, 3 * max(areas)
        tab.run("document.getElementById('from').value = arguments[0]; "
                "document.getElementById('to').value = arguments[1]", low, high)
        tab.set(shade=False)
        self.check_colors(page, areas, "sequential", lambda v: (v - low) / (high - low))
        tab.set(log=True)
        self.check_colors(page, areas, "sequential",
                          lambda v: math.log(v / low) / math.log(high / low))
        tab.run("document.activeElement.blur()")
        tab.keys("n")
        self.assertEqual(tab.run("return document.getElementById('to').value"), "")

    def test_signed_values_have_a_map_with_zero_in_its_middle(self):
        page = self.page("spectrum", golden("uv8.off"), "--count", 3)
        tab, values = self.browser, page.values("mode_1")
        tab.plain()
        largest = max(map(abs, values))
        self.check_colors(page, values, "diverging", lambda v: (v / largest + 1) / 2)
        tab.run("document.getElementById('to').value = arguments[0]", 2 * largest)
        tab.set(shade=False)
        self.check_colors(page, values, "diverging", lambda v: (v / largest / 2 + 1) / 2)
        legend = tab.run("return [...document.getElementById('legend-numbers').children]"
                         ".map(e => Number(e.textContent))")
        self.assertEqual(legend[2], 0)
        self.assertEqual(legend[0], -legend[4])

    def test_the_legend_has_the_unit(self):
        self.page("distance", golden("uv8.off"), "--from", 0)
        self.assertEqual(self.browser.text("legend-name"), "distance [length]")
        self.page("distance", golden("uv8.off"), "--from", 0, "--length-unit", "mm")
        self.assertEqual(self.browser.text("legend-name"), "distance [mm]")

    def test_marks_stand_at_the_extremes(self):
        page = self.page("poisson", golden("grid4.nsc"), "--rhs", 1)
        tab, values = self.browser, page.values("u")
        tab.plain()
        mark, = self.marks()
        self.assertAlmostEqual(mark["value"], max(values), delta=1e-6 * max(values))
        self.assertFalse(mark["isHidden"])
        found = tab.click(*map(round, mark["at"]))
        self.assertAlmostEqual(found["value"], max(values), delta=1e-6 * max(values))

    def test_a_smallest_value_that_is_rounding_has_no_mark(self):
        for least, names in (("1e-18", ["max"]), ("1e-2", ["max", "min"])):
            self.page("heat", golden("grid4.nsc"), "--side", "primal", "--until", "1e-9",
                      "--initial", f"x-{least}*(x<0.1)")
            self.browser.set(step=0)
            self.assertEqual([mark["name"] for mark in self.marks()], names)

    def parts_filled(self):
        """Of the picture's width and height, by what is drawn."""
        return self.browser.run("""
            const canvas = document.getElementById("canvas"), gl = canvas.getContext("webgl2");
            const {width, height} = canvas, bytes = new Uint8Array(4 * width * height);
            gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            let [left, right, low, high] = [width, 0, height, 0];
            for (let i = 0; i < width * height; ++i)
                if (bytes[4 * i] !== bytes[0] || bytes[4 * i + 2] !== bytes[2]) {
                    const x = i % width, y = Math.floor(i / width);
                    [left, right] = [Math.min(left, x), Math.max(right, x)];
                    [low, high] = [Math.min(low, y), Math.max(high, y)];
                }
            return [(right - left) / width, (high - low) / height];""")

    def test_what_a_cut_leaves_fills_the_view(self):
        self.page("spectrum", golden("kuhn3.nsc"), "--degree", 1, "--count", 1)
        tab = self.browser
        tab.plain()
        for cut in (50, 20, 100):
            tab.set(cut=cut)
            self.assertAlmostEqual(max(self.parts_filled()), 0.94, delta=0.02, msg=str(cut))
        tab.run("document.getElementById('canvas').focus()")
        tab.keys("-")
        before = self.parts_filled()
        tab.set(cut=20)
        self.assertLess(max(self.parts_filled()), max(before), "it stays as somebody moved it")

    # Cells

    def test_edges_of_many_cells_are_off(self):
        for frequency, is_on in ((9, True), (15, False)):
            self.succeed("generate", "icosphere", "--frequency", frequency, "-o", "s.off")
            page = self.page("view", "s.off")
            self.assertEqual(page.header["cells"] <= 2000, is_on)
            self.assertEqual(self.is_checked("edges"), is_on)

    def test_values_on_planes_are_heights(self):
        page = self.page("poisson", golden("grid4.nsc"), "--rhs", 1)
        tab, values = self.browser, page.values("u")
        tab.plain()
        flat = self.marks()
        tab.keys("h")
        tab.set(shade=False)
        high = max(values)
        self.check_colors(page, values, "sequential", lambda v: v / high)
        mark, = self.marks()
        self.assertAlmostEqual(mark["place"][2], 0.5, delta=1e-5)
        self.assertEqual(mark["place"][:2], flat[0]["place"][:2])
        tab.keys("h")
        again = self.marks()
        self.assertEqual(again, flat)

    def test_the_picture_is_saved_with_its_legend(self):
        page = self.page("spectrum", golden("uv8.off"), "--count", 3)
        tab = self.browser
        width, height = tab.size()
        wanted = tab.pixel(width // 2, height // 2)
        found = tab.driver.execute_async_script(CATCH)
        self.assertEqual(found["type"], "image/png")
        self.assertEqual(found["size"], [width, height + 64])
        self.assertLess(distance(found["middle"], wanted), ROUNDING)
        ends = [map_color(page.header["maps"]["diverging"], t) for t in (0.005, 0.995)]
        for color, end in zip(found["bar"], ends):
            self.assertLess(distance(color, end), 8)
        self.assertEqual(tab.complaints(), [])
