# SPDX-License-Identifier: MIT
"""Distances along surfaces, and parallel transport."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, as_array, floats, integers
from ._complex import CellsLike, Complex, as_complex
from ._conditions import vertex_numbers
from ._errors import InvalidInput
from ._vertices import at_vertices, numbers_of


def _surface(given: CellsLike) -> Complex:
    """The mesh with circumcentric stars. Distances do not depend on the stars, so a warning about
    an automatic choice would be irrelevant."""
    return as_complex(given, in_units=True, star="circumcentric")


class GeodesicDistance:
    """Distances along a surface from any source vertices.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
    method : str
        "exact": lengths of shortest paths on the flat triangles, up to rounding, independent of the
        triangulation of the surface. "heat": smoothed, with errors of some percent of the greatest
        distance. It reuses its factorizations for all single sources, and works on bad triangles
        with ``delaunay="flips"``.
    time_scale : float
        Heat method only: duration of the heat flow, in squared mean edges. Longer is smoother.
    engine : str
        Heat method only: engine name, see `backends`.
    """

    def __init__(self, complex: CellsLike, *, method: str = "exact", time_scale: float = 4.0,
                 engine: str = "auto") -> None:
        self._complex = _surface(complex)
        self._solver = _core.GeodesicDistance(self._complex._mesh, method, time_scale, engine)

    def to(self, sources: Any) -> Floats:
        """Distance of every vertex from the nearest source vertex; see `geodesic_distance`."""
        found = self._solver.to(vertex_numbers(self._complex, sources, "sources"))
        return at_vertices(self._complex, found)


def geodesic_distance(complex: CellsLike, sources: Any, *, method: str = "exact",
                      time_scale: float = 4.0, engine: str = "auto") -> Floats:
    """Distance of every vertex from the nearest source vertex, along the surface.

    Parameters
    ----------
    sources : int, array_like of int or bool, callable or str
        Vertex numbers, or one mark per vertex; a callable that takes all points and returns marks;
        "boundary", or else a group of the file. For the other parameters see `GeodesicDistance`.

    Returns
    -------
    numpy.ndarray
        One number per input vertex; nan where no cell uses the vertex.

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
    """A shortest path from a vertex to the nearest source, straight in each triangle.

    Attributes
    ----------
    source : int
        The vertex where it ends.
    length : float
    segments : numpy.ndarray, shape (segments, 2, N)
        End points of the straight pieces, in order. On glued meshes the position jumps where the path
        crosses a seam.
    start : numpy.ndarray, shape (N,)
        The vertex where it begins.
    """

    source: int
    length: float
    segments: Floats
    start: Floats

    @property
    def points(self) -> Floats:
        """(segments + 1, N): the points of the path, on a mesh without seams."""
        return np.asarray(np.concatenate([self.start[None], self.segments[:, 1]]))


class SurfacePaths:
    """Shortest paths and isolines of the exact distance, at all points of the surface.

    For the parameters see `geodesic_distance`. Paths lie on the input triangles, even if edges were
    flipped.

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
        """Shortest path from a vertex to the nearest source; without segments at a source."""
        given = integers(np.atleast_1d(vertex), "vertex")
        number = numbers_of(self._complex, given, "vertex")[0]
        source, length, ends = self._paths.path(int(number))
        return ShortestPath(int(self._complex.vertices[source]), length, np.stack(ends, axis=1),
                            self._complex.points[given[0]])

    def isolines(self, levels: npt.ArrayLike, *, divisions: int = 8) -> tuple[Floats, Integers]:
        """Isolines as segments, (m, 2, N), and the level index of each segment. Every triangle is
        divided into ``divisions**2`` triangles."""
        ends, numbers = self._paths.isolines(floats(np.atleast_1d(levels), "levels"), divisions)
        return np.stack(ends, axis=1), np.asarray(numbers)


class ParallelTransport:
    """Parallel transport of tangent vectors along shortest paths on a two-sided surface.

    A vector is a complex number in the polar coordinates of its vertex. Its argument is the angle
    from the unit vector in `directions`, measured in the orientation of the triangles. `directions`
    holds the unit vectors in space along the reference edges. It raises InvalidInput if a flip made
    one of these edges or only lengths are known: such edges have no direction in space. Everything
    has a row for each input vertex; where no cell uses it, vectors are nan, and vertex numbers -1.
    """

    def __init__(self, complex: CellsLike, *, time_scale: float = 4.0,
                 engine: str = "auto") -> None:
        self._complex = as_complex(complex)
        self._solver = _core.ParallelTransport(self._complex._mesh, time_scale, engine)

    @property
    def _edges(self) -> Integers:
        """The same as 0-cells, a row for each."""
        return self._solver.reference(self._complex._mesh)

    @property
    def reference(self) -> Any:
        """Reference edge of each vertex, at angle 0: a row (vertex, other vertex)."""
        return at_vertices(self._complex, self._complex.vertices[self._edges])

    @property
    def directions(self) -> Floats:
        """Unit vectors along the reference edges, one row per vertex."""
        ways = _ways(self._complex, self._edges)
        ways /= abs(ways).max(axis=1)[:, None] # squares of lengths may be 0
        return at_vertices(self._complex, ways / np.linalg.norm(ways, axis=1)[:, None])

    def extend(self, sources: npt.ArrayLike, vectors: npt.ArrayLike) -> npt.NDArray[np.complex128]:
        """Transports one vector per source vertex to every vertex."""
        given = np.atleast_1d(as_array(vectors, "vectors").astype(np.complex128))
        real, imaginary = self._solver.extend(
            numbers_of(self._complex, integers(np.atleast_1d(sources), "sources"),
                       "sources"),
            floats(given.real, "vectors"), floats(given.imag, "vectors"))
        return at_vertices(self._complex, real + 1j * imaginary)


def _ways(complex: Complex, ends: Integers) -> Floats:
    """Vectors along edges of the input, from first to second 0-cell; on a glued mesh, in the box.
    Raises InvalidInput for edges that are not in the input or have no position."""
    box = complex.box
    points, pairs = box._mesh.points, box.input.d(0).tocsr().indices.reshape(-1, 2)
    if points.shape[1] == 0:
        raise InvalidInput("only lengths are known, so edges have no direction in space: expected "
                           "a mesh with points, without flips if it is glued")
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    numbers = complex._mesh.cells_of_places(0).astype(np.int64)
    keys, wanted = (rows @ [complex.size(0), 1] for rows in (numbers[pairs], ends))
    order = np.argsort(keys, kind="stable")
    places = order[np.searchsorted(keys[order], wanted).clip(max=len(keys) - 1)]
    flipped = complex.vertices[ends[keys[places] != wanted]]
    if len(flipped):
        raise InvalidInput(f"a flip made the reference edge of vertex {flipped[0, 0]}, so it has no "
                           "direction in space: expected a mesh without flips",
                           vertices=flipped[:, 0].tolist())
    found = pairs[places]
    return np.asarray(points[found[:, 1]] - points[found[:, 0]])
