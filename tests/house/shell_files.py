# SPDX-License-Identifier: MIT
"""Manual pages and completions that cmake/shell_files.py makes of the command: each command has a
page that man formats without complaint, and the shells complete its words.

Usage: shell_files.py PROGRAM VERSION. A shell that is not there is passed over.
"""
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "cmake" / "shell_files.py"
PROGRAM, VERSION = sys.argv.pop(1), sys.argv.pop(1)


def load():
    spec = importlib.util.spec_from_file_location("made_by", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    sys.modules["made_by"] = module
    spec.loader.exec_module(module)
    return module


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"there is no {program}")


class ShellFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.share = Path(cls.folder.name)
        subprocess.run([sys.executable, "-B", SCRIPT, PROGRAM, VERSION, cls.share], check=True)
        cls.commands = load().commands_of(PROGRAM)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_shell(self, *words):
        done = subprocess.run(words, check=True, text=True, capture_output=True, timeout=60,
                              stdin=subprocess.DEVNULL, cwd=self.share,
                              env={**os.environ, "HOME": str(self.share), "LC_ALL": "C.UTF-8"})
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_each_command_of_help_is_described(self):
        text = subprocess.run([PROGRAM, "--help"], check=True, text=True, capture_output=True).stdout
        self.assertGreaterEqual(len(self.commands[""].commands), 16)
        for word in self.commands[""].commands:
            self.assertIn(word, text)
        names = [name for option in self.commands["spectrum"].options for name in option.names]
        self.assertLessEqual({"--side", "--degree", "--count"}, set(names))

    def test_each_command_has_a_page(self):
        pages = {page.name for page in (self.share / "man/man1").iterdir()}
        self.assertEqual(pages, {"polydec.1", *(f"polydec-{word}.1"
                                                for word in self.commands[""].commands)})
        text = (self.share / "man/man1/polydec-spectrum.1").read_text()
        self.assertIn(VERSION, text)
        self.assertIn(r"\-\-side", text)

    @needs("man")
    def test_man_formats_the_pages(self):
        for page in ("polydec.1", "polydec-spectrum.1", "polydec-generate.1"):
            text = self.run_shell("man", "--warnings", "-P", "cat", "-l",
                                  str(self.share / "man/man1" / page))
            self.assertIn("SYNOPSIS", text)

    @needs("bash")
    def test_bash_completes(self):
        def completed(*words):
            array = " ".join(f"'{word}'" for word in words)
            return self.run_shell("bash", "-c", f"""
                source bash-completion/completions/polydec
                COMP_WORDS=(polydec {array}); COMP_CWORD={len(words)}; _polydec
                echo "${{COMPREPLY[*]}}" """).split()
        self.assertEqual(completed("spec"), ["spectrum"])
        self.assertIn("--side", completed("spectrum", "--s"))
        self.assertEqual(completed("spectrum", "--side", ""), [])  # files
        self.assertIn("icosphere", completed("generate", "ico"))
        self.assertNotIn("spectrum", completed("spectrum", "mesh.off", "s"))

    @needs("zsh")
    def test_zsh_completes(self):
        def completed(*words):
            array = " ".join(f"'{word}'" for word in words)
            return self.run_shell("zsh", "-f", "-c", f"""
                _describe() {{ print -l -- $known; }}; _files() {{ }}
                complete_it() {{ local -a words=(polydec {array}); local CURRENT={len(words) + 1}
                                 source zsh/site-functions/_polydec; }}
                complete_it""").splitlines()
        self.assertTrue(any(line.startswith("spectrum:") for line in completed("")))
        self.assertTrue(any(line.startswith("--side:") for line in completed("spectrum", "")))

    @needs("fish")
    def test_fish_completes(self):
        def completed(line):
            text = self.run_shell("fish", "--no-config", "-c", f"""
                source fish/vendor_completions.d/polydec.fish; function polydec; end
                complete -C '{line}'""")
            return {entry.split("\t")[0] for entry in text.splitlines()}
        self.assertIn("spectrum", completed("polydec spec"))
        self.assertIn("--side", completed("polydec spectrum --s"))
        self.assertIn("icosphere", completed("polydec generate ico"))


if __name__ == "__main__":
    unittest.main()
