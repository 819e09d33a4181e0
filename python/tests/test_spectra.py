# SPDX-License-Identifier: MIT
"""Spectra are those that scipy finds, and none is missing."""
import numpy as np
import pytest
import scipy.sparse as sp
import scipy.sparse.linalg

import polydec
from conftest import complex_of, near, refused


@pytest.mark.parametrize("name", ["well_centered", "goldberg", "flange", "kuhn"])
@pytest.mark.parametrize("k", [0, 1, 2])
def test_spectra_are_those_of_dense_matrices(name, k):
    c = complex_of(name)
    modes = polydec.spectrum(c, degree=k, count=8)
    M = sp.diags(c.star(k)).toarray()
    root = np.sqrt(c.star(k))
    dense = np.linalg.eigvalsh(c.stiffness(k).toarray() / root / root[:, None])
    assert np.allclose(modes.eigenvalues, dense[:8], atol=1e-11 * dense[-1])
    assert modes.certificate.complete
    assert modes.certificate.below_shift == modes.certificate.returned_below_shift
    assert np.allclose(modes.modes.T @ M @ modes.modes, np.eye(8), atol=1e-9)
    assert (modes.side, modes.degree) == ("primal", k) and modes.residuals.shape == (8,)
    dual = polydec.spectrum(c, degree=c.dim - k, side="dual", count=4)
    assert dual.modes.shape == (c.size(k), 4)


def test_certificates_are_shown(sphere):
    modes = polydec.spectrum(sphere, count=9)
    assert "9 values" in repr(modes) and "complete" in repr(modes)


def test_conditions(square):
    natural = polydec.spectrum(square, count=5)
    assert abs(natural.eigenvalues[0]) < 1e-10
    essential = polydec.spectrum(square, count=5, essential=True)
    assert np.allclose(essential.eigenvalues[0], 2 * np.pi ** 2, rtol=0.1)
    space = polydec.FormSpace(square, essential=True)
    assert np.allclose(polydec.spectrum(space.inside, count=5).eigenvalues, essential.eigenvalues)
    on_boundary = np.setdiff1d(np.arange(square.size(0)), space.free)
    assert abs(essential.modes[on_boundary]).max() == 0
    left = polydec.spectrum(square, count=3, essential=lambda x: x[:, 0] < 1e-9)
    assert np.allclose(left.eigenvalues[0], np.pi ** 2 / 4, rtol=0.1)
    assert 0 < left.coarseness < 1


def test_coexact_spectrum():
    box = complex_of("kuhn")
    curl = polydec.spectrum(box, degree=1, count=5, coexact=True, essential=True)
    assert curl.coarseness is None
    space = polydec.FormSpace(box, 1, essential=True)
    d, star, kept = space.inside.d(1), space.inside.star(2), space.free
    for value, mode in zip(curl.eigenvalues, curl.modes[kept].T):
        curl_curl = d.T @ (star * (d @ mode))
        assert np.allclose(curl_curl, value * box.star(1)[kept] * mode, atol=1e-8)
    refused(lambda: polydec.spectrum(box, degree=3, count=1, coexact=True), "coexact 3-forms",
            "there are none", "smaller degree")


@pytest.mark.parametrize("place", [(1, 2), (2, 1)])
def test_matrices_that_are_not_symmetric_beside_a_large_entry_are_refused(place):
    A, other = sp.lil_matrix(sp.diags([1e15, 1., 2., 3.])), sp.diags([1e15, 1., 1., 2.]).tocsr()
    A[place] = .5
    refused(lambda: polydec.smallest_eigenpairs(A.tocsr(), count=1), "symmetric", "A", "(1, 2)")
    refused(lambda: polydec.smallest_eigenpairs(other, A.tocsr(), count=1), "symmetric", "M",
            "(1, 2)")


def test_smallest_eigenpairs():
    A = sp.diags(np.repeat([3.0, -1.0, 7.0], 10))
    pairs = polydec.smallest_eigenpairs(A, count=15)
    assert np.allclose(pairs.eigenvalues, [-1] * 10 + [3] * 5)
    assert pairs.certificate.complete
    pairs = polydec.smallest_eigenpairs(A, np.full(30, 2.0), 3)
    assert np.allclose(pairs.eigenvalues, -0.5)
    M = sp.random(30, 30, 0.2, random_state=2)
    M = M @ M.T + sp.identity(30)
    import scipy.linalg
    pairs = polydec.smallest_eigenpairs(A, M, 30)
    assert np.allclose(pairs.eigenvalues, scipy.linalg.eigh(A.toarray(), M.toarray())[0])
    waived = polydec.smallest_eigenpairs(A, count=2, certified=False)
    assert not waived.certificate.complete or waived.certificate.below_shift >= 2


@pytest.mark.parametrize("A, M, words", [
    (np.triu(np.ones((4, 4))), None, ("symmetric",)),
    (np.eye(4), -np.ones(4), ("positive",)),
    (np.eye(4), np.ones(3), (4, 3)),
    (np.eye(4) * np.nan, None, ("finite",)),
])
def test_matrices_that_are_refused(A, M, words):
    refused(lambda: polydec.smallest_eigenpairs(A, M, 2), *words)


def test_counts_that_are_refused(square):
    for count in (0, -1, square.size(0) + 1):
        refused(lambda: polydec.spectrum(square, count=count))
    refused(lambda: polydec.spectrum(square, linear_solver="nonsense"), "nonsense")


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_robins_condition(square, side):
    free, held = (polydec.spectrum(square, side=side, count=3, essential=essential).eigenvalues
                  for essential in (False, True))
    some = polydec.spectrum(square, side=side, count=3, robin=2.0)
    assert some.certificate.complete
    assert (some.eigenvalues > free + 0.1).all() and (some.eigenvalues < held).all()
    hardly = polydec.spectrum(square, side=side, count=3, robin=1e-9)
    assert abs(hardly.eigenvalues - free).max() < 1e-6
    refused(lambda: polydec.spectrum(square, side=side, count=3, robin=2.0, coexact=True),
            "facet 0", "Robin")


def test_shapes_are_enclosed():
    """The eigenvalues of the unit square, not of its mesh."""
    grid = polydec.meshes.grid(6, 6)
    truth = np.pi ** 2 * np.array([2, 5, 5, 8])
    for level in (1, 2):
        found = polydec.shape_spectrum(grid, count=4, essential=True, level=level)
        assert (found.lower <= truth).all() and (truth <= found.upper).all()
        assert found.modes.shape == (49, 4) and found.zeros == 0 and (found.widths > 0).all()
    assert found.count.at_least == 6 and 10 < found.count_at / np.pi ** 2 < 13 and "4 values [" in repr(found)
    free = polydec.shape_spectrum(grid, count=3, conductivity=2.0, density=8.0)
    assert free.zeros == 1 and free.widths[0] == 0
    assert free.lower[1] <= np.pi ** 2 / 4 <= free.upper[1]
    two = np.repeat([1.0, 10.0], 36)[np.argsort(np.argsort(np.arange(72)))]
    assert polydec.shape_spectrum(grid, count=2, density=two, flips=False).upper[1] < np.pi ** 2
    fine = polydec.shape_spectrum(grid, count=2, width=1e-5, max_triangles=2000)
    assert fine.widths.max() <= 1e-5 and fine.simplices > 72 and len(fine.modes) == 49
    forms = polydec.shape_spectrum(grid, degree=1, count=2)
    assert (forms.lower <= np.pi ** 2).all() and (forms.upper >= np.pi ** 2).all()
    assert polydec.count_below(grid, 25, essential=True) == (1, 1)
    assert polydec.count_below(polydec.discretize(grid, merge=False), 25, essential=True) == (1, 1)
    with pytest.warns(polydec.PolydecWarning, match="too large"):
        assert polydec.count_below(grid, 1e4, essential=True).at_most is None
    with pytest.warns(polydec.PolydecWarning, match="wider"):
        polydec.shape_spectrum(grid, count=2, width=1e-9)
    refused(lambda: polydec.count_below(grid, 1, level=3), "level 3")
    merged = polydec.discretize(grid)
    twice = polydec.shape_spectrum(merged, conductivity=2.0, count=3)
    assert np.allclose(twice.upper, 2 * polydec.shape_spectrum(grid, count=3).upper, rtol=1e-9)


def test_materials_divide_eigenvalues():
    box = complex_of("kuhn")

    def curl(box):
        return polydec.spectrum(box, degree=1, count=4, coexact=True, essential=True).eigenvalues
    filled = box.with_electric_material(4, lambda x: 2 + 0 * x[:, 0])
    assert near(curl(filled), curl(box) / 8, 1e-8)
    assert near(curl(box.with_electric_material(4)), curl(box) / 4, 1e-8)
    refused(lambda: box.with_electric_material(np.ones(3)), "permittivity")
