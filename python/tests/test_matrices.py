# SPDX-License-Identifier: MIT
"""Sparse matrices of any format, and those whose indices are wrong."""
import numpy as np
import pytest
import scipy.sparse as sp

import polydec
from conftest import refused


def test_matrices_of_any_format():
    A = sp.random(30, 30, 0.2, random_state=1)
    A = A @ A.T + sp.identity(30)
    expected = np.linalg.solve(A.toarray(), np.ones(30))
    for given in [A.tocsr(), A.tocsc(), A.tocoo(), A.todia(), A.tolil(), A.toarray(),
                  A.tocsr().astype(np.float32).astype(np.float64), sp.csr_array(A)]:
        assert np.allclose(polydec.solve(given, np.ones(30)), expected)
    doubled = sp.coo_matrix((np.r_[A.tocoo().data / 2, A.tocoo().data / 2],
                             (np.tile(A.tocoo().row, 2), np.tile(A.tocoo().col, 2))))
    assert np.allclose(polydec.solve(doubled, np.ones(30)), expected)
    unsorted = A.tocsr()[:, ::-1].tocsr()
    assert np.allclose(polydec.solve(unsorted, unsorted @ np.ones(30)), np.ones(30))
    refused(lambda: polydec.solve(A * 1j, np.ones(30)), "complex128")
    refused(lambda: polydec.solve(A, np.ones(29)))
    refused(lambda: polydec.solve(A.tocsr()[:20], np.ones(20)))
    with pytest.raises(polydec.InvalidInput, match=r"\(3, 4\)|NaN|nan"):
        B = A.tolil()
        B[3, 4] = np.nan
        polydec.solve(B, np.ones(30))


def test_systems_without_unknowns_are_solved():
    for A in sp.csr_matrix((0, 0)), sp.csr_array((0, 0)), np.zeros((0, 0)):
        for b in np.zeros(0), np.zeros((0, 2)):
            for symmetric in None, True, False:
                assert polydec.solve(A, b, symmetric=symmetric).values.shape == b.shape


def compressed(kind, indices, indptr):
    """A matrix of shape (2, 2) whose parts are not looked at."""
    matrix = kind((2, 2))
    matrix.data, matrix.indices, matrix.indptr = np.ones(len(indices)), indices, indptr
    return matrix


@pytest.mark.parametrize("kind", [sp.csr_matrix, sp.csc_matrix, sp.csr_array])
@pytest.mark.parametrize("indices, indptr", [
    ([0, 10 ** 8], [0, 1, 2]), ([0, -1], [0, 1, 2]), ([0, 1], [0, 2, 1]), ([], [0, 10 ** 8, 0]),
    ([0, 1], [0, 1, 5]), ([0, 1], [0, 2])])
def test_indices_of_matrices_are_looked_at(kind, indices, indptr):
    matrix = compressed(kind, *(np.array(each, dtype=np.int32) for each in (indices, indptr)))
    square, ones = polydec.discretize(polydec.meshes.grid(1, 1)), np.ones(2)
    for name, ask in (("A", lambda: polydec.solve(matrix, ones)),
                      ("A", lambda: polydec.smallest_eigenpairs(matrix, count=1)),
                      ("M", lambda: polydec.smallest_eigenpairs(sp.eye(2), matrix, count=1)),
                      ("d_0", lambda: polydec.Cells.of([matrix], 2 * [ones], 2 * [ones])),
                      ("star of degree 0", lambda: square.with_star(0, matrix))):
        refused(ask, name, "indices", "expected", "(2, 2)")
