# SPDX-License-Identifier: MIT
"""--help, and what is said of mistyped and missing words."""
import re

from command import TestCase, golden

GROUPS = ["Options", "Mesh", "Star", "Boundary", "Time", "Output", "Commands", "Meshes",
          "Expressions"]
PARSER = re.compile(r"[{}]|->|\b(ENUM|TEXT|INT|UINT|FLOAT|POSITIVE|NONNEGATIVE|REQUIRED)\b"
                    r"|\b(Needs|Excludes|Positionals)\b| in \[|\]\.\.\.")


def section(text, title):
    """The names in the rows of a section of help."""
    rows = text.split(f"\n{title}:\n")[1].split("\n")
    names = []
    for row in rows:
        if not row.startswith("  "):
            break
        if row[2] != " ":
            names.append(row.split()[0])
    return names


class Help(TestCase):
    def helps(self):
        """Every line of words that has a help of its own, with it."""
        whole = self.succeed("--help").out
        yield (), whole
        for name in section(whole, "Commands"):
            text = self.succeed(name, "--help").out
            yield (name,), text
            for mesh in section(text, "Meshes") if name == "generate" else ():
                yield (name, mesh), self.succeed(name, mesh, "--help").out

    def test_every_help_is_plain_and_fits(self):
        for words, text in self.helps():
            self.assertIsNone(PARSER.search(text), words)
            for line in text.splitlines():
                self.assertLessEqual(len(line), 100, words)
                self.assertEqual(line, line.rstrip(), words)
            titles = re.findall(r"^(\w+):$", text.split("\nExample")[0], re.M)
            self.assertEqual(titles, [group for group in GROUPS if group in titles], words)
        self.assertIn("Exit codes", self.succeed("--help").out)

    def test_every_help_has_an_example(self):
        for words, text in self.helps():
            if words:
                self.assertIn(f"\n  polydec {words[0]}", text.split("\nExample")[1], words)

    def test_options_are_in_groups(self):
        text = self.succeed("heat", "--help").out
        self.assertLessEqual(text.count("\n"), 60)
        self.assertEqual(section(text, "Options")[0], "--initial")
        for title, option in (("Mesh", "--periodic"), ("Star", "--star"), ("Time", "--until"),
                              ("Boundary", "--natural"), ("Output", "--json"),
                              ("Expressions", "FORM")):
            self.assertIn(option, section(text, title))

    def test_required_options_choices_and_defaults_are_named(self):
        text = self.succeed("heat", "--help").out
        for words in (("Usage: polydec heat MESH --initial FORM --until TIME [OPTIONS]",),
                      ("--side SIDE", "primal", "dual", "(default: primal)"),
                      ("--degree K", "(default: 0)"), ("--tolerance T", "(default: 0.0001)"),
                      ("--star NAME", "circumcentric", "galerkin", "hybrid", "barycentric",
                       "(default: automatic)"), ("--until TIME", "(required)"),
                      ("--frames N", "(default: 20)")):
            self.assertSays(text, *words)


class Misuse(TestCase):
    def test_the_nearest_name_is_suggested(self):
        mesh = golden("grid4.nsc")
        poisson = ("poisson", mesh, "--rhs", "1")
        for code, arguments, words in (
                (1, ("haet",), ("command 'haet'", "'heat'")),
                (1, ("haet", mesh, "--until", "1"), ("command 'haet'", "'heat'")),
                (1, (*poisson, "--sied", "dual"), ("poisson has no option '--sied'", "'--side'")),
                (1, (*poisson, "--boundry=x"), ("'--boundry=x'", "'--boundary'")),
                (1, ("generate", "uvsphere"), ("'uvsphere'", "mean 'uv-sphere'")),
                (1, ("generate", "grid", "--nz", "4", "-o", "a.off"), ("grid", "'--nz'", "'--nx'")),
                (1, ("generate", "--mesher", "tetgan", mesh), ("tetgen", "'tetgan'", "'tetgen'")),
                (1, (*poisson, "--side", "daul"), ("--side: ", "'daul'", "mean 'dual'")),
                (1, (*poisson, "--star", "galerkn"), ("--star: ", "'galerkn'", "mean 'galerkin'")),
                (1, ("reproduce", "fig77"), ("NAME: ", "'fig77'", "mean 'fig7'")),
                (2, (*poisson, "--engine", "cholmdo"), ("`cholmdo`", "mean 'cholmod'")),
                (2, ("spectrum", mesh, "--eigen-engine", "spectar"), ("`spectar`", "'spectra'")),
                (2, ("heat", mesh, "--initial", "x", "--until", "1", "--integrator", "cvod"),
                 ("`cvod`", "mean 'cvode'"))):
            self.assertSays(self.fail_with(code, *arguments), *words)

    def test_nothing_is_suggested_where_no_name_is_near(self):
        for arguments in (("frobnicate",), ("info", "m.off", "--frobnicate"),
                          ("generate", "sponge", "-o", "a.off")):
            self.assertNotIn("did you mean", self.fail_with(1, *arguments))

    def test_groups_are_suggested(self):
        self.write("walls.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
                   '1 1 "inlet"\n1 2 "outside"\n$EndPhysicalNames\n$Nodes\n3\n'
                   "1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n3\n"
                   "1 1 2 1 1 1 2\n2 1 2 2 2 2 3\n3 2 2 3 3 1 2 3\n$EndElements\n")
        self.assertSays(self.fail_with(2, "poisson", "walls.msh", "--rhs", "1", "--essential-on",
                                       "inlte"), "inlte", "mean 'inlet'", "outside")

    def test_all_that_is_missing_is_named_at_once(self):
        mesh = golden("grid4.nsc")
        for arguments, words in (
                ((), ("expected a command: ", "info", "backends")),
                (("info",), ("info needs MESH",)),
                (("heat", mesh), ("heat needs --initial FORM", "and --until TIME")),
                (("heat",), ("MESH", "--initial FORM", "--until TIME")),
                (("merge", mesh), ("--out FILE",)),
                (("generate",), ("generate: ", "grid", "clusters")),
                (("generate", "grid"), ("grid needs --out FILE",)),
                (("generate", "--mesher", "tetgen"), ("SURFACE", "and --out FILE")),
                (("reproduce",), ("NAME: ", "fig2", "all", "--list")),
                (("distance", mesh), ("--from", "--from-where", "--from-on")),
                (("poisson", mesh, "--rhs"), ("--rhs: ", "expected", "values"))):
            self.assertSays(self.fail_with(1, *arguments), *words)

    def test_options_without_effect_are_refused(self):
        mesh = golden("grid4.nsc")
        solve = ("poisson", mesh, "--rhs", "1")
        for option in (("--up", "x"), ("--length-unit", "mm")):
            for words in (solve, (*solve, "-o", "u.vtu"), ("info", mesh),
                          ("merge", mesh, "-o", "m.vtu"), ("generate", "grid", "-o", "g.off"),
                          ("distance", mesh, "--from", 0), ("spectrum", mesh),
                          ("hodge", mesh, "--form", "y; x"),
                          ("heat", mesh, "--initial", "x", "--until", 1, "-o", "h.pvd")):
                self.assertSays(self.fail_with(2, *words, *option), option[0], "page", "-o")
        self.succeed(*solve, "-o", "u.html", "--up", "x")
        self.assertSays(self.fail_with(2, "draw", mesh, "--eye", 1, 2, 3), "--eye", "plane")
        self.assertSays(self.fail_with(1, *solve, "--natural", "--robin", 2), "--natural",
                        "--robin")

    def test_side_and_degree_have_defaults(self):
        mesh = golden("grid4.nsc")
        self.assertEqual(self.ask("spectrum", mesh, "--count", 2)["eigenvalues"],
                         self.ask("spectrum", mesh, "--side", "primal", "--degree", 0, "--count",
                                  2)["eigenvalues"])
        for arguments, degree in ((("poisson", mesh, "--rhs", "1"), None),
                                  (("heat", mesh, "--initial", "x", "--until", ".1"), 0),
                                  (("hodge", mesh, "--form", "y; x"), 1)):
            answer = self.ask(*arguments)
            self.assertEqual((answer["side"], answer.get("degree")), ("primal", degree))
