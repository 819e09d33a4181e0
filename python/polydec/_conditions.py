# SPDX-License-Identifier: MIT
"""Where values are given: conditions on the boundary, vertices inside, sources."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._arrays import Floats, Integers, floats, integers, marks
from ._cells import Cells
from ._complex import Complex
from ._errors import InvalidInput
from ._vertices import at_cells, numbers_of


def facet_marks(cells: Cells, essential: Any) -> list[bool]:
    """One mark, or one for each facet, from those of users, who may mark facets by their places or
    name groups of the file."""
    names = [essential] if isinstance(essential, str) else essential
    if isinstance(names, (list, tuple)) and names and all(isinstance(name, str) for name in names):
        groups: list[bool] = _whole(cells).facets_in(*names).tolist()
        return groups
    places = cells.facet_sites() if isinstance(cells, Complex) else np.zeros((0, 0))
    return marks(essential, places, cells.size(cells.dim - 1))


def facet_coefficients(cells: Cells, robin: Any) -> Floats:
    """Coefficients of Robin's condition, one for each facet; empty, if there are none."""
    if robin is None:
        return np.zeros(0)
    if callable(robin):
        robin = robin(cells.facet_sites() if isinstance(cells, Complex) else np.zeros((0, 0)))
    facets = cells.size(cells.dim - 1)
    given = floats(np.full(facets, robin) if np.ndim(robin) == 0 else robin,
                   "coefficients of Robin's condition")
    if len(given) != facets:
        raise InvalidInput(f"{len(given)} coefficients of Robin's condition are given: expected one, "
                           f"or one for each of {facets} facets")
    return given


def vertex_numbers(cells: Cells, chosen: Any, name: str) -> Integers:
    """The 0-cells of vertices that are given by their numbers, by a mark for each, by a function of
    all points that marks them, or by "boundary" or a group of the file, for which cells are those
    of a mesh."""
    if isinstance(chosen, str):
        complex = _whole(cells)
        return numbers_of(cells, complex.boundary_vertices() if chosen == "boundary"
                          else complex.vertices_in(chosen), name)
    if callable(chosen):
        chosen = chosen(_whole(cells).points)
    given = np.atleast_1d(np.asarray(chosen))
    if given.dtype != bool:
        return numbers_of(cells, integers(given, name), name)
    given = at_cells(cells, given)
    if given.shape != (cells.size(0),) or not given.any():
        raise InvalidInput(f"{name} marks {np.count_nonzero(given)} of {given.size} vertices: "
                           f"expected some of {cells.size(0)}")
    return integers(np.flatnonzero(given), name)


def _whole(cells: Cells) -> Complex:
    if isinstance(cells, Complex):
        return cells
    raise InvalidInput("vertices are chosen by places or groups, which cells of one's own do not "
                       "have: give their numbers")


def vertex_marks(cells: Cells, fixed: Any) -> list[bool]:
    """A mark for each vertex at which values are given, or none at all."""
    if fixed is None:
        return []
    marked = np.zeros(cells.size(0), dtype=bool)
    numbers = vertex_numbers(cells, fixed, "fixed")
    if len(numbers) == 0 or numbers.min() < 0 or numbers.max() >= len(marked):
        raise InvalidInput(f"fixed has {len(numbers)} vertices: expected some, by numbers from 0 to "
                           f"{len(marked) - 1}")
    marked[numbers] = True
    result: list[bool] = marked.tolist()
    return result


def conditions_of(cells: Cells, essential: Any, robin: Any = None,
                  fixed: Any = None) -> _core.Conditions:
    """Conditions for C++ from those of users."""
    marked = facet_marks(cells, essential)
    made = _core.Conditions(marked, facet_coefficients(cells, robin), vertex_marks(cells, fixed))
    if len(marked) > 1:
        _core.require_essential(cells._cells, made, "essential")
    return made


def conditions_or_none(cells: Cells, essential: Any, robin: Any = None,
                       fixed: Any = None) -> _core.Conditions | None:
    """None where nothing is given, for those that are built in."""
    if essential is None and robin is None and fixed is None:
        return None
    return conditions_of(cells, False if essential is None else essential, robin, fixed)
