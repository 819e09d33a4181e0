# SPDX-License-Identifier: MIT
"""Spaces of forms under conditions on the boundary."""
from __future__ import annotations

import functools
from typing import Any

import numpy as np
import numpy.typing as npt

from ._arrays import Floats, Integers, Values, floats
from ._cells import Cells
from ._cochain import Form, of_kind
from ._conditions import space_of
from ._complex import CellsLike, as_cells
from ._errors import InvalidInput
from ._vertices import form_at_cells


class FormSpace:
    """Forms of one side and degree that obey conditions on the boundary.

    The conditions fix some values of a form; the others are free. Matrices for your own equations
    act on the free values.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Degree and side of the forms.
    essential : bool or array of bool or callable, optional
        Facets with given values, as for `spectrum`. By default the built-in conditions hold.
    robin : float, array_like or callable, optional
        Coefficients of Robin's condition, as for `PoissonSolver`.
    fixed : array_like or callable or str, optional
        Vertices with given values, as for `PoissonSolver`.

    Attributes
    ----------
    cells : list of numpy.ndarray
        For each degree, the numbers of the cells with free values.
    free : numpy.ndarray
        The numbers of the cells that carry the free values: ``cells[degree]`` for primal forms,
        ``cells[n - degree]`` for dual forms.

    Examples
    --------
    Poisson's equation with values 0 on the boundary:

    >>> import numpy as np, polydec, scipy.sparse.linalg as la
    >>> square = polydec.discretize(polydec.meshes.well_centered(8))
    >>> space = polydec.FormSpace(square, essential=True)
    >>> load = space.restrict(square.star(0))       # f = 1
    >>> u = space.extend(la.spsolve(space.stiffness().tocsc(), load))
    >>> bool(abs(u - polydec.poisson(square, 1.0, essential=True).form.values).max() < 1e-12)
    True
    """

    def __init__(self, complex: CellsLike, degree: int = 0, *, side: str = "primal",
                 essential: Any = None, robin: Values | None = None, fixed: Any = None) -> None:
        self._complex = complex = as_cells(complex)
        self._space = space_of(complex, side, degree, essential, robin, fixed)
        self.cells: list[Integers] = self._space.cells()
        self._cell_degree = degree if side == "primal" else complex.dim - degree
        self.free = self.cells[self._cell_degree]

    @functools.cached_property
    def inside(self) -> Cells:
        """The cells with free values, and the operators on forms that vanish elsewhere.

        With Robin's condition the star below dual forms has its weights; primal forms have them
        in `stiffness`."""
        return Cells(self._space.inside())

    def stiffness(self) -> Any:
        """``star Delta`` on the free values, symmetric, with the weights of Robin's condition.

        For dual forms it is that of the primal forms whose stars they are: multiply solutions by
        ``inside.star(n - degree)``."""
        return self._space.stiffness()

    def restrict(self, values: Form, k: int | None = None) -> Floats:
        """The free values of a form; or for any k, the values on ``cells[k]``."""
        k = self._cell_degree if k is None else k
        given = of_kind(values, "values", ("primal", k), ("dual", self._complex.dim - k))
        rows = form_at_cells(self._complex, _rows(given), "primal", k)
        _check_as_many(rows, self._complex.size(k), f"one for each {k}-cell")
        return rows[self.cells[k]]

    def extend(self, values: npt.ArrayLike, k: int | None = None) -> Floats:
        """The inverse of `restrict`, with 0 on all other cells: one value per free cell."""
        k = self._cell_degree if k is None else k
        rows = _rows(values)
        _check_as_many(rows, len(self.cells[k]), f"one for each free {k}-cell")
        result = np.zeros((self._complex.size(k),) + rows.shape[1:])
        result[self.cells[k]] = rows
        return result

    def __repr__(self) -> str:
        return f"FormSpace({len(self.free)} free values; {self._space.in_words()})"


def _rows(values: Any) -> Floats:
    """A number or a row of numbers for each cell."""
    return floats(values, "values", np.ndim(values) or 1)


def _check_as_many(rows: Floats, expected: int, cells: str) -> None:
    if len(rows) != expected:
        raise InvalidInput(f"{len(rows)} values are given: expected {expected}, {cells}")
