# SPDX-License-Identifier: MIT
"""The simplices in each cell of a complex."""
from __future__ import annotations

from typing import Any

from . import _core
from ._arrays import Integers
from ._cells import Cells
from ._cochain import Cochain, Form, as_form, made


class Merging:
    """The simplices in each cell of a `Complex`, and the maps between cells and simplices.

    Forms on simplices live on ``complex.input``. `lift` and `diamond` refer to the pieces, which
    equal the input simplices unless edges were flipped.
    """

    def __init__(self, complex: Cells, mesh: _core.Discretization) -> None:
        self._complex = complex
        self._mesh = mesh

    @property
    def is_identity(self) -> bool:
        """Whether nothing was merged."""
        return self._mesh.is_identity

    def diamond(self, k: int) -> Any:
        """Orientation, 1 or -1, of each k-piece in its cell: a view of type int8.

        It maps primal k-forms from pieces to cells, and commutes with d.
        """
        return self._mesh.diamond(k)

    def carriers(self, k: int) -> tuple[Integers, Integers]:
        """For each k-piece, the cell that contains it in its interior: dimensions and numbers."""
        return self._mesh.carriers(k)

    def lift(self, k: int) -> Any:
        """Lift of primal k-forms from cells to pieces: ``diamond(k) @ lift(k)`` is the identity. It
        commutes with d."""
        return self._mesh.lift(k)

    def to_merged(self, form: Form, degree: int | None = None, side: str = "primal") -> Cochain:
        """Maps a form from input simplices to merged cells: by sums, or by means of dual values."""
        given = as_form(self._complex, form, degree, side)
        return made(_core.to_merged(self._mesh, given), self._complex)

    def to_input(self, form: Form, degree: int | None = None, side: str = "primal") -> Cochain:
        """Maps a form from merged cells to input simplices: by shares of volume, or by copies.

        Use `lifted` before taking derivatives.
        """
        given = as_form(self._complex, form, degree, side)
        return made(_core.to_input(self._mesh, given), Cells(self._mesh.input_cells))

    def lifted(self, form: Form, degree: int | None = None) -> Cochain:
        """Maps a primal form from merged cells to input simplices; commutes with d."""
        given = as_form(self._complex, form, degree)
        return made(_core.lifted(self._mesh, given), Cells(self._mesh.input_cells))

    def consistency(self, form: Form, degree: int | None = None,
                    side: str = "dual") -> dict[str, Any]:
        """Deviation of a dual form on simplices from a form on merged cells.

        Returns a dict: ``worst`` is the largest deviation; ``cell``, ``found``, ``expected`` and
        ``description`` describe its place.
        """
        return _core.consistency(self._mesh, as_form(self._complex, form, degree, side))
