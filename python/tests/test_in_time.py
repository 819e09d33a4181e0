# SPDX-License-Identifier: MIT
"""Evolutions and what long runs keep."""
import numpy as np
import pytest

import polydec
from conftest import complex_of, is_interrupted, near, refused, said, together

INTEGRATORS = [engine.name for engine in polydec.backends()
               if engine.kind == "integrator" and engine.available
               and engine.name not in ("backward-euler", "implicit-midpoint")] # of fixed steps


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_modes_decay_at_their_rates(side):
    torus = complex_of("torus")
    found = polydec.spectrum(torus, degree=1, side=side, count=3)
    mode, eigenvalue = found.modes[:, 2], found.eigenvalues[2] # beside two that are harmonic
    run = polydec.Evolution(torus, mode, degree=1, side=side, diffusion=0.5,
                            relative_tolerance=1e-8, absolute_tolerance=1e-12)
    assert not run.march(1 / eigenvalue)
    assert near(run.forms[0], np.exp(-0.5) * mode, 1e-6)
    assert run.report["steps"] > 0 and run.report["engine"] == "runge-kutta"
    assert not near(run.forms[0], np.exp(-0.6) * mode, 1e-2)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_every_integrator_couples_unknowns(sphere, integrator):
    z = sphere.points[:, 2]
    run = polydec.Evolution(sphere, [z, 0 * z], reaction=lambda t, u, v: (v, -u),
                            integrator=integrator, relative_tolerance=1e-8)
    times = [0.5, 1.0]
    for time, (at, u, v) in zip(times, run.frames(times)):
        assert at == time and near(u, np.cos(time) * z, 1e-5) and near(v, -np.sin(time) * z, 1e-5)


def test_there_are_integrators():
    assert {"runge-kutta"} <= set(INTEGRATORS)


def test_unknowns_of_different_kinds(square):
    one = square.cochain(np.ones(square.size(0)), 0)
    two = square.cochain(np.ones(square.size(2, "dual")), 2, "dual")
    run = polydec.Evolution(square, [one, two], diffusion=[1.0, 0.0],
                            reaction=lambda t, u, v: (None, 3 * t ** 2 * np.ones(len(v))))
    run.march(1.0)
    assert near(run.forms[0], np.ones(square.size(0)), 1e-9)
    assert near(run.forms[1], 2 * np.ones(len(two)), 1e-4)


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_values_on_the_boundary(square, side):
    sites = polydec.PoissonSolver(square, side=side).sites
    at = square.points if side == "primal" else square.facet_sites()
    run = polydec.Evolution(square, 1 + sites[:, 0], side=side, diffusion=1.0, essential=True,
                            boundary=lambda t: (1 + t) * (1 + at[:, 0]),
                            reaction=lambda t, u: 1 + sites[:, 0])
    run.march(0.5)
    assert near(run.forms[0], 1.5 * (1 + sites[:, 0]), 1e-4)
    still = polydec.Evolution(square, np.full(len(sites), 2.0), side=side, diffusion=1.0,
                              essential=True, boundary=2.0)
    still.march(0.5)
    assert near(still.forms[0], np.full(len(sites), 2.0), 1e-9)
    with pytest.raises(polydec.InvalidInput, match=said("3 values", "boundary")):
        polydec.Evolution(square, np.zeros(len(sites)), side=side, diffusion=1.0, essential=True,
                          boundary=np.zeros(3)).march(1.0)


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_what_flows_through_the_boundary(square, side):
    """u = (1 + t) (1 + x), by its outward derivatives alone."""
    x = polydec.PoissonSolver(square, side=side).sites[:, 0]
    outward = polydec.outward_flow(square, lambda p: (p[:, 0] > 1 - 1e-9) * 1.0 - (p[:, 0] < 1e-9),
                                   side)
    run = polydec.Evolution(square, 1 + x, side=side, diffusion=1.0, essential=False,
                            boundary=lambda t: {"derivative_flow": (1 + t) * outward},
                            reaction=lambda t, u: 1 + x)
    run.march(0.5)
    assert near(run.forms[0], 1.5 * (1 + x), 1e-4)
    with pytest.raises(polydec.InvalidInput, match=said("boundary", "'flux'")):
        polydec.Evolution(square, x, side=side, diffusion=1.0, boundary={"flux": outward}).march(1)


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_data_and_conditions_that_apply_nowhere_are_refused(square, side):
    u, flow = np.ones(square.size(0, side)), polydec.outward_flow(square, 1.0, side)
    for names, given, conditions in (
            ("boundary", 5.0, {"essential": False}), ("boundary", 5.0, {"robin": 1.0}),
            ("boundary", lambda t: 5.0, {"essential": False}),
            ("derivative_flow", {"derivative_flow": flow}, {"essential": True}),
            ("derivative_flow", lambda t: {"derivative_flow": flow}, {"essential": True})):
        with pytest.raises(polydec.InvalidInput, match=said(names, "none of the", "facet")):
            polydec.Evolution(square, u, side=side, diffusion=1.0, boundary=given, **conditions)
    for conditions in ({"essential": True}, {"robin": 1.0}, {"essential": False}):
        refused(lambda: polydec.Evolution(square, u, side=side, **conditions),
                "diffusion", "0", "conditions")
    polydec.Evolution(square, [u, u], side=side, diffusion=[1.0, 0.0], essential=True)
    polydec.Evolution(square, u, side=side, diffusion=1.0, essential=False, boundary=0.0)


def test_conditions_are_those_of_unknowns_that_diffuse(square):
    u = square.cochain(np.ones(square.size(0)), 0)
    rho = square.cochain(np.ones(square.size(2)), 0, "dual")
    for conditions in ({"fixed": [0]}, {"essential": True}, {"essential": False, "robin": 1.0}):
        run = polydec.Evolution(square, [u, rho], diffusion=[1.0, 0.0],
                                reaction=lambda t, u, rho: (None, rho), **conditions)
        alone = polydec.Evolution(square, u, diffusion=1.0, **conditions)
        for each in (run, alone):
            each.march(0.1)
        assert near(run.forms[0], alone.forms[0], 1e-4)
        assert near(run.forms[1], np.exp(0.1) * rho.values, 1e-4)
    refused(lambda: polydec.Evolution(square, [u, rho], diffusion=[1.0, 1.0], fixed=[0]),
            "primal 0-forms")


def test_data_beside_unused_vertices_are_those_of_the_mesh_without():
    grid = polydec.meshes.grid(4, 4)
    c = polydec.discretize((np.vstack([[[9, 9]], grid.points]), np.asarray(grid.simplices) + 1))
    values = np.append(np.nan, np.arange(25.0))
    ends = []
    for given in (values, {"values": values}, lambda t: {"values": values}, {"values": values[1:]}):
        run = polydec.Evolution(c, np.ones(26), diffusion=1.0, essential=True, boundary=given)
        run.march(0.1)
        ends.append(run.forms[0][1:])
    assert all(np.array_equal(end, ends[0]) for end in ends) and ends[0][24] == 24
    for given in (np.ones(24), {"values": np.ones(24)}):
        refused(lambda: polydec.Evolution(c, np.ones(26), diffusion=1.0, essential=True,
                                          boundary=given), "24 values", "expected 25")
    ones = polydec.Evolution(c, np.ones(26), diffusion=1.0, essential=True,
                             boundary={"values": 1.0})
    ones.march(0.1)
    assert near(ones.forms[0][1:], np.ones(25))


def test_heat_takes_whole_steps(square):
    u = square.points[:, 0]
    assert np.array_equal(polydec.heat(square, u, .1, np.int64(2)), polydec.heat(square, u, .1, 2))
    for steps in (2.5, 2.0, "2"):
        refused(lambda: polydec.heat(square, u, .1, steps), "steps", steps, "whole number")


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_heat_leaves_through_robins_condition(square, side):
    start = np.ones(square.size(0 if side == "primal" else 2))
    cooled = polydec.heat(square, start, 0.01, 10, side=side, robin=2.0)
    kept = polydec.heat(square, start, 0.01, 10, side=side, essential=False)
    cold = polydec.heat(square, start, 0.01, 10, side=side, essential=True)
    assert near(kept, start) and cooled.max() < 1 and (cooled > cold - 1e-12).all()
    hardly = polydec.heat(square, start, 0.01, 10, side=side, robin=lambda at: 1e-9 + 0 * at[:, 0])
    assert near(hardly, start, 1e-6)
    run = polydec.Evolution(square, start, side=side, diffusion=1.0, robin=2.0,
                            relative_tolerance=1e-6)
    run.march(0.1)
    assert np.abs(run.forms[0] - cooled).max() < 0.02


def test_events_end_marches(square):
    run = polydec.Evolution(square, np.ones(square.size(0)), reaction=lambda t, u: -u,
                            event=lambda t, u: u[0] - 0.5, relative_tolerance=1e-9)
    assert run.march(3.0)
    assert abs(run.time - np.log(2)) < 1e-6
    assert not run.march(3.0) and run.time == 3.0


def test_errors_of_functions_come_through(square):
    ones = np.ones(square.size(0))

    def fails(time, *forms):
        raise KeyError("mine")

    for words in ({"reaction": fails}, {"event": fails}, {"boundary": fails, "diffusion": 1.0,
                                                          "essential": True}):
        with pytest.raises(KeyError, match="mine"):
            polydec.Evolution(square, ones, **words).march(1.0)
    refused(lambda: polydec.Evolution(square, ones, reaction=lambda t, u: np.zeros(3)).march(1.0),
            "3 rates", "unknown 0")
    refused(lambda: polydec.Evolution(square, [ones, ones],
                                      reaction=lambda t, u, v: (u, v, u)).march(1.0),
            "rates", "3 unknowns", "expected 2")
    with pytest.raises(polydec.SolverFailure, match=said("time 0.5")):
        polydec.Evolution(square, ones,
                          reaction=lambda t, u: np.nan * u if t > 0.5 else u).march(1.0)
    refused(lambda: polydec.Evolution(square, ones, integrator="nonsense"), "runge-kutta")
    refused(lambda: polydec.Evolution(square, ones, diffusion=[1.0, 2.0]),
            "2 coefficients", "diffusion")


@pytest.mark.parametrize("equation", [{"diffusion": 1.0}, {"reaction": lambda t, u: np.cos(t) * u}])
def test_ctrl_c_ends_a_march_which_may_go_on(square, equation):
    run = polydec.Evolution(square, square.points[:, 0], fixed_step=1e-6, most_steps=10 ** 9,
                            **equation)
    assert is_interrupted(lambda: run.march(100.0))
    assert 0 < run.time < 100 and np.isfinite(run.forms[0]).all()
    assert not run.march(run.time + 1e-4)


def test_a_reaction_cannot_use_the_run_itself(square):
    run = polydec.Evolution(square, np.ones(square.size(0)), reaction=lambda t, u: run.time * u)
    refused(lambda: run.march(1.0), "same solver")
    assert run.time == 0.0


def test_runs_go_on_in_the_same_bits(sphere, tmp_path):
    z, times = sphere.points[:, 2], [0.1, 0.2, 0.4]
    equations = polydec.IncompressibleFlow(sphere)
    w = equations.project(polydec.flow_of_vorticity(sphere, z ** 3))
    runs = {"heat": lambda: polydec.Evolution(sphere, z, diffusion=0.1, label="a",
                                              reaction=lambda t, u: np.sin(t) * u),
            "waves": lambda: polydec.Waves(sphere, z, source=lambda t: t * z, label="a"),
            "flow": lambda: polydec.Flow(equations, w, 0.02)}
    for name, made in runs.items():
        whole, first, again = made(), made(), made()
        whole.march(times[-1])
        ends = [frame[0] for frame in made().frames(times)]
        frames = first.frames(times, checkpoint=tmp_path / name)
        for _ in range(2):
            next(frames) # what the second shows is not kept when it is left alone
        assert [frame[0] for frame in again.frames(times, checkpoint=tmp_path / name)] == ends[1:]
        if name != "heat": # whose steps depend on the times
            assert np.array_equal(whole.forms[0], again.forms[0])
        resumed = made()
        resumed.resume(again.time, again.state())
        assert np.array_equal(resumed.forms[0], again.forms[0])
        assert list(made().frames(times, checkpoint=tmp_path / name)) == []
        refused(lambda: list(made().frames([0.1, 0.3, 0.5], checkpoint=tmp_path / name)), "times")
        refused(lambda: list(made().frames(times, checkpoint=tmp_path / "none" / "such")),
                error=polydec.IoError)


def test_checkpoints_of_other_runs_are_refused(sphere, tmp_path):
    z = sphere.points[:, 2]

    def frames(start, **words):
        run = polydec.Evolution(sphere, start, reaction=lambda t, u: np.sin(9 * t) * u, **words)
        return list(run.frames([0.1], checkpoint=tmp_path / "a"))

    frames(z, label="sine")
    for start, words in ((2 * z, {}), (z, {"diffusion": 0.1}), (z, {"label": "cosine"}),
                         (z, {"boundary": None, "relative_tolerance": 1e-3})):
        refused(lambda: frames(start, **{"label": "sine", **words}), "another")
    refused(lambda: frames(z), "label")


def test_constants_are_no_functions_for_checkpoints(square, tmp_path):
    def frames(boundary, **words):
        run = polydec.Evolution(square, np.ones(square.size(0)), diffusion=1.0, essential=True,
                                boundary=boundary, **words)
        return list(run.frames([0.1], checkpoint=tmp_path / "a"))

    assert len(frames(1.0)) == 1 and frames({"values": 1.0}) == []
    refused(lambda: frames(2.0), "another")
    refused(lambda: frames(lambda t: 1.0), "label")
    refused(lambda: frames(1.0, event=lambda t, u: 1.0), "label")


def test_frames_stop_at_an_event(sphere, tmp_path):
    def frames():
        run = polydec.Evolution(sphere, sphere.points[:, 2], reaction=lambda t, u: -u, label="a",
                                event=lambda t, u: u.max() - 0.8)
        return run.frames([0.1, 0.2, 0.4, 10.0], checkpoint=tmp_path / "a")

    assert 0.2 < [frame[0] for frame in frames()][-1] < 0.4
    assert list(frames()) == []


def test_two_runs_in_two_threads(sphere):
    found = {}

    def work(rate):
        run = polydec.Evolution(sphere, np.ones(sphere.size(0)), diffusion=0.1,
                                reaction=lambda t, u: rate * u, relative_tolerance=1e-8)
        run.march(1.0)
        found[rate] = run.forms[0][0]

    together(lambda: work(1.0), lambda: work(2.0))
    assert all(abs(found[rate] / np.exp(rate) - 1) < 1e-5 for rate in found) and len(found) == 2


@pytest.mark.parametrize("until", [-1e-9, -1.0, float("nan")])
def test_no_march_goes_back_before_the_start(square, until):
    flow = polydec.IncompressibleFlow(square)
    for run in (polydec.Evolution(square, np.ones(square.size(0)), diffusion=1.0),
                polydec.Waves(square, np.ones(square.size(0))),
                polydec.Flow(flow, np.zeros(square.size(1)), 0.1)):
        refused(lambda: run.march(until), "time")
        refused(lambda: next(run.frames([until])), "time")
        assert run.time == 0


def test_a_long_march_says_what_it_will_do(square):
    waves = polydec.Waves(square, np.ones(square.size(0)))

    def hear(text):
        raise KeyError(text)

    for march in (lambda until: waves.march(until, progress=hear),
                  lambda until: list(waves.frames([until], progress=hear))):
        with pytest.raises(KeyError, match=r"[\d,]{12,} steps of .*; about .* time_step shortens") as said:
            march(waves.time + 2e9 * waves.time_step)
        assert "::" not in str(said.value)
    waves.march(waves.time + 1, progress=hear)


def test_series(sphere, tmp_path):
    with polydec.Series(tmp_path / "film.pvd", sphere) as film:
        for t in (0.0, 1.0):
            film.add(t, {"z": t * sphere.points[:, 2]})
        refused(lambda: film.add(0.5, {"z": sphere.points[:, 2]}), "after")
    assert (tmp_path / "film.pvd").read_text().count("DataSet timestep") == 2
    with polydec.Series(tmp_path / "film.html", sphere, title="A film") as page:
        page.add(0.0, sphere.points[:, 2])
    assert "A film" in (tmp_path / "film.html").read_text()
    refused(lambda: polydec.Series(tmp_path / "film.txt", sphere))
