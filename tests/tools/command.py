# SPDX-License-Identifier: MIT
"""Runs the command under limits of time and memory, for the tests beside this file."""
import collections
import json
import os
import resource
import select
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from words import says  # noqa: E402

COMMAND = GOLDEN = None
MEMORY = 500 * 2**20
SECONDS = 60  # time limit of a call
SLOWER = 5    # factor on every time limit under a sanitizer; POLYDEC_TEST_PATIENCE overrides it
limited = True

Outcome = collections.namedtuple("Outcome", "code out err")


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def patience(seconds):
    """The time limit in seconds, scaled for sanitizers or by POLYDEC_TEST_PATIENCE."""
    return seconds * float(os.environ.get("POLYDEC_TEST_PATIENCE", 1 if limited else SLOWER))


def stop_ignoring_signals():
    """Scripts start background jobs with SIGINT and SIGQUIT ignored, nohup with SIGHUP ignored.
    Child processes inherit ignored signals, but not handlers: this installs an empty handler."""
    for number in (signal.SIGHUP, signal.SIGINT, signal.SIGQUIT, signal.SIGTERM):
        if signal.getsignal(number) == signal.SIG_IGN:
            signal.signal(number, lambda *_: None)


def members(session):
    """The processes of a session."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc") if os.path.isdir("/proc/self") else ()):
        try:
            with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as file:
                fields = file.read().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        if int(fields[3]) == session and fields[0] != "Z":
            found.append(int(name))
    return found


class Process(subprocess.Popen):
    """A program in its own session. The whole session is killed at the time limit and when `with`
    ends."""

    def __init__(self, words, **options):
        options.setdefault("stdin", subprocess.DEVNULL)
        words = [word if isinstance(word, bytes) else str(word) for word in words]
        super().__init__(words, start_new_session=True, **options)

    def __exit__(self, *error):
        self.end()
        return super().__exit__(*error)

    def end(self):
        """Kills the program and every process of its session, whatever their groups."""
        if self.returncode is not None:  # another process may have its number by now
            return
        for kill, number in [(os.killpg, self.pid)] + [(os.kill, n) for n in members(self.pid)]:
            try:
                kill(number, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def finish(self, seconds=None):
        """Waits until the program ends. Fails at the time limit, with the output so far."""
        seconds = patience(seconds or SECONDS)
        try:
            out, err = self.communicate(timeout=seconds)
        except subprocess.TimeoutExpired as late:
            self.end()
            line = shlex.join(map(os.fsdecode, self.args))
            raise AssertionError(f"not done in {seconds} s: {line}\nso far:\n"
                                 f"{shown(late.output)}{shown(late.stderr)}") from None
        except BaseException:
            self.end()
            raise
        return Outcome(self.returncode, out, err)


def shown(output):
    return output.decode(errors="replace") if isinstance(output, bytes) else output or ""


def run_program(words, seconds=None, **options):
    """Exit code, stdout and stderr of any program. Fails at the time limit."""
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **options}
    with Process(words, **options) as process:
        return process.finish(seconds)


def start(*arguments, **options):
    """Starts the command and returns while it runs."""
    return Process([COMMAND, *arguments], **options)


def run(*arguments, folder=None, seconds=None, limit=False, **options):
    """Exit code, stdout and stderr of the command. Fails at the time limit."""
    if limit and limited:
        options["preexec_fn"] = limit_memory
    return run_program([COMMAND, *arguments], seconds, cwd=folder, **options)


class Deadline:
    """A time limit for a loop that waits."""

    def __init__(self, what, seconds=None):
        self.what, self.seconds = what, patience(seconds or SECONDS)
        self.end = time.monotonic() + self.seconds

    def left(self):
        """Remaining seconds, greater than 0. Fails if there are none."""
        left = self.end - time.monotonic()
        if left <= 0:
            raise AssertionError(f"time limit of {self.seconds} s: {self.what}")
        return left


def wait_until(condition, what, seconds=None, pause=0.01):
    deadline = Deadline(what, seconds)
    while not condition():
        time.sleep(min(pause, deadline.left()))


def read_piece(descriptor, size, deadline):
    """At most `size` bytes of a pipe or terminal; none at its end."""
    while not select.select([descriptor], [], [], deadline.left())[0]:
        pass
    try:
        return os.read(descriptor, size)
    except OSError:  # the other end of a terminal is closed
        return b""


def read_all(descriptor, what, size=1000):
    deadline, text = Deadline(what), b""
    while piece := read_piece(descriptor, size, deadline):
        text += piece
    return text


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

    def steps_of(self, name):
        """Of a series, the times and the files."""
        lines = [line.split('"') for line in self.read(name).splitlines() if "timestep" in line]
        return [float(line[1]) for line in lines], [line[5] for line in lines]

    def start(self, *arguments, **options):
        return start(*arguments, **{"cwd": self.folder, "stdout": subprocess.DEVNULL, **options})

    def succeed(self, *arguments, **options):
        outcome = run(*arguments, folder=self.folder, **options)
        self.assertEqual(outcome.code, 0, f"{arguments}\n{outcome.err}")
        return outcome

    def generate(self, kind, *arguments, extension="off"):
        """The path of a mesh that the command generates."""
        path = self.path(f"{kind}.{extension}")
        self.succeed("generate", kind, *arguments, "-o", path)
        return path

    def ask(self, *arguments, **options):
        """The JSON object that stdout holds, and nothing else."""
        return parse(self.succeed(*arguments, "--json", **options).out)

    def assertSays(self, message, *words):
        """Asserts that a message contains these words in this order: its place, numbers and key
        words. A place that ends with a colon must begin the message."""
        place = str(words[0])
        if place.rstrip().endswith(":"):
            self.assertTrue(message.startswith((place, f"polydec: {place}")),
                            f"{place!r} does not begin\n{message}")
        self.assertTrue(says(message, *words), f"{words}\nare not said by\n{message}")

    def check_error(self, outcome, code):
        """Asserts an error of one to three lines and nothing on stdout; exit code 1 names --help."""
        lines = [line for line in outcome.err.splitlines() if "polydec: warning: " not in line]
        self.assertEqual(outcome.code, code, outcome.err)
        self.assertEqual(outcome.out, "")
        self.assertIn(len(lines), (1, 2, 3), outcome.err)
        self.assertTrue(lines[0].startswith("polydec: "), outcome.err)
        if code == 1:
            self.assertSays(lines[-1], "--help")
        return "\n".join(lines)

    def fail_with(self, code, *arguments, **options):
        return self.check_error(run(*arguments, folder=self.folder, **options), code)


def main():
    """python3 command.py TEST COMMAND GOLDEN_FOLDER [NAME ..] runs the tests of a file, or those named."""
    global COMMAND, GOLDEN, limited
    test, *asked = sys.argv[1:]
    COMMAND, GOLDEN = map(os.path.abspath, asked[:2])
    stop_ignoring_signals()
    # programs under a sanitizer reserve more addresses than any limit allows
    limited = run("--version", limit=True).code == 0
    sys.path.insert(0, os.path.dirname(os.path.abspath(test)))
    unittest.main(module=Path(test).stem, argv=[test, *asked[2:]])


if __name__ == "__main__":
    import command  # the module of which the tests know
    command.main()
