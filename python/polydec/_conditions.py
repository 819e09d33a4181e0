# SPDX-License-Identifier: MIT
"""Conditions on the boundary and at vertices, and vertices of sources."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from . import _core
from ._arrays import Floats, Integers, as_array, at_places, called, integers
from ._cells import Cells
from ._complex import Complex
from ._errors import InvalidInput
from ._vertices import at_cells, numbers_of


def facet_marks(cells: Cells, essential: Any) -> list[bool]:
    """One mark, or one per facet, from user input. Users may also mark facets by a function of
    position or by groups of the file."""
    names = [essential] if isinstance(essential, str) else essential
    if isinstance(names, (list, tuple)) and names and all(isinstance(name, str) for name in names):
        essential = _whole(cells).facets_in(*names)
    if callable(essential):
        essential = called(essential, facet_places(cells), "marks of essential")
    array = as_array(essential, "essential")
    if array.dtype != bool:
        raise InvalidInput(f"essential is of the type {array.dtype}: expected True, False, or one "
                           "of them for each facet; select vertices with fixed")
    count = cells.size(cells.dim - 1)
    if array.shape not in ((), (count,)):
        raise InvalidInput(f"essential has the shape {array.shape}: expected one mark for each of "
                           f"{count} facets")
    marked: list[bool] = array.ravel().tolist()
    return marked


def facet_places(cells: Cells) -> Floats:
    """A point on each facet. User-defined cells have no positions; their points have no columns."""
    return cells.facet_sites() if isinstance(cells, Complex) else np.zeros(
        (cells.size(cells.dim - 1), 0))


def by_groups(cells: Cells, values: Any, on_vertices: bool = False) -> Any:
    """Values on facets or at all points from a number for each group of the file, 0 elsewhere; other
    values as they are."""
    if not isinstance(values, Mapping):
        return values
    complex = _whole(cells)
    result = np.zeros(len(complex.points) if on_vertices else complex.size(complex.dim - 1))
    for group, value in values.items():
        result[complex.vertices_in(group) if on_vertices else complex.facets_in(group)] = value
    return result


def vertex_numbers(cells: Cells, chosen: Any, name: str) -> Integers:
    """The 0-cells of vertices. Vertices are given by numbers, by one mark each, by a function that
    takes all points and returns marks, by "boundary", or by a group of the file. The last three
    need the cells of a mesh."""
    if isinstance(chosen, str):
        complex = _whole(cells)
        return numbers_of(cells, complex.boundary_vertices() if chosen == "boundary"
                          else complex.vertices_in(chosen), name)
    if callable(chosen):
        chosen = called(chosen, _whole(cells).points, name)
    given = np.atleast_1d(as_array(chosen, name))
    if given.dtype != bool:
        return numbers_of(cells, integers(given, name), name)
    given = at_cells(cells, given)
    if given.shape != (cells.size(0),) or not given.any():
        raise InvalidInput(f"{name} marks {np.count_nonzero(given)} of {given.size} vertices: "
                           f"expected at least one of {cells.size(0)}")
    return integers(np.flatnonzero(given), name)


def _whole(cells: Cells) -> Complex:
    if isinstance(cells, Complex):
        return cells
    raise InvalidInput("cells without a mesh have no positions or groups to choose vertices by: "
                       "give the numbers of vertices")


def vertex_marks(cells: Cells, fixed: Any) -> list[bool]:
    """One mark per vertex, true where values are given; or an empty list."""
    if fixed is None:
        return []
    marked = np.zeros(cells.size(0), dtype=bool)
    numbers = vertex_numbers(cells, fixed, "fixed")
    if len(numbers) == 0 or numbers.min() < 0 or numbers.max() >= len(marked):
        raise InvalidInput(f"fixed has {len(numbers)} vertices: expected at least one, from 0 to "
                           f"{len(marked) - 1}")
    marked[numbers] = True
    result: list[bool] = marked.tolist()
    return result


def space_of(cells: Cells, side: str, degree: int, essential: Any, robin: Any = None,
             fixed: Any = None, *, otherwise: bool | None = None) -> _core.FormSpace:
    """The forms of a side and degree under conditions from user input. Where none say whether facets
    are essential, they are so for dual forms, or as `otherwise` says; but not beside Robin's."""
    if essential is None:
        essential = robin is None and (side == "dual" if otherwise is None else otherwise)
    marked = facet_marks(cells, essential)
    coefficients = np.zeros(0) if robin is None else at_places(
        by_groups(cells, robin), facet_places(cells), "Robin coefficients")
    space = _core.FormSpace(cells._cells, side, degree, marked, coefficients,
                            vertex_marks(cells, fixed))
    space.require_use("essential" if len(marked) > 1 else "", "", "" if robin is None else "robin")
    return space
