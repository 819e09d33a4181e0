# SPDX-License-Identifier: MIT
"""Holds certified spectra of random small meshes against the eigenvalues in 60 digits.

    sixty_digits.py POLYDEC [COUNT [SEED]]

The dual volumes are computed anew from the coordinates, by the recursion over the circumcenters in
60 digits; of polydec only the cells are taken, which are integers. Every eigenvalue must lie within
its radius. The last line tells how many meshes, eigenvalues and refusals there were.
"""

import itertools
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import mpmath
from mpmath import mp

mp.dps = 60


def grown(n, rng):
    """Simplices put on facets of each other: trees and books."""
    cells, vertices = [list(range(n + 1))], n + 1
    for _ in range(rng.randrange(6)):
        corners = list(rng.choice(cells))
        corners[rng.randrange(n + 1)] = vertices
        vertices += 1
        cells.append(corners)
    return cells, vertices


def ring(n, rng):
    """A closed band, one-sided or not."""
    length = 2 * n + 1 + rng.randrange(3)
    return [[(first + i) % length for i in range(n + 1)] for first in range(length)], length


def cubes(n, rng):
    """A row of cubes, split like Kuhn's; the points come with it."""
    sides = [1 + rng.randrange(2)] + [1] * (n - 1)
    grid = list(itertools.product(*(range(s + 1) for s in sides)))
    number = {point: i for i, point in enumerate(grid)}
    cells = []
    for low in itertools.product(*(range(s) for s in sides)):
        for order in itertools.permutations(range(n)):
            at, corners = list(low), [number[low]]
            for axis in order:
                at[axis] += 1
                corners.append(number[tuple(at)])
            cells.append(corners)
    return cells, [list(map(float, point)) for point in grid]


def random_mesh(rng):
    n = rng.choice([1, 2, 2, 2, 3, 3, 4])
    N = n + rng.choice([0, 0, 1])
    make = rng.choice([grown, ring, cubes])
    cells, points = make(n, rng)
    if isinstance(points, int):
        points = [[float(rng.randrange(-3, 4)) for _ in range(N)] for _ in range(points)]
    points = [point + [0.0] * (N - len(point)) for point in points]
    jitter = rng.choice([0, 1e-8, 1e-3, 0.1, 0.3])
    flat = rng.choice([1, 1, 1e-1, 1e-2, 1e-4])
    scale = rng.choice([1, 1, 1e-8, 1e8, 1e-60, 1e60])
    return [[scale * (flat if i == 0 else 1) * (x + jitter * rng.uniform(-1, 1))
             for i, x in enumerate(point)] for point in points], cells


def write(path, points, cells):
    lines = [f"{len(points[0])} {len(cells[0]) - 1} {len(points)} {len(cells)}"]
    lines += [" ".join(map(repr, point)) for point in points]
    lines += [" ".join(map(str, cell)) for cell in cells]
    path.write_text("\n".join(lines) + "\n")


def integers(path):
    """A sparse integer matrix: shape and {(row, column): value}."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("%")]
    rows, columns, _ = map(int, lines[0].split())
    entries = {}
    for line in lines[1:]:
        i, j, value = line.split()
        entries[int(i) - 1, int(j) - 1] = int(float(value))
    return rows, columns, entries


def table(path):
    return [tuple(map(int, line.split())) for line in path.read_text().splitlines()]


class Sphere:
    """Volume and barycentric coordinates of the circumcenter, in 60 digits."""

    def __init__(self, corners):
        k = len(corners) - 1
        edges = [[a - b for a, b in zip(corner, corners[0])] for corner in corners[1:]]
        gram = mpmath.matrix(k, k)
        for i in range(k):
            for j in range(k):
                gram[i, j] = mpmath.fdot(edges[i], edges[j])
        self.volume = mpmath.sqrt(mpmath.det(gram)) / mpmath.factorial(k) if k else mp.one
        self.barycentric = [mp.one]
        if k:
            right = mpmath.matrix([gram[i, i] / 2 for i in range(k)])
            rest = list(mpmath.lu_solve(gram, right))
            self.barycentric = [1 - mpmath.fsum(rest)] + rest


def volumes(points, simplices):
    """Volumes of the simplices of every degree and of their duals."""
    n = len(simplices) - 1
    number = [{s: i for i, s in enumerate(list_)} for list_ in simplices]
    spheres = [[Sphere([points[v] for v in s]) for s in list_] for list_ in simplices]
    primal = [[sphere.volume for sphere in list_] for list_ in spheres]
    dual = [[mp.zero] * len(list_) for list_ in simplices]
    dual[n] = [mp.one] * len(simplices[n])
    for k in range(n, 0, -1):
        for t, vertices in enumerate(simplices[k]):
            for i in range(k + 1):
                s = number[k - 1][vertices[:i] + vertices[i + 1:]]
                height = spheres[k][t].barycentric[i] * k * primal[k][t] / primal[k - 1][s]
                dual[k - 1][s] += height * dual[k][t] / (n - k + 1)
    return primal, dual


def stars(folder, points):
    simplices = []
    while (folder / f"simplices_{len(simplices)}.txt").exists():
        simplices.append(table(folder / f"simplices_{len(simplices)}.txt"))
    primal, dual = volumes(points, simplices)
    result = []
    for k in range(len(simplices)):
        rows, _, pieces = integers(folder / f"diamond_{k}.mtx")
        volume, product = [mp.zero] * rows, [mp.zero] * rows
        for cell, s in pieces:
            volume[cell] += primal[k][s]
            product[cell] += primal[k][s] * dual[k][s]
        result.append([p / v**2 for p, v in zip(product, volume)])
    return result


def laplacian(folder, star, k):
    """M^-1/2 A M^-1/2 of the k-cells."""
    size, root = len(star[k]), [mpmath.sqrt(m) for m in star[k]]
    result = mpmath.matrix(size, size)

    def add_products(rows, weights):
        for row, weight in zip(rows, weights):
            for i, a in row:
                for j, b in row:
                    result[i, j] += a * b * weight

    if k + 1 < len(star):
        rows = [[] for _ in star[k + 1]]
        for (t, s), value in integers(folder / f"d_{k}.mtx")[2].items():
            rows[t].append((s, value / root[s]))
        add_products(rows, star[k + 1])
    if k > 0:
        rows = [[] for _ in star[k - 1]]
        for (t, s), value in integers(folder / f"d_{k - 1}.mtx")[2].items():
            rows[s].append((t, value * root[t]))
        add_products(rows, [1 / m for m in star[k - 1]])
    return result


def run(polydec, *arguments):
    return subprocess.run([polydec, *map(str, arguments)], capture_output=True, text=True)


def check(polydec, folder, rng):
    """None if the spectrum is refused; else the eigenvalues outside their radii, and how many."""
    points, cells = random_mesh(rng)
    mesh = folder / "mesh.nsc"
    write(mesh, points, cells)
    # the mass of n-cells is always positive, that of others seldom on such meshes
    side, n = rng.choice(["primal", "dual"]), len(cells[0]) - 1
    k = rng.choice([n, rng.randrange(n + 1)])
    degree = k if side == "primal" else n - k
    asked = ["spectrum", mesh, "--side", side, "--degree", degree, "--json"]
    found = run(polydec, *asked, "--count", 4)
    if fewer := re.search(r"so 1 to (\d) can be had", found.stderr):
        found = run(polydec, *asked, "--count", fewer[1])
    if found.returncode != 0:
        assert found.returncode in (2, 3) and len(found.stderr) > 20, (points, cells, found)
        return None
    answer = json.loads(found.stdout)
    facets = json.loads(run(polydec, "info", mesh, "--json").stdout)["facets"]
    if facets["boundary_degenerate"] > 0 and (side == "dual" or k == n):
        return None  # such forms are 0 on the cells there, which are left out
    out = folder / "operators"
    written = run(polydec, "operators", mesh, "--out", out)
    assert written.returncode == 0, written.stderr
    exact = [[mp.mpf(x) for x in point] for point in points]
    values = mpmath.eigsy(laplacian(out, stars(out, exact), k), eigvals_only=True)
    values = sorted(values)
    noise = mp.mpf(10)**-45 * max(map(abs, values))  # of the 60 digits
    outside = []
    for i, (value, radius) in enumerate(zip(answer["eigenvalues"], answer["radii"])):
        if abs(value - values[i]) > radius + noise:
            outside.append((i, value, radius, mpmath.nstr(values[i], 20)))
    return outside, len(answer["eigenvalues"]), (side, degree, points, cells)


def main(polydec, count=20, seed=1):
    meshes = refused = eigenvalues = 0
    wrong = []
    for number in range(count):
        with tempfile.TemporaryDirectory() as name:
            result = check(polydec, pathlib.Path(name), random.Random(f"{seed} {number}"))
        if result is None:
            refused += 1
            continue
        meshes += 1
        eigenvalues += result[1]
        if result[0]:
            wrong.append(number)
            print(f"mesh {number}: outside its radius {result[0]}\n  {result[2]}")
    print(f"{meshes} meshes, {eigenvalues} eigenvalues, {refused} refused, {len(wrong)} wrong")
    assert meshes > 0
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], *map(int, sys.argv[2:])))
