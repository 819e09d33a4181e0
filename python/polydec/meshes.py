# SPDX-License-Identifier: MIT
"""Meshes of generators, and changed ones.

Every generator gives a `Mesh`; the same arguments give the same mesh on every machine.
"""
from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Integers, floats
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
    """A mesh under other numbers: `vertices` and `cells` hold the old number of each."""

    mesh: Mesh
    vertices: Integers
    cells: Integers


def length_mesh(mesh: Mesh) -> LengthMesh:
    """The simplices of a mesh with the lengths of their edges, without its points.

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
    """The unit square in rows of hexagons with corners on circles, fanned into triangles.

    >>> from polydec import discretize, meshes
    >>> meshes.hexagons(4), discretize(meshes.hexagons(4)).size(2)
    (Mesh(46 points in R^2, 72 simplices of dimension 2), 22)
    """
    return Mesh._of(_core.hexagons(columns))


def well_centered(rows: int) -> Mesh:
    """The unit square in ``2 * rows`` rows of acute triangles: all duals are positive.

    >>> from polydec import discretize, meshes
    >>> bool(discretize(meshes.well_centered(4)).dual_volumes(1).min() > 0)
    True
    """
    return Mesh._of(_core.well_centered(rows))


def uv_sphere(meridians: int, bands: int) -> Mesh:
    """Unit sphere of triangles at the poles, and trapezoids, each split by a diagonal.

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
    """Goldberg's polyhedron in the unit sphere: 12 pentagons, ``10 * frequency**2 - 10`` hexagons.

    All faces are planar with corners on a circle, and fanned into triangles. Takes about a second
    for frequency 32.

    >>> import polydec
    >>> polydec.discretize(polydec.meshes.goldberg(1)).shape   # the dodecahedron
    (20, 30, 12)
    """
    return Mesh._of(_core.goldberg(frequency))


def torus(major: int, minor: int, major_radius: float = 1.0, minor_radius: float = 0.4) -> Mesh:
    """Torus around the z axis of major times minor trapezoids, each split by a diagonal.

    The radii, `major_radius` and `minor_radius`, are those of the center line and of the tube.

    >>> from polydec import meshes
    >>> meshes.torus(8, 6)
    Mesh(48 points in R^3, 96 simplices of dimension 2)
    """
    return Mesh._of(_core.torus(major, minor, major_radius, minor_radius))


def moebius(around: int, across: int, width: float = 0.6) -> Mesh:
    """Moebius strip with the center line of radius 1; not orientable.

    >>> from polydec import discretize, meshes
    >>> discretize(meshes.moebius(9, 3)).report()["orientable"]
    False
    """
    return Mesh._of(_core.moebius(around, across, width))


def flange(segments: int) -> Mesh:
    """A machine part, closed, of genus 1: planar rectangles and trapezoids, each split.

    >>> from polydec import discretize, meshes
    >>> discretize(meshes.flange(12)).betti_numbers()
    [1, 2, 1]
    """
    return Mesh._of(_core.flange(segments))


def kuhn(cells: Sequence[int], lengths: Sequence[float] = ()) -> Mesh:
    """Kuhn's triangulation of a box in R^n: ``cells[k]`` boxes along axis k, each n! simplices.

    >>> from polydec import meshes
    >>> meshes.kuhn([2, 2, 2])
    Mesh(27 points in R^3, 48 simplices of dimension 3)
    """
    return Mesh._of(_core.kuhn(list(cells), list(lengths)))


def split_boxes(cells: Sequence[int], lengths: Sequence[float] = (), seed: int = 1) -> Mesh:
    """The same boxes as of `kuhn`, each split at random into n! simplices.

    >>> from polydec import meshes
    >>> meshes.split_boxes([2, 1], seed=3)
    Mesh(6 points in R^2, 4 simplices of dimension 2)
    """
    return Mesh._of(_core.split_boxes(list(cells), list(lengths), seed))


def bcc(cells: int | Sequence[int], edge: float | None = None) -> Mesh:
    """Body-centered cubic lattice: cells**3 cubes of the unit cube, or cells[k] along axis k.

    Around each inner square there are four congruent tetrahedra.

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
        return Mesh._of(make(cells) if edge is None else make([cells] * dimension, edge))
    return Mesh._of(make(list(cells), 1.0 if edge is None else edge))


def sphere_clusters(dimension: int = 3, cells_per_side: int = 6, spheres: int = 1,
                    points_on_sphere: int = 40, radius: float = 0.25, seed: int = 1) -> Mesh:
    """A random Delaunay mesh of the unit cube with empty spheres of many points on them.

    Each sphere becomes one cell with that many corners when it is merged.

    Parameters
    ----------
    dimension : int
    cells_per_side : int
        Of the jittered grid that the points are of.
    spheres, points_on_sphere : int
        How many, and of how many points each.
    radius : float
        Of the spheres.
    seed : int
        Of the random numbers.

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
    """The mesh with every coordinate moved at random by at most `amplitude`.

    >>> from polydec import meshes
    >>> mesh = meshes.grid(2, 2)
    >>> bool(0 < abs(meshes.perturbed(mesh, 0.1).points - mesh.points).max() <= 0.1)
    True
    """
    return Mesh._of(_core.perturbed(mesh._mesh, amplitude, seed))


def shuffled(mesh: Mesh, seed: int = 1) -> Renumbered:
    """The same mesh under random vertex and cell numbers.

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
    """The same mesh with numbers along Morton's curve: neighbors in space are near in memory.

    >>> from polydec import meshes
    >>> meshes.along_morton_curve(meshes.shuffled(meshes.grid(2, 2)).mesh).mesh
    Mesh(9 points in R^2, 8 simplices of dimension 2)
    """
    renumbered, vertices, cells = _core.along_morton_curve(mesh._mesh)
    return Renumbered(Mesh._of(renumbered), vertices, cells)


def weld(mesh: Mesh, length: float | None = None) -> Mesh:
    """The mesh with one vertex where several are at most `length` apart.

    So slits between cells close. Without a length, it is 1e-9 of the size of the mesh. No edge
    longer than the length vanishes, and no cell is turned over; ``warnings`` tells how many
    vertices were joined.

    Raises
    ------
    InvalidInput
        For a length that is negative or not finite, and for cells that make no sense.

    Examples
    --------
    >>> from polydec import Mesh, meshes
    >>> slit = Mesh([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], [[0, 1, 2], [3, 4, 5]])
    >>> meshes.weld(slit)
    Mesh(4 points in R^2, 2 simplices of dimension 2)
    """
    return Mesh._of(_core.weld(mesh._mesh, length))


def join_hanging(mesh: Mesh, length: float | None = None) -> Mesh:
    """The mesh welded, with triangles and tetrahedra split at the hanging nodes of its boundary.

    Vertices inside boundary edges and facets, up to `length` off them, become corners of the cells
    there, as `weld` takes the length. Volume, orientation and tags stay.

    Raises
    ------
    InvalidInput
        As `weld`; naming the cell if it is too thin to be split; for hanging nodes of cells of
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
    """Vertices of the boundary at places of others, vertices that hang inside its edges or facets,
    and the number of facets that lie on others with other corners."""

    coincident: Integers
    hanging: Integers
    misfits: int


def unjoined_boundary(mesh: Mesh) -> UnjoinedBoundary:
    """Where the boundary of a mesh lies upon itself without being joined.

    >>> from polydec import Mesh, meshes
    >>> slit = Mesh([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], [[0, 1, 2], [3, 4, 5]])
    >>> meshes.unjoined_boundary(slit).coincident
    array([3, 4], dtype=int32)
    """
    return UnjoinedBoundary(*_core.unjoined_boundary(mesh._mesh))


def peeled(mesh: Mesh) -> Mesh:
    """The mesh without the flat cells that meshers leave on its boundary.

    >>> from polydec import meshes
    >>> len(meshes.peeled(meshes.grid(2, 2)).simplices)          # there are none
    8
    """
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
