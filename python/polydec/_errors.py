# SPDX-License-Identifier: MIT
"""What goes wrong, as classes that are also Python's own."""
from __future__ import annotations

import sys
import warnings
from typing import Any, Mapping, Sequence

# What messages of the library call by its name in C++, by its name here.
_WORDING = {
    "DiscretizeOptions::delaunay": "delaunay=\"flips\"",
    "Delaunay::flips_and_splits": "delaunay=\"flips_and_splits\"",
    "Delaunay::flips": "delaunay=\"flips\"",
    "StarKind::": "star=",
    "star=automatic": "star=\"automatic\"",
    "Side::primal": "side=\"primal\"",
    "GeodesicOptions::time_scale": "time_scale",
    "GeodesicOptions::linear_solver": "engine",
    "DistanceMethod::heat": "method=\"heat\"",
    "Materials::keep_apart": "materials=\"keep_apart\"",
    "MergeCriterion::none": "merge=False",
    "CellData::on_cells": "a dual 0-form",
    "peeled(mesh)": "polydec.meshes.peeled(mesh)",
    "weld(mesh)": "polydec.meshes.weld(mesh)",
    "join_hanging(mesh)": "polydec.meshes.join_hanging(mesh)",
    "set_memory_limit": "polydec.set_memory_limit",
}


def told(text: str) -> str:
    """A message of the library in the words of this package."""
    for theirs, ours in _WORDING.items():
        text = text.replace(theirs, ours)
    return text


class Error(Exception):
    """What every error of polydec is.

    The text says what is wrong, where, and what to do. The attributes say where, to programs.

    Attributes
    ----------
    degree : int or None
        Of the cells that the text names.
    cells, vertices : tuple of int
        All of those of which the text names the first few.
    path : str or None
        The file that the text names.
    line : int or None
        And the line, from 1.
    """

    def __init__(self, text: str = "", *, degree: int | None = None, cells: Sequence[int] = (),
                 vertices: Sequence[int] = (), path: str | None = None,
                 line: int | None = None) -> None:
        super().__init__(told(text))
        self.degree = degree
        self.cells = tuple(cells)
        self.vertices = tuple(vertices)
        self.path = path
        self.line = line


class InvalidInput(Error, ValueError):
    """The data do not fit: the text names the cell, vertex or line, and what was expected."""


class SolverFailure(Error, ArithmeticError):
    """An engine did not deliver.

    Attributes
    ----------
    report : dict
        How far it came: ``engine``, ``iterations``, ``residual``, ``backward_error`` and ``tried``;
        what was not measured is NaN.
    """

    def __init__(self, text: str = "", *, report: Mapping[str, Any] | None = None,
                 **place: Any) -> None:
        super().__init__(text, **place)
        self.report = dict(report or {})


class BackendUnavailable(Error, ImportError):
    """The engine cannot be had here: the text names the package that brings it."""


class IoError(Error, OSError):
    """A file cannot be opened, read or written, or memory does not suffice for what it holds."""


class PolydecWarning(UserWarning):
    """A result may be another one than was asked for: the text says why, and what helps."""


def warn(texts: Sequence[str]) -> None:
    """Warns of each of these at the line that called the package."""
    if not texts:
        return
    level, frame = 1, sys._getframe().f_back
    while frame is not None and frame.f_globals.get("__name__", "").startswith("polydec"):
        level, frame = level + 1, frame.f_back
    for text in texts:
        warnings.warn(told(text), PolydecWarning, stacklevel=level)
