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

NEEDLE = "OFF\n4 2 0\n0 0 0\n4 0 0\n3 1 0\n1 1 0\n3 0 1 2\n3 0 2 3\n"
FULL = "polydec: standard output is not writable: No space left on device\n"
CLOSED = "polydec: standard output is not writable: Bad file descriptor\n"
BROKEN = "polydec: standard output is not writable: Broken pipe\n"
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

    def start(self, *arguments, closed=(), **streams):
        def close():
            for number in closed:
                os.close(number)
        return subprocess.run([command.COMMAND, *arguments], cwd=self.folder, timeout=100,
                              check=False, preexec_fn=close,
                              **{"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE,
                                 "stderr": subprocess.PIPE, **streams})

    def check_file(self):
        self.assertEqual(self.read("u.vtu"), self.file)
        os.remove(self.path("u.vtu"))
        self.assertEqual(os.listdir(self.folder), ["needle.off"])

    def test_a_full_output_is_told_and_files_are_whole(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            done = self.start(*POISSON, stdout=full)
            self.assertEqual((done.returncode, done.stderr.decode()), (4, self.whole.err + FULL))
            self.check_file()
            for arguments in (("info", "needle.off"), ("info", "needle.off", "--json"),
                              ("--help",), ("info", "--help"), ("--version",), ("backends",)):
                done = self.start(*arguments, stdout=full)
                self.assertEqual((done.returncode, done.stderr.decode()[-len(FULL):]), (4, FULL))

    def test_a_closed_output_is_told_and_no_file_gets_what_is_printed(self):
        done = self.start(*POISSON, closed=(1,))
        self.assertEqual((done.returncode, done.stderr.decode()), (4, self.whole.err + CLOSED))
        self.check_file()

    def test_a_broken_pipe_is_told(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "w", encoding="ascii") as pipe:
            done = self.start(*POISSON, stdout=pipe)
        self.assertEqual((done.returncode, done.stderr.decode()), (4, self.whole.err + BROKEN))
        self.check_file()

    def test_a_full_or_closed_error_stream_costs_nothing(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            for options in ({"stderr": full}, {"closed": (2,)}, {"closed": (0,)},
                            {"closed": (0, 2)}):
                done = self.start(*POISSON, **options)
                self.assertEqual((done.returncode, done.stdout.decode()), (0, self.whole.out))
                self.check_file()
            self.assertEqual(self.start("info", "no.off", stderr=full).returncode, 4)
            self.assertEqual(self.start("info", stderr=full).returncode, 1)

    def test_all_closed_is_an_error_without_a_word(self):
        self.assertEqual(self.start(*POISSON, closed=(0, 1, 2)).returncode, 4)
        self.check_file()

    def test_an_output_that_does_not_wait_is_waited_for(self):
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        with subprocess.Popen([command.COMMAND, "poisson", "--help"], stdout=writer) as process:
            os.close(writer)
            time.sleep(0.3)
            text = b""
            while piece := os.read(reader, 64):
                text += piece
            self.assertEqual(process.wait(timeout=20), 0)
        os.close(reader)
        self.assertEqual(text.decode(), self.succeed("poisson", "--help").out)


@unittest.skipUnless(shutil.which("tetgen"), "the work that is interrupted is TetGen's")
class Signals(TestCase):
    def setUp(self):
        super().setUp()
        corners = "".join(f"{i & 1} {i >> 1 & 1} {i >> 2}\n" for i in range(8))
        self.write("cube.off", f"OFF\n8 6 0\n{corners}4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n"
                               "4 0 4 6 2\n4 1 3 7 5\n")
        self.write("out.mesh", "old")
        os.mkdir(self.path("temporary"))

    def begin(self, volume, before=None):
        environment = {**os.environ, "TMPDIR": self.path("temporary")}
        return subprocess.Popen([command.COMMAND, "generate", "--mesher", "tetgen", "cube.off",
                                 "--volume", volume, "-o", "out.mesh"], cwd=self.folder,
                                env=environment, stdout=subprocess.DEVNULL, preexec_fn=before,
                                stderr=subprocess.DEVNULL)

    def wait_for_work(self):
        for _ in range(40000):
            if os.listdir(self.path("temporary")):
                return
            time.sleep(0.00025)
        self.fail("it does not begin")

    def check_nothing_left(self):
        self.assertEqual(os.listdir(self.path("temporary")), [])
        self.assertEqual(sorted(os.listdir(self.folder)), ["cube.off", "out.mesh", "temporary"])
        self.assertEqual(self.read("out.mesh"), "old")

    def test_each_ends_the_process_and_leaves_nothing(self):
        for number in 5 * ENDING: # also as soon as the folder is there
            with self.begin("1e-9") as process:
                self.wait_for_work()
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=20), -number)
            self.check_nothing_left()

    def test_one_that_was_ignored_stays_ignored(self):
        for number in (signal.SIGHUP, signal.SIGINT, signal.SIGXFSZ):
            self.write("out.mesh", "old")
            with self.begin("1e-4", lambda: signal.signal(number, signal.SIG_IGN)) as process:
                self.wait_for_work()
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=60), 0)
            self.assertNotEqual(self.read("out.mesh"), "old")

    def test_a_limit_of_file_sizes_ends_it_by_its_signal(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        done = subprocess.run([command.COMMAND, "generate", "icosphere", "--frequency", "30", "-o",
                               "out.mesh"], cwd=self.folder, preexec_fn=limit, check=False,
                              capture_output=True, timeout=60)
        self.assertEqual(done.returncode, -signal.SIGXFSZ)
        self.check_nothing_left()


if __name__ == "__main__":
    command.main()
