#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the tables of docs/many_machines.md, "What it costs": what each stage of polydec-mpi info
takes the busiest rank.

    scripts/ranks_table.py BIN                   print the tables
    scripts/ranks_table.py BIN --docs            and put them into the page
    scripts/ranks_table.py BIN --ranks 1 2       other numbers of ranks

BIN holds polydec and polydec-mpi. A mesh of Kuhn's tetrahedra or of triangles, in a temporary
folder, takes some 40 MB; each run takes seconds, and as many cores as ranks if there are so many.
Meshes stay the same for all numbers of ranks, or have as many cells a rank.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from tables import line, put

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "many_machines.md"
MPIRUN = ["mpirun", "-x", "OMP_NUM_THREADS=1", "--oversubscribe", "--bind-to", "none", "--mca",
          "mpi_yield_when_idle", "1"]
STAGES = ["read", "owners", "complex", "volumes", "merge", "cells"]
MEGA = 1e-6
PATIENCE = 300  # seconds for a run, after which it counts as hanging
# how many cubes or squares an edge of the mesh has: of the whole one, and on so many ranks of those
# with as many cells a rank
CUBES, CUBES_BY_RANKS = 55, {1: 28, 2: 35, 4: 44, 8: 55}
SQUARES, SQUARES_BY_RANKS = 707, {1: 250, 2: 354, 4: 500, 8: 707}


def measure(binaries, mesh, ranks, runs):
    """What polydec-mpi info tells of its ranks in the run that took least."""
    words = MPIRUN + ["-n", str(ranks), str(binaries / "polydec-mpi"), "info", str(mesh), "--json",
                      "--timing"]
    told = [json.loads(subprocess.run(words, check=True, capture_output=True, text=True,
                                      stdin=subprocess.DEVNULL, timeout=PATIENCE).stdout)["ranks"]
            for _ in range(runs)]
    return min(told, key=lambda run: sum(run["stages"][stage]["cpu_seconds"] for stage in STAGES))


def rows(columns, baseline):
    """Of the table: a name, and what of each column."""
    yield "held twice", [f"{100 * (run['cells_held'] / run['cells'] - 1):.1f} %" for run in columns]
    for stage in STAGES:
        yield f"{stage}: CPU, s; sent, MB", [
            f"{of['cpu_seconds']:.2f}; {MEGA * of['bytes_sent']:.0f}"
            for of in (run["stages"][stage] for run in columns)]
    yield "together", [
        "{:.2f}; {:.0f}".format(sum(run["stages"][stage]["cpu_seconds"] for stage in STAGES),
                                sum(MEGA * run["stages"][stage]["bytes_sent"] for stage in STAGES))
        for run in columns]
    yield "memory at its peak, MB a rank", [f"{MEGA * run['peak_memory']:,.0f}" for run in columns]
    yield "bytes a cell held", [
        f"{(run['peak_memory'] - baseline) / (run['cells_held'] / run['count']):.0f}"
        for run in columns]


def table(head, columns, baseline):
    lines = [[head] + [f"{run['count']} rank{'s' if run['count'] > 1 else ''}" for run in columns],
             ["---"] * (len(columns) + 1)]
    lines += [[name] + cells for name, cells in rows(columns, baseline)]
    return "".join(map(line, lines))


def maker(binaries, folder):
    """A function of what to generate that gives the file, made where it is missing."""
    def made(kind, *options):
        out = folder / ("-".join((kind,) + options).replace("--", "") + ".pdm")
        if not out.exists():
            subprocess.run([str(binaries / "polydec"), "generate", kind, *options, "-o", str(out)],
                           check=True, capture_output=True)
        return out
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("binaries", type=pathlib.Path)
    parser.add_argument("--docs", action="store_true")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2, 4, 8],
                        choices=list(CUBES_BY_RANKS))
    parser.add_argument("--runs", type=int, default=3, help="of each, the best of which counts")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        made = maker(options.binaries, pathlib.Path(folder))

        def cubes(side):
            return made("kuhn", "--cells", str(side))

        def squares(side):
            return made("grid", "--nx", str(side), "--ny", str(side))

        def columns(mesh_on):
            return [measure(options.binaries, mesh_on(r), r, options.runs) for r in options.ranks]

        baseline = measure(options.binaries, cubes(2), 1, 1)["peak_memory"]
        tables = []
        for name, mesh, side, by_ranks in [("tetrahedra", cubes, CUBES, CUBES_BY_RANKS),
                                           ("triangles", squares, SQUARES, SQUARES_BY_RANKS)]:
            whole = columns(lambda r: mesh(side))
            tables.append(table(f"{whole[0]['cells']:,} {name}", whole, baseline))
            parts = columns(lambda r: mesh(by_ranks[r]))
            least, most = (round(of(run["cells"] / run["count"] for run in parts), -3)
                           for of in (min, max))
            some = f"{least:,.0f}" if least == most else f"{least:,.0f} to {most:,.0f}"
            tables.append(table(f"{some} {name} a rank", parts, baseline))
    text = "\n".join(tables)
    print(text, end="")
    if options.docs:
        put(PAGE, "ranks_table.py", text)


if __name__ == "__main__":
    main()
