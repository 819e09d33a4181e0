# SPDX-License-Identifier: MIT
"""Runs the command under limits of time and memory, for the tests beside this file."""
import collections
import json
import os
import re
import resource
import select
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest

COMMAND = GOLDEN = None
MEMORY = 500 * 2**20
SECONDS = 60  # after which what is waited for counts as hanging
SLOWER = 5    # so many times as long where a sanitizer looks on, or as POLYDEC_TEST_PATIENCE says
limited = True

Outcome = collections.namedtuple("Outcome", "code out err")


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def patience(seconds):
    """How long something is waited for that takes at most so many seconds without a sanitizer."""
    return seconds * float(os.environ.get("POLYDEC_TEST_PATIENCE", 1 if limited else SLOWER))


def stop_ignoring_signals():
    """In the background of a script SIGINT and SIGQUIT are ignored, with nohup SIGHUP, and what is
    started from here would inherit that. A handler is not inherited, even one that does nothing."""
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
    """A program in a session of its own, which is killed as a whole where it is not done in time,
    or when `with` ends."""

    def __init__(self, words, **options):
        options.setdefault("stdin", subprocess.DEVNULL)
        words = [word if isinstance(word, bytes) else str(word) for word in words]
        super().__init__(words, start_new_session=True, **options)

    def __exit__(self, *error):
        self.end()
        return super().__exit__(*error)

    def end(self):
        """Kills it and all that it started, also what has a group of its own."""
        if self.returncode is not None:  # its number may be another's by now
            return
        for kill, number in [(os.killpg, self.pid)] + [(os.kill, n) for n in members(self.pid)]:
            try:
                kill(number, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def finish(self, seconds=None):
        """Waits for its end, whatever it prints. Fails if that takes too long."""
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
    """Code, stdout and stderr of any program. Fails if it takes too long."""
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **options}
    with Process(words, **options) as process:
        return process.finish(seconds)


def start(*arguments, **options):
    """The command, which goes on while the test does."""
    return Process([COMMAND, *arguments], **options)


def run(*arguments, folder=None, seconds=None, limit=False, **options):
    """Code, stdout and stderr of the command. Fails if it takes too long."""
    if limit and limited:
        options["preexec_fn"] = limit_memory
    return run_program([COMMAND, *arguments], seconds, cwd=folder, **options)


class Deadline:
    """Fails where something is still waited for after a time."""

    def __init__(self, what, seconds=None):
        self.what, self.seconds = what, patience(seconds or SECONDS)
        self.end = time.monotonic() + self.seconds

    def left(self):
        """Seconds that are left, more than 0."""
        left = self.end - time.monotonic()
        if left <= 0:
            raise AssertionError(f"waited for {self.seconds} s in vain: {self.what}")
        return left


def wait_until(condition, what, seconds=None, pause=0.01):
    deadline = Deadline(what, seconds)
    while not condition():
        time.sleep(min(pause, deadline.left()))


def read_piece(descriptor, size, deadline):
    """At most so many bytes of a pipe or terminal; none at its end."""
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


def says(message, *words):
    """Whether a message has all the words or numbers, as a whole and in this order."""
    pattern = ".*?".join(
        (r"(?<![\w.-])" if word[:1].isdigit() else r"(?<!\w)" if word[:1].isalpha() else "")
        + re.escape(word)
        + (r"(?!\w|\.\d)" if word[-1:].isdigit() else r"(?!\w)" if word[-1:].isalpha() else "")
        for word in map(str, words))
    return re.search(pattern, message, re.DOTALL) is not None


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

    def start(self, *arguments, **options):
        return start(*arguments, **{"cwd": self.folder, "stdout": subprocess.DEVNULL, **options})

    def succeed(self, *arguments, **options):
        outcome = run(*arguments, folder=self.folder, **options)
        self.assertEqual(outcome.code, 0, f"{arguments}\n{outcome.err}")
        return outcome

    def ask(self, *arguments, **options):
        """The JSON object that stdout holds, and nothing else."""
        return parse(self.succeed(*arguments, "--json", **options).out)

    def assertSays(self, message, *words):
        """That all the words are there in this order: place, kind and what is wrong, by which a
        message is known however its sentence is put. A place with a colon begins the message."""
        place = str(words[0])
        if place.rstrip().endswith(":"):
            self.assertTrue(message.startswith((place, f"polydec: {place}")),
                            f"{place!r} does not begin\n{message}")
        self.assertTrue(says(message, *words), f"{words}\nare not said by\n{message}")

    def check_error(self, outcome, code):
        """An error of one to three lines, and nothing on stdout. Wrong usage is told of --help."""
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
    """python3 TEST COMMAND GOLDEN_FOLDER"""
    global COMMAND, GOLDEN, limited
    COMMAND, GOLDEN = map(os.path.abspath, sys.argv[1:3])
    stop_ignoring_signals()
    # programs under a sanitizer reserve more addresses than any limit allows
    limited = run("--version", limit=True).code == 0
    unittest.main(module="__main__", argv=sys.argv[:1] + sys.argv[3:])
