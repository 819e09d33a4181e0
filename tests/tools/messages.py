# SPDX-License-Identifier: MIT
"""Messages name the file, can be printed, end soon, and say what was expected."""
import os

from command import TestCase, golden

FLAT = "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"


class Messages(TestCase):
    def test_options_say_what_they_expect(self):
        mesh = golden("grid4.nsc")
        spectrum = ("spectrum", mesh, "--side", "primal", "--degree")
        for arguments, words in (
                (("info", mesh, "--tolerance", "nan"), ("--tolerance: ", "number", 0, "'nan'")),
                (("info", mesh, "--tolerance", "inf"), ("--tolerance: ", "number", 0, "'inf'")),
                (("info", mesh, "--tolerance", "1e-4x"), ("--tolerance: ", "number", 0, "'1e-4x'")),
                (("info", mesh, "--angle-tolerance", "-nan"),
                 ("--angle-tolerance: ", "number", 0, "'-nan'")),
                ((*spectrum, "0", "--count", "1e3"), ("--count: ", "whole number", "'1e3'")),
                ((*spectrum, "0", "--count", "99999999999"),
                 ("--count: ", "whole number", "'99999999999'")),
                ((*spectrum, "one"), ("--degree: ", "whole number", "'one'")),
                (("distance", mesh, "--from", "0.5"), ("--from: ", "whole number", "'0.5'")),
                (("distance", mesh, "--from", "0", "--time-scale", "nan"),
                 ("--time-scale: ", "number", "'nan'")),
                (("generate", "kuhn", "--cells", "2.5", "-o", "a.nsc"),
                 ("--cells: ", "whole number", "'2.5'")),
                (("generate", "kuhn", "--lengths", "inf", "-o", "a.nsc"),
                 ("--lengths: ", "number", "'inf'")),
                (("generate", "clusters", "--seed", "-1", "-o", "a.nsc"),
                 ("--seed: ", "whole number", 0, "'-1'")),
                (("info", ""), ("MESH: ", "empty")),
                (("info", mesh, "--max-memory", "much"),
                 ("--max-memory: ", "500M", "2G", "'much'")),
                (("info", mesh, "--max-memory", "-1G"), ("--max-memory: ", "500M", "2G", "'-1G'")),
                (("info", "-dash.off"), ("'-dash.off'", "./", "--rhs=-x")),
                (("info", mesh, "\x1b[2J\n"), ("'\\x1b[2J\\n'",))):
            self.assertSays(self.fail_with(1, *arguments), *words)
        self.assertEqual(os.listdir(self.folder), [])

    def test_whole_numbers_are_decimal(self):
        for text, squares in (("010", 10), ("08", 8), ("+0009", 9), ("+7", 7)):
            answer = self.ask("generate", "grid", "--nx", text, "--ny", "01", "-o", "a.nsc")
            self.assertEqual(answer["points"], (squares + 1) * 2)
        for text in ("0x10", "0b1", "+-3", "1_0", "1'0"):
            self.assertSays(self.fail_with(1, "generate", "grid", "--nx", text, "-o", "a.nsc"),
                            "polydec: --nx: ", "whole number", f"'{text}'")
        self.ask("generate", "clusters", "--seed", "010", "-o", "a.nsc")
        self.ask("generate", "clusters", "--seed", "10", "-o", "b.nsc")
        self.assertEqual(self.read("a.nsc"), self.read("b.nsc"))

    def test_a_file_whose_name_begins_with_a_dash_can_be_named(self):
        self.write("-dash.off", FLAT.replace("2 0 0", "0 1 0"))
        self.succeed("info", "./-dash.off")

    def test_what_shows_after_reading_names_the_file(self):
        self.write("flat.off", FLAT)
        for arguments in (("info",), ("merge", "-o", "a.off"), ("operators", "--out", "out"),
                          ("poisson", "--side", "primal", "--rhs", "1"), ("distance", "--from", "0"),
                          ("spectrum", "--side", "primal", "--degree", "0")):
            self.assertSays(self.fail_with(2, arguments[0], "flat.off", *arguments[1:]),
                            "polydec: flat.off: ", "no cells", "\n", "1 cell", "area", "0 (0 1 2)")

    def test_names_are_printable(self):
        name = "a\x1b[31m\nb\u202ec.off"
        self.write(name, FLAT)
        message = self.fail_with(2, "info", name)
        self.assertTrue(message.startswith("polydec: a\\x1b[31m\\nb\\u202ec.off: "), message)
        self.assertTrue(all(line.isprintable() for line in message.split("\n")), message)
        self.assertSays(self.fail_with(4, "info", "no\n.off"), "read", "no\\n.off: ",
                        "No such file")
        self.write("é.off", FLAT)
        self.assertTrue(self.fail_with(2, "info", "é.off").startswith("polydec: é.off: "))

    def test_bytes_that_are_no_text_are_told_as_such(self):
        name = os.path.join(os.fsencode(self.folder), b"\xff\xfe.off")
        with open(name, "wb") as file:
            file.write(FLAT.replace("2 0 0", "0 1 0").encode())
        self.assertEqual(self.ask("merge", name, "-o", b"\xff.obj")["out"], "\\xff.obj")
        self.assertSays(self.fail_with(4, "info", b"\xff.off"), "read", "\\xff.off: ",
                        "No such file")

    def test_messages_end_after_a_few_hundred_characters(self):
        long = "x" * 100000
        for code, arguments in ((1, ("poisson", "m.off", "--side", "primal", "--rhs", long)),
                                (1, ("info", "m.off", f"--{long}")),
                                (1, ("info", "m.off", "--tolerance", long)),
                                (1, (long,)), (4, ("info", f"{long}.off")),
                                (2, ("info", f"m.{long}"))):
            message = self.fail_with(code, *arguments)
            self.assertLess(len(message), 800, message)
        self.write("word.off", f"OFF\n3 1 0\n{long} 0 0\n")
        self.assertLess(len(self.fail_with(2, "info", "word.off")), 800)

    def test_the_end_of_a_long_name_is_told(self):
        message = self.fail_with(4, "info", "folder/" * 60 + "mesh.off")
        self.assertSays(message, "polydec: ", "read", "...", "/mesh.off: ", "No such file")
        self.assertLess(len(message), 800)

    def test_names_in_answers_are_printable_as_text_and_whole_in_json(self):
        name = "a\x1b[31m\nb"
        for arguments in (("generate", "grid", "-o", f"{name}.off"), ("info", f"{name}.off"),
                          ("merge", f"{name}.off", "-o", f"{name}.ply"),
                          ("operators", f"{name}.off", "--out", name),
                          ("reproduce", "fig6", "--levels", "1", "--out", name + "2")):
            text = self.succeed(*arguments).out
            self.assertIn("a\\x1b[31m\\nb", text)
            self.assertNotIn("\x1b", text)
            if arguments[0] in ("generate", "merge", "operators"):
                self.assertEqual(self.ask(*arguments)["out"], arguments[-1])
