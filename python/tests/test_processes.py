# SPDX-License-Identifier: MIT
"""Pickling, threads, other processes, Ctrl-C and what listeners do."""
import _thread
import copy
import gc
import multiprocessing
import pickle
import threading
import time

import numpy as np
import pytest

import polydec
from conftest import complex_of, is_interrupted, python, refused, together


@pytest.mark.parametrize("protocol", [2, pickle.HIGHEST_PROTOCOL])
def test_meshes_are_pickled(protocol):
    mesh = polydec.Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], [5], facets=[[0, 1]],
                        facet_tags=[3])
    again = pickle.loads(pickle.dumps(mesh, protocol))
    for name in ("points", "simplices", "tags", "facets", "facet_tags"):
        assert np.array_equal(getattr(again, name), getattr(mesh, name))
    lengths = polydec.meshes.length_mesh(mesh)
    assert np.array_equal(pickle.loads(pickle.dumps(lengths, protocol)).lengths, lengths.lengths)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy,
                                    lambda mesh: pickle.loads(pickle.dumps(mesh))])
def test_copies_of_meshes_have_groups(grouped_square, copied):
    mesh = polydec.read_mesh(grouped_square)
    again = copied(mesh)
    assert again.groups == mesh.groups and again._file == mesh._file
    for made in (polydec.discretize(again), copied(polydec.discretize(mesh))):
        assert made.facets_in("the wall").sum() == 1


@pytest.mark.parametrize("options", [
    {}, {"merge": False}, {"star": "galerkin"}, {"angle_tolerance": 1e-3},
    {"delaunay": "flips_and_splits"}])
def test_complexes_are_pickled_to_the_last_bit(options):
    mesh = polydec.meshes.perturbed(polydec.meshes.hexagons(6), 1e-3, 1)
    c = polydec.discretize(mesh, **options)
    again = pickle.loads(pickle.dumps(c))
    assert again.shape == c.shape and again.options == c.options
    for k in range(3):
        assert np.array_equal(again.dual_volumes(k), c.dual_volumes(k))
        star, other = again.star(k), c.star(k)
        assert np.array_equal(getattr(star, "data", star), getattr(other, "data", other))
    assert np.array_equal(again.stiffness(0).data, c.stiffness(0).data)


def test_what_cannot_be_pickled(square):
    glued = polydec.discretize(polydec.periodic(polydec.meshes.grid(4, 4), [[1, 0], [0, 1]]))
    for made in (square.with_star(1, square[1].star), square.with_material(0, 2.0), glued.box):
        refused(lambda: pickle.dumps(made), "box", "with_star", "material")


def test_results_and_errors_are_pickled(square):
    modes = polydec.spectrum(square, count=3)
    again = pickle.loads(pickle.dumps(modes))
    assert np.array_equal(again.modes, modes.modes) and again.certificate == modes.certificate
    error = refused(lambda: complex_of("hexagons").inverse_star(1))
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and again.cells == error.cells
    told = polydec.IoError("too large: raise the limit (polydec.set_memory_limit)")
    assert str(pickle.loads(pickle.dumps(told))) == str(told) == told.args[0]


def test_listeners_are_told():
    stages, steps = [], []
    c = polydec.discretize(polydec.meshes.grid(8, 8), star="galerkin", progress=stages.append)
    assert stages == ["complex", "volumes", "merge", "stars"]
    polydec.spectrum(c, count=3, progress=steps.append)
    assert len(steps) > 1 and all(isinstance(step, str) for step in steps)


class Enough(Exception):
    pass


def enough(what):
    raise Enough(what)


def test_what_listeners_raise_passes_through(square):
    with pytest.raises(Enough):
        polydec.discretize(polydec.meshes.grid(4, 4), progress=enough)
    with pytest.raises(Enough):
        polydec.spectrum(square, count=3, progress=enough)
    assert polydec.spectrum(square, count=3).certificate.complete # nothing is broken by it


def test_two_threads_with_a_listener_each():
    c = complex_of("flange")
    expected = polydec.spectrum(c, degree=1, count=6).eigenvalues
    told = [[], []]
    found = [None, None]

    def work(i):
        for _ in range(3):
            found[i] = polydec.spectrum(c, degree=1, count=6,
                                        progress=lambda what: told[i].append(what))
            gc.collect()

    together(lambda: work(0), lambda: work(1))
    for i in range(2):
        assert np.array_equal(found[i].eigenvalues, expected) and told[i]


def test_other_threads_go_on_meanwhile():
    mesh = polydec.meshes.grid(250, 250)
    counted = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    polydec.discretize(mesh, merge=False)
    meanwhile = counted[0] - before
    done.set()
    thread.join()
    assert meanwhile > 1


def test_solvers_may_be_shared(square):
    solver = polydec.PoissonSolver(square)
    expected = solver.solve(1.0).values
    found = []
    together(*8 * [lambda: found.append(solver.solve(1.0).values)])
    assert len(found) == 8 and all(np.array_equal(u, expected) for u in found)


@pytest.mark.parametrize("listen", [None, lambda what: None])
def test_interrupted_spectrum(listen):
    c = polydec.discretize(polydec.meshes.torus(300, 200))
    assert is_interrupted(lambda: polydec.spectrum(c, count=200, progress=listen), 0.5)
    assert polydec.spectrum(c, count=2).certificate.complete


def test_interrupted_steps(square):
    assert is_interrupted(lambda: polydec.heat(square, square.points[:, 0], 1e-3, 10 ** 8))
    waves = polydec.Waves(square, square.points[:, 0])
    assert is_interrupted(lambda: waves.march(1e9 * waves.time_step))


def test_interrupted_distances():
    """They take half a minute each."""
    sphere = polydec.discretize(polydec.meshes.icosphere(200), star="circumcentric")
    assert is_interrupted(lambda: polydec.geodesic_distance(sphere, 0), 2)
    assert is_interrupted(lambda: polydec.SurfacePaths(sphere, 0), 2)


def test_interrupted_stage():
    mesh = polydec.meshes.grid(200, 200)

    def stop(what):
        if what == "volumes":
            _thread.interrupt_main()

    with pytest.raises(KeyboardInterrupt):
        polydec.discretize(mesh, progress=stop)


def shape_of(mesh):
    return polydec.discretize(mesh).shape


def test_spawned_processes():
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        meshes = [polydec.meshes.grid(n, n) for n in (3, 4)]
        assert pool.map(shape_of, meshes) == [(16, 24, 9), (25, 40, 16)]


def test_import_is_light():
    code = ("import sys, polydec; print(sorted(m for m in sys.modules if m in ("
            "'matplotlib', 'meshio', 'pyvista', 'IPython')))")
    assert python("-c", code).stdout == "[]\n"
