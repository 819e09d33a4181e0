# SPDX-License-Identifier: MIT
"""Every operator is what scipy makes of its definition, on every mesh in every degree. The laws that
hold are tested in C++, and the numbers in tests/tools/operator_files.py."""
import numpy as np
import pytest
import scipy.sparse as sp

import polydec
from conftest import MAKERS, complex_of, degrees, near, refused


def has_inverse(c, k):
    return 0 <= k <= c.dim and len(c.zeros(k)) == 0


def test_near_can_fail():
    assert not near(np.ones(3), np.ones(3) + 1e-6)


@pytest.mark.parametrize("name, k", degrees())
def test_derivatives(name, k):
    c = complex_of(name)
    d = c.d(k)
    assert d.shape == (c.size(k + 1), c.size(k)) and d.dtype == np.float64
    assert (d != c.incidence(k)).nnz == 0
    assert (c.d(k + 1) @ d).count_nonzero() == 0 if k < c.dim else d.nnz == 0
    assert (c.boundary(k + 1) != d.T).nnz == 0
    # dual (n-k-1)-forms live on the (k+1)-cells
    if k < c.dim:
        dual = c.d(c.dim - k - 1, "dual")
        assert (dual != (-1) ** (k + 1) * d.T).nnz == 0
        assert (c.boundary(c.dim - k, "dual") != dual.T).nnz == 0


@pytest.mark.parametrize("name, k", degrees())
def test_stars_are_ratios_of_volumes(name, k):
    c = complex_of(name)
    assert np.array_equal(c.star(k), c.dual_volumes(k) / c.volumes(k))
    zeros = c.zeros(k)
    if len(zeros):
        error = refused(lambda: c.inverse_star(k))
        assert error.degree == k and list(error.cells) == list(zeros)
    else:
        assert near(c.inverse_star(k) * c.star(k), np.ones(c.size(k)), 1e-15)


@pytest.mark.parametrize("name, k", degrees())
def test_codifferentials(name, k):
    c = complex_of(name)
    if k == 0:
        assert c.codifferential(0).shape == (0, c.size(0))
    elif has_inverse(c, k - 1):
        expected = sp.diags(1 / c.star(k - 1)) @ c.d(k - 1).T @ sp.diags(c.star(k))
        assert near(c.codifferential(k), expected, 4e-16)
    else:
        refused(lambda: c.codifferential(k))
    if k < c.dim and has_inverse(c, k):
        expected = (-1) ** (k + 1) * sp.diags(c.star(k + 1)) @ c.d(k) @ sp.diags(1 / c.star(k))
        assert near(c.codifferential(c.dim - k, "dual"), expected, 4e-16)


@pytest.mark.parametrize("name, k", degrees())
def test_stiffnesses_are_stars_of_laplacians(name, k):
    c = complex_of(name)
    needed = ([k - 1] if k > 0 else []) + ([k] if k < c.dim else [])
    if all(has_inverse(c, i) for i in needed):
        assert near(c.stiffness(k), sp.diags(c.star(k)) @ c.laplacian(k), 1e-13)
    else:
        refused(lambda: c.laplacian(k))


@pytest.mark.parametrize("name", MAKERS)
def test_generators_of_homology(name):
    c = complex_of(name)
    for k, b in enumerate(c.betti_numbers()):
        cycles = c.homology_generators(k)
        assert cycles.shape == (c.size(k), b)
        assert abs(c.boundary(k) @ cycles).max() == 0 if b and k else True


@pytest.mark.parametrize("name, k", degrees())
def test_carriers_of_pieces(name, k):
    c = complex_of(name)
    dimensions, numbers = c.merging.carriers(k)
    assert len(dimensions) == c.pieces.size(k) and (dimensions >= k).all()
    pieces = dimensions == k
    assert np.isclose(np.bincount(numbers[pieces], c.pieces.volumes(k)[pieces]),
                      c.volumes(k)).all()


@pytest.mark.parametrize("kind", ["galerkin", "hybrid", "barycentric", "automatic"])
def test_other_stars(kind):
    c = polydec.discretize(polydec.meshes.perturbed(polydec.meshes.grid(6, 6), 0.04, 3), star=kind)
    assert c.star_kind == ("hybrid" if kind == "automatic" else kind)
    for k in range(3):
        star = c.star(k)
        matrix = star if sp.issparse(star) else sp.diags(star)
        assert np.linalg.eigvalsh(matrix.toarray()).min() > 0
        values = np.arange(c.size(k), dtype=float)
        back = c.inverse_star(k) * values if isinstance(star, np.ndarray) else (
            c.inverse_star(k) @ values)
        assert np.allclose(matrix @ back, values)
        applied = c.laplacian(k) @ values
        assert np.allclose(matrix @ applied, c.cochain(values, k).laplacian().star())
    assert np.allclose(c[1].star @ np.ones(c.size(1)), c.cochain(np.ones(c.size(1)), 1).star())
    u = np.sin(np.arange(c.size(0))) # the codifferential is no matrix where it inverts one
    assert np.allclose(c.codifferential(1) @ (c.d(0) @ u), c.laplacian(0) @ u)


def test_own_stars():
    c = complex_of("grid")
    doubled = c.with_star(1, 2 * c[1].star)
    assert near(doubled.stiffness(0), 2 * c.stiffness(0), 1e-15)
    assert doubled.star_kind == "own" and isinstance(doubled, polydec.Complex)
    assert near(polydec.Cells.with_star(c, 1, 2 * c[1].star).stiffness(0), doubled.stiffness(0), 0)
    refused(lambda: c.with_star(1, np.eye(20)), "20 rows", "1-cells", "expected 31")


def test_material_stars():
    c = polydec.discretize(polydec.meshes.grid(4, 4), star="galerkin")
    assert near(c.material_star(1, 3.0), 3 * c.star(1), 1e-14)
    tensors = np.broadcast_to(np.eye(2) / 3, (c.input.size(2), 2, 2))
    assert near(c.conductivity_star(tensors), 3 * c.star(1), 1e-14)


def test_own_cells():
    n = 8
    s = np.arange(n * n).reshape(n, n)
    right, above = np.roll(s, -1, 0), np.roll(s, -1, 1)
    rows = np.arange(2 * n * n)
    ends = np.concatenate([right.ravel(), above.ravel()])
    starts = np.concatenate([s.ravel(), s.ravel()])
    d0 = sp.csr_matrix((np.r_[-np.ones(2 * n * n), np.ones(2 * n * n)],
                        (np.r_[rows, rows], np.r_[starts, ends])))
    y = n * n
    sides = np.concatenate([s.ravel(), (y + right).ravel(), above.ravel(), (y + s).ravel()])
    d1 = sp.csr_matrix((np.repeat([1.0, 1.0, -1.0, -1.0], n * n),
                        (np.tile(s.ravel(), 4), sides)))
    ones = [np.ones(n * n), np.ones(2 * n * n), np.ones(n * n)]
    torus = polydec.Cells.of([d0, d1], ones, ones)
    assert torus.shape == (64, 128, 64) and torus.betti_numbers() == [1, 2, 1]
    values = polydec.spectrum(torus, degree=1, count=4).eigenvalues
    assert np.allclose(values, [0, 0, *[4 * np.sin(np.pi / n) ** 2] * 2], atol=1e-9)
    u = polydec.poisson(torus, np.eye(64)[0])
    assert np.allclose(torus.laplacian(0) @ u, np.eye(64)[0] - 1 / 64)
    refused(lambda: polydec.Cells.of([d0, abs(d1)], ones, ones), "0-cell 0", "2-cell 0", "faces")


def test_conditions_leave_cells_out(square):
    space = polydec.FormSpace(square, essential=True)
    assert [len(cells) for cells in space.cells] == list(space.inside.shape)
    on_boundary = square.boundary_facets()
    vertices = np.unique(square.incidence(0)[on_boundary].indices)
    kept = np.setdiff1d(np.arange(square.size(0)), vertices)
    assert np.array_equal(space.free, kept)
    assert near(space.stiffness(), square.stiffness(0)[kept][:, kept], 1e-15)
    values = np.arange(len(kept), dtype=float)
    assert np.array_equal(space.restrict(space.extend(values)), values)
    half = polydec.FormSpace(square, essential=on_boundary & (square.centers(1)[:, 0] < 0.5))
    assert len(space.free) < len(half.free) < square.size(0)
    cooled = polydec.FormSpace(square, robin=2.0)
    assert len(cooled.free) == square.size(0)
    around = (cooled.stiffness() - square.stiffness(0)).sum()
    assert np.isclose(around, 2.0 * square.volumes(1)[on_boundary].sum())
    assert "essential" in repr(space) or "Dirichlet" in repr(space)
    for wrong in (values[:1], np.append(values, 0), values[0]):
        refused(lambda: space.extend(wrong), "expected")
    for act, size in ((space.extend, len(kept)), (space.restrict, square.size(0))):
        refused(lambda: act(np.full(size, 1j)), "complex128", "real numbers")
    refused(lambda: polydec.FormSpace(square, 7), "degree", "7")


@pytest.mark.parametrize("star", ["circumcentric", "galerkin", "barycentric"])
def test_operators_are_linear_over_the_complex_numbers(star):
    c = polydec.discretize(polydec.meshes.perturbed(polydec.meshes.grid(3, 3), .02, 1), star=star)
    for k in range(3):
        for operator in (c.laplacian(k), c.codifferential(k), c.inverse_star(k)):
            size = c.size(k)
            x, y = np.cos(np.arange(size)), np.sin(np.arange(size))
            apply = operator.__mul__ if isinstance(operator, np.ndarray) else operator.__matmul__
            assert near(apply(x + 1j * y), apply(x) + 1j * apply(y))
            assert near(apply((x + 1j * y).astype(np.complex64)), apply(x) + 1j * apply(y), 1e-6)


def test_degrees_that_there_are_not(square):
    for call in [square.volumes, square.star, square.d, square.laplacian, square.centers,
                 square.cells, square.merging.diamond, square.merging.lift]:
        refused(lambda: call(4))
    refused(lambda: square.laplacian(0, "left"), "side", '"left"', "expected")
    with pytest.raises(IndexError):
        square[3]
    assert square.size(7) == 0 and len(square) == 3
    assert [cells.num_simplices for cells in square] == list(square.shape)


@pytest.mark.parametrize("name", MAKERS)
def test_volumes_are_of_the_mesh_whatever_its_stars(name):
    c = complex_of(name)
    for k in range(c.dim + 1):
        for other in (c.with_material(k, 5.0), c.with_stars("barycentric")):
            assert np.array_equal(other.volumes(k), c.volumes(k))
            assert np.array_equal(other.dual_volumes(k), c.dual_volumes(k))


@pytest.mark.filterwarnings("ignore:the lengths of the mesh")
def test_operators_ask_only_for_what_they_are_made_of():
    c = polydec.discretize(polydec.meshes.kuhn([1, 1, 1], [1e-110] * 3))
    a = c.cochain(np.arange(float(c.size(1))), 1)
    assert near(c.laplacian(1) @ a.values, a.laplacian().values)
    assert near(c.codifferential(1) @ a.values, a.delta().values)
    assert near(c.star(1), c.dual_volumes(1) / c.volumes(1))
    assert near(c.star(1) * a.values, a.star().values)
    assert near(c.inverse_star(1), 1 / c.star(1))
    for k in range(4):
        assert len(c.zeros(k)) == len(c.negatives(k)) == 0
    refused(lambda: c.volumes(3), "degree 3", "range")
    refused(lambda: c.star(0), "degree 0", "range")


def test_names_of_pydec(square):
    for k in range(3):
        assert near(square[k].d, square.d(k), 0) if k < 2 else square[k].d.nnz == 0
        assert near(square[k].star.diagonal(), square.star(k), 0)
        assert near((square[k].star @ square[k].star_inv).diagonal(), np.ones(square.size(k)))
        assert square[k].primal_volume.base is not None
        assert near(square[k].dual_volume / square[k].primal_volume, square.star(k), 0)
