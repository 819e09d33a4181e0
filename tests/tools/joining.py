# SPDX-License-Identifier: MIT
"""Vertices at one place and hanging nodes: every command tells of them, and joins them if asked."""
import itertools
import math
import os

import command
from command import TestCase
from motions import off, squares


def both(one, other):
    return one[0] + other[0], one[1] + [tuple(v + len(one[0]) for v in cell) for cell in other[1]]


def seamed_sphere(n):
    """A sphere whose vertices are doubled along a meridian and once for each triangle at a pole."""
    points, cells = [], []
    for i in range(n + 1):
        for j in range(2 * n + 1):
            theta, phi = math.pi * i / n, math.pi * (j % (2 * n)) / n
            points.append((math.sin(theta) * math.cos(phi) if 0 < i < n else 0.0,
                           math.sin(theta) * math.sin(phi) if 0 < i < n else 0.0,
                           math.cos(theta)))
    for i, j in itertools.product(range(n), range(2 * n)):
        a, b = i * (2 * n + 1) + j, (i + 1) * (2 * n + 1) + j
        cells += [(a, b, b + 1)] if i < n - 1 else []
        cells += [(a, b + 1, a + 1)] if i > 0 else []
    return points, cells


def cube_stl(rounding):
    """A cube in which zeros of every other facet are off by a rounding."""
    corners = list(itertools.product((0.0, 1.0), repeat=3))
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    text = "solid\n"
    for number, (a, b, c, d) in enumerate(squares):
        for triangle in ((a, b, c), (a, c, d)):
            text += "facet normal 0 0 0\nouter loop\n"
            for v in triangle:
                off_by = rounding if number % 2 else 0.0
                text += "vertex " + " ".join(repr(x or off_by) for x in corners[v]) + "\n"
            text += "endloop\nendfacet\n"
    return text + "endsolid\n"


class SplitVertices(TestCase):
    def setUp(self):
        super().setUp()
        self.write("seam.off", off(*seamed_sphere(8)))

    def test_are_counted_and_told_with_the_remedy(self):
        info = self.ask("info", "seam.off")
        self.assertEqual(info["unjoined"], {"coincident": 7 + 2 * 15, "hanging": 0, "misfits": 0})
        self.assertEqual(info["boundary_components"], 1)
        self.assertSays(" ".join(info["warnings"]), "37", "vertices", "coincide", "--weld")
        self.assertSays(self.succeed("info", "seam.off").out, "not joined", "37")

    def test_every_command_tells(self):
        for words in (["spectrum", "--side", "primal", "--degree", 0, "--count", 3],
                      ["merge", "-o", "a.off"], ["operators", "--out", "folder"],
                      ["poisson", "--side", "primal", "--rhs", "1"], ["distance", "--from", 0]):
            with self.subTest(words[0]):
                told = self.succeed(words[0], "seam.off", *words[1:]).err
                self.assertSays(told, "37", "coincide", "--weld")

    def test_are_joined_if_asked_wherever_the_option_stands(self):
        for words in (["--weld", "seam.off"], ["seam.off", "--weld"], ["seam.off", "--weld", "1e-6"],
                      ["--weld", "1e-6", "seam.off"], ["seam.off", "--weld=1e-6"]):
            info = self.ask("info", *words)
            self.assertEqual(info["betti"]["input"], [1, 0, 1])
            self.assertEqual(info["unjoined"], {"coincident": 0, "hanging": 0, "misfits": 0})
            self.assertSays(" ".join(info["warnings"]), "joined", "37", "vertices")

    def test_a_length_must_be_one(self):
        for wrong in ("-1", "nan"):
            self.assertSays(self.fail_with(1, "info", "seam.off", f"--weld={wrong}"), "--weld",
                            "number")
        self.assertSays(self.fail_with(1, "info", "seam.off", "--weld", "-1"), "--weld",
                        "number")

    def test_files_of_lengths_have_no_places(self):
        self.write("a.nsl", "2 3 1\n0 1 2\n0 1 1\n0 2 1\n1 2 1\n")
        for option in ("--weld", "--join-hanging"):
            self.assertSays(self.fail_with(2, "info", "a.nsl", option), option, "lengths")
        self.assertSays(self.fail_with(2, "info", "a.nsl", "--peel"), "--peel", "lengths")


class HangingNodes(TestCase):
    def setUp(self):
        super().setUp()
        self.write("hanging.off", off(*both(
            squares(4, 4, lambda i, j: (i / 4, j / 4, 0)),
            squares(8, 8, lambda i, j: (1 + i / 8, j / 8, 0)))))

    def test_are_counted_and_told_with_the_remedy(self):
        info = self.ask("info", "hanging.off")
        self.assertEqual(info["unjoined"]["coincident"], 5)
        self.assertEqual(info["unjoined"]["hanging"], 4)
        self.assertSays(" ".join(info["warnings"]), "--weld", "4 vertices", "hang",
                        "--join-hanging")

    def test_are_joined_if_asked(self):
        info = self.ask("info", "hanging.off", "--join-hanging")
        self.assertEqual(info["unjoined"], {"coincident": 0, "hanging": 0, "misfits": 0})
        self.assertEqual(info["euler"]["input"], 1)
        self.assertAlmostEqual(info["volume"], 2)


class Stl(TestCase):
    def test_is_always_welded_and_tells_if_places_differ(self):
        for rounding, joined in ((0.0, False), (1.2246e-16, True), (1e-12, True)):
            self.write("cube.stl", cube_stl(rounding))
            info = self.ask("info", "cube.stl")
            self.assertEqual(info["cells"]["input"], [8, 18, 12])
            self.assertEqual(info["cells"]["merged"], [8, 12, 6])
            self.assertEqual(info["betti"]["input"], [1, 0, 1])
            self.assertEqual(any("joined" in each for each in info["warnings"]), joined)
        self.write("cube.stl", cube_stl(1e-6))
        self.assertGreater(self.ask("info", "cube.stl")["boundary_components"], 0)

    def test_closed_parts_of_cad_are_closed(self):
        for path in command.data_files("cad"):
            if os.path.basename(path) in ("featuretype.STL", "1002_tray_bottom.STL", "65004.stl",
                                          "520644.stl", "torus.STL", "20mm-xyz-cube.stl"):
                info = self.ask("info", path)
                self.assertEqual(info["boundary_components"], 0, path)
                self.assertEqual(info["betti"]["input"][2], 1)
