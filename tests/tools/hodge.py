# SPDX-License-Identifier: MIT
"""The subcommand hodge: parts of forms that are known."""
import math

from command import TestCase, golden
from motions import Mesh


class Hodge(TestCase):
    def norms(self, mesh, side, form, *more):
        found = self.ask("hodge", mesh, "--side", side, "--form", form, *more)["norms"]
        parts = [found[name] for name in ("exact", "coexact", "harmonic")]
        self.assertAlmostEqual(math.hypot(*parts), found["form"], delta=1e-9 * found["form"])
        return [part / found["form"] for part in parts]

    def test_gradients_are_exact_and_turning_is_coexact(self):
        for side, natural in (("primal", ()), ("dual", ("--natural",))):
            exact, _, harmonic = self.norms(golden("grid4.nsc"), side, "1; 2*y", *natural)
            self.assertGreater(exact, 0.99)
            self.assertLess(harmonic, 1e-9)
        exact, coexact, harmonic = self.norms(golden("uv8.off"), "primal", "-y; x; 0")
        self.assertLess(exact, 1e-9)
        self.assertGreater(coexact, 1 - 1e-9)
        self.assertLess(harmonic, 1e-9)

    def test_a_wind_around_a_torus_is_harmonic_in_part(self):
        torus = self.path("torus.off")
        self.succeed("generate", "torus", "-o", torus)
        for side in ("primal", "dual"):
            self.assertGreater(self.norms(torus, side, "-y; x; 0")[2], 0.5)
            for degree, form in ((0, "1"), (2, "x; y; z")):
                self.norms(torus, side, form, "--degree", degree)

    def test_solids_have_forms_of_four_degrees(self):
        for degree, form in enumerate(("x", "x; y; z", "x; y; z", "x")):
            for side in ("primal", "dual"):
                for mesh in ("kuhn3.nsc", "fcc1.nsc"):
                    self.norms(golden(mesh), side, form, "--degree", degree)

    def test_functions_on_duals_are_means_over_the_pieces_of_each_cell(self):
        """Galerkin's values are at centroids: of triangles a third and two thirds along a square."""
        ask = ("hodge", golden("grid4.nsc"), "--side", "dual", "--degree", 0, "--star", "galerkin", "--form")
        means = [((i + 1 / 3)**2 + (i + 2 / 3)**2) / 32 for i in range(4)] # squares of x in a column
        expected = math.sqrt(sum(mean**2 for mean in means) / 4)
        self.assertAlmostEqual(self.ask(*ask, "x^2")["norms"]["form"], expected, delta=1e-12)
        centroids = [(2 * i + 1) / 8 for i in range(4)]
        expected = math.sqrt(sum(x**2 for x in centroids) / 4)
        self.assertAlmostEqual(self.ask(*ask, "x")["norms"]["form"], expected, delta=1e-12)

    def test_norms_are_told_where_their_squares_are_no_numbers(self):
        """Of values times 1e-170, 1e160 and on a mesh times 1e80, whose powers of lengths cancel."""
        mesh, form = golden("grid4.nsc"), "-y; x"
        one = self.ask("hodge", mesh, "--form", form)["norms"]
        large = self.write("large.nsc", Mesh.read(mesh).times(1e80).text())
        for scale, (at, given) in ((1e-170, (mesh, "-1e-170*y; 1e-170*x")),
                                   (1e160, (mesh, "-1e160*y; 1e160*x")), (1e160, (large, form))):
            other = self.ask("hodge", at, "--form", given)["norms"]
            for name in ("form", "coexact"):
                self.assertAlmostEqual(other[name] / scale / one[name], 1, delta=1e-9)
        self.assertIsNone(self.ask("hodge", large, "--degree", 0, "--form", "1e250")["norms"]["form"])

    def test_pages_and_files_have_the_parts(self):
        self.succeed("hodge", golden("uv8.off"), "--side", "primal", "--form", "-y; x; z", "-o", "a.vtu")
        for name in ("form", "exact", "coexact", "harmonic"):
            with open(self.path("a.vtu"), "rb") as file:
                self.assertIn(f'Name="{name}'.encode(), file.read())
        self.succeed("hodge", golden("uv8.off"), "--side", "dual", "--form", "-y; x; z", "-o", "a.html")

    def test_other_forms_are_refused(self):
        ask = ("hodge", golden("uv8.off"), "--side", "primal")
        self.assertSays(self.fail_with(2, *ask, "--form", "x; y"), "--form", "1-form",
                        "3 coordinates", 3)
        self.assertSays(self.fail_with(2, *ask, "--form", "1/0; 0; 0"), "--form", "inf")
        self.assertSays(self.fail_with(2, *ask, "--degree", 3, "--form", "x"), "degree 3",
                        "expected", 0, 2)
        self.fail_with(1, *ask, "--form", "x; ; y")
