# SPDX-License-Identifier: MIT
"""Questions on whose answers much hangs: forms with linear coefficients, warnings, units, certificates,
and how processes end."""
import warnings

import numpy as np
import pytest

import polydec
from conftest import near, python, said
from polydec import meshes

FOLDED = ([[0, 0], [1, 0], [.5, 1], [.4, .6]], [[0, 1, 2], [1, 0, 3]])


def shaken(mesh, amount):
    """With its inner points moved at random."""
    points = mesh.points.copy()
    inside = ((points > 1e-9) & (points < 1 - 1e-9)).all(axis=1)
    points[inside] += np.random.default_rng(2).uniform(-amount, amount, points[inside].shape)
    return polydec.Mesh(points, mesh.simplices)


@pytest.mark.parametrize("star, mesh", [
    ("circumcentric", shaken(meshes.bcc(2), .02)),
    ("galerkin", shaken(meshes.kuhn([3, 3, 3]), .1))], ids=["circumcentric", "galerkin"])
@pytest.mark.parametrize("k, field", [
    (1, lambda x: np.column_stack([-x[:, 1], x[:, 0], 0 * x[:, 0]])),
    (2, lambda x: np.column_stack([x[:, 2], -x[:, 1], x[:, 0]]))], ids=["x dy - y dx", "flux of x"])
def test_whitney_forms_with_linear_coefficients_come_back_in_space(star, mesh, k, field):
    c = polydec.discretize(mesh, star=star)
    w = polydec.de_rham(c, k, field)
    solver = polydec.PoissonSolver(c, degree=k, essential=True)
    assert near(solver.solve(0 * w, boundary=w).values, w, 1e-10)


@pytest.mark.parametrize("ask", [polydec.discretize, lambda mesh: polydec.poisson(mesh, 1.0),
                                 lambda mesh: polydec.spectrum(mesh, count=1)])
def test_a_fold_is_told_by_whatever_takes_the_mesh(ask):
    with pytest.warns(polydec.PolydecWarning, match=said("folded")):
        ask(FOLDED)


@pytest.mark.parametrize("size", [1e-100, 1e-12, 1e-9, 1e12, 1e20, 1e100])
def test_answers_are_in_the_units_of_what_is_given(size):
    mesh = meshes.kuhn([2, 2])
    given = (mesh.points * size, mesh.simplices)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert polydec.spectrum(given, count=2).eigenvalues[1] * size * size == pytest.approx(8)
        assert polydec.poisson(given, 1.0).values.max() / size / size == pytest.approx(.0625)
        distances = polydec.geodesic_distance(given, [0]), polydec.geodesic_distance(mesh, [0])
        assert near(distances[0] / size, distances[1], 1e-9)
    assert np.array_equal(polydec.discretize(given).points, given[0])


@pytest.mark.parametrize("height", [1e-12, 1e-9, 1e-6, 9e-5, 1e-3])
def test_certified_values_are_those_of_the_matrix(height):
    """A facet of the boundary whose dual is short, by a triangle whose angle is almost right."""
    points = [[0, 0], [2, 0], [2, 2], [0, 2],
              [1 + np.cos(1.2) * (1 + height), np.sin(1.2) * (1 + height)], [1.2, 3.1]]
    c = polydec.discretize((points, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [3, 2, 5]]))
    exact = np.sort(np.linalg.eigvals(c.laplacian(2).toarray()).real)[:3]
    found = polydec.spectrum(c, degree=2, count=3)
    assert found.certificate.complete
    assert (abs(found.eigenvalues - exact) <= found.radii + 1e-13 * abs(exact)).all()


@pytest.mark.parametrize("code, printed", [
    ("""if True:
    def solve():
        while True:
            polydec.spectrum(polydec.meshes.grid(12, 12), count=3)
    def make():
        while True:
            polydec.meshes.grid(3, 3)
    for work in (solve, make, make):
        threading.Thread(target=work, daemon=True).start()
    time.sleep(.3)
    print('end')""", "end"),
    ("""if True:
    c = polydec.discretize(polydec.meshes.kuhn([10, 10, 10]))
    with multiprocessing.get_context('fork').Pool(2) as pool:
        again = pool.map(polydec.discretize, 2 * [polydec.meshes.kuhn([10, 10, 10])])
    print([other.shape == c.shape for other in again])""", "[True, True]")],
    ids=["daemon_threads", "forked_children"])
def test_the_interpreter_ends_with_its_own_code(code, printed):
    code = f"import multiprocessing, threading, time, polydec\n{code}"
    assert python("-c", code, OMP_NUM_THREADS="2").stdout.strip() == printed
