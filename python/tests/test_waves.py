# SPDX-License-Identifier: MIT
"""Waves: energy, sources, losses, steps and absorbing layers."""
import warnings

import numpy as np
import pytest

import polydec
from conftest import complex_of, near, refused, said


@pytest.mark.parametrize("name, k", [("kuhn", 0), ("kuhn", 1), ("hexagons", 0), ("torus", 1)])
@pytest.mark.parametrize("side", ["primal", "dual"])
def test_waves_of_either_side_keep_their_energy(name, k, side):
    c, words = complex_of(name), {"degree": k, "side": side, "essential": side == "dual"}
    E = np.cos(np.arange(c.size(k, side)))
    waves = polydec.Waves(c, E, np.zeros(c.size(k + 1, side)), **words)
    step = waves.time_step
    assert np.isclose(step, 0.9 * polydec.stable_step(c, **words))
    waves.march(step)
    (E1, B1), energy = waves.forms, waves.energy
    if side == "primal":
        assert near(B1, -step * (c.d(k) @ E))
        assert near(c.star(k) * (E1 - E), step * (c.d(k).T @ (c.star(k + 1) * B1)))
    waves.march(2 * step)
    assert near(waves.forms[1] - B1, -step * (c.d(k, side) @ E1))
    waves.march(200 * step)
    assert np.isclose(waves.energy, energy)
    refused(lambda: polydec.Waves(c, E, time_step=2 * step, **words), "below")


def test_essential_waves_are_those_of_conditioned_cells():
    box = complex_of("kuhn")
    space = polydec.FormSpace(box, 1, essential=True)
    inside = space.inside
    assert polydec.stable_step(box, 1, essential=True) == polydec.stable_step(inside, 1)
    E = space.restrict(np.cos(np.arange(box.size(1))))
    within, _ = polydec.wave(inside, E, 1.0, degree=1)
    whole, _ = polydec.wave(box, space.extend(E), 1.0, degree=1, essential=True)
    assert np.array_equal(space.extend(within), whole)


def test_sources_and_losses(square):
    """Constant functions are moved by sources alone, at E' = f(t) - loss E."""
    n, ones = square.size(0), np.ones(square.size(0))
    driven = polydec.Waves(square, ones, time_step=0.01, source=lambda t: np.cos(t) * ones)
    driven.march(1.0)
    assert abs(driven.time - 1) < 1e-12 and near(driven.forms[0], np.full(n, 1 + np.sin(1)), 1e-5)
    lossy = polydec.Waves(square, ones, time_step=0.01, loss=2.0)
    lossy.march(1.0)
    assert near(lossy.forms[0], np.full(n, np.exp(-2)), 1e-3)
    with pytest.raises(ZeroDivisionError):
        polydec.wave(square, ones, 1.0, source=lambda t: 1 / 0)
    refused(lambda: polydec.wave(square, ones, 1.0, source=lambda t: [1.0, 2.0]))


def test_waves_take_the_fewest_equal_steps_to_a_time(square):
    u = square.points[:, 0]
    step = polydec.stable_step(square) / 2
    for time, steps in ((0.0, 0), (0.4 * step, 1), (11 * step, 11), (11.5 * step, 12)):
        waves = polydec.Waves(square, u, time_step=time / max(1, steps) or step)
        waves.march(time)
        assert near(polydec.wave(square, u, time, time_step=step)[0], waves.forms[0])
    for given in (-0.5, float("nan")):
        refused(lambda: polydec.wave(square, u, 1.0, time_step=given), "time step is", given)
    for until in (-0.1, float("nan"), float("inf")):
        refused(lambda: polydec.wave(square, u, until), "the time is", until)
    refused(lambda: polydec.wave(square, u, 1.0, time_step=1e-11), "steps", "larger time_step")


def test_losses_of_fixed_values_are_not_warned_of(square):
    loss = np.where(square.boundary_facets(), 1e9, 0.0)
    E, B = np.cos(np.arange(square.size(1))), np.ones(square.size(2))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        polydec.Waves(square, E, degree=1, essential=True, loss=loss)
    with pytest.warns(polydec.PolydecWarning, match=said("losses of E", "1e+09")):
        polydec.Waves(square, E, degree=1, essential=False, loss=loss)
    B[0] = np.nan
    refused(lambda: polydec.Waves(square, E, B, degree=1), "values of B", "nan")


def test_absorbing_layers():
    line = polydec.discretize(polydec.meshes.kuhn([200], [10.0]))
    pulse = np.exp(-10 * (line.points[:, 0] - 5) ** 2)
    for layer in (2.0, polydec.AbsorbingLayer(2.0, "conducting"),
                  polydec.AbsorbingLayer(2.0, sides=[(True, True)])):
        assert abs(polydec.wave(line, pulse, 20.0, layer=layer)[0]).max() < 1e-2
    one_side = polydec.AbsorbingLayer(2.0, sides=[(True, False)])
    assert abs(polydec.wave(line, pulse, 9.0, layer=one_side)[0]).max() > 0.3
    waves, again = (polydec.Waves(line, pulse, time_step=0.04, layer=2.0) for _ in range(2))
    assert waves.layer == "stretched"
    waves.march(12.0)
    for _ in again.frames([6.0, 12.0]):
        pass
    assert np.array_equal(waves.forms[0], again.forms[0])
    with pytest.raises(polydec.InvalidInput, match=said("layer", "mesh")):
        inside = polydec.FormSpace(line, essential=True).inside
        polydec.Waves(inside, np.zeros(inside.size(0)), layer=2.0)
