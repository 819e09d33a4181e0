# SPDX-License-Identifier: MIT
"""Makes the n-th allocation, write or read of every command fail, once or from then on, writes and
reads a few bytes at a time, takes nothing of what is printed, and sends signals at any time: a
command ends with code 0 and the right answer, or with code 1 to 4, a message and what was there
before, or by the signal. Nothing is left behind.

    faults.py COMMAND PRELOAD [--all] [--only NAME ..] [--kinds KIND ..] [--stride N]
"""
import argparse
import base64
import json
import math
import os
import random
import re
import shlex
import shutil
import signal
import struct
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tools"))

from command import (Deadline, Process, read_piece, run_program,  # noqa: E402
                     stop_ignoring_signals)

REQUEST = struct.Struct("=iiqii")
ANSWER = struct.Struct("=iiqqq")
NOTHING, ALLOCATION, WRITING, READING, SHORTENED, SIGNALED, UNTAKEN = range(7)
KINDS = {"allocation": ALLOCATION, "writing": WRITING, "reading": READING, "shortened": SHORTENED,
         "signals": SIGNALED, "untaken": UNTAKEN}
SIGNALS = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGQUIT, signal.SIGXCPU,
           signal.SIGXFSZ)
SECONDS = 60
MOST_TOLD = 20

# concyclic and other pairs, an obtuse triangle at an edge, a boundary
SQUARES = """OFF
9 8 0
0 0 0
1 0 0
2 0 0
0 1 0
1.1 .9 0
2 1 0
0 2 0
1 2.1 0
2 2 0
3 0 1 3
3 1 4 3
3 1 2 4
3 2 5 4
3 3 4 6
3 4 7 6
3 4 5 7
3 5 8 7
"""
CUBE = ("OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n4 0 2 3 1\n4 4 5 7 6\n"
        "4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")

COMMANDS = {
    "info": ["info", "squares.off", "--delaunay", "--json"],
    "info-text": ["info", "squares.off"],
    "merge": ["merge", "squares.off", "-o", "out.vtu"],
    "spectrum": ["spectrum", "squares.off", "--side", "primal", "--degree", "0", "--count", "3",
                 "--json", "-o", "out.vtu"],
    "poisson": ["poisson", "squares.off", "--side", "dual", "--rhs", "x*y+1", "--exact", "x",
                "--json", "-o", "out.vtu"],
    "engine": ["poisson", "squares.off", "--side", "primal", "--rhs", "1", "--engine",
               "eigen.ldlt"],
    "distance": ["distance", "squares.off", "--from", "0", "--json", "-o", "out.vtu"],
    "operators": ["operators", "squares.off", "--out", "folder"],
    "generate": ["generate", "icosphere", "--frequency", "2", "-o", "out.ply"],
    "help": ["poisson", "--help"],
    "misuse": ["poisson", "squares.off", "--side", "dual", "--rhs", "x*)"],
    "refusal": ["info", "cube.off", "--angle-tolerance", "-1"],
}
# What those end with that are refused when nothing fails.
CODES = {"misuse": 1, "refusal": 1}
MESHER = ["generate", "--mesher", "tetgen", "cube.off", "-o", "out.mesh"]
OLD = b"what was there before\n"

# What says by which way an answer came, or how long it took, and not what it is.
WAYS = {"seconds", "timing", "engine", "tried", "iterations", "linear_solver", "eigen_solver",
        "residual", "residuals", "warnings"}


def numbers_alike(a, b):
    return a == b or math.isclose(a, b, rel_tol=1e-7, abs_tol=1e-9)


def alike(a, b):
    """Whether two answers are one but for rounding and the way they came."""
    if isinstance(a, dict) and isinstance(b, dict):
        return set(a) == set(b) and all(key in WAYS or alike(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(alike, a, b))
    if isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return numbers_alike(a, b)
    return a == b


NUMBER = re.compile(rb"(?<![A-Za-z_])[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")


def texts_alike(a, b):
    if a == b:
        return True
    if NUMBER.sub(b"#", a) != NUMBER.sub(b"#", b):
        return False
    return all(numbers_alike(float(x), float(y))
               for x, y in zip(NUMBER.findall(a), NUMBER.findall(b)))


ARRAY = re.compile(rb'<DataArray type="Float64"[^>]*format="binary">\n([^<]*)\n')


def arrays_alike(a, b):
    """Whether two arrays, in base64 behind their length, are one but for rounding and a sign, which
    eigenvectors have none of."""
    first, second = ([x for x, in struct.iter_unpack("=d", base64.b64decode(text)[8:])]
                     for text in (a, b))
    return len(first) == len(second) and any(
        all(numbers_alike(x, sign * y) for x, y in zip(first, second)) for sign in (1, -1))


def grids_alike(a, b):
    return ARRAY.sub(b"", a) == ARRAY.sub(b"", b) and all(
        map(arrays_alike, ARRAY.findall(a), ARRAY.findall(b)))


def outputs_alike(a, b):
    if a == b:
        return True
    if a.startswith(b"<?xml"):
        return grids_alike(a, b)
    if a.startswith(b"{") and b.startswith(b"{"):
        try:
            return alike(json.loads(a), json.loads(b))
        except ValueError:
            return False
    return texts_alike(a, b)


class Server:
    """The command, loaded once and copied for each request."""

    def __init__(self, command, preload, arguments, folder, variables):
        ours, theirs = os.pipe(), os.pipe()
        self.to, self.back = ours[1], theirs[0]
        environment = {**os.environ, "LD_PRELOAD": preload, "OPENBLAS_NUM_THREADS": "1",
                       "OMP_NUM_THREADS": "1", "POLYDEC_FAULTS": f"{ours[0]} {theirs[1]}",
                       **variables}
        self.process = Process([command, *arguments], cwd=folder, env=environment,
                               pass_fds=(ours[0], theirs[1]))
        os.close(ours[0])
        os.close(theirs[1])

    def ask(self, kind, number=0, forever=False, signal_number=0):
        os.write(self.to, REQUEST.pack(kind, forever, number, signal_number, SECONDS))
        deadline = Deadline(f"an answer of {shlex.join(self.process.args)}", 2 * SECONDS)
        answer = b""
        while len(answer) < ANSWER.size:
            piece = read_piece(self.back, ANSWER.size - len(answer), deadline)
            if not piece:
                raise RuntimeError("the program cannot be preloaded: is it built with sanitizers?")
            answer += piece
        return ANSWER.unpack(answer)

    def close(self):
        os.close(self.to)
        os.close(self.back)
        with self.process:
            self.process.finish()


class Case:
    """A command in a folder of its own, what it should answer and what it should leave."""

    def __init__(self, options, name):
        self.name = name
        self.arguments = MESHER if name == "mesher" else COMMANDS[name]
        self.folder = tempfile.mkdtemp(prefix="polydec-faults-")
        self.temporary = os.path.join(self.folder, "temporary")
        os.mkdir(self.temporary)
        for file, text in (("squares.off", SQUARES), ("cube.off", CUBE)):
            self.write(file, text.encode())
        self.target = self.arguments[-1] if "-o" in self.arguments else None
        self.out_folder = "folder" if "folder" in self.arguments else None
        self.server = Server(options.command, options.preload, self.arguments, self.folder,
                             {"TMPDIR": self.temporary})
        self.runs = 0
        self.codes = {}
        self.findings = []
        self.earlier = self.earlier_result(options.command) if self.out_folder else {}
        self.restore()
        self.code = CODES.get(name, 0)
        status, _, *self.counts = self.server.ask(NOTHING)
        code = os.waitstatus_to_exitcode(status)
        if code != self.code:
            raise SystemExit(f"{name}: code {code} where nothing fails, not {self.code}; it said "
                             f"{self.read('stderr').decode()}")
        self.right = self.outputs()

    def earlier_result(self, command):
        """The files of a folder that may be replaced: the same command's, of another mesh."""
        arguments = [{"squares.off": "cube.off"}.get(word, word) for word in self.arguments]
        done = run_program([command, *arguments], cwd=self.folder)
        if done.code != 0:
            raise SystemExit(f"{self.name}: code {done.code}; it said {done.err}")
        folder = os.path.join(self.folder, self.out_folder)
        return {name: self.read(os.path.join(folder, name)) for name in os.listdir(folder)}

    def close(self):
        self.server.close()
        shutil.rmtree(self.folder)

    def write(self, name, data):
        with open(os.path.join(self.folder, name), "wb") as file:
            file.write(data)

    def read(self, name):
        with open(os.path.join(self.folder, name), "rb") as file:
            return file.read()

    def files(self):
        """Every file below the folder but those of the tests themselves."""
        found = {}
        for root, folders, names in os.walk(self.folder):
            for name in folders:
                found[os.path.relpath(os.path.join(root, name), self.folder)] = None
            for name in names:
                path = os.path.relpath(os.path.join(root, name), self.folder)
                if path not in ("stdout", "stderr"):
                    found[path] = self.read(path)
        return found

    def restore(self):
        if self.target:
            self.write(self.target, OLD)
        if self.out_folder:
            path = os.path.join(self.folder, self.out_folder)
            shutil.rmtree(path, ignore_errors=True)
            os.mkdir(path)
            for name, data in self.earlier.items():
                self.write(os.path.join(self.out_folder, name), data)
        for name in os.listdir(self.temporary):
            shutil.rmtree(os.path.join(self.temporary, name), ignore_errors=True)
        self.before = self.files()

    def outputs(self):
        return self.read("stdout"), self.files()

    def other_file(self, files):
        """What differs from the files that there should be at the end, or nothing."""
        right = self.right[1]
        if set(files) != set(right):
            return f"other files: {sorted(set(files) ^ set(right))}"
        for name in files:
            if not outputs_alike(files[name] or b"", right[name] or b""):
                return f"another {name}: {files[name][:200]!r}"
        return None

    def flaw(self, code, allowed_signal):
        """What is wrong with what was just done, or nothing."""
        out, files = self.outputs()
        err = self.read("stderr")
        if code == self.code and (code == 0 or out == self.right[0]):
            if code == 0 and not outputs_alike(out, self.right[0]):
                return f"another answer: {out[:200]!r}"
            return self.other_file(files)
        if code < 0 and -code != allowed_signal:
            return f"ended by signal {-code}"
        if code not in (1, 2, 3, 4) and code >= 0:
            return "an unknown code"
        if code > 0 and b"polydec: " not in err:
            return "no message"
        if code in (1, 2) and self.code == 0:
            return "the user is blamed"
        if code == 3 and self.kind == ALLOCATION:
            return "an engine is blamed"
        if code > 0 and out and self.kind not in (WRITING, UNTAKEN):
            return f"half an answer on standard output: {out[:80]!r}"
        # all of it may be there, if it could no longer be told
        if files != self.before and self.other_file(files):
            changed = [name for name in set(files) | set(self.before)
                       if files.get(name, "") != self.before.get(name, "")]
            return f"left or changed: {sorted(changed)}"
        return None

    def run(self, kind, number, forever=False, signal_number=0):
        self.kind = kind
        status, timed_out, *_ = self.server.ask(kind, number, forever, signal_number)
        code = os.waitstatus_to_exitcode(status)
        self.runs += 1
        self.codes[code] = self.codes.get(code, 0) + 1
        flaw = f"not done in {SECONDS} s" if timed_out else self.flaw(code, signal_number)
        if flaw:
            how = "from then on" if forever else "once"
            self.findings.append(f"{self.name}: kind {kind}, {number} {how}, signal "
                                 f"{signal_number}: code {code}, {flaw}; it said "
                                 f"{self.read('stderr')[:200]!r}")
        if self.files() != self.before:
            self.restore()


def numbers(count, stride):
    """Every so many, and two more than there are, at which nothing fails."""
    return range(stride, count + 3, stride)


def examine(options, name, kinds):
    case = Case(options, name)
    try:
        return examine_case(options, case, kinds)
    finally:
        case.close()


def examine_case(options, case, kinds):
    begin = time.time()
    chance = random.Random(1)
    for kind in kinds:
        if kind in (ALLOCATION, WRITING, READING):
            stride = options.stride if kind == ALLOCATION else max(1, options.stride // 20)
            for n in numbers(case.counts[kind - 1], stride):
                for forever in (False, True):
                    case.run(kind, n, forever)
        elif kind == UNTAKEN:
            case.run(kind, 1, True)
        elif kind == SHORTENED:
            for size in (1, 7, 100):
                case.run(kind, size)
        else:
            for _ in range(options.signals):
                case.run(kind, chance.randrange(1, 60000), False, chance.choice(SIGNALS))
    told = ", ".join(f"{number} x {code}" for code, number in sorted(case.codes.items()))
    print(f"{case.name}: {case.counts[0]} allocations, {case.counts[1]} writes, "
          f"{case.counts[2]} reads; {case.runs} faults, codes {told}; "
          f"{len(case.findings)} findings, {time.time() - begin:.0f} s", flush=True)
    for finding in case.findings[:MOST_TOLD]:
        print("  " + finding)
    return case.runs, len(case.findings)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("preload", type=os.path.abspath)
    parser.add_argument("--all", action="store_true", help="every fault instead of a few")
    parser.add_argument("--only", nargs="*", help="commands")
    parser.add_argument("--kinds", nargs="*", choices=KINDS, default=list(KINDS))
    parser.add_argument("--stride", type=int)
    parser.add_argument("--signals", type=int)
    options = parser.parse_args()
    options.stride = options.stride or (1 if options.all else 97)
    options.signals = options.signals if options.signals is not None else (
        1000 if options.all else 5)
    names = list(COMMANDS) + (["mesher"] if shutil.which("tetgen") else [])
    stop_ignoring_signals()
    total = bad = 0
    for name in options.only or names:
        runs, findings = examine(options, name, [KINDS[kind] for kind in options.kinds])
        total += runs
        bad += findings
    print(f"{total} faults, {bad} findings")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
