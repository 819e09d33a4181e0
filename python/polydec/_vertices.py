# SPDX-License-Identifier: MIT
"""Conversion between input vertices and 0-cells, the vertices that cells use."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers
from ._errors import InvalidInput

if TYPE_CHECKING:
    from ._cells import Cells


def _mesh_or_none(cells: Any) -> _core.Discretization | None:
    mesh = getattr(cells, "_mesh", None)
    return mesh if isinstance(mesh, _core.Discretization) else None


def mesh_of(complex: Any) -> _core.Discretization:
    """The C++ discretization of a Complex. Raises InvalidInput for other types."""
    mesh = _mesh_or_none(complex)
    if mesh is None:
        raise InvalidInput(f"an object of type {type(complex).__name__} is given: expected the "
                           "Complex that discretize returns for a mesh")
    return mesh


def _unused(cells: Cells) -> _core.Discretization | None:
    """The mesh of these cells if it has unused vertices, else None."""
    mesh = _mesh_or_none(cells)
    return mesh if mesh is not None and mesh.vertex_count != cells.size(0) else None


def at_vertices(cells: Cells, rows: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Values at input vertices from values at 0-cells; at unused vertices nan, or -1 for whole
    numbers."""
    mesh = _unused(cells)
    if mesh is None or len(rows) != cells.size(0):
        return rows
    unknown = -1 if rows.dtype.kind == "i" else np.nan
    result = np.full((mesh.vertex_count, *rows.shape[1:]), unknown, rows.dtype)
    result[mesh.vertices] = rows
    return result


def at_cells(cells: Cells, rows: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Values at 0-cells from values at input vertices; other arrays do not change."""
    mesh = _unused(cells)
    if mesh is None or len(rows) != mesh.vertex_count:
        return rows
    chosen: npt.NDArray[Any] = rows[mesh.vertices]
    return chosen


def _is_of_vertices(cells: Cells, side: str, degree: int) -> bool:
    return degree == (0 if side == "primal" else cells.dim)


def form_at_vertices(cells: Cells, values: Floats, side: str, degree: int) -> Floats:
    """Values of a form for users: forms on vertices or their duals get one per input vertex."""
    return at_vertices(cells, values) if _is_of_vertices(cells, side, degree) else values


def form_at_cells(cells: Cells, values: Floats, side: str, degree: int | None) -> Floats:
    """Inverse of `form_at_vertices`; without a degree the number of values decides."""
    if degree is None or _is_of_vertices(cells, side, degree):
        return at_cells(cells, values)
    return values


def points_of(mesh: _core.Discretization) -> Floats:
    """Points of all input vertices; nan for unknown positions."""
    if mesh.vertex_count == len(mesh.points):
        return mesh.points
    result = np.full((mesh.vertex_count, mesh.points.shape[1]), np.nan)
    result[mesh.vertices] = mesh.points
    unused = np.ones(len(result), dtype=bool)
    unused[mesh.vertices] = False
    if mesh.isolated.shape[1] == result.shape[1]:
        result[unused] = mesh.isolated
    return result


def numbers_of(cells: Cells, chosen: Integers, name: str) -> Integers:
    """The 0-cells of vertices, given by vertex numbers."""
    mesh = _mesh_or_none(cells)
    return chosen if mesh is None else mesh.cells_of_vertices(name, chosen)
