# SPDX-License-Identifier: MIT
"""Holds polydec-mpi against polydec, and against faults.

Usage: command.py POLYDEC POLYDEC_MPI PRELOAD MPIEXEC ..; what follows are options of mpiexec. A
complaint a line; exit code: 0 none, 1 some.
"""

import json
import os
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tools"))

from command import SECONDS, Process, run_program, says, stop_ignoring_signals  # noqa: E402

MESHES = {
    "grid": ["grid", "--nx", "7", "--ny", "5"],
    "sphere": ["uv-sphere", "--meridians", "12", "--bands", "7"],
    "torus": ["torus", "--major", "12", "--minor", "8"],
    "cubes": ["kuhn", "--cells", "3", "3", "3"],
    "bcc": ["bcc", "--cells", "2", "2", "2"],
    "tesseracts": ["kuhn", "--cells", "1", "1", "2", "1"],
}
EXACT = ["dimension", "ambient_dimension", "cells", "euler", "components", "orientable", "facets",
         "vertices_per_cell", "concyclic"]


class Commands:
    def __init__(self, words):
        self.polydec, self.mpi, self.preload, *self.mpiexec = words

    def alone(self, *words):
        return run_program([self.polydec, *words])

    def line(self, ranks, *words):
        return [*self.mpiexec, str(ranks), self.mpi, *map(str, words)]

    def on(self, ranks, *words):
        return run_program(self.line(ranks, *words))


complaints = []


def expect(holds, what):
    if not holds:
        complaints.append(what)
        print(what, flush=True)


def near(a, b, share):
    return abs(a - b) <= share * max(abs(a), abs(b), 1e-300)


def answers(commands, ranks, *words):
    """What one process and several ranks say as JSON; none where either fails."""
    one, several = commands.alone(*words, "--json"), commands.on(ranks, *words, "--json")
    expect(one.code == several.code,
           f"{words}: exit code {several.code} on {ranks} ranks, {one.code} on one: {several.err}")
    if one.code != 0 or several.code != 0:
        return None
    return json.loads(one.out), json.loads(several.out)


def hold_info(commands, ranks, name, mesh):
    pair = answers(commands, ranks, "info", mesh)
    if pair is None:
        return
    one, several = pair
    for key in EXACT:
        expect(several.get(key) == one.get(key), f"info {name}: {key} {several.get(key)}")
    expect(near(several["volume"], one["volume"], 1e-13), f"info {name}: volume")
    for k, (ours, theirs) in enumerate(zip(several["stars"], one["stars"], strict=True)):
        expect(ours == theirs, f"info {name}: star {k}: {ours} for {theirs}")
    expect(several["ranks"]["count"] == ranks, f"info {name}: ranks {several['ranks']}")


def hold_poisson(commands, ranks, name, mesh):
    for side in ["primal", "dual"]:
        for more in [["--boundary", "x"], ["--natural"], ["--essential-where", "x<.3", "--flux=y"],
                     ["--boundary", "3", "--flux", "5"], ["--essential-where", "x>99"]]:
            words = ["poisson", mesh, "--side", side, "--rhs", "1+x*y", *more]
            pair = answers(commands, ranks, *words, "--star", "circumcentric")
            if pair is None:
                continue
            one, several = pair
            size = max(abs(one["min"]), abs(one["max"]))
            for key in ["min", "max"]:
                expect(abs(one[key] - several[key]) <= 1e-9 * size,
                       f"{words}: {key} {several[key]} for {one[key]}")
            for key in ["side", "boundary", "unknowns", "free_components", "conditions", "star"]:
                expect(one[key] == several[key], f"{words}: {key} {several[key]} for {one[key]}")
            doubts, others = [[text.split(":")[0] for text in answer["warnings"]
                               if "negative dual" in text] for answer in (one, several)]
            expect(doubts == others, f"{words}: warnings {others} for {doubts}")


def hold_spectrum(commands, ranks, name, mesh):
    words = ["spectrum", mesh, "--side", "primal", "--degree", "0", "--count", "6"]
    pair = answers(commands, ranks, *words)
    if pair is None:
        return
    one, several = pair
    largest = max(map(abs, one["eigenvalues"]))
    for a, b in zip(one["eigenvalues"], several["eigenvalues"], strict=True):
        expect(abs(a - b) <= 1e-9 * largest, f"spectrum {name}: {b} for {a}")
    for key in ["below_shift", "returned_below_shift", "complete"]:
        expect(one["certificate"][key] == several["certificate"][key],
               f"spectrum {name}: {key} of the certificate")


def hold_warnings(commands, folder):
    """Of a square in two parts that do not share their vertices."""
    slit = folder / "slit.nsc"
    slit.write_text("2 2 6 2\n0 0\n1 0\n0 1\n1 0\n1 1\n0 1\n0 1 2\n3 4 5\n")
    pair = answers(commands, 3, "info", slit)
    if pair is not None:
        one, several = (answer["warnings"] for answer in pair)
        expect(several == one and len(one) == 1, f"warnings of a slit: {several} for {one}")


def triangle_with_group():
    """A .vtu file that ranks read in parts."""
    arrays = [("Points", "Float64", 3, struct.pack("<9d", 0, 0, 0, 1, 0, 0, 0, 1, 0)),
              ("connectivity", "Int64", 1, struct.pack("<3q", 0, 1, 2)),
              ("offsets", "Int64", 1, struct.pack("<q", 3)), ("types", "UInt8", 1, b"\x05"),
              ("material", "Int32", 1, struct.pack("<i", 7))]
    tags, data = [], b""
    for name, kind, count, values in arrays:
        tags.append(f'<DataArray Name="{name}" type="{kind}" NumberOfComponents="{count}" '
                    f'format="appended" offset="{len(data)}"/>')
        data += struct.pack("<Q", len(values)) + values
    text = ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            'header_type="UInt64"><UnstructuredGrid><Piece NumberOfPoints="3" NumberOfCells="1">'
            f'<Points>{tags[0]}</Points><Cells>{"".join(tags[1:4])}</Cells><CellData>{tags[4]}'
            '</CellData></Piece></UnstructuredGrid><AppendedData encoding="raw">_')
    return text.encode() + data + b"</AppendedData></VTKFile>"


def hold_groups(commands, folder):
    mesh = folder / "group.vtu"
    mesh.write_bytes(triangle_with_group())
    done = commands.on(2, "convert", mesh, "-o", folder / "group.pdm")
    expect(done.code == 0 and says(done.err, "left out the groups of 1 cell", ".vtu"),
           f"convert with groups: {done.err}")


def cells_of(piece):
    return int(re.search(r'NumberOfCells="(\d+)"', piece.read_text()).group(1))


def hold_files(commands, folder, mesh):
    sliced, picture = folder / "a.pdm", folder / "a.pvtu"
    done = commands.on(3, "convert", mesh, "-o", sliced)
    expect(done.code == 0, f"convert: {done.err}")
    texts = {commands.on(ranks, "info", sliced, "--json").out.split('"ranks"')[0]
             for ranks in [1, 2, 3]}
    expect(len(texts) == 1, f"info of one file says several things: {texts}")
    for ranks in [3, 2]:
        done = commands.on(ranks, "merge", sliced, "-o", picture, "--json")
        expect(done.code == 0, f"merge: {done.err}")
        pieces = re.findall(r'Source="([^"]+)"', picture.read_text())
        expect(len(pieces) == ranks and len(list((folder / "a").iterdir())) == ranks,
               f"merge on {ranks} ranks: {pieces}")
        expect(sum(cells_of(folder / piece) for piece in pieces) ==
               json.loads(done.out)["cells"]["merged"], "merge: cells of the pieces")


def hold_errors(commands, folder, mesh):
    bad = folder / "bad.nsc"
    bad.write_text("2 2 3 1\n0 0\n1 0\n0 1\n0 1 7\n")
    bent = folder / "bent.nsc"  # an obtuse corner across from the boundary
    bent.write_text("2 2 4 2\n0 0\n4 0\n2 1\n2 -1\n0 1 2\n1 0 3\n")
    cases = [
        (["info", folder / "none.off"], 4, ["none.off", "No such file"]),
        (["info", bad], 2, ["bad.nsc:5"]),
        (["distance", mesh, "--from", "1"], 1, ["distance", "one process"]),
        (["info", mesh, "--delaunay"], 1, ["--delaunay", "one process"]),
        (["info"], 1, ["needs MESH"]),
        (["poisson", mesh, "--side", "dual", "--rhs", "1/0"], 2, ["--rhs", "'1/0'"]),
        (["poisson", mesh, "--side", "dual", "--rhs", "1", "--petsc", "-foo 3"], 2, ["-foo"]),
        (["poisson", mesh, "--side", "dual", "--rhs", "1", "--engine", "none"], 2, ["none"]),
        (["poisson", mesh, "--side", "dual", "--rhs", "1", "-o", folder / "u.vtu"], 2, [".pvtu"]),
        (["spectrum", mesh, "--side", "dual", "--degree", "9"], 2, ["degree"]),
        (["merge", mesh, "-o", folder / "no" / "a.pvtu"], 4, ["a.pvtu", "folder"]),
        (["convert", mesh, "-o", mesh], 2, [".pdm"]),
        (["spectrum", bent, "--side", "primal", "--degree", "0"], 2,
         ["automatic", "hybrid", "0-cells", "--star circumcentric"]),
        (["poisson", bent, "--side", "dual", "--rhs", "1"], 2, ["hybrid", "--star circumcentric"]),
        (["poisson", mesh, "--side", "dual", "--rhs", "1", "--star", "galerkin"], 2,
         ["galerkin", "--star circumcentric"]),
    ]
    for words, code, said in cases:
        done = commands.on(3, *words)
        expect(done.code == code, f"{words}: exit code {done.code} for {code}")
        expect(says(done.err, *said), f"{words}: says {done.err}")
        expect(done.err.count("polydec-mpi: ") == 1, f"{words}: said by several ranks")
        expect(done.out == "", f"{words}: half an answer")


def processes_of(parent):
    """Those that mpiexec has started."""
    found = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            behind_name = status.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        if int(behind_name[1]) == parent:
            found.append(int(status.parent.name))
    return found


def hold_deaths(commands, folder):
    """Whenever a rank dies, all end, and what is written is whole or not there."""
    mesh, out = folder / "large.pdm", folder / "dead.pdm"
    commands.alone("generate", "kuhn", "--cells", "24", "24", "24", "-o", str(mesh))
    times = random.Random(1)
    deaths = int(os.environ.get("POLYDEC_TEST_SEEDS", "3"))
    for delay in [times.uniform(0.05, 1) for _ in range(deaths)]:
        for ending in [signal.SIGKILL, signal.SIGINT]:
            with Process(commands.line(3, "convert", mesh, "-o", out), stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE) as run:
                time.sleep(delay)
                victims = processes_of(run.pid)
                if ending == signal.SIGKILL and victims:
                    os.kill(victims[-1], ending)
                elif ending == signal.SIGINT:
                    run.send_signal(ending)
                try:
                    run.finish()
                except AssertionError as hanging:
                    expect(False, f"ranks hang after {ending}: {hanging}")
            if out.exists():
                expect(out.read_bytes() == mesh.read_bytes(), f"half a file after {ending}")
                out.unlink()


def with_little_memory(commands, kilobytes, words, seconds):
    """Outcome of three ranks, the last with a memory limit; None if they exceed the time limit."""
    poor = ["sh", "-c", f'ulimit -v {kilobytes}; exec "$0" "$@"', commands.mpi, *words]
    line = [*commands.mpiexec, "2", commands.mpi, *words, ":", "-n", "1", *poor]
    try:
        return run_program(line, seconds)
    except AssertionError:
        return None


def least_memory(commands):
    """Kilobytes with which MPI and PETSc start; with less they wait in vain, before polydec has a say.
    One step more than the first that will do: there they start only most of the time."""
    step = 30000
    for kilobytes in range(230000, 2000000, step):
        done = with_little_memory(commands, kilobytes, ["--help"], 5)
        if done and done.code == 0:
            return kilobytes + step
    return 2000000


def starts(commands, kilobytes, tiny):
    """Whether MPI and PETSc start with this memory, which is not always so where more is not there
    than they need: then they wait in PetscInitialize."""
    done = with_little_memory(commands, kilobytes, ["info", tiny], 5)
    return done is not None and done.code == 0


def hold_memory(commands, folder):
    """Where one rank may not have more memory, all end, with an error or the right answer."""
    mesh, out = folder / "large.pdm", folder / "poor.pdm"
    tiny, least, tried = folder / "tiny.pdm", least_memory(commands), 0
    commands.alone("generate", "kuhn", "--cells", "2", "2", "2", "-o", str(tiny))
    for kilobytes in range(least, least + 200000, 10000):
        if tried == 4 or not all(starts(commands, kilobytes, tiny) for _ in range(4)):
            continue
        tried += 1
        done = None
        for _ in range(3):  # MPI itself waits for ever now and then
            done = done or with_little_memory(commands, kilobytes, ["convert", mesh, "-o", out],
                                              SECONDS / 3)
        if done is None:
            expect(False, f"ranks hang each time with {kilobytes} kB on one of them")
            continue
        expect(done.code == 0 or done.err != "", f"no error with {kilobytes} kB")
        expect(out.exists() == (done.code == 0), f"a file after an error: {done.err}")
        if out.exists():
            expect(out.read_bytes() == mesh.read_bytes(), f"half a file with {kilobytes} kB")
            out.unlink()
    expect(tried > 0, "no memory with which MPI starts each time was found")


def hold_full_disks(commands, folder):
    """Where one rank can write no more, all end before long, and nothing half written is left."""
    limit = 30  # seconds
    mesh, full = folder / "cubes.nsc", folder / "full"
    full.mkdir()
    kept = ["operators", mesh, "--out", full / "operators"]
    writing = [(kept, [0]),
               (["convert", mesh, "-o", full / "a.pdm"], [0]),
               (["merge", mesh, "-o", full / "a.pvtu"], [0, 1]),
               (["poisson", mesh, "--side", "dual", "--rhs", "1", "-o", full / "u.pvtu"], [2])]
    for words, ranks in writing:
        for rank in ranks:
            for number in [1, 2, 9] if words is kept else [1]:
                line = commands.line(3, *words)
                done = run_program(["env", f"POLYDEC_FULL_DISK={rank} {number} {full}",
                                    f"LD_PRELOAD={commands.preload}", *line], limit)
                left = [path.name for path in full.iterdir()]
                what = f"{words[0]}, rank {rank} from write {number} on"
                expect(done.code == 4 and not left, f"{what}: code {done.code}, left {left}")
                expect(says(done.err, "cannot write", str(full)), f"{what}: says {done.err}")


def main():
    stop_ignoring_signals()
    commands = Commands(sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for turn, (mesh, words) in enumerate(MESHES.items()):
            file = str(folder / f"{mesh}.nsc")
            made = commands.alone("generate", *words, "-o", file)
            expect(made.code == 0, f"generate {mesh}: {made.err}")
            ranks = 2 + turn % 3
            hold_info(commands, ranks, mesh, file)
            if mesh != "bcc":  # whose automatic stars are matrices
                hold_spectrum(commands, ranks, mesh, file)
            if turn % 2 == 0:
                hold_poisson(commands, ranks, mesh, file)
        hold_warnings(commands, folder)
        hold_groups(commands, folder)
        hold_files(commands, folder, folder / "cubes.nsc")
        hold_errors(commands, folder, str(folder / "grid.nsc"))
        hold_full_disks(commands, folder)
        hold_deaths(commands, folder)
        hold_memory(commands, folder)
    print(f"{len(complaints)} complaint(s)")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
