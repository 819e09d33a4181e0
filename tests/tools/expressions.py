# SPDX-License-Identifier: MIT
"""Expressions mean what they say, or are refused before any work is done."""
import os

from command import TestCase, golden

# What the parser would take for something else: what is said of it, and the position.
MISREAD = {
    "x=0": ("=", "==", 2),
    "x = y": ("=", "==", 3),
    "x==0 ? y=1 : 2": ("=", "==", 9),
    "x,y": ("comma", "point", 2),
    "0,5": ("comma", "point", 2),
    "0,5*x": ("comma", "point", 2),
    "(0,5)": ("comma", "point", 3),
    "2*(x,y)": ("comma", "point", 5),
    "max(0,5, x)": ("decimal comma", "arguments", 6),
    "0<x<1": ("comparison", "&&", 5),
    "x==y==0": ("comparison", "&&", 7),
    "x\ny": ("character", 2),
    "é": ("character", 1),
    '"x"': ("character", 1),
    "x\x1b[31m": ("character", 2),
    "+".join(["x"] * 5001): ("10001 characters", 10000),
    "(" * 250 + "x" + ")" * 250: (200, "parentheses", 200),
}
NO_EXPRESSIONS = ("2x", "x y", "sin x", "x +", "x;y", "x!", "x%2", "e", "v", "()", "1..2", "if(x,1, 2)",
                  "x += 1", "1e400", "x?1", "_pi", "_e")
# Value at (x, y) = (1, 1), the last vertex of the grid, whose values at other vertices differ.
GOOD = {
    "x+2*y": 3, "-x^2-y": -2, "2^3^(x*y)": 8, "max(x, 5*y)": 5, "atan2(x,1)": 0.7853981633974483,
    "x>0.5 && y>0.5": 1, "(x<0.5) == (y<0.5)": 1, "x>=1 ? 7 : y<0.5 ? 1 : 2": 7, "x1+x2": 2,
    "log(exp(x))": 1, "cos(pi*x)": -1, "+".join(["x"] * 2000): 2000,
}


class Expressions(TestCase):
    def arguments(self, option, text, mesh=None):
        data = {"--rhs": "0", option: text}
        return ("poisson", mesh or golden("grid4.nsc"), "--side", "primal",
                *(f"{name}={value}" for name, value in data.items()))

    def test_what_would_be_misread_is_refused(self):
        for text, words in MISREAD.items():
            with self.subTest(text[:40]):
                message = self.fail_with(1, *self.arguments("--rhs", text))
                self.assertTrue(message.startswith("polydec: --rhs: '"), message)
                self.assertSays(message.rpartition("' ")[2], "expression", *words)
                self.assertTrue(message.isprintable() or "\n" in message, message)
                self.assertNotIn("\x1b", message)

    def test_what_is_no_expression_is_refused(self):
        for text in NO_EXPRESSIONS:
            with self.subTest(text):
                message = self.fail_with(1, *self.arguments("--rhs", text))
                self.assertTrue(message.startswith(f"polydec: --rhs: '{text}' "), message)
                self.assertSays(message, f"'{text}' ", "expression")

    def test_each_option_is_looked_at_before_the_mesh_is(self):
        for option in ("--rhs", "--boundary", "--flux", "--exact", "--essential-where"):
            self.assertSays(
                self.fail_with(1, *self.arguments(option, "x=0", "there-is-no-such.off")),
                f"polydec: {option}: ", "'x=0'", "expression", "=", "==", "position 2")

    def test_positions_count_from_1(self):
        for text, position in (("q", 1), ("x+", 3), ("1+)", 3), ("x=0", 2)):
            self.assertSays(self.fail_with(1, *self.arguments("--rhs", text)), f"'{text}'",
                            f"position {position}")

    def test_good_ones_have_their_values(self):
        for text, value in GOOD.items():
            with self.subTest(text[:40]):
                answer = self.ask(*self.arguments("--boundary", f"(x==1 && y==1) * ({text})"))
                self.assertAlmostEqual(answer["max"] if value > 0 else answer["min"], value,
                                       delta=1e-13 * abs(value))

    def test_only_coordinates_of_the_mesh_are_known(self):
        for mesh, text, used, has in (("grid4.nsc", "x+z", 3, 2), ("grid4.nsc", "x3", 3, 2),
                                      ("kuhn1d.nsc", "y", 2, 1), ("uv8.off", "x4", 4, 3)):
            self.assertSays(
                self.fail_with(2, *self.arguments("--boundary", text, golden(mesh))),
                "polydec: --boundary: ", f"'{text}'", f"coordinate {used}", "mesh", has)
        self.succeed(*self.arguments("--boundary", "x4*x1", golden("kuhn4.nsc")))

    def test_a_file_that_could_be_an_expression_is_not_guessed_at(self):
        self.write("x", "0 " * 25)
        self.assertSays(self.fail_with(1, *self.arguments("--rhs", "x")), "polydec: --rhs: ", "'x'",
                        "expression", "file", "(x)", "./x")
        self.succeed(*self.arguments("--rhs", "(x)"))
        self.succeed(*self.arguments("--rhs", "./x"))
        # the default is no file
        self.write("0", "nothing")
        self.succeed("poisson", golden("grid4.nsc"), "--side", "primal", "--rhs", "1")

    def test_values_do_not_depend_on_the_order_of_sites(self):
        rows = [(0, 0), (1, 0), (1, 1), (0, 1)]
        answers = []
        for order in ((0, 1, 2, 3), (2, 0, 3, 1)):
            place = {v: i for i, v in enumerate(order)}
            lines = ["2 2 4 2", *("%d %d" % rows[v] for v in order),
                     *(" ".join(str(place[v]) for v in cell) for cell in ((0, 1, 2), (0, 2, 3)))]
            mesh = self.write("square.nsc", "\n".join(lines) + "\n")
            answer = self.ask("poisson", mesh, "--side", "primal", "--rhs", "0", "--boundary",
                              "x + 3*y - (x>0.5 ? 2 : y)")
            answers.append((answer["min"], answer["max"]))
        self.assertEqual(answers[0], answers[1])

    def test_no_work_is_done_for_a_wrong_file_of_values(self):
        self.write("f.txt", "1 2 3x")
        self.assertSays(self.fail_with(2, *self.arguments("--rhs", "f.txt", "no-such.off")),
                        "polydec: f.txt: ", "entry 2", "number", "expected")
        self.assertEqual(os.listdir(self.folder), ["f.txt"])
