# SPDX-License-Identifier: MIT
"""Laws of forms and fields."""
import numpy as np
import pytest

import polydec
from conftest import complex_of, refused

@pytest.mark.parametrize("name", ["hexagons", "kuhn"])
def test_integrals_of_forms_and_fluxes_on_both_sides(name):
    c = complex_of(name)
    product = lambda x: np.prod(1 + x, axis=1)
    gradient = lambda x: product(x)[:, None] / (1 + x)
    assert np.allclose(polydec.de_rham(c, 0, product), product(c.points))
    assert np.allclose(polydec.de_rham(c, 1, gradient), c.d(0) @ product(c.points))
    flux = polydec.de_rham(c, c.dim - 1, polydec.flux_form(lambda x: x))
    density = polydec.de_rham(c, c.dim, lambda x: c.dim)
    assert np.allclose(c.d(c.dim - 1) @ flux, density)
    assert np.allclose(polydec.flux_sharp(c, flux), c.centroids(c.dim), atol=1e-9)
    on_duals = polydec.de_rham(c, 0, lambda x: x[:, 0], side="dual")
    assert np.allclose(on_duals, c.dual_sites()[:, 0])


def test_functions_are_called_once(square):
    calls = []
    polydec.de_rham(square, 1, lambda x: calls.append(x.shape) or x)
    assert len(calls) == 1 and calls[0][1] == 2
    polydec.Evolution(square, 2 * [square.points[:, 0]], diffusion=1.0,
                      essential=lambda x: calls.append(x.shape) or x[:, 0] < .1)
    assert len(calls) == 2
    with pytest.raises(ZeroDivisionError): # what they raise passes through
        polydec.de_rham(square, 1, lambda x: 1 / 0)
    refused(lambda: polydec.de_rham(square, 0, lambda x: np.full(len(x), np.nan)), "finite")


def test_products_of_forms_and_of_arrays(square):
    c = square
    u = c.cochain(np.sin(np.arange(c.size(0))), 0)
    a = c.cochain(np.cos(np.arange(c.size(1))), 1)
    arrays = polydec.wedge(c, u.values, a.values, degrees=(0, 1))
    assert isinstance(arrays, np.ndarray) and np.array_equal(arrays, u.wedge(a))
    one = c.cochain(np.ones(c.size(0)), 0)
    for weights in ("uniform", "circumcentric"):
        assert np.allclose(polydec.wedge(c, one, a, weights=weights), a)


def test_products_of_duals(square):
    a = square.cochain(np.sin(np.arange(square.size(1))), 1)
    pairs = polydec.primal_dual_wedge(square, a, a.star())
    assert np.isclose(pairs.sum(), a.norm() ** 2)
    dx, dy = (square.cochain(x, 0).d().star() for x in square.points.T)
    assert np.allclose(polydec.wedge(square, dx, dy), -polydec.wedge(square, dy, dx).values)
    refused(lambda: a.wedge(a).wedge(a))
    one = square.cochain(np.ones(square.size(2)), 0, "dual")
    assert np.allclose(polydec.wedge(square, one, dx, weights="uniform"), dx)
    refused(lambda: polydec.wedge(square, one, dx, weights="circumcentric"), "dual 0-form", "wedge")


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_weights_of_products_are_two(square, side):
    one = square.cochain(np.ones(square.size(0, side)), 0, side)
    for name in ("nonsense", "dual"):
        refused(lambda: polydec.wedge(square, one, one, weights=name), name, "uniform",
                "circumcentric")


@pytest.mark.parametrize("kind, places", [("ppp", "p"), ("pdp", "p"), ("dpp", "d"), ("ppd", "p"),
                                          ("pdd", "p"), ("dpd", "d")])
@pytest.mark.parametrize("name", ["well_centered", "kuhn"])
def test_flats_of_constants(name, kind, places):
    c = complex_of(name)
    X = np.arange(1.0, c.points.shape[1] + 1)
    form = polydec.flat(c, kind, np.tile(X, (c.size(0) if places == "p" else c.size(c.dim), 1)))
    assert form.degree == 1 and form.side == ("primal" if kind[2] == "p" else "dual")
    if form.side == "primal":
        assert np.allclose(form, c.d(0) @ c.points @ X)
        assert np.allclose(polydec.sharp_pp(c, form), X)
        assert np.allclose(polydec.sharp_pd(c, form), X)


def test_whitney(square):
    dx = polydec.de_rham(square, 1, lambda x: [3, -1] + 0 * x)
    assert np.allclose(polydec.whitney_at_centroids(square, dx, degree=1), [3, -1])
    assert np.allclose(polydec.whitney_form(square, dx, 4, [0.2, 0.3, 0.5], degree=1), [3, -1])


@pytest.mark.parametrize("name", ["hexagons", "kuhn"])
def test_forms_go_to_the_input_and_back(name):
    c = complex_of(name)
    for k in range(c.dim + 1):
        form = c.cochain(np.sin(np.arange(c.size(k))), k)
        there = c.merging.to_input(form)
        assert there.complex.shape == c.input.shape
        assert np.allclose(c.merging.to_merged(there), form)
        assert np.allclose(c.merging.to_merged(c.merging.lifted(form)), form)
        if k < c.dim:
            assert np.allclose(c.merging.lifted(form).d(), c.merging.lifted(form.d()))
    dual = c.cochain(np.sin(np.arange(c.size(c.dim - 1))), 1, "dual")
    assert c.merging.consistency(c.merging.to_input(dual))["worst"] < 1e-12


def test_arithmetic_of_cochains(square):
    a = square.cochain(np.arange(square.size(1)), 1)
    assert np.array_equal((2 * a - a / 2 + a * 0.5 + -a), a)
    assert isinstance(np.float64(2) * a, polydec.Cochain)
    assert len(a) == square.size(1) and np.asarray(a).dtype == np.float64
    assert a.d().d().values.shape == (0,)
    assert np.isclose(square.inner_product(a.delta(), square.cochain(square.points[:, 0], 0)),
                      square.inner_product(a, square.cochain(square.points[:, 0], 0).d()))
    assert np.allclose(a.star().star(), -a)
    refused(lambda: polydec.Cochain([1.0], 0).d(), "complex")
