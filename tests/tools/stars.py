# SPDX-License-Identifier: MIT
"""The command with every kind of star."""
import command
from command import TestCase, golden

ONE_FORMS = ("--side", "primal", "--degree", 1, "--count", 3)
KINDS = ("circumcentric", "hybrid", "galerkin", "barycentric", "automatic")


class Stars(TestCase):
    def setUp(self):
        super().setUp()
        self.negative = golden("star_negative.nsc")

    def test_are_positive_by_default_where_forms_are_solved_for(self):
        answer = self.ask("spectrum", self.negative, *ONE_FORMS)
        self.assertEqual(answer["star"], {"kind": "hybrid", "galerkin_share": 1.0})
        self.assertTrue(answer["certificate"]["complete"])
        self.assertGreater(answer["eigenvalues"][0], 0)
        warning, = answer["warnings"]
        self.assertSays(warning, "3 dual edges", "hybrid", "--delaunay")
        told = self.succeed("spectrum", self.negative, *ONE_FORMS).out
        self.assertSays(told, "hybrid stars", "Galerkin", "100 %")
        said = self.fail_with(2, "spectrum", self.negative, *ONE_FORMS, "--star", "circumcentric")
        self.assertSays(said, self.negative, "--star automatic")

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
        self.assertSays(said, "--star hybrid", "dimension 3", "galerkin", "automatic")
        self.fail_with(1, "spectrum", golden("kuhn3.nsc"), "--star", "own", *ONE_FORMS)

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

    def has_spectrum(self, mesh, side, degree, *options):
        """yes, no or, with negative eigenvalues, indefinite."""
        found = command.run("spectrum", mesh, "--side", side, "--degree", degree, "--count", 1,
                            "--json", *options, folder=self.folder)
        if found.code != 0:
            self.check_error(found, 2)
            return "no"
        value = command.parse(found.out)
        return "yes" if value["eigenvalues"][0] >= -value["radii"][0] else "indefinite"

    def test_make_the_verdicts_of_info_what_spectra_do(self):
        for name, *merging in (("star_negative.nsc",), ("fcc1.nsc",), ("grid4.nsc", "--no-merge")):
            for kind in KINDS:
                n = self.ask("info", golden(name))["dimension"]
                if kind != "hybrid" or n == 2:
                    with self.subTest(name, kind=kind):
                        self.check_verdicts(golden(name), n, ("--star", kind, *merging))

    def check_verdicts(self, mesh, n, options):
        info = self.ask("info", mesh, *options)
        told = set()
        for each in info["laplacians"]:
            k = each["degree"]
            verdicts = (each["spectrum"], each["dual_spectrum"])
            self.assertEqual(verdicts, (self.has_spectrum(mesh, "primal", k, *options),
                                        self.has_spectrum(mesh, "dual", n - k, *options)))
            told.update(verdicts)
        self.assertEqual(told == {"yes"} and all(star["zero"] == star["negative"] == 0
                                                 for star in info["stars"]), not info["advice"])
        if options[1] != "circumcentric":
            self.assertEqual(told, {"yes"})
        for way_out in {text.rsplit(": add ", 1)[1] for text in info["advice"]}:
            helped = self.ask("info", mesh, *way_out.split(), *options[2:])
            self.assertEqual(helped["advice"], [])

    def test_tell_the_numbers_of_their_diagonals(self):
        plain = self.ask("info", self.negative)
        self.assertEqual([star["diagonal"] for star in plain["stars"]], [True] * 3)
        self.assertEqual(plain["star"], {"kind": "circumcentric", "galerkin_share": 0.0})
        other = self.ask("info", self.negative, "--star", "automatic")
        self.assertEqual(other["star"], {"kind": "hybrid", "galerkin_share": 1.0})
        self.assertEqual([star["diagonal"] for star in other["stars"]], [True, False, True])
        self.assertEqual([star["negative"] for star in other["stars"]], [0] * 3)
        self.assertIsNone(other["stars"][1]["condition"])
        self.assertEqual(other["input_stars"], plain["input_stars"])
        self.assertSays(self.succeed("info", self.negative, "--star", "hybrid").out, "hybrid stars",
                        "Galerkin", "100 %")
        said = self.fail_with(2, "info", golden("kuhn3.nsc"), "--star", "hybrid")
        self.assertSays(said, "--star hybrid", "dimension 3", "galerkin", "automatic")
        solid = self.generate("bcc", "--cells", 2, extension="mesh")
        mixed = "galerkin stars, diagonal for functions"
        for star, is_mixed in (("automatic", True), ("galerkin", False)):
            said = self.succeed("spectrum", solid, "--count", 1, "--star", star).out
            self.assertIn("galerkin stars", said)
            self.assertEqual(mixed in said, is_mixed)

    def test_are_advised_where_duals_have_no_volume(self):
        for name, options, count in (("fcc1.nsc", (), 24), ("grid4.nsc", ("--no-merge",), 16)):
            advice, = self.ask("info", golden(name), *options)["advice"]
            self.assertSays(advice, f"{count} dual edges", "volume", "--star automatic")

    def test_are_advised_where_edges_cannot_flip(self):
        self.succeed("generate", "bcc", "--cells", 2, "-o", "bcc.nsc")
        advice = self.ask("info", "bcc.nsc")["advice"]
        self.assertEqual([text.rsplit(": ", 1)[1] for text in advice], ["add --star automatic"])
        self.assertGreater(self.ask("spectrum", "bcc.nsc", *ONE_FORMS)["eigenvalues"][0], 0)
