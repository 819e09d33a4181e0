# SPDX-License-Identifier: MIT
"""Shows that the checks of the house can fail: each flaw put into a sound tree is named, alone."""
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import layering
import site_checks
import words

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
import tables  # noqa: E402

SPDX = "// SPDX-License-Identifier: MIT\n"
SOUND = {
    "polydec.h": SPDX + '#include "dec/star.h"\n',
    "base/text.cpp": SPDX + 'const char* text = "cut-off - well-known -1";\n',
    "base/types.h": SPDX + "#include <Eigen/Core>\n\n#include <cstdint>\n",
    "complex/cells.h": SPDX + '#include "base/types.h"\n',
    "complex/cells.cpp": SPDX + '#include "complex/cells.h"\n\n#include <fmt/format.h>\n'
                         "// dimension == 3 is nothing special, nor is \"--option\"\n"
                         'const char* text = "dimension == 3";\n',
    "backends/engine.cpp": SPDX + "#include <Spectra/SymEigsSolver.h>\n#include <cholmod.h>\n",
    "dec/star.h": SPDX + '#include "complex/cells.h"\n\n#include <vector>\n',
    "dec/star.cpp": SPDX + "bool top(int k) { return k == dimension() && size(3) == n; }\n",
    "dec/detail.h": SPDX + "#include <fmt/format.h>\n",
    "tools/main.cpp": SPDX + '#include "examples/report.h"\n#include "polydec.h"\n\n'
                             "#include <CLI/CLI.hpp>\n",
    "tests/dec/star.cpp": SPDX + '#include "dec/star.h"\n#include "examples/report.h"\n'
                                 "#include <Eigen/SparseLU>\n",
    "tests/dec/mesh.py": "#!/usr/bin/env python3\n# SPDX-License-Identifier: MIT\n",
    "examples/01_first.cpp": SPDX + "#include <polydec.h>\n",
    "build/thing.cpp": '#include "io/anything.h"\n',
    "demo": "#!/bin/sh\n# SPDX-License-Identifier: MIT\n",
}
PUBLIC = {"polydec.h", "base/types.h", "complex/cells.h", "dec/star.h"}

# (file, what is put at its end, part of the complaint)
FLAWS = [
    ("base/types.h", '#include "complex/cells.h"', "complex is not to its left"),
    ("complex/cells.cpp", '#include "dec/star.h"', "dec is not to its left"),
    ("complex/cells.cpp", "#include <dec/star.h>", "dec is not to its left"),
    ("complex/cells.cpp", '  #  include "tests/dec/star.h"', "tests is not to its left"),
    ("dec/star.cpp", '#include "polydec.h"', "polydec.h is not to its left"),
    ("polydec.h", '#include "tools/main.h"', "tools is not to its left"),
    ("dec/star.cpp", 'auto star = fmt::format("*");', "includes no fmt/format.h"),
    ("dec/star.cpp", "Vector ones() { throw 1; }", "includes no base/types.h"),
    ("complex/cells.cpp", 'void fail() { throw InvalidInput("no"); }', "includes no base/errors.h"),
    ("examples/01_first.cpp", '#include "tests/dec/star.h"', "tests is not to its left"),
    ("examples/01_first.cpp", '#include "tools/main.h"', "tools is not to its left"),
    ("polydec.h", '#include "examples/report.h"', "examples is not to its left"),
    ("tools/main.cpp", '#include "tests/star.h"', "tests is not to its left"),
    ("dec/star.cpp", '#include "star.h"', "no path from the repository root"),
    ("dec/star.h", "#include <fmt/format.h>", "Eigen and std alone"),
    ("dec/star.h", "#include <math.h>", "Eigen and std alone"),
    ("dec/star.h", '#include "dec/detail.h"', "not installed"),
    ("dec/star.cpp", "#include <Spectra/SymEigsSolver.h>", "belongs into backends"),
    ("dec/star.cpp", "#include <cholmod.h>", "belongs into backends"),
    ("dec/star.cpp", "#include <suitesparse/cholmod.h>", "belongs into backends"),
    ("dec/star.cpp", "#include <Eigen/SparseCholesky>", "belongs into backends"),
    ("dec/star.cpp", "#include <Eigen/CholmodSupport>", "belongs into backends"),
    ("examples/01_first.cpp", "#include <Spectra/SymEigsSolver.h>", "belongs into backends"),
    ("tests/dec/star.cpp", "#include <Spectra/SymEigsSolver.h>", "belongs into backends"),
    ("dec/star.cpp", "if (dimension == 3) {", "branch on the dimension"),
    ("dec/star.cpp", "if (K.dimension()==2) {", "branch on the dimension"),
    ("dec/star.cpp", "return 2 == complex.dimension() ? a : b;", "branch on the dimension"),
    ("dec/star.cpp", "switch (volumes.dimension()) {", "branch on the dimension"),
    ("complex/cells.cpp", "if (ambient_dimension == 3)", "branch on the dimension"),
    ("complex/cells.cpp", "/* why\n */ if (n == 2)", "branch on the dimension"),
    ("dec/star.cpp", 'throw Error("give --side dual");', "an option of the command"),
    ("dec/star.cpp", 'throw Error("leave out -o");', "an option of the command"),
    ("tests/dec/star.cpp", "namespace polydec::test::in_star {}\nint one(int k) { return k; }",
     "never called"),
    ("dec/star.cpp", "\n" * 400, "longer than 400 lines"),
]


class Twins(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        for name, code in SOUND.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(code)

    def assert_only(self, complaints, place, part):
        self.assertEqual(len(complaints), 1, complaints)
        self.assertTrue(complaints[0].startswith(place + ": "), complaints)
        self.assertIn(part, complaints[0])

    def test_a_sound_tree_passes(self):
        self.assertEqual(layering.check(self.root, PUBLIC), [])
        self.assertEqual(words.check(self.root), [])

    def test_each_flaw_is_named_alone(self):
        for name, flaw, part in FLAWS:
            with self.subTest(name=name, flaw=flaw):
                (self.root / name).write_text(SOUND[name] + flaw + "\n")
                line = (SOUND[name] + flaw + "\n").count("\n")
                self.assert_only(layering.check(self.root, PUBLIC), f"{name}:{line}", part)
                (self.root / name).write_text(SOUND[name])

    def test_a_header_is_reached_from_the_umbrella_or_not_installed(self):
        complaints = layering.check(self.root, PUBLIC | {"dec/detail.h"})
        self.assert_only(complaints[:1], "dec/detail.h:1", "not reached")
        self.assertEqual(layering.check(self.root, PUBLIC | {"base/text.h"}, {"base/text.h"}), [])

    def test_rooms_that_include_each_other_are_named(self):
        star, cells = self.root / "dec/stars/star.h", self.root / "dec/cells.cpp"
        star.parent.mkdir()
        star.write_text(SPDX + '#include "dec/detail.h"\n')
        self.assertEqual(layering.check(self.root, PUBLIC), [])
        cells.write_text(SPDX + '#include "dec/stars/star.h"\n')
        complaints = layering.check(self.root, PUBLIC)
        self.assertEqual(len(complaints), 2)
        self.assertIn("dec/cells.cpp:1: dec and dec/stars include each other", complaints)

    def test_every_kind_of_source_needs_the_license_line(self):
        for name in ("dec/a.h", "dec/a.cpp", "dec/CMakeLists.txt", "cmake/a.cmake",
                     "cmake/a.cmake.in", "scripts/a.sh", "tests/a.py"):
            with self.subTest(name=name):
                (self.root / name).parent.mkdir(exist_ok=True)
                (self.root / name).write_text("\n")
                self.assert_only(layering.check(self.root, PUBLIC), f"{name}:1", "is missing")
                (self.root / name).unlink()

    def test_a_script_needs_the_license_line_below_its_first(self):
        (self.root / "demo").write_text("#!/bin/sh\necho\n")
        self.assert_only(layering.check(self.root, PUBLIC), "demo:2", "is missing")

    def test_each_word_is_found(self):
        for word in words.WORDS:
            with self.subTest(word=word):
                (self.root / "README.md").write_text(f"Read\nsee {word}\n")
                self.assert_only(words.check(self.root), "README.md:2", f"`{word}`")

    def test_each_phrase_is_found_over_two_lines_too(self):
        for phrase in words.PHRASES:
            with self.subTest(phrase=phrase):
                self.assert_phrase("README.md", f"Read\nsee {phrase}\n", phrase)
                first, rest = phrase.split(" ", 1)
                self.assert_phrase("base/a.cpp", f'{SPDX}t("see {first} "\n  "{rest}");\n', phrase)

    def assert_phrase(self, name, text, phrase):
        (self.root / name).write_text(text)
        self.assert_only(words.check(self.root), f"{name}:2", f"`{phrase}`")
        (self.root / name).unlink()

    def test_each_flaw_of_a_site_is_named(self):
        html = self.root / "html"
        html.mkdir()
        (html / "other.html").write_text('<p id="here">')
        for flaw, part in (('<a href="other.html#here">', None),
                           ('<a href="none.html">', "not there"),
                           ('<a href="other.html#there">', "no such anchor"),
                           ('<script src="https://elsewhere.example/a.js">', "loads"),
                           ('<link href="//elsewhere.example/a.css">', "loads")):
            with self.subTest(flaw=flaw):
                (html / "index.html").write_text(flaw)
                complaints = site_checks.lost_links(html.resolve())
                self.assertEqual(len(complaints), 1 if part else 0, complaints)
                self.assertTrue(all(part in complaint for complaint in complaints))

    def test_memory_beyond_its_target_is_named(self):
        rows = {name: dict(zip(("result_B", "peak_B"), targets))
                for name, targets in tables.MEMORY_TARGETS.items()}
        self.assertEqual(tables.memory_failures(rows), [])
        for name, row in rows.items():
            for counter in row:
                with self.subTest(name=name, counter=counter):
                    worse = {**rows, name: {**row, counter: 1.2 * row[counter]}}
                    complaints = tables.memory_failures(worse)
                    self.assertEqual(len(complaints), 1, complaints)
                    self.assertIn(name, complaints[0])


if __name__ == "__main__":
    unittest.main()
