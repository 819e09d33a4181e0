# SPDX-License-Identifier: MIT
"""Problems with known solutions."""
import numpy as np
import pytest

import polydec
from conftest import complex_of, refused


def plane(x):
    return 1 + x @ np.arange(1.0, x.shape[1] + 1)


@pytest.mark.parametrize("name", ["grid", "hexagons", "well_centered", "kuhn", "bcc", "tesseract"])
@pytest.mark.parametrize("side", ["primal", "dual"])
def test_linear_functions_are_exact(name, side):
    c = complex_of(name)
    solver = polydec.PoissonSolver(c, side=side)
    u = solver.solve(0.0, plane)
    assert np.allclose(u, plane(solver.sites), atol=1e-11)
    assert u.report["residual"] < 1e-10 and u.report["engine"]
    # given as what flows through
    slope = np.arange(1.0, c.points.shape[1] + 1)
    low = lambda x: x[:, 0] < 1e-9
    outward = np.sign(solver.flux_sites - 0.5) * (abs(abs(solver.flux_sites - [
        c.points.max(0) / 2]) - c.points.max(0) / 2) < 1e-9)
    mixed = polydec.poisson(c, 0.0, plane, outward @ slope, side=side, essential=low)
    assert np.allclose(mixed, plane(solver.sites), atol=1e-10)


def test_values_may_be_numbers_arrays_and_functions(square):
    f = square.points[:, 0]
    u = polydec.poisson(square, f).values
    assert np.array_equal(polydec.poisson(square, lambda x: x[:, 0]).values, u)
    assert np.array_equal(polydec.poisson(square, list(f)).values, u)
    assert np.array_equal(polydec.poisson(square, square.cochain(f, 0)).values, u)
    three = polydec.PoissonSolver(square, conductivity=3.0).solve(f)
    assert np.allclose(3 * three.values, u)


def test_free_components(square):
    u = polydec.poisson(square, lambda x: x[:, 0], essential=False)
    assert u.report["free_components"] == 1 and u.report["incompatible"] > 0.1
    assert abs(square.star(0) @ u) < 1e-10


def test_darcy():
    c = complex_of("hexagons")
    slope = np.array([2.0, -1.0])
    flow = polydec.poisson(c, 0.0, lambda x: x @ slope, side="dual")
    assert np.allclose(flow.form, c.dual_sites() @ slope)
    assert np.allclose(polydec.flux_sharp(c, flow.flux), -slope)
    assert (flow.form.side, flow.flux.side, flow.flux.degree) == ("dual", "primal", 1)


@pytest.mark.parametrize("name, k", [("torus", 1), ("kuhn", 2)])
@pytest.mark.parametrize("side", ["primal", "dual"])
def test_hodge_decompositions(name, k, side):
    c = complex_of(name)
    form = c.cochain(np.cos(np.arange(c.size(k, side))), k, side)
    parts = polydec.hodge_decomposition(c, form)
    assert np.allclose(parts.exact + parts.coexact + parts.harmonic, form)
    assert np.allclose(parts.potential.d(), parts.exact, atol=1e-9)
    assert np.allclose(parts.copotential.d(), parts.coexact.star(), atol=1e-9)
    cells = k if side == "primal" else c.dim - k
    assert polydec.harmonic_forms(c, k, side=side).shape == (c.size(cells), c.betti_numbers()[cells])


def test_heat_follows_the_matrix(square):
    u = np.sin(np.arange(square.size(0)))
    M = np.diag(square.star(0))
    step = np.linalg.solve(M + 0.1 * square.stiffness(0).toarray(), M @ u)
    assert np.allclose(polydec.heat(square, u, 0.1), step)
    twice = polydec.heat(square, step, 0.1)
    assert np.allclose(polydec.heat(square, u, 0.1, 3), polydec.heat(square, twice, 0.1))
    half = M + 0.05 * square.stiffness(0).toarray()
    crank = np.linalg.solve(half, (2 * M - half) @ u)
    assert np.allclose(polydec.heat(square, u, 0.1, integrator="implicit-midpoint"), crank)
    cold = polydec.heat(square, u, 0.1, essential=True)
    assert abs(np.delete(cold, polydec.FormSpace(square, essential=True).free)).max() == 0
    for bad, reason in ((-1.0, "fixed_step is -1"), (0.0, "fixed_step above 0")):
        with pytest.raises(polydec.InvalidInput, match=reason):
            polydec.heat(square, u, bad)


def test_distances(sphere):
    north = int(sphere.points[:, 2].argmax())
    distance = polydec.geodesic_distance(sphere, north)
    exact = np.arccos(np.clip(sphere.points @ sphere.points[north], -1, 1))
    assert distance[north] == 0 and abs(distance - exact).max() < 0.25
    solver = polydec.GeodesicDistance(sphere)
    assert np.array_equal(solver.to([north]), distance)
    smoothed = polydec.geodesic_distance(sphere, north, method="heat", time_scale=2)
    assert 1e-4 < abs(smoothed - distance).max() < 0.25
    for heat_alone in ({"time_scale": 2}, {"engine": "eigen.ldlt"}):
        with pytest.raises(polydec.InvalidInput, match="time_scale and engine.*method=\"heat\""):
            polydec.geodesic_distance(sphere, north, **heat_alone)
    refused(lambda: polydec.geodesic_distance(sphere, north, method="fast"), "exact")
    paths = polydec.SurfacePaths(sphere, north)
    far = int(distance.argmax())
    path = paths.path(far)
    pieces = np.linalg.norm(path.segments[:, 1] - path.segments[:, 0], axis=1)
    assert path.source == north and np.isclose(path.length, distance[far], rtol=1e-13)
    assert np.isclose(pieces.sum(), path.length, rtol=1e-12)
    assert np.allclose(path.points[[0, -1]], sphere.points[[far, north]])
    assert np.array_equal(paths.path(north).points, sphere.points[[north]])
    lines, levels = paths.isolines([0.5, 1])
    angles = np.arccos(np.clip(lines.mean(axis=1) @ sphere.points[north], -1, 1))
    assert abs(angles - np.array([0.5, 1])[levels]).max() < 0.1
    south = int(sphere.points[:, 2].argmin())
    exact = np.arccos(np.clip(sphere.points @ sphere.points[[north, south]].T, -1, 1)).min(axis=1)
    assert abs(solver.to([north, south]) - exact).max() < 0.25
    for sources in ([], [-1], [sphere.size(0)], [0.5]):
        refused(lambda: solver.to(sources))


def test_parallel_transport():
    flat = complex_of("well_centered")
    transport = polydec.ParallelTransport(flat)
    directions = transport.directions
    assert np.allclose(np.linalg.norm(directions, axis=1), 1)
    vectors = transport.extend(5, 2.0)
    angles = np.arctan2(directions[:, 1], directions[:, 0])
    in_plane = vectors * np.exp(1j * angles)
    assert np.allclose(in_plane, in_plane[5], atol=1e-3) and np.allclose(abs(vectors), 2.0)


@pytest.mark.parametrize("size, is_glued", [(1, False), (1e-200, False), (1, True)])
def test_parallel_transport_numbers_vertices_as_the_input(size, is_glued):
    mesh = polydec.meshes.grid(4, 4)
    numbers = np.random.default_rng(1).permutation(len(mesh.points) + 5)[:len(mesh.points)]
    points = np.full((len(mesh.points) + 5, 2), 7.0 * size)
    points[numbers] = size * mesh.points
    pair = points, numbers[mesh.simplices]
    c = polydec.discretize(polydec.periodic(pair, size * np.eye(2)) if is_glued else pair)
    transport = polydec.ParallelTransport(c)
    used = np.isin(np.arange(len(c.points)), c.vertices)
    vectors, directions, reference = (transport.extend(c.vertices[3], 1 + 2j), transport.directions,
                                      transport.reference)
    assert {len(vectors), len(directions), len(reference)} == {len(c.points)}
    in_plane = vectors[used] * (directions[used] @ [1, 1j])
    assert np.allclose(in_plane, in_plane[0]) and np.isclose(abs(in_plane[0]), 5 ** .5)
    assert (reference[used, 0] == c.vertices).all() and used[reference[used]].all()
    assert np.isnan(vectors[~used]).all() and np.isnan(directions[~used]).all()
    assert (reference[~used] == -1).all() and (is_glued or not used.all())


def test_edges_without_place_have_no_direction():
    ball = polydec.discretize(polydec.meshes.perturbed(polydec.meshes.icosphere(4), .12, 1),
                              delaunay="flips")
    edges = ball.input.d(0).indices.reshape(-1, 2).tolist()
    reference = polydec.ParallelTransport(ball).reference
    flipped = [edge[0] for edge in reference if sorted(edge) not in edges]
    error = refused(lambda: polydec.ParallelTransport(ball).directions,
                      "flip", "vertex", "direction")
    assert list(error.vertices) == flipped
    lengths = polydec.meshes.length_mesh(polydec.meshes.icosphere(2))
    refused(lambda: polydec.ParallelTransport(lengths).directions, "lengths", "direction", "points")


def test_flips_make_stars_positive():
    mesh = polydec.meshes.perturbed(polydec.meshes.grid(8, 8), 0.05, 4)
    bad = polydec.discretize(mesh, star="circumcentric")
    good = polydec.discretize(mesh, delaunay="flips_and_splits")
    assert min(bad.star(1)) < 0 < min(good.star(1))
    assert good.report()["intrinsic"]["flips"] > 0
    u = polydec.poisson(good, 0.0, plane)
    assert np.allclose(u, plane(good.points))
    form = good.cochain(good.points[:, 0], 0).d()
    back = good.merging.to_input(form)
    assert np.allclose(back, good.input.d(0) @ mesh.points[:, 0])
