# SPDX-License-Identifier: MIT
"""Meshes refined before anything else: the same shape, groups and vertices, shorter edges."""
import math

from command import TestCase, golden
from lengths import flat_torus
from materials import EXACT, KAPPA, plate


class Refine(TestCase):
    def test_in_every_dimension_the_shape_stays(self):
        for dimension, length in ((1, 0.3), (2, 0.3), (3, 0.5), (4, 0.7)):
            mesh = self.generate("kuhn", "--dimension", dimension, "--cells", 2, extension="nsc")
            coarse, fine = (self.ask("info", mesh, *more) for more in ((), ("--refine", length)))
            self.assertGreaterEqual(fine["cells"]["input"][-1], 2 * coarse["cells"]["input"][-1])
            self.assertAlmostEqual(fine["volume"], coarse["volume"], delta=1e-12)
            self.assertEqual(fine["betti"], coarse["betti"])

    def test_groups_and_numbers_for_each_cell_go_to_the_parts(self):
        halves = self.write("halves.mesh", plate(4, lambda x, y, i: 1 if x < 2 else 2))
        numbers = self.write("kappa.txt", "\n".join(
            "1" if i // 8 < 2 else "10" for i in range(32)))
        for kappa in (KAPPA, numbers):
            answer = self.ask("poisson", halves, "--rhs", 0, "--boundary", EXACT, "--exact", EXACT,
                              "--conductivity", kappa, "--refine", 0.1, "--side", "primal")
            self.assertLess(answer["error"]["max"], 1e-12)

    def test_enclosures_are_those_of_the_same_shape(self):
        for mesh, length in ((golden("grid4.nsc"), 0.2), (self.write("torus.nsl", flat_torus(3)), 0.5)):
            bounds = [self.ask("spectrum", mesh, "--of-shape", "--count", 4, *more)["shape"]
                      for more in ((), ("--refine", length))]
            self.assertGreater(bounds[1]["triangles"], 2 * bounds[0]["triangles"])
            for a, b, c, d in zip(bounds[0]["lower"], bounds[0]["upper"], bounds[1]["lower"], bounds[1]["upper"]):
                self.assertLessEqual(max(a, c), min(b, d))
                self.assertLessEqual(d - c, b - a)

    def test_glued_boxes_and_lengths_alone(self):
        square = self.generate("grid", "--nx", 3, "--ny", 3, extension="nsc")
        glued = ("--periodic", "1,0", "--glue", "1-x; y+1", "--refine", 0.2)
        answer = self.ask("info", square, *glued)
        self.assertEqual(answer["betti"]["merged"], [1, 1, 0])
        self.assertAlmostEqual(answer["volume"], 1, delta=1e-12)
        self.succeed("spectrum", square, "--side", "primal", "--degree", 0, "--count", 3, *glued, "-o",
                     "modes.vtu")
        torus = self.write("torus.nsl", flat_torus(4))
        found = self.ask("spectrum", torus, "--side", "dual", "--degree", 0, "--count", 2, "--refine", 0.2)
        self.assertAlmostEqual(found["eigenvalues"][1], (2 * math.pi / 4) ** 2, delta=0.01)

    def test_vertices_keep_their_numbers(self):
        square = self.generate("grid", "--nx", 2, "--ny", 2, extension="nsc")
        for more in ((), ("--refine", 0.1)):
            answer = self.ask("distance", square, "--from", 0, *more)
            self.assertAlmostEqual(answer["max"], math.sqrt(2), delta=1e-12)

    def test_files_remember_it(self):
        self.succeed("operators", golden("grid4.nsc"), "--refine", 0.2, "--out", "made")
        self.assertIn('"refine":0.2', self.read("made/manifest.json").replace(" ", ""))

    def test_lengths_that_make_no_sense_are_refused(self):
        for length in (0, -1):
            self.assertSays(self.fail_with(2, "info", golden("grid4.nsc"), "--refine", length), "above 0")
        self.assertSays(self.fail_with(2, "info", golden("grid4.nsc"), "--refine", 1e-9),
                        "would give", "simplices", "1e+08")
