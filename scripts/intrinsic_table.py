# SPDX-License-Identifier: MIT
"""Writes the table of intrinsic flips: what `polydec info` says of every surface file below some
folders without --delaunay, with it, and with --delaunay=split-boundary.

Usage: intrinsic_table.py POLYDEC [NAME=]FOLDER_OR_FILE... [--page PAGE.md]

A file is called by NAME, or that of its folder, and its path in there. The table goes to stdout,
or into PAGE.md between the two lines that mark its place there. Which files were left out and why,
and what is against the laws (flips change no topology and leave no negative dual inside, splits
none at all), is told on stderr. Exit code: 0 done, 1 wrong usage, 2 some law is broken.
"""
import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from tables import line, put

EXTENSIONS = {".off", ".obj", ".ply", ".stl", ".mesh", ".msh", ".vtk", ".vtu", ".nsc"}
SECONDS = 60
GOOD_CODES = {0, 2, 3}
COUNT = 25
OPTIONS = (), ("--delaunay",), ("--delaunay=split-boundary",)

Answer = collections.namedtuple("Answer", "info error problem")


class Row:
    """What became of one file. `interior` is the smallest star_1 inside after the flips."""

    def __init__(self, group, name, plain, flipped, split, interior):
        self.group, self.name = group, name
        self.triangles = flipped["cells"]["input"][2]
        self.orientable = flipped["orientable"]
        self.larger = flipped["volume"] / plain["volume"] if plain else None
        done = flipped["intrinsic"]
        self.before, self.boundary_before = (done["negative_before"],
                                             done["negative_boundary_before"])
        self.flips, self.boundary_after = done["flips"], done["negative_boundary"]
        self.lengthened = done["added_length"] > 0
        self.polygons, self.interior = flipped["cells"]["merged"][2], interior
        self.splits = split["intrinsic"]["splits"]
        self.seconds = sum(flipped["timing"][stage] for stage in ("volumes", "merge"))


# The command

def refuse_constant(name):
    raise ValueError(f"{name} is no JSON")


def run(command, *arguments):
    """What the command said, or why it did not, or what it must never do."""
    try:
        done = subprocess.run([command, *arguments], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return Answer(None, None, f"not done after {SECONDS} s")
    lines = [line for line in done.stderr.splitlines() if "polydec: warning: " not in line]
    if done.returncode not in GOOD_CODES:
        return Answer(None, None, f"exit code {done.returncode}: {' '.join(lines)[:300]}")
    if done.returncode:
        text = " ".join(lines).removeprefix("polydec: ")
        return Answer(None, text, None if text else f"exit code {done.returncode} without a word")
    return Answer(done.stdout, None, None)


def ask(command, path, *more):
    answer = run(command, "info", path, "--json", "--timing", *more)
    if answer.info is None:
        return answer
    try:
        return Answer(json.loads(answer.info, parse_constant=refuse_constant), None, None)
    except ValueError as error:
        return Answer(None, None, f"no JSON: {error}")


def entries(path):
    """Lines of numbers of a Matrix Market file, without the one of sizes."""
    with open(path, encoding="ascii") as file:
        lines = (line for line in file if not line.startswith("%"))
        next(lines)
        yield from (line.split() for line in lines)


def smallest_inside(command, path):
    """Smallest star_1 of the edges with two triangles: every edge but those with one coefficient
    of +-1 in d_1. An edge with the same cell on both sides has none, or one of +-2."""
    with tempfile.TemporaryDirectory() as folder:
        done = run(command, "operators", path, "--delaunay", "--out", folder)
        if done.info is None:
            raise ValueError(done.problem or done.error)
        stars = [float(line[0]) for line in entries(os.path.join(folder, "star_1.mtx"))]
        sides = [0] * len(stars)
        for _, edge, coefficient in entries(os.path.join(folder, "d_1.mtx")):
            sides[int(edge) - 1] += abs(int(float(coefficient)))
    inside = [star for star, count in zip(stars, sides) if count != 1]
    return min(inside, default=None)


# Laws

def same_topology(plain, other):
    return all(plain[key]["input"] == other[key][stage]
               for key in ("betti", "euler") for stage in ("input", "merged"))


def flaws(plain, flipped, split, interior):
    """What of flips and splits is not as it has to be; plain is None where only flips can do with
    the triangles."""
    found = []
    for what, info in (("flips", flipped), ("splits", split)):
        if not same_topology(plain or flipped, info):
            found.append(f"{what} change the topology to {info['betti']}")
        if info["intrinsic"]["negative"]:
            found.append(f"{what} leave {info['intrinsic']['negative']} negative duals inside")
        # a length added to all edges may add a little
        relative = 1e-3 if info["intrinsic"]["added_length"] else 1e-9
        if plain and abs(info["volume"] / plain["volume"] - 1) > relative:
            found.append(f"{what} change the area: {plain['volume']!r} to {info['volume']!r}")
    if interior is not None and interior <= 0:
        found.append(f"flips leave star_1 = {interior!r} inside")
    for k, star in enumerate(split["stars"]):
        if star["min"] <= 0 or star["zero"] or star["negative"]:
            found.append(f"splits leave star_{k} from {star['min']!r}, {star['negative']} negative "
                         f"and {star['zero']} zero ones")
    return found


def describe(command, group, name, path):
    """(row or None, why there is none, what is wrong)"""
    plain, flipped, split = (ask(command, path, *more) for more in OPTIONS)
    problems = [answer.problem for answer in (plain, flipped, split) if answer.problem]
    if plain.info and plain.info["dimension"] != 2:
        return None, f"its cells are of dimension {plain.info['dimension']}", []
    if problems or not (flipped.info and split.info):
        return None, flipped.error or split.error or "", problems
    try:
        interior = (smallest_inside(command, path) if flipped.info["boundary_components"]
                    else flipped.info["stars"][1]["min"])
    except ValueError as error:
        return None, "", [f"operators --delaunay: {error}"]
    known = (plain.info, flipped.info, split.info)
    return Row(group, name, *known, interior), "", flaws(*known, interior)


# The table

def telling(rows):
    """The files that show something: the extremes of each column, one-sided ones, and then those
    with the most flips until there are enough."""
    reasons = [(5, lambda row: row.flips), (3, lambda row: row.flips / row.triangles),
               (4, lambda row: row.splits), (3, lambda row: row.triangles),
               (3, lambda row: row.boundary_after), (2, lambda row: row.before),
               (2, lambda row: row.lengthened and row.flips), (2, lambda row: not row.orientable),
               (1, lambda row: row.seconds),
               (2, lambda row: 0 if row.interior is None else 1 / row.interior)]
    chosen = []
    for count, key in reasons + [(len(rows), lambda row: row.flips)]:
        for row in sorted((row for row in rows if key(row)), key=key, reverse=True)[:count]:
            if row not in chosen and len(chosen) < COUNT:
                chosen.append(row)
    return sorted(chosen, key=lambda row: -row.triangles)


def heading(first, *more):
    return line((first,) + more) + line(("---",) + ("--:",) * len(more))


def total_line(name, rows):
    def add(key):
        return f"{sum(getattr(row, key) for row in rows):,}"
    return line([name, f"{len(rows):,}", add("triangles"), f"{add('before')} / "
                 f"{add('boundary_before')}", add("flips"), add("polygons"), add("boundary_after"),
                 f"{sum(row.boundary_after > 0 for row in rows)}", add("splits"),
                 f"{sum(row.seconds for row in rows):.1f}"])


def totals(rows):
    text = heading("folder", "files", "triangles", "negative before, inside / boundary", "flips",
                   "polygons", "negative after, all on the boundary", "files with such", "splits",
                   "seconds")
    groups = list(dict.fromkeys(row.group for row in rows))
    for group in groups:
        text += total_line(group, [row for row in rows if row.group == group])
    return text + (total_line("all", rows) if len(groups) > 1 else "")


def file_line(row):
    name = row.name + " *" * row.lengthened + " (one-sided)" * (not row.orientable)
    if row.larger and row.larger > 1.001:
        name += f" (area x {row.larger:.3g})"
    interior = "-" if row.interior is None else f"{row.interior:.1e}"
    return line([name, f"{row.triangles:,}", f"{row.before:,} / {row.boundary_before:,}",
                 f"{row.flips:,}", f"{row.polygons:,}", interior, f"{row.boundary_after:,}",
                 f"{row.splits:,}", f"{row.seconds:.2f}"])


def table(rows):
    chosen = telling(rows)
    text = totals(rows) + "\n"
    text += heading("file", "triangles", "negative before, inside / boundary", "flips", "polygons",
                    "smallest star_1 inside", "negative after, on the boundary", "splits",
                    "seconds")
    text += "".join(map(file_line, chosen))
    text += (f"\n{len(chosen)} of {len(rows)} files: those with the most flips, flips per triangle,"
             " splits or\ntriangles, the smallest stars, and such like. Seconds are those of the "
             "flips, the volumes and the merging.\n")
    if any(row.lengthened for row in chosen):
        text += "\\* a length was added to all edges, because some triangle has nearly no area.\n"
    return text


# Files

def surfaces(argument):
    """(group, name, path) of the files of a folder, or of the one file."""
    name, equals, place = argument.partition("=")
    place = place if equals else argument
    if not os.path.exists(place):
        raise ValueError(f"there is no {place}")
    root = os.path.normpath(place if os.path.isdir(place) else os.path.dirname(place) or ".")
    group = name if equals else os.path.basename(os.path.abspath(root))
    if not os.path.isdir(place):
        return [(group, f"{group}/{os.path.basename(place)}", place)]
    found = [os.path.join(folder, file) for folder, _, files in os.walk(root) for file in files]
    return [(group, f"{group}/{os.path.relpath(path, root)}", path) for path in sorted(found)
            if os.path.splitext(path)[1].lower() in EXTENSIONS]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("polydec")
    parser.add_argument("place", nargs="+", metavar="[NAME=]FOLDER_OR_FILE")
    parser.add_argument("--page", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        files = [file for place in arguments.place for file in surfaces(place)]
    except ValueError as error:
        parser.error(str(error))
    rows, broken = [], 0
    for group, name, path in files:
        row, reason, problems = describe(arguments.polydec, group, name, path)
        if row:
            rows.append(row)
        elif reason:
            print(f"left out {name}: {reason}", file=sys.stderr)
        for problem in problems:
            print(f"BROKEN {name}: {problem}", file=sys.stderr)
        broken += bool(problems)
    print(f"{len(files)} files, {len(rows)} in the table, {broken} against the laws",
          file=sys.stderr)
    if not rows:
        sys.exit("No surface was found.")
    if arguments.page:
        put(arguments.page, "intrinsic_table.py", table(rows))
    else:
        print(table(rows), end="")
    return 2 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
