# SPDX-License-Identifier: MIT
"""Exceptions, derived from Python's built-in ones too, and warnings."""
from __future__ import annotations

import sys
import warnings
from typing import Any, Mapping, Sequence

# C++ names in messages of the library, and the names of this package.
_WORDING = {
    "DiscretizeOptions::delaunay": "delaunay=\"flips\"",
    "Delaunay::flips_and_splits": "delaunay=\"flips_and_splits\"",
    "Delaunay::flips": "delaunay=\"flips\"",
    "symmetric matrix C of": "symmetric matrix A of",
    "StarKind::": "star=",
    "star=automatic": "star=\"automatic\"",
    "Side::primal": "side=\"primal\"",
    "GeodesicOptions::time_scale": "time_scale",
    "GeodesicOptions::linear_solver": "engine",
    "DistanceMethod::heat": "method=\"heat\"",
    "Materials::keep_apart": "materials=\"keep_apart\"",
    "MergeCriterion::none": "merge=False",
    "CellData::on_cells": "a dual 0-form",
    "BoundaryConditions::essential": "essential",
    "peeled(mesh)": "polydec.meshes.peeled(mesh)",
    "weld(mesh)": "polydec.meshes.weld(mesh)",
    "join_hanging(mesh)": "polydec.meshes.join_hanging(mesh)",
    "DiscretizeOptions::": "",
    "IntegratorOptions::": "",
    "WaveOptions::": "",
    "FlowSteps::": "",
    "FlowOptions::": "",
    "FlowBoundary::": "",
    "FlowScheme::imex": "scheme=\"imex\"",
    "set_memory_limit": "polydec.set_memory_limit",
    "ShortestPaths": "geodesic_distance",
    "dual_wedge for dual ones": "wedge(.., side=\"dual\") for dual ones",
    "longer steps or an earlier end": "a larger time_step or a smaller time",
    "HodgeStar::zeros of degree 1": "zeros(1)",
    "FlowBoundary::pressure": "pressure_on",
    "Discretization::with_stars": "with_star",
    "its facts are wrong; if it has a kernel, give it in the facts":
        "symmetric or positive is wrong; expected a matrix with an inverse",
    "If it has a kernel, give it in the facts": "Expected a matrix with an inverse",
    "give the kernel in the facts": "give a matrix with an inverse",
    "the facts do not say that this matrix is": "this matrix is not known to be",
    "although its facts say so": "although positive=True",
    "Say so in the facts": "Say symmetric=True",
}


def told(text: str) -> str:
    """A message of the library with the names of this package."""
    for theirs, ours in _WORDING.items():
        text = text.replace(theirs, ours)
    return text


class Error(Exception):
    """Base class of all polydec errors.

    The text says what is wrong, where, and what to do. The attributes give the place to programs.

    Attributes
    ----------
    degree : int or None
        Degree of the cells that the text names.
    cells, vertices : tuple of int
        All cells and vertices concerned; the text names the first few.
    path : str or None
        The file that the text names.
    line : int or None
        The line of that file, counted from 1.
    """

    def __init__(self, text: str = "", *, degree: int | None = None, cells: Sequence[int] = (),
                 vertices: Sequence[int] = (), path: str | None = None,
                 line: int | None = None) -> None:
        super().__init__(text)
        self.degree = degree
        self.cells = tuple(map(int, cells))
        self.vertices = tuple(map(int, vertices))
        self.path = path
        self.line = line


class InvalidInput(Error, ValueError):
    """Invalid data. The text names the cell, vertex or line, and the expected input."""


class SolverFailure(Error, ArithmeticError):
    """An engine failed.

    Attributes
    ----------
    report : dict
        State at the failure: ``engine``, ``iterations``, ``residual``, ``backward_error`` and
        ``tried``. Values that were not measured are NaN.
    """

    def __init__(self, text: str = "", *, report: Mapping[str, Any] | None = None,
                 **place: Any) -> None:
        super().__init__(text, **place)
        self.report = dict(report or {})


class BackendUnavailable(Error, ImportError):
    """The engine is not available; the text names the package that contains it."""


class IoError(Error, OSError):
    """A file cannot be opened, read or written, or its contents do not fit into memory."""


class PolydecWarning(UserWarning):
    """A result may differ from the requested one; the text says why, and what helps."""


def warn(texts: Sequence[str]) -> None:
    """Issues these warnings at the line that called the package."""
    if not texts:
        return
    level, frame = 2, sys._getframe().f_back
    while frame is not None and frame.f_globals.get("__name__", "").startswith("polydec"):
        level, frame = level + 1, frame.f_back
    for text in texts:
        warnings.warn(told(text), PolydecWarning, stacklevel=level)
