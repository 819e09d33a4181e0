# SPDX-License-Identifier: MIT
"""Hodge decompositions and harmonic forms."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from . import _core
from ._arrays import Floats
from ._cells import Form, as_form
from ._cochain import Cochain
from ._complex import CellsLike, as_cells
from ._conditions import conditions_or_none


@dataclass(frozen=True)
class HodgeParts:
    """A form as the sum of an exact, a coexact and a harmonic one, orthogonal to each other.

    ``potential.d()`` is the exact part, ``copotential.d()`` the star of the coexact one.
    """

    exact: Cochain
    coexact: Cochain
    harmonic: Cochain
    potential: Cochain
    copotential: Cochain


class HodgeSolver:
    """Hodge decompositions of forms of one side and degree, with factorizations for all of them.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Of the forms.
    essential
        Where on the boundary the forms and their potentials are 0, as for `spectrum`; without it
        the conditions hold that need nothing done about the boundary.
    engine : str
        A name of `backends`.
    """

    def __init__(self, complex: CellsLike, *, degree: int, side: str = "primal",
                 essential: Any = None, engine: str = "auto") -> None:
        self._complex = complex = as_cells(complex, in_units=True)
        self._kind = side, degree
        self._solver = _core.HodgeSolver(complex._cells, side, degree,
                                         conditions_or_none(complex, essential), engine)

    def decompose(self, form: Form) -> HodgeParts:
        """The parts of a form."""
        side, degree = self._kind

        def made(parts: tuple[str, int, Floats]) -> Cochain:
            of, k, values = parts
            return Cochain(values, k, of, self._complex if len(values) else None)

        return HodgeParts(*map(made, self._solver.decompose(*as_form(self._complex, form, degree, side))))

    def harmonic_forms(self) -> Floats:
        """Columns of norm 1, closed and coclosed, orthogonal to each other: Betti number many."""
        return self._solver.harmonic_forms()


def hodge_decomposition(complex: CellsLike, form: Form, *, degree: int | None = None,
                        side: str = "primal", essential: Any = None,
                        engine: str = "auto") -> HodgeParts:
    """The Hodge decomposition of a form, as a `HodgeSolver` makes it.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> torus = polydec.discretize(polydec.meshes.torus(12, 8))
    >>> form = torus.cochain(np.cos(np.arange(torus.size(1))), 1)
    >>> parts = polydec.hodge_decomposition(torus, form)
    >>> np.allclose(parts.exact + parts.coexact + parts.harmonic, form)
    True
    """
    complex = as_cells(complex)
    given_side, k, values = as_form(complex, form, degree, side)
    solver = HodgeSolver(complex, degree=k, side=given_side, essential=essential, engine=engine)
    return solver.decompose(Cochain(values, k, given_side, complex))


def harmonic_forms(complex: CellsLike, degree: int, *, side: str = "primal",
                   essential: Any = None, engine: str = "auto") -> Floats:
    """A basis of the harmonic forms, a column each, as a `HodgeSolver` makes it.

    >>> import polydec
    >>> polydec.harmonic_forms(polydec.discretize(polydec.meshes.torus(12, 8)), 1).shape
    (192, 2)
    """
    return HodgeSolver(complex, degree=degree, side=side, essential=essential,
                       engine=engine).harmonic_forms()
