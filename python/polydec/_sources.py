# SPDX-License-Identifier: MIT
"""Sources of forms: Delta u = f of any degree, magnets, slow flows."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Values, at_places, floats
from ._cells import Cells, Form, as_form
from ._cochain import Cochain
from ._complex import CellsLike, Complex, as_cells, mesh_of
from ._conditions import conditions_of, facet_marks


def _made(parts: tuple[str, int, Floats], cells: Cells) -> Cochain:
    side, degree, values = parts
    return Cochain(values, degree, side, cells if len(values) else None)


def _or_none(values: npt.ArrayLike | None, name: str) -> Floats:
    return np.zeros(0) if values is None else floats(np.asarray(values), name)


def boundary_data(*, values: npt.ArrayLike | None = None,
                  codifferential: npt.ArrayLike | None = None, flow: npt.ArrayLike | None = None,
                  derivative_flow: npt.ArrayLike | None = None
                  ) -> tuple[Floats, Floats, Floats, Floats]:
    """What is known on the boundary, as the module takes it."""
    return (_or_none(values, "values on the boundary"),
            _or_none(codifferential, "values of the codifferential on the boundary"),
            _or_none(flow, "values of the flow"),
            _or_none(derivative_flow, "values of the flow of the derivative"))


def outward_flow(complex: Complex, derivatives: Values, side: str = "primal") -> Floats:
    """The `derivative_flow` of 0-forms with these outward normal derivatives on the boundary.

    Parameters
    ----------
    complex : Complex
    derivatives : float, array_like or callable
        At `Complex.facet_sites`, of which those on the boundary matter.
    side : str

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> solver = polydec.HodgeLaplaceSolver(square, degree=0, essential=lambda p: p[:, 0] < 0.01)
    >>> pulled = polydec.outward_flow(square, lambda p: p[:, 0] > 0.99)     # u = x
    >>> u = solver.solve(np.zeros(25), derivative_flow=pulled).form
    >>> bool(abs(u.values - square.points[:, 0]).max() < 1e-12)
    True
    """
    return _core.outward_flow(mesh_of(complex), side,
                              at_places(derivatives, complex.facet_sites(), "outward derivatives"))


@dataclass(frozen=True)
class FormSolution:
    """A solution of ``Delta u = f`` and what was found beside it.

    Attributes
    ----------
    form : Cochain
        u.
    beside : Cochain
        delta u of a primal form, du of a dual one.
    removed : Cochain
        The harmonic part of the data, which no u can give.
    report : dict
        As that of a `Solution`.
    """

    form: Cochain
    beside: Cochain
    removed: Cochain
    report: dict[str, Any]


@dataclass(frozen=True)
class CurlCurlSolution:
    """A potential, what of the current is no curl, and how the solve went."""

    potential: Cochain
    removed: Cochain
    report: dict[str, Any]


class HodgeLaplaceSolver:
    """Solves ``Delta u = (d delta + delta d) u = f`` for forms of any degree, with one factorization.

    Harmonic forms obey ``Delta u = 0``: the harmonic part of f is removed and told, and u has the
    one that is asked for, by default none.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Of the forms.
    essential : bool or array of bool or callable
        Facets of the boundary where the tangential parts of u and of delta u are given; elsewhere
        those of star u and of star du are. As for `PoissonSolver`.
    robin : float, array_like or callable, optional
        Coefficients of Robin's condition where facets are not essential, as for `PoissonSolver`.
    engine : str
        A name of `backends`.

    Raises
    ------
    InvalidInput
        If the star of the forms or of those beside them is not positive; ``cells`` says where.
    """

    def __init__(self, complex: CellsLike, *, degree: int, side: str = "primal",
                 essential: Any = True, robin: Values | None = None,
                 engine: str = "auto") -> None:
        self._complex = complex = as_cells(complex)
        self._kind = side, degree
        self._solver = _core.HodgeLaplaceSolver(
            complex._cells, side, degree, conditions_of(complex, essential, robin), engine)

    def solve(self, f: Form, *, values: npt.ArrayLike | None = None,
              codifferential: npt.ArrayLike | None = None, flow: npt.ArrayLike | None = None,
              derivative_flow: npt.ArrayLike | None = None,
              harmonic: npt.ArrayLike | None = None) -> FormSolution:
        """u.

        Parameters
        ----------
        f : Cochain or array_like
            By its integrals over cells, as every form.
        values, codifferential : array_like, optional
            On essential facets, the traces of u and of delta u.
        flow, derivative_flow : array_like, optional
            On natural facets, those of star u and of star du. They all are integrals over cells on
            the boundary, or over their duals within it, as `boundary_de_rham` makes them; by
            default 0. The page on sources says of which cells.
        harmonic : array_like, optional
            Coefficients of u at `harmonic_forms`.
        """
        side, degree = self._kind
        data = boundary_data(values=values, codifferential=codifferential, flow=flow,
                             derivative_flow=derivative_flow)
        form, beside, removed, report = self._solver.solve(
            *as_form(self._complex, f, degree, side), data, _or_none(harmonic, "coefficients of harmonic forms"))
        return FormSolution(_made(form, self._complex), _made(beside, self._complex),
                            _made(removed, self._complex), report)

    def solve_curl_curl(self, current: Form, *,
                        values: npt.ArrayLike | None = None) -> CurlCurlSolution:
        """u with ``d^T star du = star j`` and ``delta u = 0``, of primal forms: magnetostatics.

        What of the current j is no curl is removed and told. `values` are those of u on the
        boundary, as for `solve`.
        """
        side, degree = self._kind
        none = np.zeros(0)
        potential, removed, report = self._solver.solve_curl_curl(
            *as_form(self._complex, current, degree, side),
            (_or_none(values, "values on the boundary"), none, none, none))
        return CurlCurlSolution(_made(potential, self._complex), _made(removed, self._complex),
                                report)

    def harmonic_forms(self) -> Floats:
        """Columns, orthonormal."""
        return self._solver.harmonic_forms()


def hodge_laplace(complex: CellsLike, f: Form, *, degree: int | None = None, side: str = "primal",
                  essential: Any = True, robin: Values | None = None,
                  engine: str = "auto") -> FormSolution:
    """Solves ``Delta u = f`` for forms of any degree: a `HodgeLaplaceSolver` made for one solve.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> torus = polydec.discretize(polydec.meshes.torus(12, 8))
    >>> f = torus.cochain(np.cos(np.arange(torus.size(1))), 1)
    >>> found = polydec.hodge_laplace(torus, f)
    >>> bool((found.form.laplacian() + found.removed - f).norm() < 1e-9)
    True
    """
    complex = as_cells(complex)
    given_side, k, values = as_form(complex, f, degree, side)
    solver = HodgeLaplaceSolver(complex, degree=k, side=given_side, essential=essential,
                                robin=robin, engine=engine)
    return solver.solve(values)


@dataclass(frozen=True)
class StokesFlow:
    """A slow flow: its flux, a primal (n-1)-form, its vorticity, a primal (n-2)-form, its pressure,
    a dual 0-form, and how the solve went."""

    flux: Cochain
    vorticity: Cochain
    pressure: Cochain
    report: dict[str, Any]


class StokesSolver:
    """Stokes' problem ``-nu Delta u + grad p = f``, ``div u = 0``, for slow flows.

    The balance of every cell is 0 to rounding. At each facet of the boundary two things are known:
    the velocity through it and along it (without slip), that through it and the vorticity (where
    the flow slips), or the pressure and the velocity along it (open). What is not given is 0.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    viscosity : float
        nu > 0.
    no_slip, open : bool or array of bool or callable
        Facets, as for `IncompressibleFlow`; along all others the flow slips.
    engine : str
        A name of `backends`.

    Raises
    ------
    InvalidInput
        Where stars are not positive, ``cells`` says where; and if nothing holds a flow back.

    Examples
    --------
    Between two plates, from one open end to the other, where pressure falls by 2 nu per length:

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(8, 8))
    >>> x = square.facet_sites()[:, 0]
    >>> flow = polydec.StokesSolver(square, open=abs(x - 0.5) > 0.49).solve(pressure=2 * (1 - x))
    >>> through = abs(flow.flux.values[x < 1e-9]).sum()
    >>> bool(abs(through - 1 / 6) < 0.01)
    True
    """

    def __init__(self, complex: CellsLike, *, viscosity: float = 1.0, no_slip: Any = True,
                 open: Any = False, engine: str = "auto") -> None:
        self._complex = complex = as_cells(complex)
        self._solver = _core.StokesSolver(complex._cells, viscosity,
                                          facet_marks(complex, no_slip),
                                          facet_marks(complex, open), engine)

    def solve(self, *, force: Form | None = None, through: npt.ArrayLike | None = None,
              along: npt.ArrayLike | None = None, vorticity: npt.ArrayLike | None = None,
              pressure: npt.ArrayLike | None = None) -> StokesFlow:
        """The flow. Values at other cells than they are for do not matter.

        Parameters
        ----------
        force : Cochain or array_like, optional
            The flux of f, a primal (n-1)-form.
        through : array_like, optional
            What flows through the facets of the boundary that are not open.
        along : array_like, optional
            The tangential velocity: integrals of the star of the flux, which is u for odd n and -u
            for even n, over the duals within the boundary of the (n-2)-cells, as
            `boundary_de_rham` makes them.
        vorticity : array_like, optional
            Where the flow slips, a primal (n-2)-form.
        pressure : array_like, optional
            At open facets, for each (n-1)-cell.
        """
        n = self._complex.dim
        none = np.zeros(self._complex.size(n - 1))
        _, degree, values = as_form(self._complex, none if force is None else force, n - 1)
        known = (_or_none(through, "fluxes"), _or_none(along, "velocities along the boundary"),
                 _or_none(vorticity, "vorticities"), _or_none(pressure, "pressures"))
        flux, found, head, report = self._solver.solve(degree, values, known)
        return StokesFlow(_made(flux, self._complex), _made(found, self._complex),
                          _made(head, self._complex), report)
