# SPDX-License-Identifier: MIT
"""Vertices at one place and hanging nodes: what is found and joined is tested in C++."""
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


def side_by_side(coarse, fine):
    """Two unit squares, one of them finer."""
    one, other = meshes.grid(coarse, coarse), meshes.grid(fine, fine)
    return polydec.Mesh(np.vstack([one.points, np.asarray(other.points) + [1, 0]]),
                        np.vstack([one.simplices, np.asarray(other.simplices) + len(one.points)]))


@pytest.mark.parametrize("mesh, find, join, finding", [
    (exploded(meshes.icosphere(3)), "coincident", "weld", "coincide with others"),
    (side_by_side(2, 4), "hanging", "join_hanging", "hang")])
def test_what_is_not_joined_is_warned_of_and_the_remedy_helps(mesh, find, join, finding):
    with pytest.warns(polydec.PolydecWarning, match=rf"{finding}.*polydec\.meshes\.{join}"):
        found = polydec.discretize(mesh)
    assert any(finding in each for each in found.warnings)
    assert len(getattr(meshes.unjoined_boundary(mesh), find)) > 0
    joined = getattr(meshes, join)(mesh)
    coincident, hanging, misfits = meshes.unjoined_boundary(joined)
    assert (len(coincident), len(hanging), misfits) == (0, 0, 0)
    assert joined.warnings
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", polydec.PolydecWarning)
        assert [each for each in polydec.discretize(joined).warnings if "slit" in each] == []


def test_lengths_are_checked():
    for wrong in (-1, np.nan, np.inf):
        refused(lambda: meshes.weld(meshes.grid(1, 1), wrong), "length")
    apart = polydec.Mesh([[0, 0], [1, 0], [1, 1], [0, 1e-3], [1, 1 + 1e-3], [0, 1]],
                         [[0, 1, 2], [3, 4, 5]])
    assert len(meshes.weld(apart).points) == 6
    assert len(meshes.weld(apart, 0.01).points) == 4
