# SPDX-License-Identifier: MIT
"""The command with dual cells between centroids."""
from command import TestCase


class Centroids(TestCase):
    def setUp(self):
        super().setUp()
        self.sphere = self.generate("uv-sphere", "--bands", "6", "--meridians", "8")

    def test_make_every_star_positive_without_merging(self):
        found = self.ask("info", self.sphere, "--centers", "centroids")
        self.assertEqual(found["cells"]["merged"], found["cells"]["input"])
        self.assertTrue(all(star["min"] > 0 for star in found["stars"]))
        merged = self.ask("info", self.sphere)
        self.assertLess(merged["cells"]["merged"][2], merged["cells"]["input"][2])

    def test_give_spectra_of_all_forms(self):
        for side in ("primal", "dual"):
            for degree in range(3):
                answer = self.ask("spectrum", self.sphere, "--side", side, "--degree", str(degree),
                                  "--count", "4", "--centers", "centroids")
                self.assertEqual(len(answer["eigenvalues"]), 4)
                self.assertGreater(answer["eigenvalues"][0], -1e-9)

    def test_are_less_exact_than_circumcenters(self):
        grid = self.generate("grid", "--nx", "6", "--ny", "6")
        errors = [self.ask("poisson", grid, "--side", "primal", "--rhs", "0",
                           "--boundary", "x*y", "--exact", "x*y", "--centers",
                           centers)["error"]["max"] for centers in ("circumcenters", "centroids")]
        self.assertLess(errors[0], 1e-12)
        self.assertGreater(errors[1], 1e-3)

    def test_other_words_are_refused(self):
        self.assertSays(self.fail_with(1, "info", self.sphere, "--centers", "incenters"),
                        "--centers: ", "circumcenters", "incenters")
