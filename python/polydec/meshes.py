# SPDX-License-Identifier: MIT
"""Meshes: of arrays, of files, of generators.

Every generator gives a `Mesh`; the same arguments give the same mesh on every machine.
"""
from __future__ import annotations

import os
from typing import Any, NamedTuple, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats, integers

Path = Union[str, "os.PathLike[str]"]


class Mesh:
    """Points of R^N and simplices of one dimension n on them.

    Parameters
    ----------
    points : array_like, shape (vertices, N)
        Coordinates, of any layout and real type.
    simplices : array_like of int, shape (simplices, n + 1)
        Vertex numbers, counted from 0. Their order gives the orientation.
    tags : array_like of int, shape (simplices,), optional
        The number of a physical group or region, 0 for none.
    facets, facet_tags : array_like of int, shapes (facets, n) and (facets,), optional
        Facets that have a tag of their own, as parts of a boundary have.

    Attributes
    ----------
    points, simplices, tags, facets, facet_tags : numpy.ndarray
        As above, read-only. Points and simplices are shared, not copied.
    warnings : list of str
        What was untidy in a file.

    Raises
    ------
    InvalidInput
        For arrays of other shapes or types; whether simplices make sense is seen by `discretize`.

    Examples
    --------
    >>> import polydec
    >>> mesh = polydec.Mesh([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]])
    >>> mesh
    Mesh(4 points in R^2, 2 simplices of dimension 2)
    >>> mesh.points.dtype, mesh.points.flags.writeable
    (dtype('float64'), False)
    """

    __slots__ = ("_mesh", "__weakref__")

    def __init__(self, points: npt.ArrayLike, simplices: npt.ArrayLike,
                 tags: npt.ArrayLike | None = None, *, facets: npt.ArrayLike | None = None,
                 facet_tags: npt.ArrayLike | None = None) -> None:
        none = np.zeros(0, dtype=np.int32)
        self._mesh = _core.Mesh(
            floats(points, "points", 2), integers(simplices, "simplices", 2),
            none if tags is None else integers(tags, "tags"),
            none.reshape(0, 0) if facets is None else integers(facets, "facets", 2),
            none if facet_tags is None else integers(facet_tags, "facet_tags"), [])

    @classmethod
    def _of(cls, mesh: _core.Mesh) -> Mesh:
        result = cls.__new__(cls)
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
    def warnings(self) -> list[str]:
        return self._mesh.warnings

    @property
    def dim(self) -> int:
        """Dimension n of the simplices."""
        return int(self.simplices.shape[1]) - 1

    @property
    def ambient_dim(self) -> int:
        """Dimension N of the space around them."""
        return int(self.points.shape[1])

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (np.array(self.points), np.array(self.simplices), np.array(self.tags),
                            np.array(self.facets), np.array(self.facet_tags), self.warnings)

    def __repr__(self) -> str:
        return (f"Mesh({len(self.points)} points in R^{self.ambient_dim}, "
                f"{len(self.simplices)} simplices of dimension {self.dim})")


def _unpickled(*parts: Any) -> Mesh:
    return Mesh._of(_core.Mesh(*parts))


class LengthMesh:
    """Simplices, and how long their edges are, without points.

    Parameters
    ----------
    simplices : array_like of int, shape (simplices, n + 1)
        Vertex numbers, counted from 0.
    edges : array_like of int, shape (edges, 2)
        Every edge of the simplices exactly once, in any order.
    lengths : array_like, shape (edges,)
        Their lengths.
    vertices : int, optional
        The number of vertices; without it, one more than the largest number.

    Raises
    ------
    InvalidInput
        Naming the row or the edge, unless every edge of the simplices is there exactly once.

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


class Renumbered(NamedTuple):
    """A mesh under other numbers: `vertices` and `cells` hold the old number of each."""

    mesh: Mesh
    vertices: Integers
    cells: Integers


def read_mesh(path: Path) -> Mesh:
    """Reads a mesh; the extension says the format.

    Triangles in R^3 of .off, .obj, .ply and .stl; the cells of largest dimension of .mesh, .msh,
    .vtk, .vtu and .node or .ele; simplices of any dimension of .nsc. Polygons are split.

    Raises
    ------
    IoError
        If the file cannot be read; ``path`` says which.
    InvalidInput
        If it is malformed; ``path`` and ``line`` say where.
    """
    return Mesh._of(_core.read_mesh(os.fspath(path)))


def write_mesh(path: Path, mesh: Mesh) -> None:
    """Writes a mesh; the extension says the format: .nsc, .mesh, .off, .obj, .ply or .stl.

    Numbers read back exactly, except in STL. Of these formats .nsc holds every mesh.
    """
    _core.write_mesh(os.fspath(path), mesh._mesh)


def read_lengths(path: Path) -> LengthMesh:
    """Reads simplices and the lengths of their edges from an .nsl file."""
    return LengthMesh._of(_core.read_lengths(os.fspath(path)))


def write_lengths(path: Path, mesh: LengthMesh) -> None:
    """Writes an .nsl file; numbers read back exactly."""
    _core.write_lengths(os.fspath(path), mesh._mesh)


def length_mesh(mesh: Mesh) -> LengthMesh:
    """The simplices of a mesh with the lengths of their edges, without its points."""
    return LengthMesh._of(_core.length_mesh(mesh._mesh))


def _counts(cells: int | Sequence[int], dimension: int) -> list[int]:
    return [cells] * dimension if isinstance(cells, int) else list(cells)


def grid(nx: int, ny: int, width: float = 1.0, height: float = 1.0) -> Mesh:
    """A rectangle of nx times ny equal rectangles, each split by the same diagonal.

    Vertex (i, j) has the number ``i * (ny + 1) + j``.

    >>> from polydec import meshes
    >>> meshes.grid(2, 1)
    Mesh(6 points in R^2, 4 simplices of dimension 2)
    """
    return Mesh._of(_core.grid(nx, ny, width, height))


def hexagons(columns: int) -> Mesh:
    """The unit square in rows of hexagons with corners on circles, fanned into triangles."""
    return Mesh._of(_core.hexagons(columns))


def well_centered(rows: int) -> Mesh:
    """The unit square in ``2 * rows`` rows of acute triangles: all duals are positive."""
    return Mesh._of(_core.well_centered(rows))


def uv_sphere(meridians: int, bands: int) -> Mesh:
    """Unit sphere of triangles at the poles, and trapezoids, each split by a diagonal."""
    return Mesh._of(_core.uv_sphere(meridians, bands))


def icosphere(frequency: int) -> Mesh:
    """Unit sphere of ``20 * frequency**2`` triangles from the icosahedron."""
    return Mesh._of(_core.icosphere(frequency))


def goldberg(frequency: int) -> Mesh:
    """Goldberg's polyhedron in the unit sphere: 12 pentagons, ``10 * frequency**2 - 10`` hexagons.

    All faces are planar with corners on a circle, and fanned into triangles. Takes about a second
    for frequency 32.

    >>> import polydec
    >>> polydec.discretize(polydec.meshes.goldberg(1)).shape   # the dodecahedron
    (20, 30, 12)
    """
    return Mesh._of(_core.goldberg(frequency))


def torus(major: int, minor: int, major_radius: float = 1.0, minor_radius: float = 0.4) -> Mesh:
    """Torus around the z axis of major times minor trapezoids, each split by a diagonal."""
    return Mesh._of(_core.torus(major, minor, major_radius, minor_radius))


def moebius(around: int, across: int, width: float = 0.6) -> Mesh:
    """Moebius strip with the center line of radius 1; not orientable."""
    return Mesh._of(_core.moebius(around, across, width))


def flange(segments: int) -> Mesh:
    """A machine part, closed, of genus 1: planar rectangles and trapezoids, each split."""
    return Mesh._of(_core.flange(segments))


def kuhn(cells: Sequence[int], lengths: Sequence[float] = ()) -> Mesh:
    """Kuhn's triangulation of a box in R^n: ``cells[k]`` boxes along axis k, each n! simplices.

    >>> from polydec import meshes
    >>> meshes.kuhn([2, 2, 2])
    Mesh(27 points in R^3, 48 simplices of dimension 3)
    """
    return Mesh._of(_core.kuhn(list(cells), list(lengths)))


def split_boxes(cells: Sequence[int], lengths: Sequence[float] = (), seed: int = 1) -> Mesh:
    """The same boxes, each split at random into n! simplices."""
    return Mesh._of(_core.split_boxes(list(cells), list(lengths), seed))


def bcc(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """Body-centered cubic lattice: cells**3 cubes of the unit cube, or cells[k] along axis k.

    Around each inner square there are four congruent tetrahedra.
    """
    return _lattice(_core.bcc, cells, edge, 3)


def fcc(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """Face-centered cubic lattice: regular tetrahedra, and octahedra split into four."""
    return _lattice(_core.fcc, cells, edge, 3)


def d4(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """The lattice D4 in R^4: regular 16-cells, each split into 8 simplices."""
    return _lattice(_core.d4, cells, edge, 4)


def _lattice(make: Any, cells: int | Sequence[int], edge: float | None, dimension: int) -> Mesh:
    if isinstance(cells, int):
        return Mesh._of(make(cells) if edge is None else make([cells] * dimension, edge))
    return Mesh._of(make(list(cells), 1.0 if edge is None else edge))


def sphere_clusters(dimension: int = 3, cells_per_side: int = 6, spheres: int = 1,
                    points_on_sphere: int = 40, radius: float = 0.25, seed: int = 1) -> Mesh:
    """A random Delaunay mesh of the unit cube with empty spheres of many points on them.

    Each sphere becomes one cell with that many corners when it is merged.
    """
    return Mesh._of(_core.sphere_clusters(dimension, cells_per_side, spheres, points_on_sphere,
                                          radius, seed))


def perturbed(mesh: Mesh, amplitude: float, seed: int = 1) -> Mesh:
    """The mesh with every coordinate moved at random by at most `amplitude`."""
    return Mesh._of(_core.perturbed(mesh._mesh, amplitude, seed))


def shuffled(mesh: Mesh, seed: int = 1) -> Renumbered:
    """The same mesh under random vertex and cell numbers."""
    renumbered, vertices, cells = _core.shuffled(mesh._mesh, seed)
    return Renumbered(Mesh._of(renumbered), vertices, cells)


def along_morton_curve(mesh: Mesh) -> Renumbered:
    """The same mesh with numbers along Morton's curve: neighbors in space are near in memory."""
    renumbered, vertices, cells = _core.along_morton_curve(mesh._mesh)
    return Renumbered(Mesh._of(renumbered), vertices, cells)


def peeled(mesh: Mesh) -> Mesh:
    """The mesh without the flat cells that meshers leave on its boundary."""
    return Mesh._of(_core.peeled(mesh._mesh))


def tetrahedralize(surface: Mesh, *, largest_volume: float = 0.0, quality: float = 0.0,
                   holes: npt.ArrayLike | None = None) -> Mesh:
    """The inside of a closed surface as tetrahedra, by the program TetGen.

    Parameters
    ----------
    surface : Mesh
        Triangles in R^3.
    largest_volume, quality : float
        Bounds of volume, and of circumradius over shortest edge; 0 for none.
    holes : array_like, shape (holes, 3), optional
        A point in each part that is to stay empty.

    Raises
    ------
    BackendUnavailable
        If TetGen is not installed.
    """
    points = np.zeros((0, 3)) if holes is None else floats(holes, "holes", 2)
    return Mesh._of(_core.tetrahedralize(surface._mesh, largest_volume, quality, points))
