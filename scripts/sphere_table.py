# SPDX-License-Identifier: MIT
"""Prints eigenvalues on the unit sphere beside the exact ones, l (l + 1) with multiplicity 2 l + 1.

Usage: sphere_table.py PRIMAL.json DUAL.json, both as `polydec spectrum --json` prints them. Each
eigenvalue is counted for the l whose exact value is nearest. Exit code: 0 done, 1 unreadable.
"""
import json
import sys


def exact(degree):
    return degree * (degree + 1)


def clusters(values):
    """The eigenvalues that belong to l = 0, 1, .. up to the largest that is reached."""
    found = []
    for value in sorted(values):
        degree = min(range(len(values) + 1), key=lambda l: abs(exact(l) - value))
        found += [[] for _ in range(degree + 1 - len(found))]
        found[degree].append(value)
    return found


def columns(degree, cluster):
    """How many there are, the smallest, the largest, the largest error (absolute for l = 0)."""
    if not cluster:
        return f"{0:6}  {'-':>9}  {'-':>9}  {'-':>8}"
    low, high = (round(value, 6) + 0.0 for value in (cluster[0], cluster[-1]))
    error = max(abs(value - exact(degree)) for value in cluster) / max(exact(degree), 1)
    return f"{len(cluster):6}  {low:9.6f}  {high:9.6f}  {error:8.1e}"


def main(primal_file, dual_file):
    sides = []
    for name in (primal_file, dual_file):
        with open(name, encoding="utf-8") as file:
            sides.append(clusters(json.load(file)["eigenvalues"]))
    heads = "copies        min        max     error"
    print(f"{'':18} | {'primal (vertices)':38} | dual (cells)")
    print(f" l  l(l+1)  copies | {heads} | {heads}")
    for degree in range(max(map(len, sides))):
        cells = (columns(degree, side[degree] if degree < len(side) else []) for side in sides)
        print(f"{degree:2}  {exact(degree):6}  {2 * degree + 1:6} | " + " | ".join(cells))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"Cannot read the eigenvalues: {error!r}")
