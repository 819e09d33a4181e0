# SPDX-License-Identifier: MIT
"""Meshes and mesh files."""
from __future__ import annotations

import os
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats, integers

Path = Union[str, "os.PathLike[str]"]


class Mesh:
    """Points in R^N and simplices of one dimension n on these points.

    Parameters
    ----------
    points : array_like, shape (vertices, N)
        Coordinates, in any layout and real type.
    simplices : array_like of int, shape (simplices, n + 1)
        Vertex numbers, counted from 0. Their order gives the orientation.
    tags : array_like of int, shape (simplices,), optional
        The number of a physical group or region, 0 for none.
    facets, facet_tags : array_like of int, shapes (facets, n) and (facets,), optional
        Facets with their own tags, such as parts of a boundary.

    Attributes
    ----------
    points, simplices, tags, facets, facet_tags : numpy.ndarray
        As above, read-only. Points and simplices are shared, not copied.
    groups : list of (int, int, str)
        Dimension (-1 if the file does not state it), tag and name of named physical groups.
    warnings : list of str
        Defects of the file.

    Raises
    ------
    InvalidInput
        For arrays of other shapes or types. `discretize` checks the simplices themselves.

    Examples
    --------
    >>> import polydec
    >>> mesh = polydec.Mesh([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]])
    >>> mesh
    Mesh(4 points in R^2, 2 simplices of dimension 2)
    >>> mesh.points.dtype, mesh.points.flags.writeable
    (dtype('float64'), False)
    """

    __slots__ = ("_mesh", "_file", "__weakref__")

    def __init__(self, points: npt.ArrayLike, simplices: npt.ArrayLike,
                 tags: npt.ArrayLike | None = None, *, facets: npt.ArrayLike | None = None,
                 facet_tags: npt.ArrayLike | None = None) -> None:
        def given(numbers: npt.ArrayLike | None, name: str, dimensions: int = 1) -> Integers:
            return integers(() if numbers is None else numbers, name, dimensions)

        self._file = "" # that it was read from
        self._mesh = _core.Mesh(
            floats(points, "points", 2), integers(simplices, "simplices", 2), given(tags, "tags"),
            given(facets, "facets", 2), given(facet_tags, "facet_tags"), [], [], given(None, ""), 0)

    @classmethod
    def _of(cls, mesh: _core.Mesh, file: str = "") -> Mesh:
        result = cls.__new__(cls)
        result._file = file
        result._mesh = mesh
        return result

    @property
    def points(self) -> Floats:
        return self._mesh.points

    @property
    def simplices(self) -> Integers:
        return self._mesh.simplices

    @property
    def tags(self) -> Integers:
        return self._mesh.tags

    @property
    def facets(self) -> Integers:
        return self._mesh.facets

    @property
    def facet_tags(self) -> Integers:
        return self._mesh.facet_tags

    @property
    def input_cells(self) -> Integers:
        """For each simplex, the cell of the file that contains it; data on cells follow this order.
        Empty if every simplex is a cell of the file."""
        return self._mesh.input_cells

    @property
    def groups(self) -> list[tuple[int, int, str]]:
        return self._mesh.groups

    @property
    def warnings(self) -> list[str]:
        return self._mesh.warnings

    @property
    def dim(self) -> int:
        """Dimension n of the simplices."""
        return int(self.simplices.shape[1]) - 1

    @property
    def ambient_dim(self) -> int:
        """Dimension N of the ambient space."""
        return int(self.points.shape[1])

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self._file, np.array(self.points), np.array(self.simplices),
                            np.array(self.tags), np.array(self.facets), np.array(self.facet_tags),
                            self.groups, self.warnings, np.array(self.input_cells),
                            self._mesh.input_count)

    def __repr__(self) -> str:
        return (f"Mesh({len(self.points)} points in R^{self.ambient_dim}, "
                f"{len(self.simplices)} simplices of dimension {self.dim})")


def _unpickled(file: str, *parts: Any) -> Mesh:
    return Mesh._of(_core.Mesh(*parts), file)


class LengthMesh:
    """Simplices with edge lengths, without points.

    Parameters
    ----------
    simplices : array_like of int, shape (simplices, n + 1)
        Vertex numbers, counted from 0.
    edges : array_like of int, shape (edges, 2)
        Every edge of the simplices, exactly once, in any order.
    lengths : array_like, shape (edges,)
        Edge lengths.
    vertices : int, optional
        Number of vertices; by default one more than the largest vertex number.

    Attributes
    ----------
    simplices, edges, lengths, vertices
        As above; arrays are read-only.

    Raises
    ------
    InvalidInput
        If an edge is missing, repeated or foreign; the text names the row or the edge.

    Examples
    --------
    >>> import polydec
    >>> triangle = polydec.LengthMesh([[0, 1, 2]], [[0, 1], [1, 2], [0, 2]], [3, 4, 5])
    >>> polydec.discretize(triangle).volumes(2)
    array([6.])
    """

    __slots__ = ("_mesh", "__weakref__")

    def __init__(self, simplices: npt.ArrayLike, edges: npt.ArrayLike, lengths: npt.ArrayLike, *,
                 vertices: int | None = None) -> None:
        rows = integers(simplices, "simplices", 2)
        if vertices is None:
            vertices = int(rows.max(initial=-1)) + 1
        self._mesh = _core.LengthMesh(rows, vertices, integers(edges, "edges", 2),
                                      floats(lengths, "lengths"))

    @classmethod
    def _of(cls, mesh: _core.LengthMesh) -> LengthMesh:
        result = cls.__new__(cls)
        result._mesh = mesh
        return result

    @property
    def simplices(self) -> Integers:
        return self._mesh.simplices

    @property
    def edges(self) -> Integers:
        return self._mesh.edges

    @property
    def lengths(self) -> Floats:
        return self._mesh.lengths

    @property
    def vertices(self) -> int:
        return self._mesh.vertices

    @property
    def dim(self) -> int:
        """Dimension n of the simplices."""
        return int(self.simplices.shape[1]) - 1

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled_lengths, (np.array(self.simplices), np.array(self.edges),
                                    np.array(self.lengths), self.vertices)

    def __repr__(self) -> str:
        return (f"LengthMesh({self.vertices} vertices, {len(self.simplices)} simplices of "
                f"dimension {self.dim})")


def _unpickled_lengths(simplices: Any, edges: Any, lengths: Any, vertices: int) -> LengthMesh:
    return LengthMesh(simplices, edges, lengths, vertices=vertices)


def read_mesh(path: Path) -> Mesh:
    """Reads a mesh; the extension gives the format.

    Reads polygons from .off, .obj, .ply and .stl; cells of largest dimension from .mesh, .msh,
    .vtk, .vtu and .node or .ele; simplices of any dimension from .nsc and .pdm. Polygons become
    Delaunay triangles; hexahedra, wedges, pyramids and prisms become tetrahedra. Higher-order cells
    give their corners.

    Raises
    ------
    IoError
        If the file cannot be read; ``path`` names it.
    InvalidInput
        If the file is malformed; ``path`` and ``line`` say where.

    Examples
    --------
    >>> import os, polydec, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     polydec.write_mesh(folder + "/sphere.off", polydec.meshes.icosphere(2))
    ...     polydec.read_mesh(folder + "/sphere.off")
    Mesh(42 points in R^3, 80 simplices of dimension 2)
    """
    return Mesh._of(_core.read_mesh(os.fspath(path)), os.fspath(path))


def write_mesh(path: Path, mesh: Mesh) -> None:
    """Writes a mesh; the extension gives the format: .nsc, .pdm, .mesh, .off, .obj, .ply or .stl.

    Numbers read back exactly, except from STL; .off, .obj and .ply
    add z = 0 to points of the plane. Only .nsc and .pdm hold every mesh; only
    .pdm and MEDIT keep tags.

    Raises
    ------
    InvalidInput
        If the format cannot hold the mesh, such as tetrahedra in .off.
    IoError
        If the file cannot be written; ``path`` names it.

    Examples
    --------
    >>> import os, polydec, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     polydec.write_mesh(folder + "/cube.nsc", polydec.meshes.kuhn([1, 1, 1]))
    ...     polydec.read_mesh(folder + "/cube.nsc").dim
    3
    """
    _core.write_mesh(os.fspath(path), mesh._mesh)


def read_lengths(path: Path) -> LengthMesh:
    """Reads simplices and edge lengths from an .nsl file.

    Raises the same errors as `read_mesh`. For an example see `write_lengths`.

    >>> import polydec
    >>> try:
    ...     polydec.read_lengths("none.nsl")
    ... except polydec.IoError as error:
    ...     print(error.path)
    none.nsl
    """
    return LengthMesh._of(_core.read_lengths(os.fspath(path)))


def write_lengths(path: Path, mesh: LengthMesh) -> None:
    """Writes an .nsl file; numbers read back exactly.

    >>> import polydec, tempfile
    >>> triangle = polydec.LengthMesh([[0, 1, 2]], [[0, 1], [1, 2], [0, 2]], [3, 4, 5])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     polydec.write_lengths(folder + "/triangle.nsl", triangle)
    ...     polydec.read_lengths(folder + "/triangle.nsl").lengths
    array([3., 4., 5.])
    """
    _core.write_lengths(os.fspath(path), mesh._mesh)
