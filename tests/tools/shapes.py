# SPDX-License-Identifier: MIT
"""The subcommand spectrum with --of-shape: eigenvalues of the shape itself."""
import math
import os

from command import TestCase, golden, run


class Shapes(TestCase):
    def test_counts_below_are_proved_on_both_sides(self):
        answer = self.ask("spectrum", self.grid(), "--of-shape", "--essential-where", "1", "--below", 19.7, 19.8, 49)
        self.assertEqual([(c["s"], c["at_least"], c["at_most"]) for c in answer["shape"]["counts"]],
                         [(19.7, 0, 0), (19.8, 1, 1), (49, 1, 1)])
        told = self.succeed("spectrum", self.grid(), "--of-shape", "--below", 1).out
        self.assertIn("exactly 1 eigenvalue of the shape lies below 1", told)
        self.assertSays(self.fail_with(1, "spectrum", self.grid(), "--of-shape", "--below", 1, "--count", 3),
                        "excludes", "--below")

    def test_poisson_answers_come_with_a_proved_error(self):
        torsion = 0.0351442537 # of the unit square, the square of |grad u|
        answer = self.ask("poisson", self.grid(16), "--side", "primal", "--rhs", 1)
        bound = answer["error_bound"]
        true = (torsion - bound["size"]**2)**0.5
        self.assertTrue(true < bound["energy"] < 1.4 * true)
        self.assertTrue(0 < bound["l2"] < 0.1 * bound["energy"])
        self.assertAlmostEqual(bound["averaged_gradient"], bound["energy"] / 2, delta=1e-12)
        self.assertNotIn("without_error_bound", answer)
        told = self.succeed("poisson", self.grid(16), "--side", "primal", "--rhs", 1).out
        self.assertIn("error of the gradient at most", told)
        self.assertIn("f linear on triangles", told)
        self.assertNotIn("error_bound", self.ask("poisson", self.grid(), "--side", "dual", "--rhs", 1))
        fixed = self.ask("poisson", self.grid(), "--side", "primal", "--rhs", 0, "--fixed-where", "x<.1",
                         "--boundary", 1)
        self.assertNotIn("error_bound", fixed)
        self.assertSays(fixed["without_error_bound"], "vertex", "given value", "conditions on facets")

    def test_the_spectrum_of_a_mesh_speaks_of_the_shape_and_of_a_coarse_mesh(self):
        told = self.succeed("spectrum", self.grid(), "--side", "primal", "--degree", 0, "--count", 2).out
        self.assertIn("of this mesh", told)
        self.assertIn("--of-shape encloses", told)
        self.assertNotIn("coarse", told)
        self.assertIn("coarse", self.succeed("spectrum", golden("grid4.nsc"), "--side", "primal", "--degree", 0,
                                             "--count", 8).out)
        fine, rough = (self.ask("spectrum", mesh, "--side", "primal", "--degree", 0, "--count", 5)["coarseness"]
                       for mesh in (self.grid(16), self.grid(8)))
        self.assertAlmostEqual(rough / fine, 4, delta=0.5)

    def grid(self, cells=8):
        path = os.path.join(self.folder, f"grid{cells}.off")
        run("generate", "grid", "--nx", cells, "--ny", cells, "-o", path)
        return path

    def test_encloses_the_square_at_both_levels(self):
        truth = [2 * math.pi ** 2, 5 * math.pi ** 2, 5 * math.pi ** 2]
        widths = []
        for level in (1, 2):
            answer = self.ask("spectrum", self.grid(), "--of-shape", "--essential-where", "1", "--count", 3,
                              "--level", level)
            shape = answer["shape"]
            for low, high, exact in zip(shape["lower"], shape["upper"], truth):
                self.assertLessEqual(low, exact)
                self.assertGreaterEqual(high, exact)
            self.assertEqual((shape["zeros"], shape["triangles"], shape["level"]), (0, 128, level))
            self.assertLessEqual(shape["count_below"]["at_least"], shape["count_below"]["at_most"])
            self.assertEqual(answer["warnings"], [])
            widths.append(1 - shape["lower"][0] / shape["upper"][0])
        self.assertLess(widths[1], widths[0] / 20)

    def test_says_what_is_proved_and_counts_flips(self):
        told = self.succeed("spectrum", golden("grid4.nsc"), "--of-shape", "--count", 2).out
        for words in ("functions on the shape itself", "32 triangles after 0 flips", "(Neumann)", "exact",
                      "proved:", "eigenvalues of the shape lie below"):
            self.assertIn(words, told)
        told = self.succeed("spectrum", golden("grid4.nsc"), "--of-shape", "--count", 1).out
        self.assertIn(", 1 count of inertia)", told)

    def test_forms_of_other_degrees(self):
        for degree, lowest in ((1, math.pi ** 2), (2, 2 * math.pi ** 2)):
            shape = self.ask("spectrum", self.grid(), "--of-shape", "--degree", degree, "--count", 1)["shape"]
            self.assertLessEqual(shape["lower"][0], lowest)
            self.assertGreaterEqual(shape["upper"][0], lowest)

    def test_bisects_until_it_is_narrow_and_warns_where_it_is_not(self):
        wide = self.ask("spectrum", self.grid(4), "--of-shape", "--count", 2, "--width", "1e-5")
        self.assertSays(wide["warnings"][-1], "1 of 2", "wider", "refine")
        fine = self.ask("spectrum", self.grid(4), "--of-shape", "--count", 2, "--width", "1e-5",
                        "--max-triangles", 4000)
        self.assertEqual(fine["warnings"], [])
        self.assertGreater(fine["shape"]["triangles"], 32)
        cube = self.path("cube.nsc")
        self.succeed("generate", "kuhn", "--cells", 1, "-o", cube)
        solid = self.ask("spectrum", cube, "--of-shape", "--count", 2, "--width", "0.01", "--max-triangles", 4000)
        self.assertEqual(solid["warnings"], [])
        self.assertLessEqual(solid["shape"]["lower"][1], math.pi ** 2)
        self.assertGreaterEqual(solid["shape"]["upper"][1], math.pi ** 2)
        self.assertLess(1 - fine["shape"]["lower"][1] / fine["shape"]["upper"][1], 1e-5)

    def test_refuses_what_makes_no_sense(self):
        for code, words, said in (
                (1, ("--of-shape", "--side", "dual"), ("--side", "excludes", "--of-shape")),
                (1, ("--side", "primal", "--degree", 0, "--level", 1), ("--level", "requires", "--of-shape")),
                (1, ("--of-shape", "-o", "modes.vtu"), ("--out", "excludes", "--of-shape")),
                (1, ("--of-shape", "--star", "galerkin"), ("--star", "excludes", "--of-shape")),
                (1, ("--of-shape", "--angle-tolerance", 0.2),
                 ("--angle-tolerance", "excludes", "--of-shape")),
                (2, ("--of-shape", "--level", 3), ("level 3", "1", "2")),
                (2, ("--of-shape", "--max-triangles", -5), ("simplices", -5, 0)),
                (2, ("--of-shape", "--degree", 4), ("4-forms", "dimension 2")),
                (2, ("--of-shape", "--count", 10 ** 6), ("1000000 eigenvalues", "functions", "refine"))):
            ended = run("spectrum", golden("grid4.nsc"), *words)
            self.assertEqual(ended.code, code, ended.err)
            self.assertSays(ended.err, *said)
