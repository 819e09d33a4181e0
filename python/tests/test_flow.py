# SPDX-License-Identifier: MIT
"""Flows, and what they carry."""
import warnings

import numpy as np
import pytest

import polydec
from conftest import complex_of, near, refused, said

SURFACES = ["goldberg", "torus", "hexagons", "well_centered", "kuhn"]


def some_flow(name, **words):
    c = complex_of(name)
    flow = polydec.IncompressibleFlow(c, **words)
    return flow, flow.project(np.cos(np.arange(c.size(c.dim - 1))))


def moved(equations, w, dt, steps=1, **words):
    run = polydec.Flow(equations, w, dt, **words)
    assert not run.march(steps * dt)
    return run.forms[0]


@pytest.mark.parametrize("name", SURFACES)
def test_energy_is_kept_or_lost_to_friction(name):
    flow, w = some_flow(name)
    assert flow.divergence(w) < 1e-12
    after = moved(flow, w, 0.3 * flow.exchange_time(w), 5)
    assert np.isclose(flow.energy(after), flow.energy(w), rtol=1e-11)
    assert not near(after, w, 1e-3)
    c = complex_of(name)
    if c.dim == 2:
        assert near(c.star(0) * flow.vorticity(w), flow.circulations(w))
    sticky, w = some_flow(name, viscosity=0.1, no_slip=True)
    small = 1e-3 * sticky.exchange_time(w)
    rate = (sticky.energy(moved(sticky, w, small)) - sticky.energy(w)) / small
    assert rate < 0
    assert np.isclose(sticky.momentum(w) @ sticky.rate(w), -sticky.dissipation(w))


def test_walls_move_fluids():
    square = complex_of("grid")
    top = lambda x: np.outer(x[:, 1] > 1 - 1e-9, [1.0, 0.0])
    flow = polydec.IncompressibleFlow(square, viscosity=1.0, no_slip=True, wall_velocity=top)
    w = moved(flow, np.zeros(square.size(1)), 0.05, 20, scheme="imex")
    velocity = polydec.flux_sharp(square, square.cochain(w, 1))
    centers = square.centroids(2)
    assert velocity[centers[:, 1].argmax(), 0] > 0 and flow.energy(w) > 0
    still = polydec.IncompressibleFlow(square, viscosity=1.0, no_slip=True, wall_velocity=[0, 0])
    assert abs(moved(still, np.zeros(square.size(1)), 0.05)).max() == 0


def test_open_boundary_lets_through(square):
    right = lambda x: x[:, 0] > 1 - 1e-9
    left = lambda x: x[:, 0] < 1e-9
    through = polydec.de_rham(square, 1, polydec.flux_form(lambda x: [1.0, 0] + 0 * x))
    flow = polydec.IncompressibleFlow(square, open=right, boundary_flux=through)
    assert near(flow.project(0 * through), through)
    assert abs(flow.pressure(through)).max() < 1 and left(square.facet_sites()).any()
    refused(lambda: polydec.IncompressibleFlow(square, boundary_flux=np.where(
                        left(square.facet_sites()), through, 0)),
            "net outflow", "boundary", "expected 0")


def test_what_no_wall_lets_through_is_at_rest_with_a_warning(square):
    uniform = polydec.flow_of_velocity(square, np.tile([1.0, 0.0], (square.size(0), 1)))
    walls = polydec.IncompressibleFlow(square)
    with pytest.warns(polydec.PolydecWarning, match=said("at rest", "boundary_flux", "open")):
        w = walls.project(uniform)
    assert not w.any() and walls.divergence(w) == 0
    ends = polydec.IncompressibleFlow(square, open=lambda p: (p[:, 0] < 0.01) | (p[:, 0] > 0.99))
    assert near(ends.project(uniform), uniform, 1e-12)


def test_friction_that_midpoints_do_not_follow_is_warned_of(square):
    flow = polydec.IncompressibleFlow(square, viscosity=10.0)
    w = flow.project(np.cos(np.arange(square.size(1))))
    with pytest.warns(polydec.PolydecWarning, match=said("friction", "scheme=\"imex\"", "steps below")):
        polydec.Flow(flow, w, 1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        polydec.Flow(flow, w, 1.0, scheme="imex")
        polydec.Flow(flow, w, 1e-6)


def test_conditions_and_data_that_apply_nowhere_are_refused(square):
    inside, far = ~square.boundary_facets(), lambda at: at[:, 0] > 5
    for marks in (far, inside):
        for name, make in (("no_slip", polydec.IncompressibleFlow), ("open", polydec.IncompressibleFlow),
                           ("no_slip", polydec.StokesSolver), ("pressure_on", polydec.StokesSolver)):
            refused(lambda: make(square, **{name: marks}), name, "none of the", "facet")
    ones = np.ones((square.size(1), 2))
    for given, conditions in (({"wall_velocity": ones}, {}), ({"wall_velocity": ones}, {"open": True}),
                              ({"boundary_flux": 0 * ones[:, 0]}, {"open": True})):
        refused(lambda: polydec.IncompressibleFlow(square, **given, **conditions),
                *given, "none of the", "facet")
    closed = complex_of("goldberg")
    polydec.IncompressibleFlow(closed, no_slip=True, boundary_flux=np.zeros(closed.size(1)),
                               wall_velocity=[0, 0, 0])


def test_wrong_use_is_refused(square):
    flow = polydec.IncompressibleFlow(square)
    refused(lambda: flow.energy([1.0]), "fluxes")
    refused(lambda: moved(flow, np.zeros(square.size(1)), -1.0))
    refused(lambda: moved(flow, np.zeros(square.size(1)), 1.0, scheme="euler"), "scheme")
    refused(lambda: moved(flow, np.zeros(square.size(1)), 1.0, tolerance=-1.0), "tolerance is -1")
    refused(lambda: moved(flow, np.zeros(square.size(1)), 1.0, most_passes=0), "most_passes is 0")
    with pytest.raises(polydec.InvalidInput, match="tetra|orient|branch|simplices|cells"):
        polydec.IncompressibleFlow(complex_of("moebius"))


@pytest.mark.parametrize("name", SURFACES)
@pytest.mark.parametrize("sampling", ["upwind", "centered"])
def test_mass_is_carried(name, sampling):
    c = complex_of(name)
    flow = np.sin(np.arange(c.size(c.dim - 1)))
    rho = 1 + 0.5 * np.cos(np.arange(c.size(c.dim)))
    carried = polydec.FluxTransport(c, sampling=sampling)
    through = carried.mass_flux(flow, rho, np.ones(len(flow)))
    rate = carried.rate(flow, rho, np.ones(len(flow)))
    assert near(rate * c.volumes(c.dim), -(c.d(c.dim - 1) @ through))
    assert abs(carried.mass(rate) + carried.outflow(through)) < 1e-12 * abs(through).sum()
    after = rho + carried.stable_step(flow) * polydec.FluxTransport(c).rate(flow, rho)
    assert after.min() > -1e-12


@pytest.mark.parametrize("name, k", [("hexagons", 0), ("hexagons", 1), ("hexagons", 2),
                                     ("kuhn", 1), ("kuhn", 2), ("torus", 1)])
@pytest.mark.parametrize("sampling", ["upwind", "centered"])
def test_lie_derivatives_are_those_of_matrices(name, k, sampling):
    c = complex_of(name)
    X, form = np.cos(c.points), np.sin(np.arange(c.size(k)))
    L = polydec.LieDerivative(c, k, sampling=sampling)
    assert near(L(X, form), polydec.lie_derivative(c, X, k, sampling=sampling) @ form)
    if k > 0:
        i = polydec.interior_product(c, X, k, sampling=sampling)
        assert near(L.interior_product(X, form), i @ form)
    assert isinstance(L(X, c.cochain(form, k)), polydec.Cochain)
    assert near(L.inflow(X, form), polydec.inflow(c, X, k) @ form) or sampling == "centered"
    refused(lambda: L(X[:2], form))


@pytest.mark.parametrize("name", ["goldberg", "torus", "well_centered"])
def test_shallow_water_keeps_mass_and_energy(name):
    c = complex_of(name)
    water = polydec.ShallowWater(c, gravity=2.0, rotation=np.cos(c.points[:, 0]),
                                 bottom=0.1 * np.sin(np.arange(c.size(2))))
    depth = 1 + 0.1 * np.cos(np.arange(c.size(2)))
    flux = 0.01 * np.sin(np.arange(c.size(1))) * ~c.boundary_facets()
    dt = water.stable_step(depth, flux)
    run = polydec.Evolution(c, [c.cochain(depth, 0, "dual"), c.cochain(flux, 1)], reaction=water)
    run.march(4 * dt)
    later = run.forms
    assert np.isclose(water.mass(*later), water.mass(depth, flux), rtol=1e-13)
    assert np.isclose(water.energy(*later), water.energy(depth, flux), rtol=1e-5)
    assert not near(later[0], depth, 1e-3)
    rate = water.rate(depth, flux)
    assert abs(c.volumes(2) @ rate[0]) < 1e-13
    assert near(water(0, depth, flux)[0], rate[0], 0) and near(water(0, depth, flux)[1], rate[1], 0)
    assert np.isnan(water(0, -depth, flux)[0]).all() # so that a step is taken again, shorter
    assert len(water.potential_vorticity(depth, flux)) == c.size(0)
    assert water.potential_enstrophy(depth, flux) > 0
    refused(lambda: water.rate(0 * depth, flux))
