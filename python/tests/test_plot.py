# SPDX-License-Identifier: MIT
"""What `plot` draws, by numbers."""
import numpy as np
import pytest

import polydec
from conftest import near, refused

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import mpl_toolkits.mplot3d  # noqa: E402


@pytest.fixture(autouse=True)
def close():
    yield
    plt.close("all")


def square(n=6):
    return polydec.discretize(polydec.meshes.grid(n, n))


def sphere(n=3):
    return polydec.discretize(polydec.meshes.goldberg(n))


def colors_of(ax):
    """Red, green and blue of the polygons that are drawn last, in their order."""
    polygons = ax.collections[-1]
    return polygons.to_rgba(polygons.get_array())[:, :3]


@pytest.mark.parametrize("make", [square, sphere])
def test_the_axes_that_are_given_are_returned(make):
    c = make()
    ax = plt.figure().add_subplot(projection=None if make is square else "3d")
    assert polydec.plot(c, c.volumes(2), degree=2, ax=ax, bar=None) is ax
    assert ax.figure.axes == [ax]
    assert len(polydec.plot(c, c.volumes(2), degree=2).figure.axes) == 2
    assert len(polydec.plot(c).figure.axes) == 1


def test_noise_around_a_constant_is_not_shown():
    c = square()
    for value in (-0.3, 0, 2e9):
        noisy = value * (1 + 1e-13 * np.random.default_rng(1).normal(size=36))
        shown = colors_of(polydec.plot(c, noisy, degree=2))
        assert np.ptp(shown, axis=0).max() < 0.01
        assert shown[0] == pytest.approx(colors_of(polydec.plot(c, np.ones(36), degree=2))[0], abs=0.01)


@pytest.mark.parametrize("make", [square, sphere])
def test_several_fields_are_drawn_beside_each_other(make):
    c = make()
    fields = {"area": c.volumes(2), "height": c.points[:, -1], "grad": c.cochain(c.points[:, 0], 0).d()}
    axes = polydec.plot(c, fields)
    assert len({ax.get_position().bounds for ax in axes}) == 3
    for ax, (name, values) in zip(axes, fields.items()):
        one = polydec.plot(c, values, bar=name)
        assert (colors_of(ax) == colors_of(one)).all()
        assert ax.figure.axes[-1].get_ylabel() == "grad"
        assert getattr(ax, "elev", None) == getattr(one, "elev", None)
    assert polydec.plot(c, {"area": c.volumes(2)}, ax=axes[0])[0] is axes[0]
    assert len(polydec.plot(c, polydec.spectrum(c, count=2))) == 2
    refused(lambda: polydec.plot(c, fields, ax=axes[:2]), "2 axes for 3 fields")
    refused(lambda: polydec.plot(c, {}), "no field")


def test_the_label_of_the_bar():
    axes = polydec.plot(square(), np.arange(36.0), bar="speed").figure.axes
    assert "speed" in axes[1].get_ylabel()


def test_values_of_both_signs_have_a_range_around_zero():
    c = square()
    for values, limits in ((np.linspace(1, 4, 36), (1, 4)), (np.linspace(-1, 4, 36), (-4, 4))):
        polygons = polydec.plot(c, values, degree=2).collections[-1]
        assert polygons.get_clim() == pytest.approx(limits)
    zero = polydec.plot(c, np.where(np.arange(36) == 7, 0, np.linspace(-1, 4, 36)), degree=2)
    assert colors_of(zero)[7].min() > 0.9
    own = polydec.plot(c, np.linspace(-1, 4, 36), degree=2, cmap="viridis").collections[-1]
    assert own.get_clim() == pytest.approx((-1, 4))


def test_colors_in_the_plane_are_the_maps():
    values = np.linspace(0, 1, 36)
    names, low, high = polydec._core.colors(0, 1)
    assert (low, high) == (0, 1)
    ends = [[int(name[i:i + 2], 16) / 255 for i in (1, 3, 5)] for name in (names[0], names[-1])]
    shown = colors_of(polydec.plot(square(), values, degree=2))
    assert np.allclose(shown[[0, -1]], ends, atol=0.01)


def test_surfaces_are_lit():
    c = sphere()
    shown = colors_of(polydec.plot(c, np.ones(c.size(2)), degree=2))
    # all have one value: the light alone makes the difference
    brightness = shown[:, 0] / shown[:, 0].max()
    assert brightness.min() < 0.8
    assert np.allclose(shown / shown[:, :1], shown[0] / shown[0, 0])
    brightest = c.centroids(2)[brightness.argmax()]
    assert brightest[2] > 0.5 or brightest[2] < -0.5  # from above, and the back like the front


def test_many_polygons_have_no_edges():
    for n, has_edges in ((60, True), (70, False)):
        drawn = polydec.plot(square(n)).collections[-1]
        assert (len(drawn.get_edgecolor()) > 0) == has_edges


def test_arrows_of_a_one_form_in_the_plane():
    c = square(40)
    ax = polydec.plot(c, c.cochain(c.points @ [3.0, 4.0], 0).d())
    quiver, polygons = ax.collections
    assert np.allclose(polygons.get_array(), 5)
    angles = np.arctan2(quiver.V, quiver.U)
    assert np.allclose(angles, np.arctan2(4, 3)) and 100 < len(angles) <= 784


@pytest.mark.parametrize("mesh", [polydec.meshes.grid(6, 5), polydec.meshes.well_centered(5)])
@pytest.mark.parametrize("side", ["primal", "dual"])
def test_arrows_of_one_forms_point_along_their_fields(mesh, side):
    c = polydec.discretize(mesh)
    form = polydec.de_rham(c, 1, lambda x: [3.0, 4.0] + 0 * x, side=side)
    quiver = polydec.plot(c, c.cochain(form, 1, side)).collections[0]
    assert np.allclose(np.arctan2(quiver.V, quiver.U), np.arctan2(4, 3))


def darts_of(ax):
    """The arrows among the polygons: their begin and tip."""
    polygons = ax.collections[-1]
    numbers = np.flatnonzero(np.ma.getmaskarray(polygons.get_array()))
    corners = np.split(polygons._vec[:3].T, np.cumsum([s.stop - s.start for s in
                                                       polygons._segslices])[:-1])
    found = [corners[i] for i in numbers]
    return (np.array([(p[0] + p[6]) / 2 for p in found]), np.array([p[3] for p in found]))


def test_arrows_on_a_curved_surface_are_tangent_and_do_not_meet():
    c = sphere(8)
    field = np.cross([0, 0, 1], c.centroids(2))
    begin, tip = darts_of(polydec.plot(c, field))
    middle, ray = (begin + tip) / 2, tip - begin
    assert len(begin) > 100
    outward = middle / np.linalg.norm(middle, axis=1)[:, None]
    assert abs((ray * outward).sum(axis=1)).max() < 0.15 * np.linalg.norm(ray, axis=1).max()
    around = np.cross([0, 0, 1], middle)
    assert ((ray * around).sum(axis=1) > 0).all()
    # one outside and one inside the surface, and half a cube to the next at least
    assert np.linalg.norm(middle, axis=1).min() < 0.99 < np.linalg.norm(middle, axis=1).max()


def test_one_forms_of_both_sides_and_vectors_give_one_picture():
    c = square(5)
    form = c.cochain(c.points @ [1.0, 2.0], 0).d()
    vectors = polydec.sharp_pd(c, form)
    dual = form.star()
    shown = [polydec.plot(c, values).collections[-1].get_array()
             for values in (form, vectors, np.tile([1.0, 2.0], (c.size(0), 1)), dual)]
    for each in shown:
        assert np.allclose(each, np.sqrt(5))


def test_fields_are_shown_where_their_kind_says():
    c = polydec.discretize(polydec.meshes.torus(8, 6))         # as many quadrilaterals as vertices
    values = np.arange(48.0)
    for kind in ({"degree": 2}, {"degree": 0, "side": "dual"}):
        for field in (values, np.outer(values, [3.0, 0, 4.0]) / 5):
            shown = polydec.plot(c, field, **kind).collections[-1].get_array()
            assert near(shown.compressed(), values)
    wind = polydec.sharp_pd(c, c.d(0) @ c.points[:, 0])
    shown = polydec.plot(c, c.cochain(c.points[:, 0], 0).d()).collections[-1].get_array()
    assert near(shown.compressed(), np.linalg.norm(wind, axis=1), 1e-9)


def test_what_is_on_no_polygon_is_refused():
    for c in (square(3), polydec.discretize(polydec.meshes.kuhn([2, 2, 2]))):
        for values, kind in ((np.ones(7), {}), (np.ones(c.size(1)), {"degree": 1, "side": "dual"})):
            if c.dim == 3:
                refused(lambda: polydec.plot(c, values, **kind), "expected", c.size(0), c.size(2))
        refused(lambda: polydec.plot(c, np.ones((7, c.dim))), 7, "expected", c.size(c.dim))
        faces = polydec.plot(c, np.ones(c.size(2))).collections[-1].get_array()
        assert (np.ma.compressed(faces) == 1).all()


def test_vectors_of_the_cells_of_a_solid():
    c = polydec.discretize(polydec.meshes.kuhn([3, 3, 3]))
    vectors = np.tile([0.0, 3.0, 4.0], (c.size(3), 1))
    values = polydec.plot(c, vectors).collections[-1].get_array()
    assert np.allclose(values.compressed(), 5)
    assert len(values.compressed()) == c.boundary_facets().sum()


def test_the_axis_of_pages_points_up():
    c = sphere()
    for up, axis in ((None, 2), ("x", 0), ("y", 1), ("z", 2)):
        ax = polydec.plot(c, up=up)
        ax.figure.canvas.draw()
        # two points above each other are one above the other in the picture
        ends = np.stack([-np.eye(3)[axis], np.eye(3)[axis]])
        x, y, _ = mpl_toolkits.mplot3d.proj3d.proj_transform(*ends.T, ax.get_proj())
        assert abs(x[1] - x[0]) < 1e-9 and y[1] > y[0]
        # and the eye is that of pages: nearer points have less depth
        eye = polydec._core.first_view("", axis)[1]
        _, _, depth = mpl_toolkits.mplot3d.proj3d.proj_transform(
            *np.stack([np.zeros(3), 0.1 * eye]).T, ax.get_proj())
        assert depth[1] < depth[0]
    refused(lambda: polydec.plot(c, up="w"), "up is 'w'")
