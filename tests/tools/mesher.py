# SPDX-License-Identifier: MIT
"""generate --mesher: what it makes, what it refuses, and that nothing of it stays behind. Where
TetGen is not there, the command has to say how to get it instead."""
import os
import shutil
import signal
import subprocess
import unittest

import command
from command import TestCase

CUBE = ("OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n4 0 2 3 1\n4 4 5 7 6\n"
        "4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")
THERE = shutil.which("tetgen") is not None


class Mesher(TestCase):
    def setUp(self):
        super().setUp()
        self.write("cube.off", CUBE)
        self.temporary = self.path("temporary")
        os.mkdir(self.temporary)

    def tearDown(self):
        self.assertEqual(os.listdir(self.temporary), [])

    def environment(self):
        return {**os.environ, "TMPDIR": self.temporary}

    def fill(self, *arguments, **variables):
        """Code, stdout and stderr of generate --mesher tetgen."""
        return command.run("generate", "--mesher", "tetgen", *arguments, folder=self.folder,
                           env={**self.environment(), **variables})

    def check_missing(self, outcome):
        """The program is not there, and the message says how to get it."""
        self.assertSays(self.check_error(outcome, 4), "`tetgen`", "PATH", "apt-get install tetgen")

    def refuse(self, code, words, *arguments):
        """The mesher refuses; or the command, because there is none."""
        outcome = self.fill(*arguments)
        if THERE:
            self.assertEqual((outcome.code, outcome.out), (code, ""), outcome.err)
            self.assertSays(outcome.err, *words)
        else:
            self.check_missing(outcome)
        self.assertNotIn("out.mesh", os.listdir(self.folder))

    def test_without_the_program_the_package_is_named(self):
        self.check_missing(self.fill("cube.off", "-o", "out.mesh", PATH=self.temporary))

    def test_backends_tells_whether_it_is_there(self):
        answer = command.parse(self.succeed("backends", "--json").out)
        tetgen = [engine for engine in answer["backends"] if engine["name"] == "tetgen"]
        self.assertEqual([(e["kind"], e["available"], e["how_to_get"]) for e in tetgen],
                         [("mesher", THERE, "apt-get install tetgen")])

    def test_a_cube_is_filled(self):
        outcome = self.fill("cube.off", "--quality", 1.4, "--volume", 0.01, "-o", "out.mesh")
        if not THERE:
            self.check_missing(outcome)
            return
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertRegex(outcome.out, r"^out.mesh: \d+ points, \d+ simplices of dimension 3\n$")
        answer = command.parse(self.succeed("info", "out.mesh", "--json").out)
        self.assertAlmostEqual(answer["volume"], 1, delta=1e-12)
        self.assertEqual((answer["betti"]["input"], answer["orientable"]), ([1, 0, 0, 0], True))
        self.assertGreater(answer["cells"]["input"][3], 100)

    def test_a_boundary_is_kept_where_asked_for(self):
        outcome = self.fill("cube.off", "--volume", 0.01, "--keep-boundary", "-o", "out.mesh")
        if not THERE:
            self.check_missing(outcome)
            return
        self.assertEqual(outcome.code, 0, outcome.err)
        facets = command.parse(self.succeed("info", "out.mesh", "--json").out)["cells"]["input"]
        self.assertEqual(2 * facets[2] - 4 * facets[3], 12)

    def test_what_is_wrong_is_told(self):
        self.write("open.off", CUBE.replace("8 6 0", "8 5 0").replace("4 1 3 7 5\n", ""))
        self.write("flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")
        places = [tuple(float(x) for x in line.split()) for line in CUBE.splitlines()[2:10]]
        moved = "".join(f"{x + .4} {y + .3} {z + .2}\n" for x, y, z in places)
        faces = CUBE.splitlines()[10:]
        more = ["4 " + " ".join(str(int(i) + 8) for i in face.split()[1:]) for face in faces]
        head = CUBE[CUBE.index("\n0") + 1:CUBE.index("4 0 2 3 1")]
        self.write("cross.off", "OFF\n16 12 0\n" + head + moved + "\n".join(faces + more) + "\n")
        for surface, code, words in (
                ("open.off", 2, ("surface", "closed")),
                ("flat.off", 2, ("plane",)),
                ("cross.off", 2, ("pairs", "facets", "cross"))):
            outcome = self.fill(surface, "-o", "out.mesh")
            if surface == "cross.off" and not THERE:
                self.check_missing(outcome)
                continue
            self.assertEqual((outcome.code, outcome.out), (code, ""), outcome.err)
            self.assertSays(outcome.err, *words)
        self.refuse(3, ("0.01 seconds",), "cube.off", "--volume", 1e-9, "--seconds", 0.01, "-o",
                    "out.mesh")
        self.refuse(3, ("holes",), "cube.off", "--hole", 0.5, 0.5, 0.5, "-o", "out.mesh")

    def test_wrong_usage_is_code_1(self):
        for arguments, words in (
                (("--mesher", "netgen", "cube.off"), ("--mesher: ", "tetgen", "'netgen'")),
                (("--mesher", "tetgen", "cube.off"), ("needs --out",)),
                (("cube.off", "-o", "out.mesh", "--quality", "2"), ("--quality", "--mesher"))):
            self.assertSays(self.fail_with(1, "generate", *arguments), *words)

    @unittest.skipUnless(os.path.isdir("/proc/self"), "needs /proc to look at processes")
    def test_an_interrupt_leaves_neither_files_nor_processes(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.start("generate", "--mesher", "tetgen", "cube.off", "--volume", "1e-9", "-o",
                            "out.mesh", env=self.environment(),
                            stderr=subprocess.DEVNULL) as process:
                if THERE:
                    command.wait_until(self.working, "the mesher begins")
                    process.send_signal(number)
                code = process.finish(20).code
            self.assertEqual(code, -number if THERE else 4)
            self.assertEqual(self.working(), [])
            self.assertEqual(os.listdir(self.temporary), [])
            self.assertNotIn("out.mesh", os.listdir(self.folder))

    def working(self):
        """The processes that are in the folder for temporary files."""
        found = []
        for name in filter(str.isdigit, os.listdir("/proc")):
            try:
                if os.readlink(f"/proc/{name}/cwd").startswith(os.path.realpath(self.temporary)):
                    found.append(name)
            except OSError:
                pass
        return found
