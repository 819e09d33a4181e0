# SPDX-License-Identifier: MIT
"""The files of `polydec operators` hold the numbers of the library to the last bit: those that the
package for Python has. So the numbers of an independent program, which golden_numbers.py finds in the
files, are those of the package too."""
import os
import warnings

import numpy as np
import polydec
import scipy.io
import scipy.sparse as sp

import command
from command import TestCase, golden
from golden_numbers import TOLERANCE, compare_spectrum, read_cells, read_expected


def pairs_of(faces, simplices):
    """Which simplex has which face, by the vertices of both."""
    number = {tuple(face): i for i, face in enumerate(faces)}
    return {(i, number[tuple(s[:p] + s[p + 1:])]) for i, s in enumerate(simplices) for p in range(len(s))}


class OperatorFiles(TestCase):
    def test_hold_the_numbers_of_the_library(self):
        wanted = read_expected()
        for mesh in (name for name in os.listdir(command.GOLDEN) if name.endswith((".off", ".nsc"))):
            self.succeed("operators", golden(mesh), "--out", mesh, *TOLERANCE)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", polydec.PolydecWarning)
                c = polydec.discretize(golden(mesh), star="circumcentric", tolerance=1e-8)
            for k in range(c.dim + 1):
                with self.subTest(mesh, k=k):
                    self.check_cells(mesh, c, k)
                    self.check_numbers(mesh, c, k)
                    if f"spectrum{k}" in wanted.get(mesh, {}):
                        self.check_spectrum(mesh, k, wanted[mesh][f"spectrum{k}"])

    def cells(self, mesh, name, k):
        return read_cells(self.path(f"{mesh}/{name}_{k}.txt"))

    def check_cells(self, mesh, c, k):
        """Merged cells have the vertices of their pieces, and pieces have their faces."""
        merged, simplices = self.cells(mesh, "cells", k), self.cells(mesh, "simplices", k)
        self.assertEqual(merged, [sorted({*c.cells(k).cell(i).tolist()}) for i in range(c.size(k))])
        self.assertEqual(simplices, sorted(sorted(cell) for cell in simplices))
        rows = sp.csr_matrix(c.merging.diamond(k))
        self.assertEqual(merged, [sorted({v for s in rows[i].indices for v in simplices[s]})
                                  for i in range(c.size(k))])
        if k < c.dim:
            pairs = zip(*map(np.ndarray.tolist, c.pieces.d(k).nonzero()))
            self.assertEqual(pairs_of(simplices, self.cells(mesh, "simplices", k + 1)), set(pairs))

    def check_numbers(self, mesh, c, k):
        expected = {"star": c.star(k), "volume": c.volumes(k), "dual_volume": c.dual_volumes(k),
                    "diamond": c.merging.diamond(k), "lift": c.merging.lift(k)}
        if k < c.dim:
            expected["d"] = c.d(k)
        if os.path.exists(self.path(f"{mesh}/laplacian_primal_{k}.mtx")):
            expected["laplacian_primal"] = c.laplacian(k)
            dual = scipy.io.mmread(self.path(f"{mesh}/laplacian_dual_{c.dim - k}.mtx"))
            self.assertEqual(abs(dual - c.laplacian(c.dim - k, "dual")).max(), 0)
        for name, matrix in expected.items():
            found = scipy.io.mmread(self.path(f"{mesh}/{name}_{k}.mtx"))
            if not sp.issparse(found):
                found = found.ravel()
            self.assertEqual(found.shape, matrix.shape, name)
            self.assertEqual(abs(found - matrix).max(), 0, name)

    def check_spectrum(self, mesh, k, wanted):
        """Also where stars are negative, so that the command has no spectrum."""
        L = scipy.io.mmread(self.path(f"{mesh}/laplacian_primal_{k}.mtx"))
        values = np.linalg.eigvals(L.toarray())
        smallest = values[np.argsort(abs(values))].real[:len(wanted["smallest"])]
        self.assertFalse(compare_spectrum(wanted, sorted(smallest)))
