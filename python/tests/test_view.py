# SPDX-License-Identifier: MIT
"""Pages and grids hold what was given, under its names, and nothing from elsewhere."""
import html
import html.parser
import re

import numpy as np
import pytest

import polydec
from conftest import refused


class Frames(html.parser.HTMLParser):
    """What the frames of a text show."""

    def __init__(self, text):
        super().__init__()
        self.shown = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag == "iframe":
            self.shown.append(dict(attrs)["srcdoc"])


@pytest.mark.parametrize("degree", [0, 1, 2])
@pytest.mark.parametrize("side", ["primal", "dual"])
def test_forms_of_every_kind(sphere, side, degree):
    values = np.arange(sphere.size(degree, side), dtype=float)
    page = polydec.view(sphere, {"height <of> ground": values}, degree=degree, side=side,
                        title="A & B", facts=["Two."])
    assert "height \\u003cof\\u003e ground" in page.html
    assert "A &amp; B" in page.html and "Two." in page.html
    assert page.html == polydec.view(sphere, {"height <of> ground": values}, degree=degree,
                                     side=side, title="A & B", facts=["Two."]).html
    assert not re.search(r"(src|href)\s*=\s*.?https?:", page.html)
    other = polydec.view(sphere, {"height <of> ground": values + np.eye(1, len(values))[0]},
                         degree=degree, side=side, title="A & B", facts=["Two."])
    assert other.html != page.html


def test_meshes_of_every_dimension(tmp_path):
    for cells in ([3], [2, 2], [2, 2, 2]):
        mesh = polydec.meshes.kuhn(cells)
        c = polydec.discretize(mesh)
        counts = ", ".join(map(str, c.shape))
        assert counts + " after merging" in polydec.view(mesh).html
        polydec.write_vtu(tmp_path / "cells.vtu", c, c.volumes(c.dim))
        assert polydec.view(c, c.volumes(c.dim)).html
    refused(lambda: polydec.view(polydec.meshes.kuhn([1, 1, 1, 1])), 4)


def test_drawings(tmp_path, monkeypatch):
    grid = polydec.discretize(polydec.meshes.grid(2, 2))
    drawing = polydec.draw(grid, duals=True, cell=np.int64(4), matrix=1, numbers=True)
    assert "dual cell of vertex 4" in drawing.svg and "boundary of the edges" in drawing.svg
    assert drawing.svg == drawing._repr_svg_()
    both = polydec.draw(grid, both_duals=True, title="A & B").svg
    assert "A &amp; B: barycentric dual" in both
    drawing.save(tmp_path / "grid.svg")
    assert (tmp_path / "grid.svg").read_text() == drawing.svg
    cube = polydec.discretize(polydec.meshes.kuhn([1, 1, 1]), merge=False)
    assert polydec.draw(cube, explode=0.5).svg != polydec.draw(cube).svg
    monkeypatch.setenv("PATH", str(tmp_path))
    refused(lambda: drawing.save(tmp_path / "grid.png"),
            "librsvg2-bin", error=polydec.BackendUnavailable)
    for wrong in (dict(cell=99), dict(cell=-1), dict(explode=1), dict(matrix=3), dict(eye=[1, 2])):
        with pytest.raises(polydec.InvalidInput):
            polydec.draw(grid if "eye" not in wrong else polydec.meshes.goldberg(2), **wrong)


def test_a_spectrum_with_its_proof(sphere):
    modes = polydec.spectrum(sphere, count=4)
    text = polydec.view(sphere, modes).html
    assert all(f"mode_{i}" in text for i in range(4))
    assert "certified: " in text and f"{modes.eigenvalues[3]:.12g}" in text
    rough = polydec.spectrum(sphere, count=4, certified=False)
    assert "not certified: " in polydec.view(sphere, rough).html


def test_times(square):
    u = np.outer(square.points[:, 0], [1.0, 0.5, 0.25])
    moving = polydec.view(square, u, times=[0, 0.1, 0.2])
    assert len(moving.html) > len(polydec.view(square, u[:, 0]).html)
    refused(lambda: polydec.view(square, u, times=[0, 0.1]), "values", "3 columns", "expected", 2)


def fields_of(c, factor=1.0):
    """Forms of all degrees and sides, and vectors at vertices and at cells."""
    def numbers(*shape):
        return factor * np.random.default_rng(4).random(shape)

    fields = {f"{side}{k}": polydec.Cochain(numbers(c.size(k, side)), k, side)
              for side in ("primal", "dual") for k in range(c.dim + 1)}
    width = c.points.shape[1]
    return {"wind": numbers(c.size(0), width), "flow": numbers(c.size(c.dim), width), **fields,
            "height": numbers(c.size(0)), "pressure": numbers(c.size(c.dim))}


def read_by_vtk(path):
    """The arrays at points, at cells and of the whole, by VTK's own library, which ParaView uses."""
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    return [{data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
             for i in range(data.GetNumberOfArrays())}
            for data in (grid.GetPointData(), grid.GetCellData(), grid.GetFieldData())]


def check_by_vtk(path, c, fields):
    parts = read_by_vtk(path)
    for name, given in fields.items():
        values = getattr(given, "values", given)
        k = {c.size(j): j for j in range(c.dim + 1)}[len(values)]
        found = parts[0 if k == 0 else 1 if k == c.dim else 2][name]
        assert np.array_equal(found[:, :values.shape[1]] if values.ndim == 2 else found, values)
    assert {"primal1_vector", "dual1_vector"} <= parts[0].keys()


def test_many_fields_together(sphere, tmp_path):
    for c in (sphere, polydec.discretize(polydec.meshes.kuhn([3, 2, 1]))):
        fields = fields_of(c)
        page = polydec.view(c, fields)
        assert all(f'"name":"{name}"' in page.html for name in fields)
        polydec.write_vtu(tmp_path / "all.vtu", c, fields)
        check_by_vtk(tmp_path / "all.vtu", c, fields)
        with polydec.Series(tmp_path / "all.pvd", c) as film:
            for time in (1.0, 2.0):
                film.add(time, fields_of(c, time))
        check_by_vtk(tmp_path / "all" / "all_0001.vtu", c, fields_of(c, 2.0))


def test_vectors_in_time(square):
    wind = np.stack([square.points, 3 * square.points, 2 * square.points], axis=2)
    moving = polydec.view(square, {"wind": wind, "u": wind[:, 0]}, times=[0, 0.1, 0.2]).html
    assert '"step":1,' in moving and '"steps":["0","0.1","0.2"]' in moving
    refused(lambda: polydec.view(square, {"wind": wind[..., :2]}, times=[0, 0.1, 0.2]),
            "wind", "2 columns", "expected", 3)


def test_notebooks_show_the_page_in_a_frame(sphere):
    page = polydec.view(sphere)
    assert Frames(page._repr_html_()).shown == [page.html]
    assert "MB" in repr(page)


def test_files(sphere, tmp_path):
    page = polydec.view(sphere)
    page.save(tmp_path / "sphere.html")
    assert (tmp_path / "sphere.html").read_text(encoding="utf-8") == page.html
    error = refused(lambda: page.save(tmp_path / "none" / "sphere.html"), error=polydec.IoError)
    assert error.path == str(tmp_path / "none" / "sphere.html")
    error = refused(lambda: polydec.write_vtu(tmp_path / "none" / "sphere.vtu", sphere),
                     error=polydec.IoError)
    assert error.path


def test_what_cannot_be_drawn(sphere):
    for draw in (polydec.view, lambda c, forms: polydec.write_vtu("none.vtu", c, forms)):
        refused(lambda: draw(sphere, np.ones(7)))
        refused(lambda: draw(sphere, {"a": np.ones((7, 3))}), 7, "rows", "a", sphere.size(2))
        refused(lambda: polydec.view(sphere, {"a": np.ones((sphere.size(1), 3))}, degree=1),
                "a", "degree 1", "vertices")
    refused(lambda: polydec.view(polydec.meshes.length_mesh(polydec.meshes.goldberg(2))))
