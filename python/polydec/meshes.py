# SPDX-License-Identifier: MIT
"""Mesh generators, and functions that change meshes.

Generators return a `Mesh`. The same arguments give the same mesh on every machine.
"""
from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Integers, floats, integers
from ._mesh import (LengthMesh, Mesh, read_lengths, read_mesh, write_lengths,
                    write_mesh)

__all__ = [
    "LengthMesh", "Mesh", "Renumbered", "UnjoinedBoundary", "along_morton_curve", "bcc", "d4",
    "fcc", "flange",
    "goldberg", "grid", "hexagons", "icosphere", "join_hanging", "kuhn", "length_mesh", "moebius",
    "peeled", "perturbed", "read_lengths", "read_mesh", "shuffled", "sphere_clusters",
    "split_boxes", "tetrahedralize", "torus", "unjoined_boundary", "uv_sphere", "weld",
    "well_centered", "write_lengths", "write_mesh",
]


class Renumbered(NamedTuple):
    """A renumbered mesh; `vertices` and `cells` hold the old numbers."""

    mesh: Mesh
    vertices: Integers
    cells: Integers


def length_mesh(mesh: Mesh) -> LengthMesh:
    """The simplices of a mesh with their edge lengths, without points.

    >>> from polydec import meshes
    >>> meshes.length_mesh(meshes.grid(1, 1))
    LengthMesh(4 vertices, 2 simplices of dimension 2)
    """
    return LengthMesh._of(_core.length_mesh(mesh._mesh))


def grid(nx: int, ny: int, width: float = 1.0, height: float = 1.0) -> Mesh:
    """A rectangle of nx times ny equal rectangles, each split by the same diagonal.

    Vertex (i, j) has the number ``i * (ny + 1) + j`` and lies at ``(i * width / nx,
    j * height / ny)``.

    >>> from polydec import meshes
    >>> meshes.grid(2, 1)
    Mesh(6 points in R^2, 4 simplices of dimension 2)
    """
    return Mesh._of(_core.grid(nx, ny, width, height))


def hexagons(columns: int) -> Mesh:
    """The unit square as rows of cyclic hexagons, each a fan of triangles.

    >>> from polydec import discretize, meshes
    >>> meshes.hexagons(4), discretize(meshes.hexagons(4)).size(2)
    (Mesh(46 points in R^2, 72 simplices of dimension 2), 22)
    """
    return Mesh._of(_core.hexagons(columns))


def well_centered(rows: int) -> Mesh:
    """The unit square as ``2 * rows`` rows of acute triangles. All duals are positive.

    >>> from polydec import discretize, meshes
    >>> bool(discretize(meshes.well_centered(4)).dual_volumes(1).min() > 0)
    True
    """
    return Mesh._of(_core.well_centered(rows))


def uv_sphere(meridians: int, bands: int) -> Mesh:
    """Unit sphere of trapezoids, each split by a diagonal, with triangles at the poles.

    >>> from polydec import meshes
    >>> meshes.uv_sphere(8, 4)
    Mesh(26 points in R^3, 48 simplices of dimension 2)
    """
    return Mesh._of(_core.uv_sphere(meridians, bands))


def icosphere(frequency: int) -> Mesh:
    """Unit sphere of ``20 * frequency**2`` triangles from the icosahedron.

    >>> from polydec import meshes
    >>> meshes.icosphere(2)
    Mesh(42 points in R^3, 80 simplices of dimension 2)
    """
    return Mesh._of(_core.icosphere(frequency))


def goldberg(frequency: int) -> Mesh:
    """Goldberg polyhedron in the unit sphere: 12 pentagons, ``10 * frequency**2 - 10`` hexagons.

    All faces are planar and cyclic, and split into fans of triangles. Frequency 32 takes about a
    second.

    >>> import polydec
    >>> polydec.discretize(polydec.meshes.goldberg(1)).shape   # the dodecahedron
    (20, 30, 12)
    """
    return Mesh._of(_core.goldberg(frequency))


def torus(major: int, minor: int, major_radius: float = 1.0, minor_radius: float = 0.4) -> Mesh:
    """Torus around the z axis of major times minor trapezoids, each split by a diagonal.

    `major_radius` is the radius of the center line, `minor_radius` the radius of the tube.

    >>> from polydec import meshes
    >>> meshes.torus(8, 6)
    Mesh(48 points in R^3, 96 simplices of dimension 2)
    """
    return Mesh._of(_core.torus(major, minor, major_radius, minor_radius))


def moebius(around: int, across: int, width: float = 0.6) -> Mesh:
    """Moebius strip with a center line of radius 1; not orientable.

    >>> from polydec import discretize, meshes
    >>> discretize(meshes.moebius(9, 3)).report()["orientable"]
    False
    """
    return Mesh._of(_core.moebius(around, across, width))


def flange(segments: int) -> Mesh:
    """A closed machine part of genus 1, made of planar rectangles and trapezoids, each split.

    >>> from polydec import discretize, meshes
    >>> discretize(meshes.flange(12)).betti_numbers()
    [1, 2, 1]
    """
    return Mesh._of(_core.flange(segments))


def kuhn(cells: Sequence[int], lengths: Sequence[float] = ()) -> Mesh:
    """Kuhn triangulation of a box in R^n: ``cells[k]`` boxes along axis k, each of n! simplices.

    >>> from polydec import meshes
    >>> meshes.kuhn([2, 2, 2])
    Mesh(27 points in R^3, 48 simplices of dimension 3)
    """
    return Mesh._of(_core.kuhn(integers(cells, "cells"), list(lengths)))


def split_boxes(cells: Sequence[int], lengths: Sequence[float] = (), seed: int = 1) -> Mesh:
    """The boxes of `kuhn`, each split at random into n! simplices.

    >>> from polydec import meshes
    >>> meshes.split_boxes([2, 1], seed=3)
    Mesh(6 points in R^2, 4 simplices of dimension 2)
    """
    return Mesh._of(_core.split_boxes(integers(cells, "cells"), list(lengths), seed))


def bcc(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """Body-centered cubic lattice: cells**3 cubes in the unit cube, or cells[k] along axis k.

    Four congruent tetrahedra surround each inner square.

    >>> from polydec import meshes
    >>> meshes.bcc(2)
    Mesh(35 points in R^3, 96 simplices of dimension 3)
    """
    return _lattice(_core.bcc, cells, edge, 3)


def fcc(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """Face-centered cubic lattice: regular tetrahedra, and octahedra split into four.

    >>> from polydec import meshes
    >>> meshes.fcc(1)
    Mesh(14 points in R^3, 24 simplices of dimension 3)
    """
    return _lattice(_core.fcc, cells, edge, 3)


def d4(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """The lattice D4 in R^4: regular 16-cells, each split into 8 simplices.

    >>> from polydec import meshes
    >>> meshes.d4(1).dim
    4
    """
    return _lattice(_core.d4, cells, edge, 4)


def _lattice(make: Any, cells: int | Sequence[int], edge: float | None, dimension: int) -> Mesh:
    if isinstance(cells, int):
        if edge is None:
            return Mesh._of(make(cells))
        cells = [cells] * dimension
    return Mesh._of(make(integers(cells, "cells"), 1.0 if edge is None else edge))


def sphere_clusters(dimension: int = 3, cells_per_side: int = 6, spheres: int = 1,
                    points_on_sphere: int = 40, radius: float = 0.25, seed: int = 1) -> Mesh:
    """A random Delaunay mesh of the unit cube with empty spheres through many points.

    Merging makes each sphere one cell with `points_on_sphere` corners.

    Parameters
    ----------
    dimension : int
    cells_per_side : int
        Cells per side of the jittered grid of points.
    spheres, points_on_sphere : int
        Number of spheres, and of points on each sphere.
    radius : float
        Radius of the spheres.
    seed : int
        Seed of the random numbers.

    Examples
    --------
    >>> from polydec import discretize, meshes
    >>> mesh = meshes.sphere_clusters(cells_per_side=4, points_on_sphere=12)
    >>> cells = discretize(mesh).cells(3)
    >>> max(len(cells.cell(i)) for i in range(len(cells)))
    12
    """
    return Mesh._of(_core.sphere_clusters(dimension, cells_per_side, spheres, points_on_sphere,
                                          radius, seed))


def perturbed(mesh: Mesh, amplitude: float, seed: int = 1) -> Mesh:
    """A copy with every coordinate perturbed at random by at most `amplitude`.

    >>> from polydec import meshes
    >>> mesh = meshes.grid(2, 2)
    >>> bool(0 < abs(meshes.perturbed(mesh, 0.1).points - mesh.points).max() <= 0.1)
    True
    """
    return Mesh._of(_core.perturbed(mesh._mesh, amplitude, seed))


def shuffled(mesh: Mesh, seed: int = 1) -> Renumbered:
    """The same mesh with random vertex and cell numbers.

    >>> import numpy as np
    >>> from polydec import meshes
    >>> mesh = meshes.grid(2, 2)
    >>> other = meshes.shuffled(mesh)
    >>> np.array_equal(other.mesh.points, mesh.points[other.vertices])
    True
    """
    renumbered, vertices, cells = _core.shuffled(mesh._mesh, seed)
    return Renumbered(Mesh._of(renumbered), vertices, cells)


def along_morton_curve(mesh: Mesh) -> Renumbered:
    """The same mesh, numbered along the Morton curve: neighbors in space are near in memory.

    >>> from polydec import meshes
    >>> meshes.along_morton_curve(meshes.shuffled(meshes.grid(2, 2)).mesh).mesh
    Mesh(9 points in R^2, 8 simplices of dimension 2)
    """
    renumbered, vertices, cells = _core.along_morton_curve(mesh._mesh)
    return Renumbered(Mesh._of(renumbered), vertices, cells)


def weld(mesh: Mesh, length: float | None = None) -> Mesh:
    """Merges vertices that are at most `length` apart, which closes slits between cells.

    The default length is 1e-9 of the size of the mesh. No edge longer than the length vanishes, and
    no cell is inverted. ``warnings`` reports how many vertices were joined.

    Raises
    ------
    InvalidInput
        For a negative or non-finite length, and for invalid cells.

    Examples
    --------
    >>> from polydec import Mesh, meshes
    >>> slit = Mesh([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], [[0, 1, 2], [3, 4, 5]])
    >>> meshes.weld(slit)
    Mesh(4 points in R^2, 2 simplices of dimension 2)
    """
    return Mesh._of(_core.weld(mesh._mesh, length))


def join_hanging(mesh: Mesh, length: float | None = None) -> Mesh:
    """Welds a mesh, and splits triangles and tetrahedra at the hanging nodes of its boundary.

    Vertices inside boundary edges and facets, up to `length` away, become corners of the cells
    there. For `length` see `weld`. Volume, orientation and tags do not change.

    Raises
    ------
    InvalidInput
        As `weld`. Also for a cell too thin to split, which the text names, and for hanging nodes in
        dimension 4 or more.

    Examples
    --------
    >>> from polydec import Mesh, meshes
    >>> hanging = Mesh([[0, 0], [0, 1], [-1, 0], [0, 0.5], [1, 0], [1, 1]],
    ...                [[0, 1, 2], [0, 4, 3], [3, 4, 5], [3, 5, 1]])
    >>> meshes.join_hanging(hanging)
    Mesh(6 points in R^2, 5 simplices of dimension 2)
    """
    return Mesh._of(_core.join_hanging(mesh._mesh, length))


class UnjoinedBoundary(NamedTuple):
    """Boundary vertices at the same point as others, hanging vertices inside boundary edges or
    facets, and the number of facets that overlap facets with other corners."""

    coincident: Integers
    hanging: Integers
    misfits: int


def unjoined_boundary(mesh: Mesh) -> UnjoinedBoundary:
    """Places where the boundary of a mesh touches itself without being joined.

    >>> from polydec import Mesh, meshes
    >>> slit = Mesh([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], [[0, 1, 2], [3, 4, 5]])
    >>> meshes.unjoined_boundary(slit).coincident
    array([3, 4], dtype=int32)
    """
    return UnjoinedBoundary(*_core.unjoined_boundary(mesh._mesh))


def peeled(mesh: Mesh) -> Mesh:
    """A copy without the flat cells that meshers leave on the boundary.

    >>> from polydec import meshes
    >>> len(meshes.peeled(meshes.grid(2, 2)).simplices)          # there are none
    8
    """
    return Mesh._of(_core.peeled(mesh._mesh))


def tetrahedralize(surface: Mesh, *, largest_volume: float = 0.0, quality: float = 0.0,
                   holes: npt.ArrayLike | None = None) -> Mesh:
    """Tetrahedral mesh of the inside of a closed surface, by the program TetGen.

    Parameters
    ----------
    surface : Mesh
        Triangles in R^3.
    largest_volume, quality : float
        Upper bounds of the volume, and of circumradius over shortest edge; 0 for no bound.
    holes : array_like, shape (holes, 3), optional
        One point in each part that stays empty.

    Raises
    ------
    BackendUnavailable
        If TetGen is not installed.

    Examples
    --------
    >>> import polydec
    >>> try:
    ...     ball = polydec.meshes.tetrahedralize(polydec.meshes.icosphere(2))
    ...     print(ball.dim)
    ... except polydec.BackendUnavailable:
    ...     print(3)
    3
    """
    points = np.zeros((0, 3)) if holes is None else floats(holes, "holes", 2)
    return Mesh._of(_core.tetrahedralize(surface._mesh, largest_volume, quality, points))
