# SPDX-License-Identifier: MIT
"""generate --mesher: what it makes, what it refuses, and that nothing of it stays behind. Where
TetGen is not there, the command has to say how to get it instead."""
import os
import shutil
import signal
import subprocess
import time
import unittest

import command
from command import TestCase

CUBE = ("OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n4 0 2 3 1\n4 4 5 7 6\n"
        "4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")
MISSING = ("polydec: the mesher `tetgen` needs the program tetgen, which is not on PATH\nTo get it: "
           "apt-get install tetgen (Debian package tetgen).\n")
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
        done = subprocess.run([command.COMMAND, "generate", "--mesher", "tetgen",
                               *map(str, arguments)], cwd=self.folder, capture_output=True,
                              stdin=subprocess.DEVNULL, timeout=100, text=True, check=False,
                              env={**self.environment(), **variables})
        return command.Outcome(done.returncode, done.stdout, done.stderr)

    def refuse(self, code, message, *arguments):
        """The mesher refuses; or the command, because there is none."""
        outcome = self.fill(*arguments)
        if THERE:
            self.assertEqual((outcome.code, outcome.out), (code, ""), outcome.err)
            self.assertIn(message, outcome.err)
        else:
            self.assertEqual(outcome, (4, "", MISSING))
        self.assertNotIn("out.mesh", os.listdir(self.folder))

    def test_without_the_program_the_package_is_named(self):
        outcome = self.fill("cube.off", "-o", "out.mesh", PATH=self.temporary)
        self.assertEqual(outcome, (4, "", MISSING))

    def test_backends_tells_whether_it_is_there(self):
        answer = command.parse(self.succeed("backends", "--json").out)
        tetgen = [engine for engine in answer["backends"] if engine["name"] == "tetgen"]
        self.assertEqual([(e["kind"], e["available"], e["how_to_get"]) for e in tetgen],
                         [("mesher", THERE, "apt-get install tetgen")])

    def test_a_cube_is_filled(self):
        outcome = self.fill("cube.off", "--quality", 1.4, "--volume", 0.01, "-o", "out.mesh")
        if not THERE:
            self.assertEqual(outcome, (4, "", MISSING))
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
            self.assertEqual(outcome, (4, "", MISSING))
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
        for surface, code, message in (
                ("open.off", 2, "the surface is not closed"),
                ("flat.off", 2, "lie in the plane"),
                ("cross.off", 2, "pairs of facets cross or overlap")):
            outcome = self.fill(surface, "-o", "out.mesh")
            if surface == "cross.off" and not THERE:
                self.assertEqual(outcome, (4, "", MISSING))
                continue
            self.assertEqual((outcome.code, outcome.out), (code, ""), outcome.err)
            self.assertIn(message, outcome.err)
        self.refuse(3, "not done within 0.01 seconds", "cube.off", "--volume", 1e-9, "--seconds",
                    0.01, "-o", "out.mesh")
        self.refuse(3, "the holes take everything away", "cube.off", "--hole", 0.5, 0.5, 0.5, "-o",
                    "out.mesh")

    def test_wrong_usage_is_code_1(self):
        for arguments, message in (
                (("--mesher", "netgen", "cube.off"), "--mesher: expected tetgen, not 'netgen'"),
                (("--mesher", "tetgen"), "SURFACE is required"),
                (("--mesher", "tetgen", "cube.off"), "--out is required"),
                (("cube.off", "-o", "out.mesh", "--quality", "2"), "--quality requires --mesher"),
                ((), "The name of a mesh, or --mesher, is required")):
            outcome = command.run("generate", *arguments, folder=self.folder)
            self.assertEqual(outcome, (1, "", f"polydec: {message}\nRun with --help for more "
                                              "information.\n"))

    @unittest.skipUnless(os.path.isdir("/proc/self"), "needs /proc to look at processes")
    def test_an_interrupt_leaves_neither_files_nor_processes(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([command.COMMAND, "generate", "--mesher", "tetgen", "cube.off",
                                   "--volume", "1e-9", "-o", "out.mesh"], cwd=self.folder,
                                  env=self.environment(), stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as process:
                if THERE:
                    self.wait_for(lambda: self.working())
                    process.send_signal(number)
                code = process.wait(timeout=20)
            self.assertEqual(code, -number if THERE else 4)
            self.assertEqual(self.working(), [])
            self.assertEqual(os.listdir(self.temporary), [])
            self.assertNotIn("out.mesh", os.listdir(self.folder))

    def wait_for(self, condition):
        for _ in range(500):
            if condition():
                return
            time.sleep(0.01)
        self.fail("this takes too long")

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


if __name__ == "__main__":
    command.main()
