# SPDX-License-Identifier: MIT
"""Numbers and units are those of the arrays that users gave."""
import numpy as np
import pytest
import scipy.sparse as sp

import polydec
from conftest import near, refused, said


def test_vertices_keep_the_numbers_of_the_arrays():
    mesh = polydec.meshes.grid(4, 3)
    unused = np.array([0, 5, 21])
    used = np.setdiff1d(np.arange(len(mesh.points) + 3), unused)
    points = np.full((len(used) + 3, 2), 7.0)
    points[used] = mesh.points
    given = points, used[mesh.simplices]
    plain = polydec.discretize(mesh)
    with pytest.warns(polydec.PolydecWarning, match=said("3 vertices", "no cell")):
        c = polydec.discretize(given)
    assert np.array_equal(c.points, points) and np.array_equal(c.vertices, used)

    def same(values, expected):
        return np.isnan(values[unused]).all() and np.array_equal(values[used], expected)

    with pytest.warns(polydec.PolydecWarning):
        assert same(polydec.geodesic_distance(given, 6), polydec.geodesic_distance(mesh, 4))
    f = np.cos(points[:, 0])
    u = polydec.poisson(c, f, lambda x: x[:, 1]).values
    assert same(u, polydec.poisson(plain, f[used], lambda x: x[:, 1]).values)
    assert same(polydec.poisson(c, 0.0, f, essential=False, fixed=[6, 20]).values,
                polydec.poisson(plain, 0.0, f[used], essential=False, fixed=[4, 18]).values)
    assert same(polydec.heat(c, f, 0.1, 2), polydec.heat(plain, f[used], 0.1, 2))
    assert same(polydec.wave(c, f, 0.2, loss=abs(f), source=lambda t: t * f)[0],
                polydec.wave(plain, f[used], 0.2, loss=abs(f[used]),
                             source=lambda t: t * f[used])[0])

    with pytest.warns(polydec.PolydecWarning):
        modes = polydec.shape_spectrum(given, count=2, essential=True).modes
    assert same(modes, polydec.shape_spectrum(mesh, count=2, essential=True).modes)

    def later(complex, u, side, degree, boundary):
        run = polydec.Evolution(complex, u, side=side, degree=degree, diffusion=0.1,
                                essential=True, reaction=lambda t, w: u - w, boundary=boundary)
        run.march(0.1)
        return run.forms[0]

    assert same(later(c, f, "primal", 0, f), later(plain, f[used], "primal", 0, f[used]))
    assert same(later(c, f, "dual", 2, None), later(plain, f[used], "dual", 2, None))
    assert near(polydec.poisson(c, f, degree=2, side="dual").form.values,
                polydec.poisson(plain, f[used], degree=2, side="dual").form.values)
    assert near(polydec.gradient(c, f), polydec.gradient(plain, f[used]))
    assert np.array_equal(c.boundary_vertices(), used[plain.boundary_vertices()])
    assert np.array_equal(c.cells(2).corners, used[plain.cells(2).corners])
    assert np.array_equal(c.cochain(f, 0).values, f[used])
    assert same(polydec.sharp_pp(c, polydec.flat(c, "ppp", np.ones_like(points)))[:, 0],
                polydec.sharp_pp(plain, polydec.flat(plain, "ppp", np.ones((20, 2))))[:, 0])
    for ask in (lambda: polydec.geodesic_distance(c, 5),
                lambda: polydec.poisson(c, 1.0, fixed=[0])):
        refused(ask, "no cell", "vertex")


@pytest.fixture
def as_many_triangles_as_vertices():
    """A square of 18 triangles, 16 vertices, and 2 that no cell uses."""
    mesh = polydec.meshes.perturbed(polydec.meshes.grid(3, 3), 0.05)
    given = np.vstack([mesh.points, [[5, 5], [6, 6]]]), mesh.simplices
    with pytest.warns(polydec.PolydecWarning, match=said("2 vertices", "no cell")):
        return polydec.discretize(given, merge=False)


@pytest.mark.parametrize("kind", [{"degree": 2}, {"degree": 0, "side": "dual"}])
def test_the_kind_of_a_form_says_where_its_values_are(as_many_triangles_as_vertices, kind,
                                                      tmp_path):
    c = as_many_triangles_as_vertices
    areas = np.arange(18.0)
    form = c.cochain(areas, kind["degree"], kind.get("side", "primal"))
    assert '"values"' in polydec.view(c, areas, **kind).html
    polydec.write_vtu(tmp_path / "array.vtu", c, areas, **kind)
    polydec.write_vtu(tmp_path / "form.vtu", c, form)
    assert (tmp_path / "array.vtu").read_bytes() == (tmp_path / "form.vtu").read_bytes()
    polydec.view(c, np.ones((18, 2)), **kind)


def test_vectors_of_flats_are_where_their_kind_says(as_many_triangles_as_vertices):
    c, field = as_many_triangles_as_vertices, np.random.default_rng(2).random((18, 2))
    plain = polydec.discretize((c.points[:16], c.cells(2).corners.reshape(-1, 3)), merge=False)
    for kind, rows in (("ppp", field[:16]), ("pdp", field[:16]), ("dpp", field), ("dpd", field)):
        assert near(polydec.flat(c, kind, field).values, polydec.flat(plain, kind, rows).values)


@pytest.mark.parametrize("exponent", [-300, 200])
def test_all_is_in_the_units_of_the_input(exponent):
    size = 2.0 ** exponent
    mesh = polydec.meshes.kuhn([2, 2, 2])
    usual = polydec.discretize(mesh)
    with pytest.warns(polydec.PolydecWarning, match=said("far", "1")):
        c = polydec.discretize((mesh.points * size, mesh.simplices))
    assert c.unit != 1 and np.array_equal(c.points, size * usual.points)
    for k in range(4):
        form = np.cos(np.arange(c.size(k)))
        assert near(c.volumes(k) / size ** k, usual.volumes(k))
        assert near(c.dual_volumes(k) / size ** (3 - k), usual.dual_volumes(k))
        assert near(c.star(k) / size ** (3 - 2 * k), usual.star(k))
        assert near(c.laplacian(k) @ form * size ** 2, usual.laplacian(k) @ form)
        assert np.isclose(c.cochain(form, k).norm() / size ** (1.5 - k),
                          usual.cochain(form, k).norm())
        assert near(c.input.volumes(k) / size ** k, usual.input.volumes(k))
    field = np.array([[0, 1, 0], [0, 0, 2], [3, 0, 0]])
    for side in ("primal", "dual"):
        assert near(polydec.de_rham(c, 1, lambda x: x / size @ field, side=side) / size,
                    polydec.de_rham(usual, 1, lambda x: x @ field, side=side))
    for degree in range(3):
        stiffness, of_usual = (polydec.FormSpace(m, degree=degree, essential=True).stiffness()
                               for m in (c, usual))
        assert near((stiffness * size ** (2 * degree - 1)).toarray(), of_usual.toarray())
        assert near((c.stiffness(degree) * size ** (2 * degree - 1)).toarray(),
                    usual.stiffness(degree).toarray())
    if exponent < 0:
        refused(lambda: c.stiffness(3), "stiffness", "range")
    own = c.with_star(1, sp.diags(np.asarray(usual.star(1)) * size))
    assert near(own.star(1).diagonal() / size, usual.star(1))
    assert near(c.material_star(1, 2.0) / size, usual.material_star(1, 2.0))
