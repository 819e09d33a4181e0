# SPDX-License-Identifier: MIT
"""The command with every kind of star."""
import command
from command import TestCase, golden

ONE_FORMS = ("--side", "primal", "--degree", 1, "--count", 3)


class Stars(TestCase):
    def setUp(self):
        super().setUp()
        self.negative = golden("star_negative.nsc")

    def test_are_positive_by_default_where_forms_are_solved_for(self):
        answer = self.ask("spectrum", self.negative, *ONE_FORMS)
        self.assertEqual(answer["star"], {"kind": "hybrid", "galerkin_share": 1.0})
        self.assertTrue(answer["certificate"]["complete"])
        self.assertGreater(answer["eigenvalues"][0], 0)
        self.assertEqual(answer["warnings"], [])
        told = self.succeed("spectrum", self.negative, *ONE_FORMS).out
        self.assertIn("hybrid stars, Galerkin's on 100 % of the cells", told)
        said = self.fail_with(2, "spectrum", self.negative, *ONE_FORMS, "--star", "circumcentric")
        self.assertIn("--star automatic", said)

    def test_are_circumcentric_where_these_are_positive(self):
        for command_of in (("spectrum", *ONE_FORMS), ("poisson", "--side", "dual", "--rhs", 1)):
            answer = self.ask(command_of[0], golden("grid4.nsc"), *command_of[1:])
            self.assertEqual(answer["star"], {"kind": "circumcentric", "galerkin_share": 0.0})

    def test_of_kinds_that_are_asked_for(self):
        values = {}
        for kind in ("galerkin", "hybrid", "barycentric"):
            answer = self.ask("spectrum", golden("ring6.nsc"), "--star", kind, *ONE_FORMS)
            self.assertEqual(answer["star"]["kind"],
                             "circumcentric" if kind == "hybrid" else kind)
            values[kind] = answer["eigenvalues"][2]
        self.assertEqual(len(set(values.values())), 3)
        said = self.fail_with(2, "spectrum", golden("kuhn3.nsc"), "--star", "hybrid", *ONE_FORMS)
        self.assertIn("take galerkin or automatic", said)
        self.fail_with(1, "spectrum", golden("kuhn3.nsc"), "--star", "own", *ONE_FORMS)

    def test_keep_linear_functions_on_both_sides(self):
        for side in ("primal", "dual"):
            answer = self.ask("poisson", self.negative, "--side", side, "--rhs", 0, "--boundary",
                              "1+2*x-y", "--exact", "1+2*x-y")
            self.assertEqual(answer["star"]["kind"], "hybrid")
            self.assertLess(answer["error"]["max"], 1e-12)

    def test_are_written_as_matrices(self):
        self.succeed("operators", self.negative, "--out", "plain")
        self.assertIn("array", self.read("plain/star_1.mtx").splitlines()[0])
        said = command.run("operators", self.negative, "--star", "galerkin", "--out", "whitney",
                           folder=self.folder)
        self.assertEqual(said.code, 0)
        self.assertIn("laplacian_primal_1.mtx", said.err)
        rows = [line.split() for line in self.read("whitney/star_1.mtx").splitlines()
                if not line.startswith("%")]
        entries = {(row[0], row[1]): float(row[2]) for row in rows[1:]}
        self.assertGreater(len(entries), int(rows[0][0]))
        self.assertTrue(all(entries[i, j] == entries[j, i] for i, j in entries))

    def test_are_advised_where_edges_cannot_flip(self):
        self.succeed("generate", "bcc", "--cells", 2, "-o", "bcc.nsc")
        advice = self.ask("info", "bcc.nsc")["advice"]
        self.assertEqual([text.rsplit(": ", 1)[1] for text in advice], ["add --star automatic"])
        self.assertGreater(self.ask("spectrum", "bcc.nsc", *ONE_FORMS)["eigenvalues"][0], 0)


if __name__ == "__main__":
    command.main()
