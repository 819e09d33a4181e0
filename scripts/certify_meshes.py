# SPDX-License-Identifier: MIT
"""Certified spectra of 1-forms of every mesh in some folders, as a table for docs/stars.md: cells,
Betti number, stars, the first eigenvalue that is not zero, seconds. Meshes that cannot be read
are left out; those with more than 500 harmonic forms are read, but their spectrum is not asked for.

Usage: certify_meshes.py PATH/TO/polydec FOLDER.. [--seconds N]     (N each, default 120)
Exit code: 0 if the zeros of every spectrum are as many as the Betti number says, else 1.
"""
import argparse
import sys
import time
from pathlib import Path

from tables import ask, line

KINDS = {".off", ".obj", ".ply", ".stl", ".mesh", ".msh", ".ele", ".vtk", ".vtu", ".nsc"}
MOST_HARMONIC = 500


def row(polydec, path, seconds):
    """A row of the table, and whether it is as it should be; None for what is no surface or solid."""
    info = ask(polydec, "info", path, seconds=seconds)
    if isinstance(info, str) or info["dimension"] < 2:
        return None
    betti = info["betti"]["merged"][1]
    row_of = [path.name, str(info["dimension"]), str(info["cells"]["merged"][1]),
              str(info["stars"][1]["negative"]), str(betti)]
    if betti > MOST_HARMONIC:
        return row_of + ["", "", "", "not asked for"], True
    count = min(betti + 3, info["cells"]["merged"][1])
    since = time.monotonic()
    found = ask(polydec, "spectrum", path, "--side", "primal", "--degree", 1, "--count", count,
                seconds=seconds)
    took = f"{time.monotonic() - since:.1f}"
    if isinstance(found, str):
        return row_of + ["", "", took, f"no: {found}"], False
    values, radii = found["eigenvalues"], found["radii"]
    zeros = sum(abs(value) <= radius for value, radius in zip(values, radii))
    negative = any(value + radius < 0 for value, radius in zip(values, radii))
    good = zeros == betti and found["certificate"]["complete"] and not negative
    star = found["star"]
    kind = star["kind"] + (f" {100 * star['galerkin_share']:.0f} %"
                           if star["kind"] == "hybrid" else "")
    first = f"{values[betti]:.6g}" if betti < count else ""
    return row_of + [kind, first, took, "yes" if good else f"no: {zeros} zeros"], good


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("polydec")
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--seconds", type=float, default=120)
    options = parser.parse_args()
    print("| mesh | n | edges | negative duals | Betti number | stars | first eigenvalue | seconds "
          "| certified |\n|---|---|---|---|---|---|---|---|---|")
    code = 0
    for folder in options.folders:
        for path in sorted(path for path in folder.rglob("*") if path.suffix.lower() in KINDS):
            told = row(options.polydec, path, options.seconds)
            if told is None:
                continue
            print(line(told[0]), end="", flush=True)
            code = code or (0 if told[1] else 1)
    sys.exit(code)


if __name__ == "__main__":
    main()
