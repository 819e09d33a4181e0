# SPDX-License-Identifier: MIT
"""Runs the command under limits of time and memory, for the tests beside this file."""
import collections
import json
import os
import resource
import subprocess
import sys
import tempfile
import unittest

COMMAND = GOLDEN = None
MEMORY = 500 * 2**20
limited = True

Outcome = collections.namedtuple("Outcome", "code out err")


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def run(*arguments, folder=None, seconds=120, limit=False):
    """Code, stdout and stderr. Raises subprocess.TimeoutExpired if it takes too long."""
    done = subprocess.run([COMMAND, *map(str, arguments)], cwd=folder, capture_output=True,
                          stdin=subprocess.DEVNULL, timeout=seconds, text=True,
                          preexec_fn=limit_memory if limit and limited else None)
    return Outcome(done.returncode, done.stdout, done.stderr)


def golden(name):
    return os.path.join(GOLDEN, name)


def refuse_constant(name):
    raise ValueError(f"{name} is no JSON")


def parse(text):
    """The one JSON object that the text is; NaN and infinity are none."""
    answer = json.loads(text, parse_constant=refuse_constant)
    if not isinstance(answer, dict):
        raise ValueError("no object")
    return answer


def data_files(*folders):
    """Files of the folders of real meshes, where they are; none otherwise."""
    root = os.environ.get("POLYDEC_TEST_DATA")
    for folder in folders:
        path = os.path.join(root, "meshes", folder) if root else ""
        if os.path.isdir(path):
            yield from (os.path.join(path, name) for name in sorted(os.listdir(path)))


class TestCase(unittest.TestCase):
    """A test with a folder of its own, emptied afterwards."""
    maxDiff = None

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), encoding="ascii") as file:
            return file.read()

    def succeed(self, *arguments, **options):
        outcome = run(*arguments, folder=self.folder, **options)
        self.assertEqual(outcome.code, 0, f"{arguments}\n{outcome.err}")
        return outcome

    def ask(self, *arguments, **options):
        """The JSON object that stdout holds, and nothing else."""
        return parse(self.succeed(*arguments, "--json", **options).out)

    def check_error(self, outcome, code):
        """An error of one to three lines, and nothing on stdout."""
        lines = [line for line in outcome.err.splitlines() if "polydec: warning: " not in line]
        self.assertEqual(outcome.code, code, outcome.err)
        self.assertEqual(outcome.out, "")
        self.assertIn(len(lines), (1, 2, 3), outcome.err)
        self.assertTrue(lines[0].startswith("polydec: "), outcome.err)
        return "\n".join(lines)

    def fail_with(self, code, *arguments, **options):
        return self.check_error(run(*arguments, folder=self.folder, **options), code)


def main():
    """python3 TEST COMMAND GOLDEN_FOLDER"""
    global COMMAND, GOLDEN, limited
    COMMAND, GOLDEN = map(os.path.abspath, sys.argv[1:3])
    # programs under a sanitizer reserve more addresses than any limit allows
    limited = run("--version", limit=True).code == 0
    unittest.main(module="__main__", argv=sys.argv[:1] + sys.argv[3:])
