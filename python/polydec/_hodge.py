# SPDX-License-Identifier: MIT
"""Hodge decompositions and harmonic forms."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from . import _core
from ._arrays import Floats
from ._cochain import Cochain, Form, as_form, made
from ._complex import CellsLike, as_cells
from ._conditions import space_of


@dataclass(frozen=True)
class HodgeParts:
    """A form as the orthogonal sum of an exact, a coexact and a harmonic form.

    The inner product is that of the free values: it differs from that of all cells only where
    values of dual forms are fixed and the star is a matrix.
    ``potential.d()`` is the exact part and ``copotential.d()`` the star of the coexact part, at
    cells whose values no condition fixes.
    """

    exact: Cochain
    coexact: Cochain
    harmonic: Cochain
    potential: Cochain
    copotential: Cochain


class HodgeSolver:
    """Hodge decompositions of forms of one side and degree. Reuses its factorizations.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Degree and side of the forms.
    essential
        Boundary facets where the forms and their potentials are 0, as for `spectrum`. Default
        conditions: natural for primal forms, zero values for dual forms.
    engine : str
        Engine name; see `backends`.
    """

    def __init__(self, complex: CellsLike, *, degree: int, side: str = "primal",
                 essential: Any = None, engine: str = "auto") -> None:
        self._complex = complex = as_cells(complex, in_units=True)
        self._kind = degree, side
        self._solver = _core.HodgeSolver(space_of(complex, side, degree, essential), engine)

    def decompose(self, form: Form) -> HodgeParts:
        """Decomposes a form."""
        parts = self._solver.decompose(as_form(self._complex, form, *self._kind))
        return HodgeParts(*(made(part, self._complex) for part in parts))

    def harmonic_forms(self) -> Floats:
        """Harmonic basis: orthonormal columns, closed and coclosed, as many as the Betti number."""
        return self._solver.harmonic_forms()


def hodge_decomposition(complex: CellsLike, form: Form, *, degree: int | None = None,
                        side: str = "primal", essential: Any = None,
                        engine: str = "auto") -> HodgeParts:
    """Hodge decomposition of a form, by a `HodgeSolver`.

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
    side, k, values = as_form(complex, form, degree, side)
    solver = HodgeSolver(complex, degree=k, side=side, essential=essential, engine=engine)
    return solver.decompose(values)


def harmonic_forms(complex: CellsLike, degree: int, *, side: str = "primal",
                   essential: Any = None, engine: str = "auto") -> Floats:
    """Basis of the harmonic forms, one column each, by a `HodgeSolver`.

    >>> import polydec
    >>> polydec.harmonic_forms(polydec.discretize(polydec.meshes.torus(12, 8)), 1).shape
    (192, 2)
    """
    return HodgeSolver(complex, degree=degree, side=side, essential=essential,
                       engine=engine).harmonic_forms()
