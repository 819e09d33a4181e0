# SPDX-License-Identifier: MIT
"""Pictures and films of pages, made without a browser: what they show, by numbers."""
import itertools
import json
import os
import re
import struct
import xml.etree.ElementTree
import zlib
from collections import Counter

from command import TestCase, golden
from motions import pvd, vtu

SVG = "{http://www.w3.org/2000/svg}"
WHITE = (255, 255, 255)


def decoded(data):
    """The rows of pixels of a PNG file with 8 bits for each of three channels."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", data[:8]
    chunks, at = {}, 8
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size:at + 12 + size])[0] == zlib.crc32(kind + body)
        chunks[kind] = body
        at += size + 12
    width, height, *form = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert form == [8, 2, 0, 0, 0] and b"IEND" in chunks, form
    lines = zlib.decompress(chunks[b"IDAT"])
    assert len(lines) == height * (3 * width + 1)
    rows, above = [], 0
    sevens = int.from_bytes(b"\x7f" * 3 * width, "big")  # bytes are added without carries
    for y in range(height):
        line = lines[y * (3 * width + 1):(y + 1) * (3 * width + 1)]
        assert line[0] == 2, line[0]
        line = int.from_bytes(line[1:], "big")
        above = ((above & sevens) + (line & sevens)) ^ ((above ^ line) & ~sevens)
        row = above.to_bytes(3 * width, "big")
        rows.append(list(zip(row[::3], row[1::3], row[2::3])))
    return rows


def color_of(text):
    return tuple(int(text[i:i + 2], 16) for i in (1, 3, 5))


def on_map(colors, part):
    """The color at a place from 0 to 1 of a map that is linear between these colors."""
    at = min(max(part, 0), 1) * (len(colors) - 1)
    i = min(int(at), len(colors) - 2)
    return tuple(a + (at - i) * (b - a) for a, b in zip(color_of(colors[i]), color_of(colors[i + 1])))


SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
HALVES = [(0, 1, 2), (0, 2, 3)]


class Stills(TestCase):
    def picture(self, name):
        with open(self.path(name), "rb") as file:
            return decoded(file.read())

    def maps(self, name):
        """The color maps in the header of the page of a mesh."""
        self.succeed("view", name, "-o", "maps.html")
        header = re.search(r'id="page-header"[^>]*>(.*?)</script>', self.read("maps.html"), re.S)
        return json.loads(header[1])["maps"]

    def box(self, rows):
        """Left, top, right and bottom of what is drawn above the legend."""
        drawn = [(x, y) for y in range(60, 700) for x, c in enumerate(rows[y]) if c != WHITE]
        xs, ys = zip(*drawn)
        return min(xs), min(ys), max(xs) + 1, max(ys) + 1

    def assert_color(self, color, expected, off=2):
        self.assertLessEqual(max(abs(a - b) for a, b in zip(color, expected)), off,
                             (color, expected))

    def test_the_color_of_a_pixel_is_the_maps_color_of_the_value_there(self):
        for kind, low in (("sequential", 0.25), ("diverging", -0.25)):
            self.write("u.vtu", vtu(SQUARE, HALVES, u=[low, low + 1, low + 1, low]))
            self.succeed("view", "u.vtu", "-o", "u.png")
            rows, colors = self.picture("u.png"), self.maps("u.vtu")[kind]
            left, top, right, bottom = self.box(rows)
            self.assertLessEqual(abs((right - left) - (bottom - top)), 1)
            ends = (low, low + 1) if kind == "sequential" else (-low - 1, low + 1)
            seen = set()
            for i in range(1, 10):
                x, y = left + (right - left) * i // 10, top + (bottom - top) * 3 // 11
                value = low + (x + 0.5 - left) / (right - left)
                if abs((x - left) + (y - top) - (right - left)) > 5:  # not on the edge between
                    self.assert_color(rows[y][x],
                                      on_map(colors, (value - ends[0]) / (ends[1] - ends[0])))
                    seen.add(rows[y][x])
            self.assertGreater(len(seen), 6)

    def test_an_svg_has_the_colors_of_the_values(self):
        self.write("u.vtu", vtu(SQUARE, HALVES, u=[0, 1, 1, 0]))
        self.succeed("view", "u.vtu", "-o", "u.svg")
        colors = self.maps("u.vtu")["sequential"]
        root = xml.etree.ElementTree.fromstring(self.read("u.svg"))
        pieces = [p for p in root.iter(f"{SVG}polygon") if len(p.get("points").split()) == 3]
        corners = [[tuple(map(float, p.split(","))) for p in piece.get("points").split()]
                   for piece in pieces]
        left = min(x for piece in corners for x, _ in piece)
        right = max(x for piece in corners for x, _ in piece)
        self.assertGreater(len(pieces), 100)
        for piece, points in zip(pieces, corners):
            middle = sum(x for x, _ in points) / 3
            self.assert_color(color_of(piece.get("fill")),
                              on_map(colors, (middle - left) / (right - left)))
        words = [text.text for text in root.iter(f"{SVG}text")]
        for word in ("u.vtu", "u", "0", "0.5", "1"):
            self.assertIn(word, words)

    def test_a_large_svg_contains_the_same_pixels_as_the_png(self):
        self.succeed("generate", "icosphere", "--frequency", 24, "-o", "s.off")
        self.succeed("view", "s.off", "--no-merge", "-o", "s.svg")
        image = xml.etree.ElementTree.fromstring(self.read("s.svg")).find(f"{SVG}image")
        self.assertTrue(image.get("href").startswith("data:image/png;base64,"))

    def test_nearer_triangles_hide_farther_ones(self):
        """Seen from (1, -2, 1.2), the triangle at y = -1 is before the one at y = 1."""
        near = [(-1, -1, -1), (1, -1, -1), (0, -1, 1)]
        far = [(-1, 1, -1), (1, 1, -1), (0, 1, 1)]
        for points, cells in ((near + far, [(0, 1, 2), (3, 4, 5)]), (far + near, [(3, 4, 5), (0, 1, 2)])):
            values = [1 if y < 0 else 0 for _, y, _ in points]
            self.write("u.vtu", vtu(points, cells, u=values))
            self.succeed("view", "u.vtu", "-o", "u.png")
            rows = self.picture("u.png")
            colors = self.maps("u.vtu")["sequential"]
            dark, light = color_of(colors[-1]), color_of(colors[0])
            counts = {"near": 0, "far": 0}
            for c, pixels in Counter(itertools.chain(*rows[60:690])).items():
                for name, full in (("near", dark), ("far", light)):
                    for shade in (0.8, 0.9, 1.0):
                        counts[name] += pixels * all(abs(a - shade * b) < 14 for a, b in zip(c, full))
            self.assertGreater(counts["near"], 1.2 * counts["far"])

    def test_the_axis_of_a_page_points_up(self):
        self.write("u.vtu", vtu([(0, 0, 0), (0, 9, 0), (-1, 0, 0.5)], [(0, 1, 2)], u=[0, 1, 2]))
        for axis, is_tall in (("y", True), ("x", False)):
            self.succeed("view", "u.vtu", "--up", axis, "-o", "u.png")
            left, top, right, bottom = self.box(self.picture("u.png"))
            self.assertEqual(bottom - top > right - left, is_tall, axis)

    def test_a_series_shows_the_step_of_largest_range(self):
        for step, height in enumerate((1, 3, 2)):
            self.write(f"{step}.vtu", vtu(SQUARE, HALVES, u=[0, height, height, 0]))
        self.write("s.pvd", pvd({step + .5: f"{step}.vtu" for step in range(3)}))
        self.succeed("view", "s.pvd", "-o", "s.svg")
        words = [text.text for text in
                 xml.etree.ElementTree.fromstring(self.read("s.svg")).iter(f"{SVG}text")]
        self.assertIn("t = 1.5", words)

    def test_pieces_of_many_ranks_are_one_picture(self):
        self.write("one.vtu", vtu(SQUARE, HALVES, u=[0, 1, 1, 0]))
        self.write("0.vtu", vtu([SQUARE[i] for i in HALVES[0]], [(0, 1, 2)], u=[0, 1, 1]))
        self.write("1.vtu", vtu([SQUARE[i] for i in HALVES[1]], [(0, 1, 2)], u=[0, 1, 0]))
        self.write("all.pvtu", '<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>'
                               '<Piece Source="0.vtu"/><Piece Source="1.vtu"/>'
                               '</PUnstructuredGrid></VTKFile>')
        for name in ("one.vtu", "all.pvtu"):
            self.succeed("view", name, "-o", name + ".png")
        one, both = self.picture("one.vtu.png"), self.picture("all.pvtu.png")
        self.assertEqual(one[60:], both[60:])  # below the title
        self.assertEqual(self.ask("view", "all.pvtu", "-o", "a.html")["cells"], 2)
        self.write("1.vtu", vtu([SQUARE[i] for i in HALVES[1]], [(0, 1, 2)], v=[0, 1, 0]))
        self.assertSays(self.fail_with(2, "view", "all.pvtu", "-o", "b.png"), "all.pvtu", "arrays",
                        "1.vtu", "0.vtu")
        self.assertNotIn("b.png", os.listdir(self.folder))

    def test_every_command_with_a_page_makes_pictures(self):
        mesh = golden("uv8.off")
        for name, more in (("view", ()), ("info", ()), ("merge", ()), ("distance", ("--from", 0)),
                           ("spectrum", ("--degree", 1, "--count", 2)),
                           ("poisson", ("--side", "dual", "--rhs", "z")),
                           ("hodge", ("--degree", 1, "--form", "-y; x; z"))):
            self.succeed(name, mesh, *more, "-o", f"{name}.png")
            self.succeed(name, mesh, *more, "-o", f"{name}.svg")
            rows = self.picture(f"{name}.png")
            drawn = sum(len(row) - row.count(WHITE) for row in rows)
            self.assertGreater(drawn, 0.1 * len(rows) * len(rows[0]), name)
            xml.etree.ElementTree.fromstring(self.read(f"{name}.svg"))
        self.succeed("generate", "kuhn", "-o", "k.PNG")
        self.picture("k.PNG")

    def test_equal_pages_give_equal_pictures(self):
        for name in ("a.png", "b.png"):
            self.succeed("distance", golden("uv8.off"), "--from", 0, "-o", name)
        with open(self.path("a.png"), "rb") as a, open(self.path("b.png"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_options_of_meshes_do_not_apply_to_results_and_pages(self):
        mesh = golden("uv8.off")
        for name in ("u.vtu", "p.html", "q.html"):
            self.succeed("distance", mesh, "--from", 0, "-o", name)
        options = (("--tolerance", 1e-3), ("--angle-tolerance", 0.1), ("--no-merge",),
                   ("--centers", "centroids"), ("--keep-groups",), ("--periodic", "1,0"),
                   ("--glue", "x+1;y;z"), ("--weld",), ("--join-hanging",), ("--peel",),
                   ("--refine", 0.5), ("--delaunay",))
        of_pages = (("--up", "x"), ("--length-unit", "mm"))
        for option in options + of_pages:
            for given, refused in ((("u.vtu",), options), (("p.html", "q.html"), options + of_pages)):
                words = ("view", *given, *option, "-o", "a.html")
                if option not in refused:
                    self.succeed(*words)
                    os.remove(self.path("a.html"))
                    continue
                self.assertSays(self.fail_with(2, *words), option[0], "apply", given[0], "omit")
                self.assertNotIn("a.html", os.listdir(self.folder))
        for given in (("u.vtu",), ("p.html", "q.html")):
            self.succeed("view", *given, "-o", "a.html", "--json", "--max-memory", "2G")

    def test_points_alone_have_no_picture(self):
        self.write("p.vtu", vtu(SQUARE, [(0,), (1,)], u=[0, 0, 0, 1]))
        self.assertSays(self.fail_with(2, "view", "p.vtu", "-o", "p.png"), "only points", ".vtu")
        self.assertNotIn("p.png", os.listdir(self.folder))


class Films(TestCase):
    def setUp(self):
        super().setUp()
        self.succeed("heat", golden("uv8.off"), "--initial", "z", "--until", 0.1, "--frames", 5,
                     "-o", "h.pvd")
        os.mkdir(self.path("bin"))
        self.tools = {**os.environ, "PATH": self.path("bin")}

    def test_without_ffmpeg_the_message_has_the_remedy(self):
        self.assertSays(self.fail_with(4, "view", "h.pvd", "-o", "h.mp4", env=self.tools), "h.mp4",
                        "ffmpeg", "apt-get install ffmpeg")
        self.assertNotIn("h.mp4", os.listdir(self.folder))

    def fake(self, text):
        """A program in place of ffmpeg, which is called in the folder of pictures."""
        self.write("bin/ffmpeg", f"#!/bin/sh\nPATH=/usr/bin:/bin\nfor out; do :; done\n{text}\n")
        os.chmod(self.path("bin/ffmpeg"), 0o755)

    def test_a_film_has_every_step(self):
        self.fake("ls *.png | wc -l > ${out#file:}")
        self.succeed("view", "h.pvd", "-o", "h.mp4", env=self.tools)
        self.assertEqual(self.read("h.mp4").split(), ["6"])

    def test_a_film_appears_whole_or_not_at_all(self):
        self.write("h.mp4", "old")
        self.fake("echo half > ${out#file:}; echo no such codec; exit 1")
        self.assertSays(self.fail_with(4, "view", "h.pvd", "-o", "h.mp4", env=self.tools), "h.mp4",
                        "ffmpeg", "no such codec")
        self.assertEqual(self.read("h.mp4"), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["bin", "h", "h.mp4", "h.pvd"])

    def test_one_mesh_is_no_film(self):
        self.fake("exit 1")
        self.assertSays(self.fail_with(2, "view", golden("uv8.off"), "-o", "h.mp4", env=self.tools),
                        "h.mp4", "series", ".pvd", ".png")
