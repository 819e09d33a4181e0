# SPDX-License-Identifier: MIT
"""The numbers of an independent program (golden/expected.json), asked for through the command."""
import copy
import json
import math
import os

from command import TestCase, golden

# the numbers were computed with it
TOLERANCE = ("--tolerance", "1e-8")


def read_expected():
    with open(golden("expected.json"), encoding="ascii") as file:
        return json.load(file)


def differs(found, wanted, relative=1e-8, absolute=1e-8):
    return not math.isclose(found, wanted, rel_tol=relative, abs_tol=absolute)


class Matrix:
    """A Matrix Market file: shape and {(row, column): value}."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            kind = file.readline().split()
            numbers = [line.split() for line in file if not line.startswith("%")]
        self.rows, self.columns = map(int, numbers[0][:2])
        if kind[2] == "array":
            self.entries = {(i, 0): float(line[0]) for i, line in enumerate(numbers[1:])}
        else:
            self.entries = {(int(i) - 1, int(j) - 1): float(x) for i, j, x in numbers[1:]}

    def values(self):
        return list(self.entries.values())


def read_cells(path):
    with open(path, encoding="ascii") as file:
        return [[int(vertex) for vertex in line.split()] for line in file]


def compare_info(wanted, info):
    """What `info --json` tells otherwise than expected."""
    summary, n = wanted["summary"], wanted["summary"]["n"]
    pairs = [("dimension", info["dimension"], n),
             ("ambient_dimension", info["ambient_dimension"], summary["N"]),
             ("input cells", info["cells"]["input"], summary["counts_simplicial"]),
             ("merged cells", info["cells"]["merged"], summary["counts_merged"]),
             ("euler", [info["euler"]["input"], info["euler"]["merged"]], summary["euler"]),
             ("betti", info["betti"]["input"], wanted["betti"]["simplicial"]),
             ("merged betti", info["betti"]["merged"], wanted["betti"]["merged"]),
             ("vertices", info["vertices_per_cell"], wanted["cells"]["vertices_per_cell"]),
             ("degenerate", info["facets"]["degenerate"], summary["degenerate_facets"]),
             ("boundary", info["facets"]["boundary_degenerate"], summary["boundary_degenerate"]),
             ("branching", info["facets"]["branching_degenerate"],
              summary["branching_degenerate"])]
    wrong = [name for name, found, value in pairs if found != value]
    if differs(info["volume"], summary["total_volume"]):
        wrong.append("volume")
    for k in range(n + 1):
        star, known = info["stars"][k], summary[f"star{k}"]
        wrong += [f"star{k} {key}" for key in ("min", "max", "min_abs")
                  if differs(star[key], known[key])]
        # those that are no more than rounding may have been counted as negative
        if not star["negative"] <= known["negative"] <= star["negative"] + star["zero"]:
            wrong.append(f"star{k} negative")
    return wrong


def compare_vector(values, wanted):
    """Keys of a summary of numbers that these have not."""
    found = {"size": len(values), "sum": math.fsum(values), "abs_sum": math.fsum(map(abs, values)),
             "norm2": math.hypot(*values), "min": min(values), "max": max(values)}
    scale = max(map(abs, values))
    return [key for key, value in found.items() if differs(value, wanted[key], 1e-8, 1e-8 * scale)]


def compare_laplacian(matrix, wanted, sum_counts):
    values = matrix.values()
    found = {"abs_sum": math.fsum(map(abs, values)), "frobenius": math.hypot(*values),
             "trace": math.fsum(x for (i, j), x in matrix.entries.items() if i == j)}
    if sum_counts:
        found["sum"] = math.fsum(values)
    scale = found["abs_sum"]
    return [key for key, value in found.items() if differs(value, wanted[key], 1e-8, 1e-9 * scale)]


def compare_operators(wanted, folder):
    """What the files of `operators` hold otherwise than expected."""
    summary, n, wrong = wanted["summary"], wanted["summary"]["n"], []
    for k in range(n + 1):
        star = Matrix(os.path.join(folder, f"star_{k}.mtx")).values()
        for name, file in (("star", "star"), ("dual", "dual_volume"), ("vol", "volume")):
            values = Matrix(os.path.join(folder, f"{file}_{k}.mtx")).values()
            wrong += [f"{name}{k} {key}"
                      for key in compare_vector(values, summary[f"{name}{k}"])]
        if f"star{k}" in wanted:
            cells = read_cells(os.path.join(folder, f"cells_{k}.txt"))
            by_cell = {tuple(cell): value for cell, value in zip(cells, star)}
            scale = max(map(abs, star))
            wrong += [f"star{k} {cell}" for cell, value in wanted[f"star{k}"]
                      if differs(by_cell.get(tuple(cell), math.inf), value, 1e-8, 1e-8 * scale)]
        if k < n:
            d = Matrix(os.path.join(folder, f"d_{k}.mtx"))
            found = {"shape": [d.rows, d.columns], "nnz": len(d.entries),
                     "values": sorted(set(d.values()))}
            wrong += [f"d{k} {key}" for key, value in found.items()
                      if summary[f"d{k}"][key] != value]
        if f"L{k}" in wanted:
            laplacian = Matrix(os.path.join(folder, f"laplacian_primal_{k}.mtx"))
            wrong += [f"L{k} {key}" for key in
                      compare_laplacian(laplacian, wanted[f"L{k}"], k == 0)]
    return wrong


def compare_spectrum(wanted, eigenvalues):
    smallest = sorted(wanted["smallest"])
    return [i for i, (found, value) in enumerate(zip(eigenvalues, smallest))
            if differs(found, value, 1e-7, 1e-7)] or len(smallest) - len(eigenvalues)


class GoldenNumbers(TestCase):
    def test_info(self):
        for name, wanted in read_expected().items():
            with self.subTest(name):
                info = self.ask("info", golden(name), *TOLERANCE)
                self.assertEqual(compare_info(wanted, info), [])

    def test_operators(self):
        for name, wanted in read_expected().items():
            with self.subTest(name):
                self.succeed("operators", golden(name), "--out", name, *TOLERANCE)
                self.assertEqual(compare_operators(wanted, self.path(name)), [])

    def test_spectra(self):
        for name, wanted in read_expected().items():
            for k in range(wanted["summary"]["n"] + 1):
                if f"spectrum{k}" not in wanted or wanted["summary"][f"star{k}"]["negative"]:
                    continue
                for side in ("primal", "dual"):
                    with self.subTest(name, k=k, side=side):
                        if name == "branching.off" and (side, k) == ("dual", 2):
                            self.assertSays(self.fail_with(2, "spectrum", golden(name), "--side", side,
                                                           "--degree", 0), "3 cells", "facet")
                        else:
                            self.check_spectrum(name, wanted, side, k)

    def check_spectrum(self, name, wanted, side, k):
        degree = k if side == "primal" else wanted["summary"]["n"] - k
        count = len(wanted[f"spectrum{k}"]["smallest"])
        answer = self.ask("spectrum", golden(name), "--side", side, "--degree", degree, "--count",
                          count, "--star", "circumcentric", *TOLERANCE)
        self.assertFalse(compare_spectrum(wanted[f"spectrum{k}"], answer["eigenvalues"]))


class BrokenTwins(TestCase):
    """A number that is a little wrong must be noticed, whichever it is."""

    def setUp(self):
        super().setUp()
        self.name = "uv8.off"
        self.wanted = read_expected()[self.name]

    def tampered(self, *keys):
        twin = copy.deepcopy(self.wanted)
        place = twin
        for key in keys[:-1]:
            place = place[key]
        place[keys[-1]] = (place[keys[-1]] + 1 if isinstance(place[keys[-1]], int)
                           else place[keys[-1]] * (1 + 1e-6))
        return twin

    def test_of_info(self):
        info = self.ask("info", golden(self.name), *TOLERANCE)
        self.assertEqual(compare_info(self.wanted, info), [])
        for keys in (("summary", "counts_merged", 1), ("summary", "total_volume"),
                     ("betti", "merged", 2), ("cells", "vertices_per_cell", "4"),
                     ("summary", "degenerate_facets"), ("summary", "star1", "min")):
            self.assertEqual(len(compare_info(self.tampered(*keys), info)), 1, keys)

    def test_of_operators(self):
        self.succeed("operators", golden(self.name), "--out", "out", *TOLERANCE)
        folder = self.path("out")
        self.assertEqual(compare_operators(self.wanted, folder), [])
        for keys in (("star1", 3, 1), ("star2", 3, 0, 1), ("L1", "trace"), ("L2", "frobenius"),
                     ("summary", "dual0", "sum"), ("summary", "vol1", "norm2"),
                     ("summary", "d0", "nnz")):
            self.assertEqual(len(compare_operators(self.tampered(*keys), folder)), 1, keys)

    def test_of_spectra(self):
        answer = self.ask("spectrum", golden(self.name), "--side", "primal", "--degree", 1,
                          "--count", 20, *TOLERANCE)
        self.assertFalse(compare_spectrum(self.wanted["spectrum1"], answer["eigenvalues"]))
        twin = self.tampered("spectrum1", "smallest", 4)
        self.assertTrue(compare_spectrum(twin["spectrum1"], answer["eigenvalues"]))
        short = answer["eigenvalues"][:-1]
        self.assertTrue(compare_spectrum(self.wanted["spectrum1"], short))
