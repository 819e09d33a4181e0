# SPDX-License-Identifier: MIT
"""Intrinsic Delaunay tessellations of surfaces as they are found, beside the numbers that an
independent program gives for them (golden/expected_calculus.json)."""
import collections
import json
import math
import os

from command import TestCase, golden
from golden_numbers import Matrix, differs
from intrinsic_laws import (compare_numbers, count_below, natural_dual_rows, sides_of_edges,
                            spectrum_of_rows_differs)


def cut_as_written(path):
    """The text of an OFF file whose polygons are cut from the corner each begins with, as the
    independent program cut them."""
    with open(path, encoding="ascii") as file:
        lines = file.read().splitlines()
    vertices, faces = map(int, lines[1].split()[:2])
    polygons = [line.split()[1:] for line in lines[2 + vertices:2 + vertices + faces]]
    triangles = [f"3 {p[0]} {p[i]} {p[i + 1]}" for p in polygons for i in range(1, len(p) - 1)]
    return "\n".join(["OFF", f"{vertices} {len(triangles)} 0", *lines[2:2 + vertices], *triangles, ""])


def read_expected():
    """{path: numbers} of the real meshes that are there."""
    with open(golden("expected_calculus.json"), encoding="ascii") as file:
        entries = json.load(file)
    root = os.environ.get("POLYDEC_TEST_DATA", "")
    paths = {os.path.join(root, name): entry["intrinsic"] for name, entry in entries.items()
             if "intrinsic" in entry}
    return {path: wanted for path, wanted in paths.items() if root and os.path.exists(path)}


class GoldenNumbers(TestCase):
    EXACTLY = ("--delaunay", "--tolerance", "1e-8")

    def expected(self):
        """The triangles and the numbers of each mesh."""
        for path, wanted in read_expected().items():
            name = os.path.basename(path)
            yield (self.write(name, cut_as_written(path)) if "quads" in name else path), wanted

    def read_operators(self, path):
        self.succeed("operators", path, "--out", "out", *self.EXACTLY)
        read = {name: Matrix(self.path(f"out/{name}.mtx"))
                for name in ("d_1", "star_0", "star_1", "volume_1", "volume_2")}
        d = read.pop("d_1")
        return d, {name: matrix.values() for name, matrix in read.items()}

    def compare_operators(self, path, wanted):
        d, values = self.read_operators(path)
        stars = collections.defaultdict(list)
        for side, star in zip(sides_of_edges(d), values["star_1"], strict=True):
            stars[side].append(star)
        wrong = [f"star0 {key}" for key in compare_numbers(values["star_0"], wanted["star0"])]
        for side, name in ((2, "star1_interior"), (1, "star1_boundary")):
            if wanted[name] is None:
                self.assertEqual(stars[side], [])
            else:
                wrong += [f"{name} {key}" for key in compare_numbers(stars[side], wanted[name])]
        for name, number in (("volume_1", "edge_length_sum"), ("volume_2", "area")):
            if differs(math.fsum(values[name]), wanted[number]):
                wrong.append(number)
        if stars[1]:
            rows = natural_dual_rows(d, values["star_1"], values["volume_2"])
            wrong += spectrum_of_rows_differs(rows, wanted["spectrum_dual0_natural"])
        return wrong

    def test_operators(self):
        for path, wanted in self.expected():
            with self.subTest(os.path.basename(path)):
                self.assertEqual(self.compare_operators(path, wanted), [])

    def test_counts(self):
        for path, wanted in self.expected():
            with self.subTest(os.path.basename(path)):
                info = self.ask("info", path, *self.EXACTLY)
                self.assertEqual(info["cells"]["merged"], wanted["counts"])
                self.assertEqual(info["intrinsic"]["negative_before"],
                                 wanted["negative_star1_before"])

    def test_spectra(self):
        for path, wanted in self.expected():
            closed = wanted["star1_boundary"] is None
            for side, known in (("primal", "spectrum_primal0"),
                                ("dual", "spectrum_dual0_natural")):
                # the command's dual 0-forms are 0 on the boundary
                if side == "primal" or closed:
                    with self.subTest(os.path.basename(path), side=side):
                        answer = self.ask("spectrum", path, "--side", side, "--degree", 0,
                                          "--star", "circumcentric", "--count",
                                          len(wanted[known]), *self.EXACTLY)
                        self.assertEqual([(x, y) for x, y in zip(answer["eigenvalues"],
                                          wanted[known], strict=True) if differs(x, y, 1e-7, 1e-7)],
                                         [])

    def test_a_number_that_is_a_little_wrong_is_noticed(self):
        for path, wanted in self.expected():
            if path.endswith("square_hole.off"):
                for key in ("edge_length_sum", "area"):
                    twin = {**wanted, key: wanted[key] * (1 + 1e-7)}
                    self.assertEqual(self.compare_operators(path, twin), [key])
                star = {**wanted["star0"], "norm": wanted["star0"]["norm"] * (1 + 1e-6)}
                self.assertEqual(self.compare_operators(path, {**wanted, "star0": star}),
                                 ["star0 norm"])
                values = wanted["spectrum_dual0_natural"]
                moved = {**wanted, "spectrum_dual0_natural":
                         values[:3] + [values[3] * (1 + 1e-6)] + values[4:]}
                self.assertEqual(self.compare_operators(path, moved), [values[3] * (1 + 1e-6)])

    def test_inertia(self):
        # the path of three vertices: 0, 1, 3
        rows = [{0: 1, 1: -1}, {0: -1, 1: 2, 2: -1}, {1: -1, 2: 1}]
        self.assertEqual([count_below(rows, x) for x in (-.5, .5, 2.5, 3.5)], [0, 1, 2, 3])
        self.assertEqual(spectrum_of_rows_differs(rows, [0, 1, 3]), [])
        self.assertEqual(spectrum_of_rows_differs(rows, [0, 1, 1]), [1])
        self.assertEqual(spectrum_of_rows_differs(rows, [0, 3]), [3])
