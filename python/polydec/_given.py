# SPDX-License-Identifier: MIT
"""Conversion of input to meshes."""
from __future__ import annotations

import os
from itertools import combinations
from typing import Any, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Integers, floats, integers
from ._errors import InvalidInput
from ._mesh import LengthMesh, Mesh, Path, read_lengths, read_mesh

#: A mesh, the path of its file, a pair of points and simplices, or a ``meshio.Mesh``.
MeshLike = Union[Mesh, LengthMesh, Path, Tuple[npt.ArrayLike, npt.ArrayLike], Any]


def as_mesh(given: MeshLike) -> Mesh | LengthMesh:
    """Converts any mesh input of `discretize` to a mesh.

    Parameters
    ----------
    given : Mesh, LengthMesh, str, os.PathLike, pair of array_like, or meshio.Mesh
        A path names a file for `read_mesh` or `read_lengths`. A pair is (points, simplices), as for
        `Mesh`. A ``meshio.Mesh`` gives its cells of largest dimension, with tags from its cell
        data. Polygons and solids are split into simplices; higher-order cells give their corners.

    Raises
    ------
    InvalidInput
        For other types; also as `read_mesh`, `read_lengths` and `Mesh`.

    Examples
    --------
    >>> import polydec
    >>> polydec.as_mesh(([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]))
    Mesh(3 points in R^2, 1 simplices of dimension 2)
    """
    if isinstance(given, (Mesh, LengthMesh)):
        return given
    if isinstance(given, (str, os.PathLike)):
        is_lengths = _core.is_length_file(os.fspath(given))
        return read_lengths(given) if is_lengths else read_mesh(given)
    if isinstance(given, (tuple, list)) and len(given) == 2:
        return _of_simplices(Mesh(given[0], given[1]))
    if hasattr(given, "points") and hasattr(given, "cells"):
        return _of_meshio(given)
    kind = f"an array of shape {given.shape}" if isinstance(given, np.ndarray) else \
        f"an object of type {type(given).__name__}"
    raise InvalidInput(f"{kind} is given for a mesh: expected a Mesh, the path of a file, a pair "
                       "(points, simplices), or a meshio.Mesh")


def _of_simplices(mesh: Mesh) -> Mesh:
    """Raises InvalidInput for 4-corner cells in space that share edges, but no triangle."""
    if mesh.points.shape[1] != 3 or mesh.simplices.shape[1] != 4:
        return mesh

    def are_shared(cells: Integers, corners: int) -> bool:
        faces = np.sort(np.vstack([cells[:, list(chosen)]
                                   for chosen in combinations(range(4), corners)]), axis=1)
        faces = faces[np.lexsort(faces.T)]
        return bool((faces[1:] == faces[:-1]).all(axis=1).any())

    if any(are_shared(cells, 3) for cells in (mesh.simplices[:1000], mesh.simplices)) \
            or not are_shared(mesh.simplices, 2):
        return mesh
    raise InvalidInput("cells of 4 corners in space are read as tetrahedra, but no two of these "
                       "share a triangle, though some share an edge: for quadrilaterals, use "
                       "split_polygons(points, cells); for tetrahedra, give a Mesh")


def split_polygons(points: npt.ArrayLike, polygons: Sequence[npt.ArrayLike],
                   tags: npt.ArrayLike | None = None) -> Mesh:
    """A polygonal surface, split into triangles. `discretize` merges concyclic triangles again.

    Parameters
    ----------
    points : array_like, shape (vertices, N)
    polygons : sequence of array_like of int
        Vertex numbers around each polygon; may be a table if all have equally many corners.
    tags : array_like of int, shape (polygons,), optional
        Tags that the triangles inherit.

    Raises
    ------
    InvalidInput
        If a corner is not a point; ``cells`` and ``vertices`` say where.

    Examples
    --------
    >>> import polydec
    >>> house = polydec.split_polygons([[0, 0], [2, 0], [2, 2], [0, 2], [1, 3]],
    ...                                [[0, 1, 2, 3], [3, 2, 4]])
    >>> polydec.discretize(house).shape
    (5, 6, 2)
    """
    corners = [integers(polygon, f"corners of polygon {i}") for i, polygon in enumerate(polygons)]
    offsets = np.cumsum([0] + [len(each) for each in corners], dtype=np.int32)
    return Mesh._of(_core.split_polygons(
        floats(points, "points", 2), np.concatenate([integers((), "corners"), *corners]), offsets,
        integers(() if tags is None else tags, "tags")))


#: Dimension and number of corners of meshio cells. Corners are the first nodes of a cell.
_KINDS = {"vertex": (0, 1), "line": (1, 2), "triangle": (2, 3), "quad": (2, 4), "tetra": (3, 4),
          "pyramid": (3, 5), "wedge": (3, 6), "hexahedron": (3, 8), "penta_prism": (3, 10),
          "hexa_prism": (3, 12)}
_SAME = {"curve": "line", "quadrilateral": "quad", "tetrahedron": "tetra"}
#: Cells with corners ordered along the axes.
_ALONG_AXES = {"pixel": ("quad", [0, 1, 3, 2]), "voxel": ("hexahedron", [0, 1, 3, 2, 4, 5, 7, 6])}


def _block(kind: str, cells: Any, tags: Integers) -> tuple[int, Integers, Integers, Integers, int]:
    """Dimension, corners, end offsets of cells, tags, and number of other nodes per cell."""
    if kind.startswith("polygon"):
        rows = [integers(cell, f"corners of {kind} {i}") for i, cell in enumerate(cells)]
        ends = np.cumsum([len(row) for row in rows], dtype=np.int32)
        return 2, np.concatenate([np.zeros(0, dtype=np.int32), *rows]), ends, tags, 0
    table = integers(cells, f"cells of the type {kind}", 2)
    if kind in _ALONG_AXES and table.shape[1] == len(_ALONG_AXES[kind][1]):
        kind, order = _ALONG_AXES[kind]
        table = table[:, order]
    name = kind.rstrip("0123456789").lower().replace("vtk_lagrange_", "")
    name = _SAME.get(name, name)
    if name not in _KINDS or table.shape[1] < _KINDS[name][1]:
        raise InvalidInput(f"the mesh has cells of the type {kind} with {table.shape[1]} nodes: "
                           "expected tetra, hexahedron, wedge, pyramid, triangle, quad, polygon or "
                           "line; convert other cells first")
    dimension, corners = _KINDS[name]
    ends = np.arange(1, len(table) + 1, dtype=np.int32) * np.int32(corners)
    return (dimension, np.ascontiguousarray(table[:, :corners]).ravel(), ends, tags,
            table.shape[1] - corners)


def _of_meshio(given: Any) -> Mesh:
    names = [name for name in given.cell_data if _core.is_tag_name(name)]
    blocks = []
    for number, block in enumerate(given.cells):
        tags = np.zeros(len(block.data), dtype=np.int32)
        if names and np.asarray(given.cell_data[names[0]][number]).dtype.kind in "iu":
            tags = integers(given.cell_data[names[0]][number], names[0])
        if len(block.data) > 0:
            blocks.append(_block(block.type, block.data, tags))
    if all(dimension == 0 for dimension, *_ in blocks):
        raise InvalidInput("the mesh has no cells: expected tetra, hexahedron, wedge, pyramid, "
                           "triangle, quad, polygon or line")
    return Mesh._of(_core.mesh_of_cells(floats(given.points, "points", 2), blocks))
