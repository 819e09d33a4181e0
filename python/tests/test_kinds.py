# SPDX-License-Identifier: MIT
"""Forms of another kind are refused, also where the number of their values would fit."""
import numpy as np
import pytest

import polydec
from conftest import refused

TORUS = polydec.discretize(polydec.periodic(polydec.meshes.grid(4, 4), [[1, 0], [0, 1]]))
U, V = TORUS.cochain(np.ones(16), 0), TORUS.cochain(np.ones(32), 1)
FLOW, WATER = polydec.IncompressibleFlow(TORUS), polydec.ShallowWater(TORUS)
CARRIED, SPACE = polydec.FluxTransport(TORUS), polydec.FormSpace(TORUS)
SQUARE = polydec.discretize(polydec.meshes.grid(4, 4))
AT_VERTICES = polydec.Cochain(np.ones(25), 0, "dual") # as many as primal 0-forms have


def dual(form):
    return TORUS.cochain(form.values, form.degree, "dual")


def evolved(rate):
    return polydec.Evolution(TORUS, U, reaction=lambda t, u: rate).march(.1)


def waved(B=None, **given):
    return polydec.Waves(TORUS, U, B, **given).march(.1)


@pytest.mark.parametrize("expected, ask", [
    ("u primal 0-form", lambda: polydec.gradient(TORUS, dual(U))),
    ("fluxes primal 1-form", lambda: FLOW.energy(dual(V))),
    ("fluxes primal 1-form", lambda: polydec.Flow(FLOW, dual(V), .1)),
    ("rotation primal 0-form", lambda: polydec.IncompressibleFlow(TORUS, rotation=dual(U))),
    ("vorticity primal 0-form", lambda: polydec.flow_of_vorticity(TORUS, dual(U))),
    ("densities dual 0-form", lambda: WATER.mass(U, V)),
    ("fluxes primal 1-form", lambda: WATER.mass(dual(U), dual(V))),
    ("bottom dual 0-form", lambda: polydec.ShallowWater(TORUS, bottom=U)),
    ("densities dual 0-form", lambda: CARRIED.rate(V, U)),
    ("force primal 1-form", lambda: polydec.StokesSolver(SQUARE).solve(
        force=SQUARE.cochain(np.ones(40), 1, "dual"))),
    ("rates primal 0-form", lambda: evolved(dual(U))),
    ("boundary primal 0-form", lambda: polydec.Evolution(
        SQUARE, np.ones(25), diffusion=1.0, essential=True, boundary=AT_VERTICES).march(.1)),
    ("wave primal 1-form", lambda: waved(dual(V))),
    ("wave primal 0-form", lambda: waved(loss=dual(U))),
    ("wave primal 0-form", lambda: waved(source=lambda t: dual(U), label="one")),
    ("f primal 0-form", lambda: polydec.PoissonSolver(TORUS).solve(dual(U))),
    ("boundary primal 0-form", lambda: polydec.poisson(SQUARE, 1.0, AT_VERTICES)),
    ("u primal 0-form", lambda: polydec.poisson_error(SQUARE, AT_VERTICES, 1.0)),
    ("goal primal 0-form", lambda: polydec.goal_interval(SQUARE, np.ones(25), goal=AT_VERTICES)),
    ("values primal 0-form or dual 2-form", lambda: SPACE.restrict(dual(U)))])
def test_forms_of_another_kind_are_refused(expected, ask):
    refused(ask, *expected.split())


def test_forms_of_the_right_kind_are_their_values():
    assert np.array_equal(polydec.gradient(TORUS, U), polydec.gradient(TORUS, U.values))
    assert FLOW.energy(V) == FLOW.energy(V.values) and CARRIED.mass(dual(U)) == 1
    assert np.array_equal(SPACE.restrict(U), U.values)
    assert np.array_equal(SPACE.restrict(U.star()), TORUS.star(0))
    evolved(U)
    waved(V, source=lambda t: U, label="one")


def test_a_side_is_primal_or_dual():
    for ask in (lambda: TORUS.size(0, "Primal"), lambda: TORUS.laplacian(0, "Primal"),
                lambda: TORUS.cochain(np.ones(16), 0, "Primal")):
        refused(ask, "side", "Primal", '"primal"')


def test_values_to_restrict_are_of_all_cells():
    mesh = polydec.meshes.grid(4, 4)
    points = np.vstack([[[9, 9]], mesh.points])                # of which one is unused
    with pytest.warns(polydec.PolydecWarning):
        c = polydec.discretize((points, mesh.simplices + 1))
    u = polydec.poisson(c, 1.0)
    space = polydec.FormSpace(c, essential=True)
    expected = u.form.values[space.free]
    assert np.array_equal(space.restrict(u.form), expected)
    assert np.array_equal(space.restrict(u.values), expected), "one for each point"
    bounds = [polydec.poisson_error(c, values, 1.0).energy for values in (u.form, u.values)]
    assert bounds[0] == bounds[1]
    for values in (np.ones(24), 1.0):
        refused(lambda: space.restrict(values), "values", "expected")
