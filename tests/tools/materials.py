# SPDX-License-Identifier: MIT
"""Materials: physical groups that are kept apart, and a conductivity for each of them."""
from command import TestCase
from motions import medit, squares

KAPPA = "group==2 ? 10 : 1"
EXACT = "x<0.5 ? x : 0.5+(x-0.5)/10"


def plate(n, tag_of):
    """The text of a square of n x n squares, of two triangles each, with a group for each."""
    points, triangles = squares(n, n, lambda i, j: (i / n, j / n))
    return medit(points, Triangles=[(*triangle, tag_of(k // 2 // n, k // 2 % n, k % 2))
                                    for k, triangle in enumerate(triangles)])


class Materials(TestCase):
    def setUp(self):
        super().setUp()
        self.halves = self.write("halves.mesh", plate(4, lambda x, y, i: 1 if x < 2 else 2))
        self.checks = self.write("checks.mesh", plate(4, lambda x, y, i: 1 + i))

    def poisson(self, mesh, *arguments):
        return self.ask("poisson", mesh, "--rhs", "0", "--boundary", EXACT, "--exact", EXACT,
                        *arguments)

    def test_two_of_them_have_their_exact_solution(self):
        for side in ("primal", "dual"):
            answer = self.poisson(self.halves, "--side", side, "--conductivity", KAPPA)
            self.assertLess(answer["error"]["max"], 1e-12)
            without = self.poisson(self.halves, "--side", side)
            self.assertGreater(without["error"]["max"], 0.05)
        answer = self.poisson(self.halves, "--side", "primal", "--conductivity", KAPPA,
                              "--no-merge")
        self.assertLess(answer["error"]["max"], 1e-12)

    def test_squares_of_two_groups_are_divided_only_if_groups_are_kept(self):
        self.assertEqual(self.ask("info", self.checks)["cells"]["merged"], [25, 40, 16])
        kept = self.ask("info", self.checks, "--keep-groups")
        self.assertEqual(kept["cells"]["merged"], [25, 56, 32])
        self.assertEqual(kept["warnings"], [])

    def test_a_conductivity_is_an_expression_or_a_file_with_a_number_for_each_cell(self):
        by_place = self.poisson(self.halves, "--side", "primal", "--conductivity",
                                "x<0.5 ? 1 : 10")
        self.assertLess(by_place["error"]["max"], 1e-12)
        numbers = self.write("kappa.txt", "2 " * 32)
        self.poisson(self.halves, "--side", "dual", "--conductivity", numbers)
        said = self.fail_with(2, "poisson", self.halves, "--side", "dual", "--rhs", "0",
                              "--conductivity", self.write("few.txt", "1 2 3"))
        self.assertSays(said, self.path("few.txt") + ": ", "3 numbers", "expected 32")

    def test_files_have_a_number_for_each_cell_of_the_mesh_file_in_its_order(self):
        rows = plate(4, lambda x, y, i: 0).splitlines()
        first = rows.index("Triangles") + 2
        triangles = rows[first:first + 32]

        def largest(order, numbers, *options):
            mesh = self.write("order.mesh", "\n".join(
                rows[:first] + [triangles[i] for i in order] + rows[first + 32:]) + "\n")
            kappa = self.write("kappa.txt", " ".join(str(numbers[i]) for i in order))
            return self.ask("poisson", mesh, "--side", "primal", "--rhs", "1", "--conductivity",
                            kappa, *options)["max"]

        alone = [1 + i % 5 for i in range(32)]
        order = [(7 * i + 3) % 32 for i in range(32)]
        expected = largest(range(32), alone, "--no-merge")
        self.assertAlmostEqual(largest(order, alone, "--no-merge"), expected, 12)
        other = largest(order, sorted(alone), "--no-merge")
        self.assertGreater(abs(other - expected), 1e-4)
        pairs = [1 + i // 2 % 5 for i in range(32)] # the same for both triangles of a square
        self.assertAlmostEqual(largest(order, pairs), largest(range(32), pairs), 12)
        mesh, kappa = self.path("order.mesh"), self.path("kappa.txt")
        self.write("kappa.txt", " ".join(map(str, alone)))
        said = self.fail_with(2, "poisson", mesh, "--side", "primal", "--rhs", "1",
                              "--conductivity", kappa)
        self.assertSays(said, "conductivity", "merged", "--keep-groups")

    def test_polygons_have_one_number_each(self):
        corners = "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n"
        left, right = "4 0 1 4 3\n", "4 1 2 5 4\n"
        answers = []
        for squares, numbers in ((left + right, "1 10"), (right + left, "10 1")):
            mesh = self.write("two.off", f"OFF\n6 2 0\n{corners}{squares}")
            answers.append(self.ask("poisson", mesh, "--side", "dual", "--rhs", "1",
                                    "--conductivity", self.write("kappa.txt", numbers))["max"])
        self.assertAlmostEqual(*answers, 12)

    def test_what_makes_no_sense_is_refused(self):
        plain = self.write("plain.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        said = self.fail_with(2, "poisson", plain, "--side", "primal", "--rhs", "1",
                              "--conductivity", KAPPA)
        self.assertSays(said, "--conductivity", "`group`", "mesh")
        said = self.fail_with(2, "poisson", self.halves, "--side", "primal", "--rhs", "1",
                              "--conductivity", "1-group")
        self.assertSays(said, "conductivity")
        self.fail_with(1, "info", self.halves, "--keep-groups", "--delaunay")
        self.fail_with(1, "poisson", self.halves, "--side", "primal", "--rhs", "group")
