# SPDX-License-Identifier: MIT
"""Distances and directions along surfaces."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats, integers
from ._complex import CellsLike, Complex, as_complex
from ._conditions import vertex_numbers
from ._vertices import at_vertices, numbers_of


def _surface(given: CellsLike) -> Complex:
    """The mesh with circumcentric stars. Distances do not depend on the stars, so a warning that
    another kind was chosen would say nothing about them."""
    return as_complex(given, in_units=True, star="circumcentric")


class GeodesicDistance:
    """Distances along a surface from any source vertices.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
    method : str
        "exact", the lengths of shortest paths on the flat triangles, up to rounding: they do not
        depend on how the triangles divide the surface. Or "heat": smoothed, off by some percent of
        the greatest distance, with factorizations that serve all single sources; good on bad
        triangles with ``delaunay="flips"``.
    time_scale : float
        Of the heat method: time of the heat flow, in squares of the mean edge: longer is smoother.
    engine : str
        Of the heat method: a name of `backends`.
    """

    def __init__(self, complex: CellsLike, *, method: str = "exact", time_scale: float = 4.0,
                 engine: str = "auto") -> None:
        self._complex = _surface(complex)
        self._solver = _core.GeodesicDistance(self._complex._mesh, method, time_scale, engine)

    def to(self, sources: Any) -> Floats:
        """The distance of every vertex from the nearest source vertex, see `geodesic_distance`."""
        found = self._solver.to(vertex_numbers(self._complex, sources, "sources"))[0]
        return at_vertices(self._complex, found)


def geodesic_distance(complex: CellsLike, sources: Any, *, method: str = "exact",
                      time_scale: float = 4.0, engine: str = "auto") -> Floats:
    """The distance of every vertex from the nearest source vertex, along the surface.

    Parameters
    ----------
    sources : int, array_like of int or bool, callable or str
        Numbers of vertices, or marks of all of them; a callable takes all points and returns marks;
        "boundary", or else a group of the file. The other parameters are those of
        `GeodesicDistance`.

    Returns
    -------
    numpy.ndarray
        A number for each vertex that was given; nan where no cell uses it.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(8, 8))
    >>> far = polydec.geodesic_distance(square, 0)
    >>> bool(abs(far - np.linalg.norm(square.points, axis=1)).max() < 1e-14)
    True
    """
    return GeodesicDistance(complex, method=method, time_scale=time_scale, engine=engine).to(sources)


class ShortestPath(NamedTuple):
    """A shortest path from a vertex to the nearest source, straight in every triangle."""

    source: int
    length: float
    segments: Floats
    """(segments, 2, N): the ends of its straight pieces, in order. On glued meshes the next one
    begins at another place where the path crosses a seam."""

    @property
    def points(self) -> Floats:
        """(segments + 1, N): the points that it passes on a mesh without seams."""
        return np.asarray(np.concatenate([self.segments[:, 0], self.segments[-1:, 1]]))


class SurfacePaths:
    """Shortest paths and isolines of the exact distance, of every point and not of vertices alone.

    Parameters are those of `geodesic_distance`. Paths lie on the triangles that were given, also
    where edges were flipped.

    Examples
    --------
    >>> import polydec
    >>> paths = polydec.SurfacePaths(polydec.meshes.grid(4, 4), 0)
    >>> path = paths.path(24)
    >>> path.source, round(path.length, 12), path.points[-1].tolist()
    (0, 1.414213562373, [0.0, 0.0])
    """

    def __init__(self, complex: CellsLike, sources: Any) -> None:
        self._complex = _surface(complex)
        self._paths = _core.SurfacePaths(self._complex._mesh,
                                         vertex_numbers(self._complex, sources, "sources"))

    def path(self, vertex: int) -> ShortestPath:
        """The shortest path from a vertex to the nearest source; no segments from a source."""
        given = integers(np.atleast_1d(np.asarray(vertex)), "vertex")
        number = numbers_of(self._complex, given, "vertex")[0]
        source, length, ends = self._paths.path(int(number))
        return ShortestPath(int(self._complex.vertices[source]), length, np.stack(ends, axis=1))

    def isolines(self, levels: npt.ArrayLike, *, divisions: int = 8) -> tuple[Floats, Integers]:
        """Segments along the points at these distances, (m, 2, N), and the number of the level of
        each; every triangle is divided into `divisions` squared ones."""
        ends, numbers = self._paths.isolines(floats(np.atleast_1d(levels), "levels"), divisions)
        return np.stack(ends, axis=1), np.asarray(numbers)


class ParallelTransport:
    """Tangent vectors carried along shortest ways over a two-sided surface.

    A vector is a complex number in the polar coordinates of its vertex: its argument is the angle
    from `directions`, the unit vectors in space along the reference edge of each vertex, in the
    direction in which the triangles are oriented. After flips edges have no direction in space, and
    `directions` is not to be had.
    """

    def __init__(self, complex: CellsLike, *, time_scale: float = 4.0,
                 engine: str = "auto") -> None:
        self._complex = as_complex(complex)
        self._solver = _core.ParallelTransport(self._complex._mesh, time_scale, engine)

    @property
    def reference(self) -> Any:
        """The edge of each vertex that has angle 0, as a row (vertex, vertex it leads to)."""
        return self._complex.vertices[self._solver.reference(self._complex._mesh)]

    @property
    def directions(self) -> Floats:
        """The unit vector along it, a row for each vertex."""
        edges = _ways(self._complex, self._solver.reference(self._complex._mesh))
        return np.asarray(edges / np.linalg.norm(edges, axis=1)[:, None])

    def extend(self, sources: npt.ArrayLike, vectors: npt.ArrayLike) -> npt.NDArray[np.complex128]:
        """A vector at every vertex from one at each source vertex."""
        given = np.atleast_1d(np.asarray(vectors, dtype=np.complex128))
        real, imaginary = self._solver.extend(
            numbers_of(self._complex, integers(np.atleast_1d(np.asarray(sources)), "sources"),
                       "sources"),
            floats(given.real, "vectors"), floats(given.imag, "vectors"))
        return np.asarray(real + 1j * imaginary)


def _ways(complex: Complex, ends: Integers) -> Floats:
    """The vectors along edges of the simplices, from their first vertices to their second: of a
    glued mesh where the edges lie in the box."""
    if not complex._mesh.is_glued:
        points = complex.points[complex.vertices]
        return np.asarray(points[ends[:, 1]] - points[ends[:, 0]])
    box = complex.box
    pairs = box.input.d(0).tocsr().indices.reshape(-1, 2)
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    numbers = complex._mesh.cells_of_places(0).astype(np.int64)
    keys = numbers[pairs] @ [complex.size(0), 1]
    order = np.argsort(keys, kind="stable")
    found = pairs[order[np.searchsorted(keys[order], ends @ [complex.size(0), 1])]]
    return np.asarray(box.points[found[:, 1]] - box.points[found[:, 0]])
