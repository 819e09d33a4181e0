# SPDX-License-Identifier: MIT
"""Vertices at one place and hanging nodes."""
import warnings

import numpy as np
import pytest

import polydec
from conftest import refused
from polydec import meshes


def exploded(mesh):
    """The cells with vertices of their own."""
    cells = np.asarray(mesh.simplices)
    return polydec.Mesh(np.asarray(mesh.points)[cells.ravel()],
                        np.arange(cells.size).reshape(cells.shape))


def side_by_side(coarse, fine, n):
    """Two unit cubes, one of them finer."""
    one, other = (meshes.kuhn([count] * n) for count in (coarse, fine))
    return polydec.Mesh(np.vstack([one.points, np.asarray(other.points) + np.eye(n)[0]]),
                        np.vstack([one.simplices, np.asarray(other.simplices) + len(one.points)]))


def volume(mesh):
    corners = np.asarray(mesh.points)[np.asarray(mesh.simplices)]
    return np.linalg.det(corners[:, 1:] - corners[:, :1])


@pytest.mark.parametrize("mesh", [meshes.torus(7, 5), meshes.icosphere(3), meshes.kuhn([2, 2, 2]),
                                  meshes.kuhn([1, 1, 1, 1])])
def test_welding_an_exploded_mesh_gives_it_back(mesh):
    welded = meshes.weld(exploded(mesh))
    assert len(welded.points) == len(mesh.points)
    corners = [np.asarray(each.points)[np.asarray(each.simplices)] for each in (mesh, welded)]
    assert np.array_equal(*corners)
    gone = mesh.simplices.size - len(mesh.points)
    assert len(meshes.unjoined_boundary(exploded(mesh)).coincident) == gone
    assert f"joined {gone} vertices" in welded.warnings[0]


def test_slits_are_warned_of_and_the_remedy_helps():
    slit = exploded(meshes.icosphere(3))
    with pytest.warns(polydec.PolydecWarning, match=r"coincide with others.*polydec\.meshes\.weld"):
        found = polydec.discretize(slit)
    assert any("coincide with others" in each for each in found.warnings)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", polydec.PolydecWarning)
        joined = polydec.discretize(meshes.weld(slit))
    assert list(joined.betti_numbers()) == [1, 0, 1]
    assert [each for each in joined.warnings if "slit" in each] == []


@pytest.mark.parametrize("n", [2, 3])
@pytest.mark.parametrize("coarse, fine", [(1, 2), (2, 4), (1, 3)])
def test_hanging_nodes_are_warned_of_and_joined(n, coarse, fine):
    mesh = side_by_side(coarse, fine, n)
    at_hand = meshes.unjoined_boundary(mesh)
    assert len(at_hand.hanging) == (fine + 1)**(n - 1) - (coarse + 1)**(n - 1)
    with pytest.warns(polydec.PolydecWarning, match=r"hang.*polydec\.meshes\.join_hanging"):
        polydec.discretize(mesh)
    joined = meshes.join_hanging(mesh)
    coincident, hanging, misfits = meshes.unjoined_boundary(joined)
    assert (len(coincident), len(hanging), misfits) == (0, 0, 0)
    assert volume(joined).min() > 0
    assert volume(joined).sum() == pytest.approx(volume(mesh).sum())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", polydec.PolydecWarning)
        assert list(polydec.discretize(joined).betti_numbers()) == [1] + [0] * n


def test_lengths_are_checked():
    for wrong in (-1, np.nan, np.inf):
        refused(lambda: meshes.weld(meshes.grid(1, 1), wrong), "length")
    apart = polydec.Mesh([[0, 0], [1, 0], [1, 1], [0, 1e-3], [1, 1 + 1e-3], [0, 1]],
                         [[0, 1, 2], [3, 4, 5]])
    assert len(meshes.weld(apart).points) == 6
    assert len(meshes.weld(apart, 0.01).points) == 4
