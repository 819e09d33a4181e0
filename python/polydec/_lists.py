# SPDX-License-Identifier: MIT
"""Cells and polygons as lists of corners."""
from __future__ import annotations

from typing import NamedTuple

from ._arrays import Floats, Integers


class CellList(NamedTuple):
    """The cells of one degree: cell i has ``corners[offsets[i]:offsets[i + 1]]``."""

    offsets: Integers
    corners: Integers

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def cell(self, i: int) -> Integers:
        """The corners of cell i."""
        return self.corners[self.offsets[i]:self.offsets[i + 1]]


class Polygons(NamedTuple):
    """Polygons: ``corners[offsets[i]:offsets[i + 1]]`` are rows of `points` around polygon i."""

    points: Floats
    offsets: Integers
    corners: Integers
