# SPDX-License-Identifier: MIT
"""Standard streams that are closed, full or broken cost no result, and signals leave nothing behind
and end the process, unless they were ignored when it began."""
import os
import resource
import shutil
import signal
import subprocess
import time
import unittest

import command
from command import TestCase
from mesher import CUBE

NEEDLE = "OFF\n4 2 0\n0 0 0\n4 0 0\n3 1 0\n1 1 0\n3 0 1 2\n3 0 2 3\n"
FULL, CLOSED, BROKEN = "No space left on device", "Bad file descriptor", "Broken pipe"
ENDING = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGQUIT, signal.SIGXCPU,
          signal.SIGXFSZ)
POISSON = ("poisson", "needle.off", "--side", "primal", "--rhs", "1", "-o", "u.vtu")


class Streams(TestCase):
    def setUp(self):
        super().setUp()
        self.write("needle.off", NEEDLE)
        self.whole = self.succeed(*POISSON)
        self.file = self.read("u.vtu")
        os.remove(self.path("u.vtu"))

    def call(self, *arguments, closed=(), **streams):
        def close():
            for number in closed:
                os.close(number)
        return command.run(*arguments, folder=self.folder, preexec_fn=close, **streams)

    def check_told(self, done, reason, before=""):
        """It ended with code 4, and the last line says why."""
        self.assertEqual(done.code, 4)
        self.assertTrue(done.err.startswith(before), done.err)
        line = done.err.removeprefix(before)
        self.assertEqual(len(line.splitlines()), 1, line)
        self.assertTrue(line.startswith("polydec: "), line)
        self.assertSays(line, "standard output", f": {reason}\n")

    def check_file(self):
        self.assertEqual(self.read("u.vtu"), self.file)
        os.remove(self.path("u.vtu"))
        self.assertEqual(os.listdir(self.folder), ["needle.off"])

    def test_a_full_output_is_told_and_files_are_whole(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            self.check_told(self.call(*POISSON, stdout=full), FULL, self.whole.err)
            self.check_file()
            for arguments in (("info", "needle.off"), ("info", "needle.off", "--json"),
                              ("--help",), ("info", "--help"), ("--version",), ("backends",)):
                done = self.call(*arguments, stdout=full)
                warnings = "".join(line for line in done.err.splitlines(True)
                                   if line.startswith("polydec: warning: "))
                self.check_told(done, FULL, warnings)

    def test_a_closed_output_is_told_and_no_file_gets_what_is_printed(self):
        self.check_told(self.call(*POISSON, closed=(1,)), CLOSED, self.whole.err)
        self.check_file()

    def test_a_broken_pipe_is_told(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "w", encoding="ascii") as pipe:
            self.check_told(self.call(*POISSON, stdout=pipe), BROKEN, self.whole.err)
        self.check_file()

    def test_a_full_or_closed_error_stream_costs_nothing(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            for options in ({"stderr": full}, {"closed": (2,)}, {"closed": (0,)},
                            {"closed": (0, 2)}):
                done = self.call(*POISSON, **options)
                self.assertEqual((done.code, done.out), (0, self.whole.out))
                self.check_file()
            self.assertEqual(self.call("info", "no.off", stderr=full).code, 4)
            self.assertEqual(self.call("info", stderr=full).code, 1)

    def test_all_closed_is_an_error_without_a_word(self):
        self.assertEqual(self.call(*POISSON, closed=(0, 1, 2)).code, 4)
        self.check_file()

    def test_an_output_that_does_not_wait_is_waited_for(self):
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        with self.start("poisson", "--help", stdout=writer) as process:
            os.close(writer)
            time.sleep(0.3)
            text = command.read_all(reader, "all of the help", 64)
            self.assertEqual(process.finish().code, 0)
        os.close(reader)
        self.assertEqual(text.decode(), self.succeed("poisson", "--help").out)


@unittest.skipUnless(shutil.which("tetgen"), "the work that is interrupted is TetGen's")
class Signals(TestCase):
    def setUp(self):
        super().setUp()
        self.write("cube.off", CUBE)
        self.write("out.mesh", "old")
        os.mkdir(self.path("temporary"))

    def begin(self, volume, before=None):
        environment = {**os.environ, "TMPDIR": self.path("temporary")}
        return self.start("generate", "--mesher", "tetgen", "cube.off", "--volume", volume, "-o",
                          "out.mesh", env=environment, preexec_fn=before, stderr=subprocess.DEVNULL)

    def wait_for_work(self):
        command.wait_until(lambda: os.listdir(self.path("temporary")), "the folder of the mesher",
                           pause=0.00025)

    def check_nothing_left(self):
        self.assertEqual(os.listdir(self.path("temporary")), [])
        self.assertEqual(sorted(os.listdir(self.folder)), ["cube.off", "out.mesh", "temporary"])
        self.assertEqual(self.read("out.mesh"), "old")

    def test_each_ends_the_process_and_leaves_nothing(self):
        for number in 5 * ENDING: # also as soon as the folder is there
            with self.begin("1e-9") as process:
                self.wait_for_work()
                process.send_signal(number)
                self.assertEqual(process.finish(20).code, -number)
            self.check_nothing_left()

    def test_one_that_was_ignored_stays_ignored(self):
        for number in (signal.SIGHUP, signal.SIGINT, signal.SIGXFSZ):
            self.write("out.mesh", "old")
            with self.begin("1e-4", lambda: signal.signal(number, signal.SIG_IGN)) as process:
                self.wait_for_work()
                process.send_signal(number)
                self.assertEqual(process.finish().code, 0)
            self.assertNotEqual(self.read("out.mesh"), "old")

    def test_a_limit_of_file_sizes_ends_it_by_its_signal(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        done = command.run("generate", "icosphere", "--frequency", 30, "-o", "out.mesh",
                           folder=self.folder, preexec_fn=limit)
        self.assertEqual(done.code, -signal.SIGXFSZ)
        self.check_nothing_left()
