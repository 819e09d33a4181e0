# SPDX-License-Identifier: MIT
"""What is handed out shares memory, cannot be written, and lives as long as someone looks at it."""
import gc
import sys

import numpy as np
import pytest
import scipy.sparse as sp
import scipy.sparse.linalg

import polydec
from conftest import complex_of


def views(c):
    """By name, what is stored and shown."""
    return {
        "points": lambda: c.points,
        "volumes": lambda: c.volumes(1),
        "dual_volumes": lambda: c.dual_volumes(1),
        "incidence": lambda: c.incidence(0).data,
        "columns": lambda: c.incidence(0).indices,
        "begins": lambda: c.incidence(0).indptr,
        "diamond": lambda: c.merging.diamond(1).data,
    }


@pytest.mark.parametrize("name", views(None))
def test_views_share_memory_and_are_read_only(square, name):
    first, second = views(square)[name](), views(square)[name]()
    assert np.shares_memory(first, second)
    assert not np.shares_memory(first, first.copy())
    assert not first.flags.writeable and first.base is not None
    with pytest.raises(ValueError, match="read-only"):
        first[0] = 7


@pytest.mark.parametrize("name", views(None))
def test_views_outlive_what_they_are_of(name):
    c = polydec.discretize(polydec.meshes.grid(40, 40))
    array = views(c)[name]()
    expected = array.copy()
    del c
    gc.collect()
    polydec.discretize(polydec.meshes.grid(41, 41)) # something else may lie there now
    assert np.array_equal(array, expected)


def test_views_of_meshes_outlive_them():
    mesh = polydec.meshes.grid(30, 30)
    points, simplices = mesh.points, mesh.simplices
    expected = points.copy(), simplices.copy()
    assert np.shares_memory(points, mesh.points)
    del mesh
    gc.collect()
    assert np.array_equal(points, expected[0]) and np.array_equal(simplices, expected[1])


@pytest.mark.parametrize("make", [
    lambda c: c.star(1), lambda c: c.laplacian(0).data, lambda c: c.centers(2),
    lambda c: polydec.spectrum(c, count=2).modes, lambda c: c.cells(2).corners,
    lambda c: c.tags, lambda c: polydec.poisson(c, 1.0).values])
def test_results_own_their_memory(square, make):
    array = make(square)
    expected = array.copy()
    gc.collect()
    assert np.array_equal(array, expected)
    array += 1 # which is nobody else's
    assert not np.shares_memory(array, make(square)) and np.array_equal(make(square), expected)


def test_references_are_counted(square):
    cells = square._cells
    before = sys.getrefcount(cells)
    held = [square.volumes(1) for _ in range(10)]
    assert sys.getrefcount(cells) == before + 10
    del held
    gc.collect()
    assert sys.getrefcount(cells) == before


def test_what_scipy_does_on_views(square):
    D = square.incidence(0)
    ones = np.ones(square.size(0))
    assert abs(D @ ones).max() == 0
    assert abs(D.T @ (D @ ones)).max() == 0
    assert D[3].nnz == 2 and D[2:5].shape[0] == 3 and abs(D).sum() == 2 * square.size(1)
    assert (D != sp.csr_matrix(D.toarray())).nnz == 0
    with pytest.raises(ValueError):
        D[0, D.indices[0]] = 3
    with pytest.raises(ValueError):
        D.data *= 2
    L = square.stiffness(0) + sp.identity(square.size(0))
    assert np.allclose(L @ scipy.sparse.linalg.splu(L.tocsc()).solve(ones), ones)
    assert sp.csgraph.connected_components(square.stiffness(0))[0] == 1


@pytest.mark.parametrize("make", [
    lambda c: c.incidence(1), lambda c: c.d(0), lambda c: c.d(1, "dual"), lambda c: c.laplacian(1),
    lambda c: c.stiffness(0), lambda c: c.boundary(1), lambda c: c.merging.lift(1),
    lambda c: c.merging.diamond(1), lambda c: c.codifferential(1)])
def test_flags_of_matrices_are_right(make):
    matrix = make(complex_of("grid"))
    assert isinstance(matrix, sp.csr_matrix)
    assert matrix.has_sorted_indices and matrix.has_canonical_format
    looked_at = sp.csr_matrix((matrix.data, matrix.indices, matrix.indptr), matrix.shape)
    assert looked_at.has_sorted_indices and looked_at.has_canonical_format


def test_bytes_overflow_and_derivatives_do_not():
    rim = 200
    angles = np.linspace(0, 2 * np.pi, rim, endpoint=False)
    points = np.vstack([[0, 0], np.c_[np.cos(angles), np.sin(angles)]])
    triangles = [[0, 1 + i, 1 + (i + 1) % rim] for i in range(rim)]
    wheel = polydec.discretize(polydec.Mesh(points, triangles), merge=False)
    D, d = wheel.incidence(0), wheel.d(0)
    assert D.dtype == np.int8
    assert (D.T @ D)[0, 0] == -56                    # 200 - 256
    assert (d.T @ d)[0, 0] == rim


def test_nothing_is_copied_from_fitting_arrays():
    points = np.random.default_rng(1).random((4, 2))
    from polydec._arrays import floats, integers
    assert floats(points, "points", 2) is points
    numbers = np.arange(6, dtype=np.int32).reshape(2, 3)
    assert integers(numbers, "numbers", 2) is numbers
    assert floats(points.T, "points", 2).flags.c_contiguous


def test_memory_does_not_grow():
    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4096

    def once():
        c = polydec.discretize(polydec.meshes.grid(20, 20), star="galerkin")
        c.laplacian(0), c.merging.lift(1), c.centers(1), c.incidence(0), c.star(0)
        polydec.poisson(c, 1.0)
        polydec.spectrum(c, count=2, progress=lambda what: None)
        with pytest.raises(polydec.InvalidInput):
            c.volumes(9)

    for _ in range(20):
        once()
    gc.collect()
    before = resident()
    for _ in range(100):
        once()
    gc.collect()
    assert resident() - before < 2.5e6
