# SPDX-License-Identifier: MIT
"""The command on meshes of which only the lengths of edges are known."""
import math
import os

from command import TestCase
from motions import nsc, squares


def flat_torus(n):
    """The text of n x n squares, each of two triangles, glued to a torus that no space holds."""
    def at(x, y):
        return x % n * n + y % n

    triangles, edges = [], []
    for x in range(n):
        for y in range(n):
            a, b, c, d = at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)
            triangles += [f"{a} {b} {c}", f"{a} {c} {d}"]
            edges += [f"{a} {b} 1", f"{a} {d} 1", f"{a} {c} {math.sqrt(2)!r}"]
    first = f"2 {n * n} {len(triangles)} {len(edges)} # n V S E"
    return "\n".join([first, *triangles, *edges, ""])


class Lengths(TestCase):
    def setUp(self):
        super().setUp()
        self.torus = self.write("torus.nsl", flat_torus(4))

    def test_boxes_glued_to_themselves_are_such_meshes(self):
        square = self.write("square.nsc", nsc(*squares(4, 4, lambda x, y: (x, y))))
        glued = ("--periodic", "4,0", "--periodic", "0,4")
        for ask in (("info",), ("spectrum", "--side", "primal", "--degree", 1, "--count", 6),
                    ("spectrum", "--side", "dual", "--degree", 0, "--count", 5)):
            answer = self.ask(ask[0], square, *ask[1:], *glued)
            expected = self.ask(ask[0], self.torus, *ask[1:])
            if ask[0] == "info":
                self.assertEqual(answer["cells"], expected["cells"])
                self.assertEqual(answer["betti"], expected["betti"])
            else:
                for one, other in zip(answer["eigenvalues"], expected["eigenvalues"]):
                    self.assertAlmostEqual(one, other, delta=1e-9)
        in_space = self.generate("grid", "--nx", 4, "--ny", 4)
        self.assertEqual(self.ask("info", in_space, "--periodic", "1,0")["cells"],
                         self.ask("info", in_space, "--periodic", "1,0,0")["cells"])
        ribbon = self.ask("info", square, "--periodic", "4,0")
        self.assertEqual(ribbon["betti"]["merged"], [1, 1, 0])
        self.assertSays(self.fail_with(2, "info", square, "--periodic", "3.5,0"), f"{square}: ",
                        "(3.5, 0)", "no vertex")
        self.assertSays(self.fail_with(2, "info", self.torus, "--periodic", "4,0"), f"{self.torus}: ",
                        "no points")
        self.assertSays(self.fail_with(1, "info", square, "--periodic", "4;0"), "--periodic: ",
                        "numbers", "commas", "'4;0'")

    def test_sides_may_be_glued_with_a_twist(self):
        square = self.path("square.off")
        self.succeed("generate", "grid", "--nx", 6, "--ny", 6, "-o", square)
        twist = ("--glue", "x+1; 1-y")
        for more, betti in (((), [1, 1, 0]), (("--periodic", "0,1"), [1, 1, 0])):
            answer = self.ask("info", square, *twist, *more)
            self.assertEqual(answer["betti"]["merged"], betti)
        klein = self.ask("spectrum", square, "--side", "primal", "--degree", 0, "--count", 5, *twist,
                         "--periodic", "0,1")
        torus = self.ask("spectrum", square, "--side", "primal", "--degree", 0, "--count", 5,
                         "--periodic", "1,0", "--periodic", "0,1")
        self.assertAlmostEqual(klein["eigenvalues"][1], torus["eigenvalues"][1], delta=1e-9)
        self.assertGreater(klein["eigenvalues"][4], torus["eigenvalues"][4] + 1)
        self.assertEqual(self.ask("info", square, "--glue", "x+1; 1-y; z")["cells"],
                         self.ask("info", square, *twist)["cells"])
        self.assertSays(self.fail_with(2, "info", square, "--glue", "2*x; 2*y"), f"{square}: ",
                        "isometry 0", "edge", 0, 1, "expected")
        coarse = self.path("coarse.off")
        self.succeed("generate", "grid", "--nx", 4, "--ny", 4, "-o", coarse)
        self.assertSays(self.fail_with(2, "info", coarse, "--glue", "x+1; y*y"), f"{coarse}: ",
                        "isometry 0", "vertices", "as far apart", "expected")
        self.assertSays(self.fail_with(2, "info", square, "--glue", "x+1"), f"{square}: ", "--glue",
                        "1 component", "expected 3")
        self.assertSays(self.fail_with(2, "info", self.torus, *twist), f"{self.torus}: ", "no points")

    def test_info_knows_all_but_coordinates(self):
        answer = self.ask("info", self.torus)
        self.assertIsNone(answer["ambient_dimension"])
        self.assertEqual(answer["cells"], {"input": [16, 48, 32], "merged": [16, 32, 16]})
        self.assertEqual(answer["betti"]["merged"], [1, 2, 1])
        self.assertAlmostEqual(answer["volume"], 16, delta=1e-12)
        for star in answer["stars"]:
            self.assertAlmostEqual(star["min"], 1, delta=1e-12)
            self.assertAlmostEqual(star["max"], 1, delta=1e-12)
        self.assertIn("dimension 2 given by edge lengths only, volume 16\n",
                      self.succeed("info", self.torus).out)

    def test_poisson_takes_constants_and_files(self):
        values = [math.cos(math.pi / 2 * (vertex // 4)) for vertex in range(16)]
        file = self.write("f.txt", "\n".join(map(repr, values)))
        answer = self.ask("poisson", self.torus, "--side", "primal", "--rhs", file, "--natural")
        self.assertAlmostEqual(answer["max"], 1 / 2, delta=1e-12)
        answer = self.ask("poisson", self.torus, "--side", "dual", "--rhs", 0, "--natural")
        self.assertAlmostEqual(answer["max"], 0, delta=1e-12)

    def test_operators_are_written(self):
        self.succeed("operators", self.torus, "--out", "operators")
        self.assertTrue(os.path.exists(self.path("operators/lift_1.mtx")))

    def test_what_needs_points_says_so(self):
        poisson = ("poisson", self.torus, "--side", "primal", "--natural", "--rhs")
        spectrum = ("spectrum", self.torus, "--side", "primal", "--degree", 0, "--count", 1)
        for what, arguments in (("--rhs x", (*poisson, "x")),
                                ("drawing", (*poisson, 0, "-o", "u.vtu")),
                                ("drawing", (*spectrum, "-o", "u.vtu")),
                                ("drawing", ("merge", self.torus, "-o", "u.off"))):
            self.assertSays(self.fail_with(2, *arguments), "lengths", what, "needs points")
        self.assertEqual(os.listdir(self.folder), ["torus.nsl"])

    def test_lengths_that_no_triangle_has_are_refused(self):
        bad = self.write("bad.nsl", "2 3 1 3\n0 1 2\n0 1 1\n0 2 1\n1 2 2.5\n")
        self.assertSays(self.fail_with(2, "info", bad), f"polydec: {bad}: ", "lengths", "2-simplex 0",
                        "0, 1, 2", "inequality", 2.5, "1 + 1")
