# SPDX-License-Identifier: MIT
"""Writes the table of enclosures: how wide the bounds of the first ten eigenvalues of the shape are for
every surface file below some folders, as it is and after bisection, and how long they take.

Usage: shape_table.py POLYDEC FOLDER... [--page PAGE.md]

Files of more than 20,000 triangles are left out. The table goes to stdout, or into PAGE.md between the
two lines that mark its place there. Files that are refused, and why, are told on stderr.
"""
import argparse
import pathlib
import sys

from tables import ask, line, put

EXTENSIONS = {".msh", ".off", ".obj", ".ply", ".stl"}
MOST, COUNT, SECONDS = 20_000, 10, 300


def widths(answer):
    """Of the eigenvalues that are not 0, the least and the greatest."""
    shape = answer["shape"]
    pairs = list(zip(shape["lower"], shape["upper"]))[shape["zeros"]:]
    each = [1 - low / high for low, high in pairs]
    return min(each, default=0), max(each, default=0)


def row(command, path):
    """Its cells, or why there are none."""
    info = ask(command, "info", path, "--no-merge", seconds=SECONDS)
    if isinstance(info, str):
        return info
    if info["dimension"] != 2:
        return "no surface"
    triangles = info["cells"]["input"][2]
    if triangles > MOST:
        return f"{triangles} triangles"
    shape = "spectrum", path, "--of-shape", "--count", COUNT
    plain = ask(command, "spectrum", path, "--side", "primal", "--degree", 0, "--count", COUNT,
                seconds=SECONDS)
    first = ask(command, *shape, seconds=SECONDS)
    if isinstance(first, str):
        return first
    if first["shape"]["zeros"] == COUNT:
        return f"has {COUNT} parts or more, and all these eigenvalues are 0"
    least, most = widths(first)
    cells = [path.name, f"{triangles}", f"{first['shape']['flips']}", f"{least:.1e} .. {most:.1e}"]
    if isinstance(plain, str):
        cells.append("")
    else:
        cells.append(f"{first['seconds']:.2f} ({first['seconds'] / max(plain['seconds'], 1e-3):.0f}x)")
    refined = first
    if most > 1e-3:
        refined = ask(command, *shape, "--width", 1e-3, "--max-triangles", max(7000, 2 * triangles),
                      seconds=SECONDS)
    if isinstance(refined, str):
        print(f"{path.name}: {refined}", file=sys.stderr)
        return [*cells, "", "refused"]
    return [*cells, f"{refined['shape']['triangles']}", f"{widths(refined)[1]:.1e}"]


def table(command, folders):
    files = sorted(path for folder in folders for path in pathlib.Path(folder).rglob("*")
                   if path.suffix.lower() in EXTENSIONS)
    text = ("| | triangles | flips | widths | s (plain) | bisected to | greatest width |\n"
            "|---|---|---|---|---|---|---|\n")
    for path in files:
        cells = row(command, path)
        if isinstance(cells, str):
            print(f"{path.name}: {cells}", file=sys.stderr)
        else:
            text += line(cells)
            print(line(cells), end="", file=sys.stderr)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("polydec")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--page", type=pathlib.Path)
    arguments = parser.parse_args()
    text = table(arguments.polydec, arguments.folders)
    if arguments.page:
        put(arguments.page, "shape_table.py", text)
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
