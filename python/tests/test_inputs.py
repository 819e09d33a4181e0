# SPDX-License-Identifier: MIT
"""Arrays of any layout, and refusals that say what is wrong, where, to people and to programs."""
import numpy as np
import pytest

import polydec
from conftest import refused, said

POINTS = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]])


@pytest.mark.parametrize("points", [
    POINTS.tolist(), POINTS.astype(np.float32), POINTS.astype(int), np.asfortranarray(POINTS),
    np.repeat(POINTS, 2, axis=0)[::2], POINTS[::-1][::-1], POINTS.astype(bool),
    POINTS.astype(">f8"), POINTS.astype(np.float16)])
def test_points_of_any_layout(points):
    assert np.array_equal(polydec.Mesh(points, TRIANGLES).points, POINTS)


@pytest.mark.parametrize("kind", [np.int8, np.int16, np.int32, np.int64, np.uint8, np.uint64, ">i4"])
def test_simplices_of_any_type(kind):
    mesh = polydec.Mesh(POINTS, TRIANGLES.astype(kind))
    assert mesh.simplices.dtype == np.int32 and np.array_equal(mesh.simplices, TRIANGLES)
    columns = np.asfortranarray(TRIANGLES.astype(kind))
    assert np.array_equal(polydec.Mesh(POINTS, columns).simplices, TRIANGLES)
    wide = np.zeros((2, 6), dtype=kind)
    wide[:, ::2] = TRIANGLES
    assert np.array_equal(polydec.Mesh(POINTS, wide[:, ::2]).simplices, TRIANGLES)


@pytest.mark.parametrize("points, simplices, words", [
    (POINTS[0], TRIANGLES, ("points", "(2,)", "expected", "2 axes")),
    (POINTS, TRIANGLES[0], ("simplices", "(3,)", "expected", "2 axes")),
    (POINTS * 1j, TRIANGLES, ("points", "complex128", "expected real numbers")),
    (POINTS, TRIANGLES + 0.5, ("simplices", "float64", "expected whole numbers")),
    ([["a", "b"]], TRIANGLES, ("points", "<U1", "expected real numbers")),
    ([[0, 0], [1]], TRIANGLES, ("points", "array")),
    (POINTS, [[0, 1, 2 ** 40]], (2 ** 40, "row 0", "32 bits")),
    (POINTS, np.array([[0, 1, 2 ** 63]], dtype=np.uint64), ("32 bits",)),
])
def test_arrays_that_are_refused(points, simplices, words):
    refused(lambda: polydec.Mesh(points, simplices), *words)


def refused_mesh(mesh, *words, **options):
    return refused(lambda: polydec.discretize(mesh, **options), *words)


def test_meshes_that_are_refused_say_where():
    outside = refused_mesh(polydec.Mesh(POINTS, [[0, 1, 2], [0, 2, 9]]), 9)
    assert isinstance(outside, ValueError)
    refused_mesh(polydec.Mesh(POINTS, [[0, 1, 2], [0, 2, -3]]), "-3")
    nan = POINTS.copy()
    nan[3, 1] = np.nan
    refused_mesh(polydec.Mesh(nan, TRIANGLES), 3)
    inf = POINTS.copy()
    inf[2, 0] = np.inf
    refused_mesh(polydec.Mesh(inf, TRIANGLES), 2)
    assert refused_mesh(polydec.Mesh(np.zeros((0, 2)), np.zeros((0, 3), int)))
    assert refused_mesh(polydec.Mesh([], []))
    assert refused_mesh(polydec.Mesh(POINTS, TRIANGLES, tags=[1, 2, 3]))


def test_places_of_errors():
    c = polydec.discretize(polydec.meshes.hexagons(12), star="circumcentric")
    error = refused(lambda: c.inverse_star(1))
    assert error.degree == 1 and len(error.cells) == len(c.zeros(1)) > 5
    assert error.path is None and error.line is None


def test_options_that_there_are_not():
    mesh = polydec.Mesh(POINTS, TRIANGLES)
    refused_mesh(mesh, "delaunay", '"always"', "expected", '"off", "flips"', delaunay="always")
    refused_mesh(mesh, "star", '"own"', "expected", '"circumcentric"', star="own")
    refused_mesh(mesh, "tolerance", tolerance=-1.0)
    with pytest.raises(TypeError):
        polydec.discretize(mesh, 1e-4) # by name alone


def test_files(tmp_path):
    missing = refused(lambda: polydec.read_mesh(tmp_path / "none.off"), error=polydec.IoError)
    assert missing.path == str(tmp_path / "none.off") and isinstance(missing, OSError)
    broken = tmp_path / "broken.off"
    broken.write_text("OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n")
    malformed = refused(lambda: polydec.read_mesh(broken))
    assert malformed.path == str(broken) and malformed.line == 4
    mesh = polydec.Mesh(POINTS, TRIANGLES, tags=[4, 5], facets=[[0, 1]], facet_tags=[9])
    polydec.write_mesh(tmp_path / "square.mesh", mesh)
    again = polydec.read_mesh(tmp_path / "square.mesh")
    assert np.array_equal(again.points, POINTS) and list(again.tags) == [4, 5]
    assert again.facets.tolist() == [[0, 1]] and list(again.facet_tags) == [9]
    lengths = polydec.meshes.length_mesh(mesh)
    polydec.write_lengths(str(tmp_path / "square.nsl"), lengths)
    assert np.array_equal(polydec.read_lengths(tmp_path / "square.nsl").lengths, lengths.lengths)


def test_lengths_alone():
    mesh = polydec.meshes.length_mesh(polydec.meshes.well_centered(4))
    c = polydec.discretize(mesh)
    assert np.allclose(c.volumes(2).sum(), 1.0) and c.points.shape[1] == 0
    assert np.allclose(polydec.spectrum(c, count=4).eigenvalues,
                       polydec.spectrum(polydec.discretize(polydec.meshes.well_centered(4)),
                                        count=4).eigenvalues)
    refused(lambda: polydec.de_rham(c, 1, lambda x: x), "lengths")
    refused(lambda: polydec.LengthMesh([[0, 1, 2]], [[0, 1], [1, 2]], [1.0, 1.0]))


def test_forms_that_do_not_fit(square):
    refused(lambda: square.cochain(square.points[:, 0], 1), "primal 1-form", "59 values")
    refused(lambda: square.norm(square.points[:, 0]), "degree")
    refused(lambda: square.cochain(square.points[:, 0], 0) + square.cochain(square.volumes(2), 2),
            "kind")
    refused(lambda: square.norm(np.full(square.size(0), np.nan), 0))
    refused(lambda: polydec.poisson(square, [1, 2, 3]), "3 values", "f", "expected one, or 59")
    refused(lambda: polydec.poisson(square, 1.0, essential=[0, 1]), "essential", "int64")
    refused(lambda: polydec.poisson(square, 1.0, essential=[True, False]), "essential", "shape")
    refused(lambda: polydec.de_rham(square, 1, lambda x: x[:, 0]), "form", "shape")


def test_values_at_vertices_inside_and_conditions_that_match_nothing():
    square = polydec.discretize(polydec.meshes.grid(8, 8))
    x, y = square.points.T
    center = (abs(x - .5) < .01) & (abs(y - .5) < .01)
    corner = (abs(x * (1 - x)) < 1e-9) & (abs(y * (1 - y)) < 1e-9)
    by_mark = polydec.poisson(square, 0.0, center, essential=False, fixed=center | corner).values
    by_place = polydec.poisson(square, 0.0, center, essential=False,
                               fixed=lambda p: (p[:, 0] == .5) & (p[:, 1] == .5)
                               | (p[:, 0] * (1 - p[:, 0]) + p[:, 1] * (1 - p[:, 1]) == 0)).values
    by_number = polydec.poisson(square, 0.0, center, essential=False,
                                fixed=np.flatnonzero(center | corner)).values
    assert by_mark[center] == 1 and (by_mark[corner] == 0).all()
    assert np.allclose(by_mark, by_place) and (by_mark == by_number).all()
    edge = polydec.poisson(square, 1.0, essential=False, fixed="boundary").values
    assert np.allclose(edge, polydec.poisson(square, 1.0).values)
    assert polydec.spectrum(square, count=1, fixed=center).eigenvalues[0] > .1
    facets = np.zeros(square.size(1), dtype=bool)
    inner = ~square.boundary_facets()
    for ask in (lambda: polydec.poisson(square, 1.0, essential=facets),
                lambda: polydec.poisson(square, 1.0, essential=inner),
                lambda: polydec.spectrum(square, essential=lambda p: p[:, 0] > 2),
                lambda: polydec.heat(square, x, 0.1, essential=facets)):
        refused(ask, "essential", "none", "32 boundary facets")
    refused(lambda: polydec.poisson(square, 1.0, essential=[3, 4]), "fixed")
    for bad in ([81], [-1], [], np.zeros(81, dtype=bool)):
        refused(lambda: polydec.poisson(square, 1.0, fixed=bad), "fixed")
    refused(lambda: polydec.poisson(square, 1.0, side="dual", fixed=center),
            "vertices", "primal 0-forms")


def test_distances_from_chosen_vertices():
    square = polydec.discretize(polydec.meshes.grid(8, 8))
    far = polydec.geodesic_distance(square, "boundary")
    assert (far[square.boundary_vertices()] == 0).all() and abs(far.max() - .5) < 1e-15
    left = square.points[:, 0] < .01
    assert (polydec.geodesic_distance(square, left)
            == polydec.geodesic_distance(square, lambda p: p[:, 0] < .01)).all()
    assert (polydec.geodesic_distance(square, left)
            == polydec.geodesic_distance(square, np.flatnonzero(left))).all()
    refused(lambda: polydec.geodesic_distance(square, "wall"), "group", "wall")
    refused(lambda: polydec.geodesic_distance(square, left & ~left), "sources", "0 of 81")


def test_hybrid_stars_come_with_their_cure():
    points = np.array([[0, 0], [2, 0], [1, .5]])
    with pytest.warns(polydec.PolydecWarning, match=said("hybrid", "flips_and_splits")) as warned:
        polydec.discretize((points, [[0, 1, 2]]))
    assert {warning.filename for warning in warned} == {__file__}, "the line of the caller"


def test_masks_and_quadrilaterals_are_asked_about():
    square = polydec.discretize(polydec.meshes.grid(3, 3))
    ones, facets = np.ones(square.size(0)), square.boundary_facets()
    holes = np.ma.masked_array(ones, mask=np.arange(len(ones)) == 3)
    for ask in (lambda: polydec.poisson(square, holes),
                lambda: polydec.poisson(square, 1.0, essential=np.ma.masked_array(facets, facets)),
                lambda: polydec.poisson(square, lambda x: holes[:len(x)]),
                lambda: polydec.de_rham(square, 0, lambda x: np.ma.masked_less(x[:, 0], .1)),
                lambda: polydec.PoissonSolver(square).solve(derivative_flow=holes),
                lambda: polydec.FormSpace(square).extend(holes),
                lambda: polydec.geodesic_distance(square, np.ma.masked_less([0, 5], 1))):
        refused(ask, "masked")
    assert polydec.poisson(square, np.ma.masked_array(ones)).values.shape == ones.shape
    corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 1], [2, 1, 1]]
    refused(lambda: polydec.discretize((corners, [[0, 1, 2, 3], [1, 4, 5, 2]])),
            "triangle", "split_polygons")
    box = polydec.meshes.kuhn([2, 2, 2])
    assert polydec.discretize((box.points, box.simplices)).size(3) == 8


def test_values_at_places_are_lists():
    square = polydec.discretize(polydec.meshes.grid(4, 4))
    u, ones = np.ones(square.size(0)), np.ones(square.size(1))
    rows, flux = np.column_stack([u, 1000 * u]), np.column_stack([ones, ones])
    for name, ask in (("f", lambda: polydec.poisson_error(square, u, rows)),
                      ("f", lambda: polydec.poisson(square, lambda x: x)),
                      ("u", lambda: polydec.poisson_error(square, rows)),
                      ("goal", lambda: polydec.goal_interval(square, u, goal=rows)),
                      ("boundary", lambda: polydec.poisson(square, 1.0, rows)),
                      ("derivatives", lambda: polydec.poisson_error(square, u, 1.0, flux)),
                      ("derivatives", lambda: polydec.outward_flow(square, flux))):
        refused(ask, name, "shape", 2, "list of numbers")
    refused(lambda: square._cells.solve_star(0, rows), "2 axes", "list of numbers")


def test_groups_have_names(grouped_square):
    mesh = polydec.read_mesh(grouped_square)
    assert mesh.groups == [(1, 7, "the wall"), (2, 1, "plate")]
    square = polydec.discretize(mesh)
    wall = square.facets_in("the wall")
    assert wall.sum() == 1 and (wall == square.facets_in(7)).all()
    assert (wall == (square.facet_tags == 7)).all()
    refused(lambda: square.facets_in("plate"), "plate", "the wall")


def test_what_stands_for_a_mesh(tmp_path):
    path = tmp_path / "square.nsc"
    polydec.write_mesh(path, polydec.Mesh(POINTS, TRIANGLES))
    lengths = tmp_path / "square.nsl"
    polydec.write_lengths(lengths, polydec.meshes.length_mesh(polydec.Mesh(POINTS, TRIANGLES)))
    for given in [path, str(path), lengths, str(lengths), (POINTS, TRIANGLES),
                  [POINTS.tolist(), TRIANGLES.tolist()], polydec.Mesh(POINTS, TRIANGLES)]:
        assert polydec.discretize(given).shape == (4, 4, 1)
        assert np.allclose(polydec.spectrum(given, count=2).eigenvalues, [0, 4])
    assert polydec.harmonic_forms(str(path), 1).shape == (4, 0)
    assert np.allclose(polydec.poisson(path, 0.0, 7.0), 7.0)
    assert polydec.geodesic_distance(path, 0)[0] == 0


@pytest.mark.parametrize("given, words", [
    (POINTS, ("array", "(4, 2)", "mesh", "expected", "Mesh", "path")),
    (None, ("NoneType", "mesh")),
    ((POINTS, TRIANGLES, 1), ("tuple", "mesh")),
    ((POINTS, TRIANGLES + 0.5), ("simplices", "float64")),
    ((TRIANGLES, POINTS), ("simplices", "float64"))])
def test_what_stands_for_no_mesh(given, words):
    for taken in (polydec.discretize, polydec.spectrum, polydec.plot):
        refused(lambda: taken(given), *words)


def test_where_cells_alone_do_not_suffice(square):
    refused(lambda: polydec.geodesic_distance(square.input, 0), "expected", "Complex")
    refused(lambda: polydec.de_rham(polydec.Mesh(POINTS, TRIANGLES), 1, lambda x: x),
            "Mesh", "expected", "Complex")


def test_missing_files_are_named():
    missing = refused(lambda: polydec.discretize("there is none.off"), error=polydec.IoError)
    assert missing.path == "there is none.off"


def test_polygons(square):
    hexagon = [[np.cos(a), np.sin(a)] for a in np.arange(6) * np.pi / 3]
    points = hexagon + [[2, 0], [2, 1]]
    c = polydec.discretize(polydec.split_polygons(points, [range(6), [0, 6, 7]], [3, 4]))
    assert c.shape == (8, 9, 2) and sorted(c.tags) == [3, 4]
    refused(lambda: polydec.split_polygons(points, [[0, 1, 9]]), 9)
    refused(lambda: polydec.split_polygons(points, [[0, 1, 2], [0.5, 1, 2]]),
            "corners", "polygon 1", "float64")


def test_solids_of_meshio():
    meshio = pytest.importorskip("meshio")
    z, y, x = np.indices((2, 2, 3)).reshape(3, -1)
    points = np.column_stack([x, y, z]).astype(float)
    h = np.array([0, 1, 4, 3, 6, 7, 10, 9])
    tags = {"gmsh:physical": [np.array([4, 5]), np.array([6])]}
    boxes = polydec.as_mesh(meshio.Mesh(
        points, [("hexahedron", [h, h + 1]), ("quad", [[0, 3, 9, 6]])], cell_data=tags))
    assert boxes.simplices.shape == (12, 4) and sorted(set(boxes.tags)) == [4, 5]
    assert len(boxes.facets) == 2 and list(boxes.facet_tags) == [6, 6]
    with pytest.warns(polydec.PolydecWarning, match="2 solids"):
        assert polydec.discretize(boxes).shape == (12, 20, 11, 2)
    for name, corners, volume in (("wedge", h[[0, 1, 2, 4, 5, 6]], 1 / 2), ("pyramid", h[:5], 1 / 3),
                                  ("hexahedron20", [*h, *[11] * 12], 1), ("tetra10", [0, 1, 3, 6, *[11] * 6], 1 / 6),
                                  ("voxel", [0, 1, 3, 4, 6, 7, 9, 10], 1)):
        mesh = polydec.as_mesh(meshio.Mesh(points, [(name, [corners])])
                               if name != "voxel" else _Cells(points, name, [corners]))
        edges = mesh.points[mesh.simplices[:, 1:]] - mesh.points[mesh.simplices[:, :1]]
        assert np.isclose(abs(np.linalg.det(edges)).sum() / 6, volume)
        assert any("higher order" in warning for warning in mesh.warnings) == name[-1].isdigit()


class _Cells:
    """What stands for a meshio.Mesh with cells of a type that meshio's class may not know."""
    cell_data: dict = {}

    def __init__(self, points, kind, cells):
        self.points = points
        self.cells = [type("Block", (), {"type": kind, "data": np.array(cells)})]


def test_meshes_of_meshio():
    meshio = pytest.importorskip("meshio")
    quads = [("triangle", [[0, 1, 4]]), ("quad", [[0, 1, 2, 3]]), ("line", [[0, 1], [1, 2]]),
             ("vertex", [[0]])]
    points = np.vstack([POINTS, [[0.5, -1]]])
    tags = {"gmsh:physical": [np.array([7]), np.array([8]), np.array([5, 0]), np.array([1])]}
    mesh = polydec.as_mesh(meshio.Mesh(points, quads, cell_data=tags))
    assert mesh.simplices.tolist()[0] == [0, 1, 4] and list(mesh.tags) == [7, 8, 8]
    assert mesh.facets.tolist() == [[0, 1]] and list(mesh.facet_tags) == [5]
    assert polydec.discretize(mesh).shape == (5, 6, 2)
    rough = {"gmsh:physical": [values + 0.5 for values in tags["gmsh:physical"]]}
    assert len(polydec.as_mesh(meshio.Mesh(points, quads, cell_data=rough)).tags) == 0
    cube = polydec.discretize(polydec.meshes.kuhn([1, 1, 1]), merge=False)
    assert polydec.discretize(polydec.to_meshio(cube)).shape == (8, 12, 6, 1)
    torus = polydec.discretize(polydec.meshes.torus(8, 6))     # as many quadrilaterals as vertices
    glued = polydec.discretize(polydec.periodic(polydec.meshes.grid(4, 4), [[1, 0], [0, 1]]))
    for c in (torus, glued):
        u, area = np.arange(c.size(0)), c.cochain(c.volumes(2), 2)
        made = polydec.to_meshio(c, {"u": u, "area": area, "by": area.star(),
                                     "wind": np.outer(u, [1.0, 2.0])})
        assert set(made.point_data) == {"u", "wind"} and set(made.cell_data) == {"area", "by"}
        assert np.array_equal(made.point_data["wind"], np.outer(made.point_data["u"], [1, 2]))
        refused(lambda: polydec.to_meshio(c, {"du": c.cochain(u, 0).d()}), "du", "1-form", "2-cells")
    with pytest.raises(polydec.InvalidInput, match=said("cells", "polyhedron8", "expected tetra")):
        polydec.discretize(meshio.Mesh(np.zeros((8, 3)), [("polyhedron8", [list(range(8))])]))
    refused(lambda: polydec.discretize(meshio.Mesh(points, [("quad", [[0, 1, 2, 9]])])),
            "cell 0", "vertex 9", "0 to 4")
    refused(lambda: polydec.discretize(meshio.Mesh(points, [("vertex", [[0]])])),
            "mesh", "no cells")


@pytest.mark.parametrize("by_lengths", [False, True])
def test_refined_meshes_have_short_edges_and_values_for_each_cell(by_lengths):
    mesh = polydec.Mesh(POINTS, TRIANGLES)
    if by_lengths:
        edges = np.array([[0, 1], [1, 2], [2, 3], [0, 3], [0, 2]])
        mesh = polydec.LengthMesh(TRIANGLES, edges, [1, 1, 1, 1, 2 ** 0.5])
    fine = polydec.discretize(mesh, refine=0.3, merge=False)
    assert fine.options["refine"] == 0.3
    assert fine.volumes(1).max() <= 0.3 * (1 + 1e-11) and fine.size(2) == 64
    assert np.isclose(fine.volumes(2).sum(), 1)
    assert fine.with_conductivity([1, 2], "primal").size(2) == 64
    refused_mesh(mesh, "above 0", refine=0)
    refused_mesh(mesh, "at least", "1e+08", refine=1e-7)
