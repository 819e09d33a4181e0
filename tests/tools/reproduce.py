# SPDX-License-Identifier: MIT
"""The figures and tables of the paper as programs get them; those that take no time."""
import os
import xml.etree.ElementTree

import command
from command import TestCase, golden

NAMES = ["table1", "table2", "fig2", "fig6", "fig7", "fig8", "fig9", "fig10", "spectra"]
QUICK = ("fig2", "fig6", "table1")


class Reproduce(TestCase):
    def test_the_list_names_each_with_a_summary(self):
        listed = self.ask("reproduce", "--list")["reproductions"]
        self.assertEqual([each["name"] for each in listed], NAMES)
        lines = self.succeed("reproduce", "--list").out.splitlines()
        self.assertEqual(lines, [f"{each['name']:<9} {each['summary']}" for each in listed])

    def test_reports_are_printed(self):
        for name in QUICK:
            outcome = self.succeed("reproduce", name)
            self.assertTrue(outcome.out.startswith(f"{name}: "))
            self.assertEqual(outcome.err, "")
        self.assertEqual(os.listdir(self.folder), [])

    def test_json_is_one_object_with_the_rows_of_every_table(self):
        for name in QUICK:
            report = self.ask("reproduce", name)
            self.assertEqual(set(report), {"name", "title", "tables", "plots", "drawings",
                                           "remarks", "warnings"})
            self.assertEqual(report["name"], name)
            self.assertTrue(report["tables"])
            for table in report["tables"]:
                self.assertTrue(table["rows"])
                for row in table["rows"]:
                    self.assertEqual(len(row), len(table["columns"]))

    def test_the_files_told_are_those_written(self):
        for name in QUICK:
            lines = self.succeed("reproduce", name, "--out", f"out/{name}").out.splitlines()
            told = [line for line in lines if line.startswith("out/")]
            there = [f"out/{name}/{file}" for file in os.listdir(self.path(f"out/{name}"))]
            self.assertEqual(sorted(told), sorted(there))
            self.assertIn(f"out/{name}/{name}.json", there)
            report = command.parse(self.read(f"out/{name}/{name}.json"))
            self.assertEqual({**report, "warnings": []}, self.ask("reproduce", name))
            suffixes = [os.path.splitext(file)[1] for file in there]
            self.assertEqual(suffixes.count(".csv"), len(report["tables"]))
            self.assertEqual(suffixes.count(".svg"),
                             len(report["plots"]) + len(report["drawings"]))
            for file in there:
                if file.endswith(".svg"):
                    root = xml.etree.ElementTree.parse(self.path(file)).getroot()
                    self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")

    def test_a_folder_of_meshes_is_surveyed(self):
        report = self.ask("reproduce", "table2", "--meshes", golden("."))
        rows = {row[0]: row for row in report["tables"][0]["rows"]}
        self.assertEqual(rows["uv8.off"][1], 112)
        self.assertIn("all", rows)
        self.assertSays(rows["kuhn3.nsc"][-1], "dimension 3")
        self.assertIsNone(rows["kuhn3.nsc"][1])

    def test_refusals(self):
        for arguments, words in (
                ((), ("NAME: ", "expected", "all", "--list")),
                (("fig1",), ("NAME: ", ", ".join(NAMES), "all", "'fig1'")),
                (("fig2", "--list"), ("NAME", "--list")),
                (("--list", "--levels", "3"), ("--list", "--levels")),
                (("--list", "--out", "figures"), ("--list", "--out")),
                (("--list", "--meshes", "models"), ("--list", "--meshes")),
                (("fig2", "--levels", "0"), ("--levels: ", "number", 1, 20, "'0'"))):
            self.assertSays(self.fail_with(1, "reproduce", *arguments), *words)
        self.assertSays(self.fail_with(4, "reproduce", "table2", "--meshes", "none"), "read",
                        "folder none: ", "No such file")
        os.mkdir(self.path("empty"))
        self.assertSays(self.fail_with(2, "reproduce", "table2", "--meshes", "empty"),
                        "folder empty", "extension", ".off, .obj, .ply, .stl")
