# SPDX-License-Identifier: MIT
"""Laws that the files of `polydec operators` obey among each other."""
import os
import re

import command
from command import TestCase, golden
from golden_numbers import Matrix, read_cells

MESHES = ("kuhn1d.nsc", "grid4.nsc", "hex4.nsc", "star_negative.nsc", "spike.nsc", "uv8.off",
          "branching.off", "kuhn3.nsc", "kuhn4.nsc", "split_cubes.nsc", "fcc1.nsc")


def product(A, B):
    rows = {}
    for (k, j), value in B.items():
        rows.setdefault(k, []).append((j, value))
    result = {}
    for (i, k), left in A.items():
        for j, right in rows.get(k, ()):
            result[i, j] = result.get((i, j), 0) + left * right
    return result


def scaled(left, A, right):
    return {(i, j): left[i] * value * right[j] for (i, j), value in A.items()}


def difference(A, B):
    """Largest entry of A - B, over the largest of B."""
    size = max((abs(x) for x in B.values()), default=1) or 1
    return max((abs(A.get(at, 0) - B.get(at, 0)) for at in {*A, *B}), default=0) / size


def identity(n):
    return {(i, i): 1 for i in range(n)}


def coboundary_of_simplices(faces, simplices):
    """With both oriented by ascending vertices."""
    number = {tuple(face): i for i, face in enumerate(faces)}
    return {(i, number[tuple(s[:p] + s[p + 1:])]): (-1) ** p
            for i, s in enumerate(simplices) for p in range(len(s))}


class OperatorFiles(TestCase):
    def load(self, name):
        self.out = self.path(name)
        self.outcome = self.succeed("operators", golden(name), "--out", self.out)
        self.n = max(int(file[2]) for file in os.listdir(self.out) if file.startswith("d_")) + 1

    def matrix(self, name, k):
        return Matrix(os.path.join(self.out, f"{name}_{k}.mtx"))

    def vector(self, name, k):
        return self.matrix(name, k).values()

    def cells(self, name, k):
        return read_cells(os.path.join(self.out, f"{name}_{k}.txt"))

    def test_laws(self):
        for name in MESHES:
            self.load(name)
            for check in (self.check_shapes, self.check_boundaries, self.check_cochain_maps,
                          self.check_stars, self.check_laplacians):
                with self.subTest(name, law=check.__name__):
                    check()

    def check_shapes(self):
        """Every matrix has a row for each cell, and a merged cell the vertices of its pieces."""
        for k in range(self.n + 1):
            merged, simplices = self.cells("cells", k), self.cells("simplices", k)
            self.assertEqual(simplices, sorted(sorted(cell) for cell in simplices))
            self.assertEqual(merged, [sorted(cell) for cell in merged])
            self.assertTrue(all(len(cell) == k + 1 for cell in simplices))
            for name in ("star", "volume", "dual_volume"):
                self.assertEqual(len(self.vector(name, k)), len(merged))
            for name, shape in (("diamond", (len(merged), len(simplices))),
                                ("lift", (len(simplices), len(merged)))):
                matrix = self.matrix(name, k)
                self.assertEqual((matrix.rows, matrix.columns), shape)
            pieces = {}
            for F, s in self.matrix("diamond", k).entries:
                pieces.setdefault(F, set()).update(simplices[s])
            self.assertEqual([sorted(pieces[F]) for F in range(len(merged))], merged)

    def check_boundaries(self):
        """d d = 0."""
        for k in range(self.n - 1):
            twice = product(self.matrix("d", k + 1).entries, self.matrix("d", k).entries)
            self.assertTrue(all(value == 0 for value in twice.values()))

    def check_cochain_maps(self):
        """Merging and lifting commute with d, and merging what was lifted changes nothing."""
        for k in range(self.n + 1):
            merged = len(self.cells("cells", k))
            back = product(self.matrix("diamond", k).entries, self.matrix("lift", k).entries)
            self.assertLess(difference(back, identity(merged)), 1e-12)
        for k in range(self.n):
            d, diamond = self.matrix("d", k).entries, self.matrix("diamond", k).entries
            above = self.matrix("diamond", k + 1).entries
            of_simplices = coboundary_of_simplices(self.cells("simplices", k),
                                                   self.cells("simplices", k + 1))
            if k + 1 == self.n:
                of_simplices = self.oriented(of_simplices, above, product(d, diamond))
            self.assertEqual(difference(product(above, of_simplices), product(d, diamond)), 0)
            lifted = product(self.matrix("lift", k + 1).entries, d)
            again = product(of_simplices, self.matrix("lift", k).entries)
            if k + 1 < self.n:
                self.assertLess(difference(again, lifted), 1e-12)

    def oriented(self, of_simplices, diamond, wanted):
        """Top simplices keep the orientation of the input, which no file tells: a facet on the
        surface of the merged cell tells it, inside the pieces must fit together."""
        cell_of = {s: (F, sign) for (F, s), sign in diamond.items()}
        cofaces = {}
        for s, f in of_simplices:
            cofaces.setdefault((cell_of[s][0], f), []).append(s)
        sign, inside = {}, []
        for (F, f), around in cofaces.items():
            if wanted.get((F, f)):
                s = around[0]
                sign[s] = wanted[F, f] * cell_of[s][1] * of_simplices[s, f]
            elif len(around) == 2:
                inside.append((f, around))
        while len(sign) < len(cell_of):
            before = len(sign)
            for f, (s, t) in inside + [(f, (t, s)) for f, (s, t) in inside]:
                if s in sign and t not in sign:
                    sign[t] = (-sign[s] * of_simplices[s, f] * of_simplices[t, f]
                               * cell_of[s][1] * cell_of[t][1])
            self.assertGreater(len(sign), before, "a piece that hangs together with nothing")
        return {(s, f): sign[s] * value for (s, f), value in of_simplices.items()}

    def check_stars(self):
        """Dual over primal volumes; sum |s||*s| = C(n,k)|K|."""
        total = sum(self.vector("volume", self.n))
        choose = 1
        for k in range(self.n + 1):
            star, primal, dual = (self.vector(name, k)
                                  for name in ("star", "volume", "dual_volume"))
            scale = max(map(abs, star))
            for s, v, w in zip(star, primal, dual):
                self.assertAlmostEqual(s, w / v, delta=1e-14 * scale)
            self.assertAlmostEqual(sum(v * w for v, w in zip(primal, dual)), choose * total,
                                   delta=1e-12 * total)
            choose = choose * (self.n - k) // (k + 1)

    def check_laplacians(self):
        """Made of d and the stars; a dual one is the primal one between stars."""
        for k in range(self.n + 1):
            if not os.path.exists(os.path.join(self.out, f"laplacian_primal_{k}.mtx")):
                continue
            star = self.vector("star", k)
            delta = self.matrix("laplacian_primal", k).entries
            dual = self.matrix("laplacian_dual", self.n - k).entries
            if min(map(abs, star)) > 1e-12 * max(map(abs, star)):
                turned = scaled(star, delta, [1 / s for s in star])
                self.assertLess(difference(dual, turned), 1e-12)
            self.assertLess(difference(delta, self.composed(k)), 1e-12)

    def composed(self, k):
        """d delta + delta d, delta = star^-1 d^T star."""
        result = {}

        def add(entries):
            for at, value in entries.items():
                result[at] = result.get(at, 0) + value

        star = self.vector("star", k)
        if k > 0:
            d, below = self.matrix("d", k - 1).entries, self.vector("star", k - 1)
            turned = {(j, i): value for (i, j), value in d.items()}
            add(product(d, scaled([1 / s for s in below], turned, star)))
        if k < self.n:
            d, above = self.matrix("d", k).entries, self.vector("star", k + 1)
            turned = {(j, i): value for (i, j), value in d.items()}
            add(product(scaled([1 / s for s in star], turned, above), d))
        return result

    def test_laplacians_that_would_divide_by_zero_are_left_out_with_a_warning(self):
        self.load("grid4.nsc")
        self.assertEqual(self.outcome.err, "")
        for k in range(3):
            self.assertTrue(os.path.exists(self.path(f"grid4.nsc/laplacian_dual_{k}.mtx")))
        self.load("fcc1.nsc")
        present = {file for file in os.listdir(self.out) if file.startswith("laplacian")}
        self.assertEqual(present, {"laplacian_primal_0.mtx", "laplacian_dual_3.mtx"})
        pattern = (r"polydec: warning: laplacian_primal_(\d).mtx \w+ laplacian_dual_(\d).mtx .*"
                   r"star of degree \d .*zero.* \d+ \d-cells .*volume \(cells \d+, .*\)")
        warnings = [re.fullmatch(pattern, line) for line in self.outcome.err.splitlines()]
        self.assertTrue(all(warnings), self.outcome.err)
        self.assertEqual([found.groups() for found in warnings],
                         [("1", "2"), ("2", "1"), ("3", "0")])

    def test_numbers_have_17_digits(self):
        self.load("uv8.off")
        wanted = command.parse(self.succeed("info", golden("uv8.off"), "--json").out)
        self.assertEqual(min(self.vector("star", 1)), wanted["stars"][1]["min"])
        self.assertEqual(max(self.vector("star", 2)), wanted["stars"][2]["max"])
