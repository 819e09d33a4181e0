# SPDX-License-Identifier: MIT
"""Questions on whose answers much hangs: linear functions by all stars, one problem asked in two
ways, defaults, warnings, units, certificates, and how processes end."""
import warnings

import numpy as np
import pytest

import polydec
from conftest import near, python, said
from polydec import meshes

OBTUSE = ([[0, 0, 0], [4, 0, 0], [2, .6, .2], [2, .3, -.5]], # a tetrahedron's surface
          [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
FOLDED = ([[0, 0], [1, 0], [.5, 1], [.4, .6]], [[0, 1, 2], [1, 0, 3]])


def shaken(mesh, amount):
    """With its inner points moved at random."""
    points = mesh.points.copy()
    inside = ((points > 1e-9) & (points < 1 - 1e-9)).all(axis=1)
    points[inside] += np.random.default_rng(2).uniform(-amount, amount, points[inside].shape)
    return polydec.Mesh(points, mesh.simplices)


SHAPES = {
    "triangles": lambda: meshes.well_centered(6),
    "squares": lambda: meshes.grid(5, 4),
    "cubes": lambda: meshes.kuhn([3, 3, 3]),
    "shaken_cubes": lambda: shaken(meshes.kuhn([3, 3, 3]), .1),
}


@pytest.fixture(params=[(name, star) for name in SHAPES
                        for star in ("circumcentric", "galerkin", "automatic")
                        if (name, star) != ("shaken_cubes", "circumcentric")], ids="-".join)
def consistent(request):
    """A flat mesh with a positive star by which linear functions are exact."""
    name, star = request.param
    return polydec.discretize(SHAPES[name](), star=star)


def test_linear_functions_come_back_from_their_boundary(consistent):
    x = consistent.points @ np.arange(1, consistent.dim + 1)
    for k, w in ((0, x), (1, consistent.d(0) @ x)):
        solver = polydec.PoissonSolver(consistent, degree=k, essential=True)
        assert near(solver.solve(0 * w, boundary=w).values, w, 1e-11)
    run = polydec.Evolution(consistent, x.copy(), diffusion=1.0, essential=True, boundary=x)
    run.march(.1)
    assert near(run.forms[0], x, 1e-8)


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


def test_normal_derivatives_on_facets_are_those_of_the_star(consistent):
    """u is given where x = 0; what flows out elsewhere are integrals over facets."""
    x, facets = consistent.points[:, 0], consistent.boundary_facets()
    at = consistent.facet_sites()[:, 0]
    essential = facets & (at < at.min() + 1e-9)
    flux = np.where(facets & (at > at.max() - 1e-9), 1.0, 0.0)
    poisson = polydec.PoissonSolver(consistent, side="primal", essential=essential)
    assert near(poisson.solve(0 * x, boundary=x, flux=flux).values, x, 1e-11)
    flow = polydec.outward_flow(consistent, flux)
    assert near(poisson.solve(0 * x, boundary=x, derivative_flow=flow).values, x, 1e-11)


@pytest.mark.parametrize("side", ["primal", "dual"])
@pytest.mark.parametrize("with_robin", [False, True])
def test_one_problem_asked_in_two_ways_has_one_solution(consistent, side, with_robin):
    """Of the solver, and of an equation in time, where the solution stands still."""
    c, place = consistent, np.random.default_rng(3)
    facets, sites = c.boundary_facets(), c.facet_sites()
    essential = facets & (sites[:, 0] < np.median(sites[facets][:, 0]))
    robin = np.where(facets & ~essential & (sites[:, 1] > np.median(sites[:, 1])), 2.5, 0)
    conditions = {"side": side, "essential": essential, "robin": robin if with_robin else None}
    poisson = polydec.PoissonSolver(c, **conditions)
    sizes = (c.size(0, side), c.size(0) if side == "primal" else c.size(c.dim - 1),
             c.size(c.dim - 1))
    for given in range(3):
        f, g, q = (place.standard_normal(size) * (i == given) for i, size in enumerate(sizes))
        if side == "dual":
            g = np.where(essential, g, 0)
        u = poisson.solve(f, boundary=g, flux=q).values
        flow = polydec.outward_flow(c, q, side=side)
        assert abs(u).max() > 0
        assert near(poisson.solve(c.cochain(f, 0, side), g, derivative_flow=flow).values, u, 1e-11)
        run = polydec.Evolution(c, u, diffusion=1.0, reaction=lambda t, v, f=f: f,
                                boundary={"values": g, "derivative_flow": flow}, **conditions)
        run.march(.1)
        assert near(run.forms[0], u, 1e-8)


def test_materials_are_the_conductivities_of_poisson_problems():
    c = polydec.discretize(meshes.perturbed(meshes.grid(6, 6), .04, 1), star="circumcentric")
    kappa = c.cochain(1 + np.arange(c.size(2)) % 5, 0, "dual")
    f = np.ones(c.size(0))
    by_star = polydec.PoissonSolver(c.with_material(1, kappa), side="primal").solve(f).values
    by_option = polydec.PoissonSolver(c, side="primal", conductivity=kappa).solve(f).values
    assert near(by_star, by_option, 1e-12)
    assert not near(polydec.PoissonSolver(c, side="primal").solve(f).values, by_option, 1e-2)


def test_stars_are_positive_by_default():
    c = polydec.discretize(OBTUSE)
    found = polydec.spectrum(c, side="dual", count=3)
    assert found.certificate.complete and found.eigenvalues[0] > -found.radii[0]
    u = np.array([1., 0, 0, 0])
    u = polydec.heat(c, u, .01, 50, side="dual")
    assert 0 < u.min() and u.max() < 1
    other = polydec.discretize(OBTUSE, star="circumcentric")
    with pytest.warns(polydec.PolydecWarning, match=said("negative", "spurious")):
        assert polydec.spectrum(other, side="dual", count=3).eigenvalues[0] < -.1


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
