# SPDX-License-Identifier: MIT
"""Sources of forms, conditions of Robin's, boxes without walls, slow flows."""
import pickle

import numpy as np
import pytest

import polydec
from conftest import complex_of, near, refused, said


@pytest.mark.parametrize("name, k", [("torus", 0), ("torus", 1), ("torus", 2), ("goldberg", 1),
                                     ("kuhn", 1), ("kuhn", 2), ("well_centered", 1)])
@pytest.mark.parametrize("side", ["primal", "dual"])
def test_sources_of_forms(name, k, side):
    c = complex_of(name)
    conditions = side == "dual" # which are built in
    f = c.cochain(np.cos(np.arange(c.size(k, side))), k, side)
    solver = polydec.PoissonSolver(c, degree=k, side=side, essential=conditions)
    found = solver.solve(f)
    assert (found.form.laplacian() + found.removed - f).norm() < 1e-8 * f.norm()
    harmonic = solver.harmonic_forms()
    for h in harmonic.T:
        assert abs(c.inner_product(found.form.values, h, k, side)) < 1e-8 * f.norm()
    if harmonic.shape[1]:
        more = solver.solve(f, harmonic=np.arange(1.0, harmonic.shape[1] + 1))
        assert near((more.form - found.form).values,
                    harmonic @ np.arange(1.0, harmonic.shape[1] + 1), 1e-8)
    expected = found.form.delta() if side == "primal" else found.form.d()
    assert len(found.flux) == len(expected)
    if len(expected):
        given = found.flux if side == "primal" else (-1.0) ** (c.dim - k) * found.flux.star()
        assert near(given.values, expected.values, 1e-7)
    refused(lambda: solver.solve(np.ones(3)))


def test_magnets():
    box = complex_of("kuhn").with_material(2, lambda x: 0.1 + x[:, 0])
    j = box.cochain(np.cos(np.arange(box.size(1))), 1)
    found = polydec.PoissonSolver(box, degree=1).solve_curl_curl(j)
    A = found.potential
    assert np.isclose(A.d().norm() ** 2, box.inner_product(A, j - found.removed))
    assert not near(A.values, polydec.PoissonSolver(complex_of("kuhn"), degree=1)
                    .solve_curl_curl(j.values).potential.values, 1e-2)


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_robin_of_a_rod(side):
    """u'' = -1 with u(0) = 0 and u' + b u = 0 at 1 is x (1 + b / 2) / (1 + b) - x^2 / 2."""
    rod = polydec.discretize(polydec.meshes.kuhn([40]))
    solver = polydec.PoissonSolver(rod, side=side, essential=lambda x: x[:, 0] < 0.5, robin=2.0)
    x = solver.sites[:, 0]
    assert near(solver.solve(1.0).values, x * (2 / 3 - x / 2), 1e-3)
    coefficients = np.where(rod.facet_sites()[:, 0] > 0.5, 2.0, 0.0)
    for robin in (coefficients, lambda at: np.where(at[:, 0] > 0.5, 2.0, 0.0)):
        u = polydec.poisson(rod, 1.0, side=side, essential=lambda at: at[:, 0] < 0.5, robin=robin)
        assert np.array_equal(u.values, solver.solve(1.0).values)
    none = polydec.poisson(rod, 1.0, side=side, essential=lambda at: at[:, 0] < 0.5)
    assert not near(none.values, u.values, 0.1)
    for robin in (-1.0, np.ones(3)):
        refused(lambda: polydec.PoissonSolver(rod, side=side, essential=False, robin=robin))


@pytest.mark.parametrize("mesh, n", [(polydec.meshes.kuhn([8]), 1), (polydec.meshes.grid(6, 6), 2),
                                     (polydec.meshes.kuhn([4, 4, 4]), 3)])
def test_boxes_without_walls(mesh, n):
    box = polydec.periodic(mesh, np.eye(n))
    c = polydec.discretize(box)
    assert not c.boundary_facets().any()
    assert c.betti_numbers() == [[1, 1], [1, 2, 1], [1, 3, 3, 1]][n - 1]
    assert len(box.points) == c.size(0) and len(box.numbers) == len(mesh.points)
    assert near(c.points, box.points) and c.box.shape[0] == len(mesh.points)
    form = polydec.de_rham(c, 1, lambda x: np.cos(2 * np.pi * x))
    potential = polydec.de_rham(c, 0, lambda x: np.sin(2 * np.pi * x).sum(axis=1) / (2 * np.pi))
    assert near(form, c.d(0) @ potential, 1e-3)
    again = polydec.discretize(pickle.loads(pickle.dumps(box)))
    assert near(again.centers(n), c.centers(n))
    refused(lambda: polydec.periodic(mesh, [np.full(n, 0.3)]))


def test_pictures_of_boxes_without_walls(tmp_path):
    mesh = polydec.meshes.grid(6, 5)
    c = polydec.discretize(polydec.periodic(mesh, np.eye(2)))
    u = np.cos(2 * np.pi * c.points[:, 0])
    polydec.write_vtu(tmp_path / "u.vtu", c, {"u": u})
    seen = polydec.read_mesh(tmp_path / "u.vtu")
    assert near(seen.points[:, :2], mesh.points)
    assert "u" in polydec.view(c, {"u": u}).html
    assert c.box.shape == (42, 71, 30) and c.shape == (30, 60, 30)
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    drawn = polydec.plot(c, u).collections[-1]
    corners = c.box.cells(2)
    expected = [np.cos(2 * np.pi * c.box.points[corners.cell(i), 0]).mean() for i in range(30)]
    assert near(drawn.get_array(), np.array(expected)) and len(drawn.get_paths()) == 30
    numbers = polydec.plot(c, np.arange(30.0), degree=2).collections[-1].get_array()
    assert numbers.sum() == 435


def test_directions_across_the_seams():
    c = polydec.discretize(polydec.periodic(polydec.meshes.grid(6, 6), np.eye(2)))
    transport = polydec.ParallelTransport(c)
    ways = np.diff(c.points[transport.reference], axis=1)[:, 0]
    assert near(transport.directions * np.linalg.norm(ways - ways.round(), axis=1)[:, None],
                ways - ways.round())


def test_boxes_with_a_twist():
    box = polydec.meshes.kuhn([4, 4, 4])
    moves = [lambda p: p + [1, 0, 0], lambda p: p + [0, 1, 0],
             lambda p: np.column_stack([1 - p[:, 0], 1 - p[:, 1], p[:, 2] + 1])]
    space = polydec.discretize(polydec.glue(box, moves))
    assert space.shape == (64, 192, 192, 64) and space.betti_numbers() == [1, 1, 1, 1]
    with pytest.raises(polydec.InvalidInput, match=said("isometry 0", "edge")):
        polydec.glue(box, [lambda p: np.column_stack([p[:, 0] + 1, 1 - p[:, 1], p[:, 2]])])


def test_materials_weight_stars(square):
    weights = square.cochain(np.linspace(1, 2, square.size(2)), 0, "dual")
    assert near(square.with_material(1, weights).star(1),
                square.star(1) * square.cell_means(1, weights))
    assert near(square.cell_means(2, weights), weights.values)


def test_materials_replace_former_ones(square):
    heavy = square.with_material(1, 5.0)
    assert near(heavy.with_material(1, 2.0).star(1), 2 * square.star(1))
    for permittivity in (1.0, 1 + 1e-9):
        assert near(heavy.with_electric_material(permittivity).star(1), square.star(1), 1e-8)
    assert near(heavy.with_electric_material(None, 2.0).star(1), heavy.star(1), 0)
    assert near(heavy.with_stars("circumcentric").star(1), square.star(1), 0)


def test_numbers_of_cells_are_in_the_order_of_the_input():
    mesh = polydec.meshes.perturbed(polydec.meshes.grid(5, 5), 0.03, 2)
    order = np.random.default_rng(1).permutation(len(mesh.simplices))
    kappa = np.linspace(1, 5, len(order))
    one, other = (polydec.discretize((mesh.points, mesh.simplices[rows]), star="circumcentric")
                  for rows in (np.arange(len(order)), order))
    u = polydec.poisson(one, 1.0, side="primal", conductivity=kappa).values
    assert near(polydec.poisson(other, 1.0, side="primal", conductivity=kappa[order]).values, u)
    assert not near(polydec.poisson(other, 1.0, side="primal", conductivity=kappa).values, u, 1e-3)
    for made in (lambda c, weights: c.with_material(1, weights).star(1),
                 lambda c, weights: c.cell_means(1, weights),
                 lambda c, weights: c.material_star(1, weights).data,
                 lambda c, weights: c.conductivity_star(weights[:, None, None] * np.eye(2)).data):
        assert near(made(one, kappa), made(other, kappa[order]))
        assert not near(made(one, kappa), made(other, kappa), 1e-3)
    by_place = polydec.discretize(polydec.meshes.grid(2, 2))
    means = by_place.cell_means(2, lambda x: 1 + x[:, 0])
    assert near(means, 1 + by_place.centroids(2)[:, 0])
    assert near(by_place.cell_means(2, by_place.cochain(means, 0, "dual")), means)
    refused(lambda: by_place.cell_means(2, means), "4 values", "8")
    refused(lambda: by_place.with_material(1, np.arange(1.0, 9)), "differ", "merged", "keep_apart")


@pytest.mark.parametrize("name", ["grid", "well_centered"])
def test_slow_flows(name):
    c = complex_of(name)
    uniform = polydec.de_rham(c, 1, polydec.flux_form(lambda x: [2.0, 1.0] + 0 * x))
    along = polydec.boundary_de_rham(c, 1, lambda x: [-2.0, -1.0] + 0 * x)
    flow = polydec.StokesSolver(c, viscosity=3.0).solve(through=uniform, along=along)
    assert near(flow.flux.values, uniform, 1e-9)
    assert abs(flow.vorticity.values).max() < 1e-8 and abs(flow.pressure.values).max() < 1e-7
    force = polydec.StokesSolver(c).solve(force=np.cos(np.arange(c.size(1))))
    assert abs(c.d(1) @ force.flux.values).max() < 1e-12 and force.flux.norm() > 0
    with pytest.raises(polydec.InvalidInput):
        polydec.StokesSolver(c).solve(through=np.where(c.facet_sites()[:, 0] < 1e-9, 1.0, 0.0))


@pytest.mark.parametrize("mesh", [polydec.meshes.grid(6, 6), polydec.meshes.well_centered(3)])
def test_slow_flows_between_open_ends(mesh):
    c = polydec.discretize(mesh)
    x = c.facet_sites()[:, 0]
    ends = c.boundary_facets() & (abs(x - 0.5) > 0.49)
    flow = polydec.StokesSolver(c, pressure_on=ends).solve(pressure=2 * (1 - x))
    assert abs(abs(flow.flux.values[ends]).sum() - 1 / 3) < 0.03
    assert abs(flow.pressure.values.mean() - 1) < 0.01
    refused(lambda: polydec.StokesSolver(c, no_slip=False, pressure_on=ends),
            1, "flows", "meet no resistance")


def test_numbers_for_groups_of_the_file(grouped_square):
    square = polydec.discretize(grouped_square)
    # the solution is constant: what the wall has, or 3 / 2 by its Robin condition
    for side in ["primal", "dual"]:
        given = polydec.poisson(square, 0.0, {"the wall": 2.5}, side=side, essential="the wall")
        assert np.allclose(given.values, 2.5)
        robin = polydec.poisson(square, 0.0, flux={"the wall": 3.0}, side=side, essential=False,
                                robin={7: 2.0})
        assert np.allclose(robin.values, 1.5)
    for given in [{"boundary": {"the wall": 1.0}}, {"flux": {"the wall": 1.0}}, {"flux": 2.0}]:
        refused(lambda: polydec.poisson(square, 0.0, degree=1, **given),
                "for 1-forms", "boundary_de_rham")
    refused(lambda: polydec.poisson(square, 0.0, {"lid": 1.0}), "lid", "the wall")
    refused(lambda: square.with_conductivity(np.ones(1)), "one for each 2-cell", "dual 0-form")


@pytest.mark.parametrize("side", ["primal", "dual"])
def test_data_that_apply_nowhere_are_refused(square, side):
    n_facets = square.size(1)
    robin = {"robin": 1.0}
    for conditions, given in [({}, {"flux": 7.0}), ({}, {"flux": np.ones(n_facets)}),
                              ({}, {"flux": lambda at: at[:, 0]}),
                              ({"essential": False}, {"boundary": 5.0}), (robin, {"boundary": 5.0}),
                              ({"essential": False}, {"boundary": lambda at: at[:, 0]})]:
        solver = polydec.PoissonSolver(square, side=side, **conditions)
        refused(lambda: solver.solve(1.0, **given), *given, "none of the", "facet")
        solver.solve(1.0, **dict.fromkeys(given, 0.0))
        if "boundary" in given:
            kind = polydec.PoissonSolver(polydec.discretize(polydec.meshes.torus(8, 6)), side=side)
            assert len(kind.solve(0.0, 5.0).values) # without a boundary there are no conditions
    for data in ({"derivative_flow": np.ones(square.size(0))},
                 {"derivative_flow": np.ones(n_facets)}):
        solver = polydec.PoissonSolver(square, side=side, essential=lambda at: at[:, 0] < .01)
        refused(lambda: solver.solve(0.0, flux=1.0, **data),
                "flux", "derivative_flow", "one of them")
    refused(lambda: polydec.poisson_error(square, np.zeros(square.size(0)), flux=7.0),
            "flux", "none of the", "facet")
    refused(lambda: polydec.PoissonSolver(square, degree=1, essential=False).solve_curl_curl(
                        np.zeros(n_facets), boundary=np.ones(n_facets)),
            "boundary", "none of the", "facet")


@pytest.mark.parametrize("flux", [1.0, np.nan, np.ones(3), lambda at: at[:, 0], {}])
@pytest.mark.parametrize("k", [1, 2])
def test_a_flux_of_forms_is_refused(square, flux, k):
    solver = polydec.PoissonSolver(square, degree=k, essential=False)
    refused(lambda: solver.solve(0.0, flux=flux), "flux", f"for {k}-forms", "derivative_flow")


@pytest.mark.parametrize("name", ["codifferential", "flow"])
def test_functions_have_no_codifferential_and_no_flow(square, name):
    for side in ("primal", "dual"):
        solver = polydec.PoissonSolver(square, side=side, essential=lambda at: at[:, 0] < .01)
        for k in range(3):
            data = {name: np.full(square.size(k), 5.0)}
            refused(lambda: solver.solve(1.0, **data), name, "0-forms", "expected")
            with pytest.raises(polydec.InvalidInput, match=said(name, "0-forms", "expected")):
                polydec.Evolution(square, np.ones(square.size(0, side)), side=side, diffusion=1.0,
                                  boundary=data)


def test_robins_condition_alone_holds_on_the_whole_boundary_as_in_the_command():
    square = polydec.meshes.kuhn([4, 4])
    alone = polydec.poisson(square, 1.0, robin=.7)
    assert near(alone.values, polydec.poisson(square, 1.0, robin=.7, essential=False).values)
    assert alone.values.min() > .3
    for ask in (lambda: polydec.poisson(square, 1.0, robin=.7, essential=True),
                lambda: polydec.spectrum(square, robin=.7, essential=True)):
        refused(ask, "robin", "none of the 16")
