# SPDX-License-Identifier: MIT
"""Poisson's equation for forms of any degree, magnetostatics, and Stokes flow."""
from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, OnFacets, Values, at_places, is_given, or_none
from ._boundary_data import boundary_data, check_use
from ._cell_data import CellNumbers
from ._cells import Cells
from ._cochain import Cochain, Form, as_form, function_values, made, of_kind, values_of
from ._complex import CellsLike, Complex, as_cells
from ._conditions import by_groups, facet_marks, facet_places, space_of
from ._errors import InvalidInput
from ._vertices import form_at_vertices


@dataclass(frozen=True)
class PoissonSolution:
    """The solution of ``Delta u = f`` and its flux. Converts to an array of the values of u.

    Attributes
    ----------
    form : Cochain
        u.
    flux : Cochain
        delta w, a primal form, where u is the primal form w or its star. For dual 0-forms: the flux
        of -kappa grad u through facets; ``flux.d()`` is then the integral of f over each cell.
    removed : Cochain
        The harmonic part of the data, which no u can match.
    report : dict
        As in `Solution`.
    """

    form: Cochain
    flux: Cochain
    removed: Cochain
    report: dict[str, Any]

    @property
    def values(self) -> Floats:
        """Values of u. At vertices: one per input vertex, nan where no cell uses the vertex."""
        u = self.form
        return form_at_vertices(u.complex, u.values, u.side, u.degree)

    def __array__(self, dtype: Any = None) -> npt.NDArray[Any]:
        return np.asarray(self.values, dtype=dtype)


@dataclass(frozen=True)
class CurlCurlSolution:
    """The `potential`, the part of the current `removed` because it is not a curl, and a `report` of the
    solve."""

    potential: Cochain
    removed: Cochain
    report: dict[str, Any]


class PoissonSolver:
    """Solves ``Delta u = (d delta + delta d) u = f`` for forms, with one factorization.

    For functions (0-forms) this is ``-div grad u = f``, or ``-div kappa grad u = f`` with a
    conductivity. For dual functions it is Darcy's problem. The harmonic part of f has no solution
    and is returned as ``removed``. The harmonic part of u is zero unless `harmonic` sets it.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Degree and side of the forms; by default primal 0-forms, with values at vertices. Dual
        0-forms have values at ``complex.dual_sites()``.
    essential : bool or array of bool or callable or str or list of str
        Boundary facets with given u (Dirichlet); for forms, given tangential parts of u and
        delta u. All, none, or one mark per (n-1)-cell; by default all, or none if `robin` is given.
        Elsewhere the normal derivative is given (Neumann); for forms, the tangential parts of
        star u and star du. A callable takes all facet sites, (size(n-1), N), and returns marks.
        Names select groups of the file.
    robin : float, array_like, callable or dict, optional
        Coefficients alpha on other facets, where du/dn + alpha u is given (Robin): positive, one
        for all facets or one each; du/dn is given where alpha is 0.
    fixed : array_like or callable or str, optional
        Further vertices with given u, also interior ones, for primal 0-forms. Same format as the
        sources of `geodesic_distance`.
    conductivity : float, array_like, Cochain or callable, optional
        kappa > 0, for 0-forms; see `Complex.with_conductivity`.
    engine : str
        Engine name; see `backends`.

    Attributes
    ----------
    sites, boundary_sites, flux_sites : numpy.ndarray
        For 0-forms: positions of f and u, of boundary values, and of normal derivatives, one row
        each. For primal forms all input vertices; where no cell uses a vertex, data are ignored and
        u is nan.

    Raises
    ------
    InvalidInput
        For ill-defined dual 0-forms or an interior dual of zero length. For other forms, if a star
        of their degree or a neighboring degree is not positive. ``cells`` says where.
    """

    def __init__(self, complex: CellsLike, *, degree: int = 0, side: str = "primal",
                 essential: Any = None, robin: OnFacets | None = None, fixed: Any = None,
                 conductivity: CellNumbers | None = None, engine: str = "auto") -> None:
        complex = as_cells(complex, in_units=True)
        if conductivity is not None:
            complex = _with_conductivity(complex, side, degree, conductivity)
        self._complex = complex
        self._kind = side, degree
        space = space_of(complex, side, degree, essential, robin, fixed, otherwise=True)
        self._require_use = functools.lru_cache(space.require_use)
        self._solver = _core.PoissonSolver(space, engine)
        self.sites, self.boundary_sites, self.flux_sites = _places(complex, side)

    def solve(self, f: Form | Values = 0.0, boundary: OnFacets = 0.0, flux: OnFacets = 0.0, *,
              codifferential: npt.ArrayLike | None = None, flow: npt.ArrayLike | None = None,
              derivative_flow: npt.ArrayLike | None = None,
              harmonic: npt.ArrayLike | None = None) -> PoissonSolution:
        """Solves for u.

        Parameters
        ----------
        f : Cochain, array_like, or for 0-forms a number or a callable
            Integrals of f over cells. For 0-forms, values at `sites`; a callable takes these
            points, (m, N).
        boundary : array_like, or for 0-forms a number, a callable or a dict
            Given values of u at `boundary_sites`; for other forms, integrals of the trace. A dict
            has a number for each group of the file, as in ``{"wall": 20.0}``; elsewhere 0.
        flux : float, array_like, callable or dict
            For 0-forms, kappa times the outward normal derivative at `flux_sites`; on Robin facets,
            plus the coefficient times u. It gives the `derivative_flow`.
        codifferential : array_like, optional
            On essential facets, the trace of delta u.
        flow, derivative_flow : array_like, optional
            On natural facets, the traces of star u and star du. All traces are integrals over cells
            on the boundary, or over their duals within it, as from `boundary_de_rham`; default 0.
            The documentation page on sources lists the cells.
        harmonic : array_like, optional
            Coefficients of the harmonic part of u in the basis `harmonic_forms`.

        Raises
        ------
        InvalidInput
            Also for data that apply to no facet of a mesh with boundary.
        """
        side, degree = self._kind
        given = _form_of(self._complex, f, side, degree, self.sites)
        trace = _trace_of(self._complex, boundary, side, degree, self.boundary_sites)
        through = self._flow_of(flux, derivative_flow) if is_given(flux) else derivative_flow
        data = boundary_data(values=trace, codifferential=codifferential, flow=flow,
                             derivative_flow=through)
        check_use(self._require_use, degree,
                  {"boundary": boundary, "codifferential": codifferential, "flux": flux,
                   "flow": flow, "derivative_flow": derivative_flow})
        form, found, removed, report = self._solver.solve(
            given, data, or_none(harmonic, "coefficients of harmonic forms"))
        return PoissonSolution(made(form, self._complex), made(found, self._complex),
                               made(removed, self._complex), report)

    def _flow_of(self, flux: OnFacets, derivative_flow: npt.ArrayLike | None) -> Floats:
        """The `derivative_flow` of a given flux."""
        side, degree = self._kind
        if degree > 0:
            raise InvalidInput(f"flux is given for {degree}-forms: expected derivative_flow, "
                               "integrals over cells on the boundary, as from boundary_de_rham")
        if derivative_flow is not None:
            raise InvalidInput("flux and derivative_flow are both given: expected one of them, "
                               "since the flux gives the derivative_flow")
        values = at_places(by_groups(self._complex, flux), self.flux_sites, "normal derivatives")
        return _core.outward_flow(self._complex._cells, side, values)

    def solve_curl_curl(self, current: Form, *,
                        boundary: npt.ArrayLike | None = None) -> CurlCurlSolution:
        """Magnetostatics: solves ``d^T star du = star j``, ``delta u = 0`` for primal forms u.

        Returns the exact and harmonic parts of the current j as ``removed``. `boundary` is the
        trace of u, as for `solve`.
        """
        side, degree = self._kind
        check_use(self._require_use, degree, {"boundary": boundary})
        potential, removed, report = self._solver.solve_curl_curl(
            as_form(self._complex, current, degree, side), boundary_data(values=boundary))
        return CurlCurlSolution(made(potential, self._complex), made(removed, self._complex),
                                report)

    def harmonic_forms(self) -> Floats:
        """Orthonormal basis of the harmonic forms, as columns."""
        return self._solver.harmonic_forms()


def _with_conductivity(cells: Cells, side: str, degree: int, kappa: CellNumbers) -> Complex:
    if degree != 0:
        raise InvalidInput(f"a conductivity is given for {degree}-forms: expected functions, of "
                           "degree 0; for other degrees use a star (Complex.with_material)")
    if not isinstance(cells, Complex):
        raise InvalidInput("conductivities are given for cells without a mesh, so the share of "
                           "each cell in the duals is unknown: give a mesh")
    return cells.with_conductivity(kappa, side)


def _places(cells: Cells, side: str) -> tuple[Floats, Floats, Floats]:
    """Positions of values, boundary values and fluxes of 0-forms."""
    facets = facet_places(cells)
    if not isinstance(cells, Complex):
        sites = np.zeros((cells.size(0, side), 0))
    else:
        sites = cells.points if side == "primal" else cells.dual_sites()
    return sites, sites if side == "primal" else facets, facets


def _form_of(cells: Cells, f: Form | Values, side: str, degree: int,
             places: Floats) -> tuple[str, int, Floats]:
    if degree == 0:
        return side, degree, function_values(cells, f, places, "values of f", side)
    given = _integrals(f, degree)
    if np.ndim(given) == 0:
        given = np.full(cells.size(degree, side), given)
    return as_form(cells, given, degree, side)


def _trace_of(cells: Cells, boundary: OnFacets, side: str, degree: int, places: Floats) -> Floats:
    if degree == 0:
        by_site = by_groups(cells, boundary, on_vertices=side == "primal")
        if side == "primal":
            return function_values(cells, by_site, places, "boundary values")
        return at_places(by_site, places, "boundary values")
    integrals = _integrals(boundary, degree)
    if is_given(integrals) and np.ndim(integrals) == 0:
        raise InvalidInput(f"boundary is {boundary!r} for {degree}-forms: expected integrals over "
                           "cells on the boundary, as from boundary_de_rham")
    return or_none(integrals if is_given(integrals) else None, "values on the boundary")


def _integrals(given: Any, degree: int) -> Any:
    if callable(given):
        raise InvalidInput(f"a function of positions is given for {degree}-forms: expected their "
                           "integrals, which de_rham computes")
    return given


def poisson(complex: CellsLike, f: Form | Values = 0.0, boundary: OnFacets = 0.0,
            flux: OnFacets = 0.0, *, degree: int | None = None, side: str = "primal",
            essential: Any = None, robin: OnFacets | None = None, fixed: Any = None,
            conductivity: CellNumbers | None = None, engine: str = "auto") -> PoissonSolution:
    """Solves ``Delta u = f`` once, by a `PoissonSolver`. A Cochain f gives side and degree;
    otherwise the default is primal 0-forms.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(8))
    >>> plane = lambda x: 1 + 2 * x[:, 0] - x[:, 1]
    >>> u = polydec.poisson(square, 0.0, plane)           # a linear function comes out exactly
    >>> bool(abs(u.values - plane(square.points)).max() < 1e-12)
    True

    The flux through facets balances in every cell:

    >>> flow = polydec.poisson(square, 1.0, side="dual")
    >>> np.allclose(square.d(1) @ flow.flux.values, square.volumes(2))
    True

    On a torus, the harmonic 1-forms have dimension two:

    >>> torus = polydec.discretize(polydec.meshes.torus(12, 8))
    >>> f = torus.cochain(np.cos(np.arange(torus.size(1))), 1)
    >>> found = polydec.poisson(torus, f)
    >>> bool((found.form.laplacian() + found.removed - f).norm() < 1e-9)
    True
    """
    if isinstance(f, Cochain):
        side, degree = f.side, f.degree
    solver = PoissonSolver(complex, degree=degree or 0, side=side, essential=essential, robin=robin,
                           fixed=fixed, conductivity=conductivity, engine=engine)
    return solver.solve(f, boundary, flux)


@dataclass(frozen=True)
class StokesFlow:
    """A Stokes flow: flux, a primal (n-1)-form; vorticity, a primal (n-2)-form; pressure, a dual
    0-form; and a report of the solve."""

    flux: Cochain
    vorticity: Cochain
    pressure: Cochain
    report: dict[str, Any]


class StokesSolver:
    """Solver of Stokes' problem ``-nu Delta u + grad p = f``, ``div u = 0``.

    The net flux out of every cell is 0 to rounding. Each boundary facet has two conditions: normal
    and tangential velocity (no slip), normal velocity and vorticity (slip), or pressure and
    tangential velocity. Data that are not given are 0.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    viscosity : float
        nu > 0.
    no_slip, pressure_on : bool or array of bool or callable
        Facets, as for `IncompressibleFlow`; the flow slips along all others.
    engine : str
        Engine name; see `backends`.

    Raises
    ------
    InvalidInput
        If stars are not positive; ``cells`` says where. Also if no condition restrains some flow.

    Examples
    --------
    Flow between two plates with known pressure at the ends; the pressure falls by 2 nu per unit length:

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(8, 8))
    >>> x = square.facet_sites()[:, 0]
    >>> flow = polydec.StokesSolver(square, pressure_on=abs(x - 0.5) > 0.49).solve(pressure=2 * (1 - x))
    >>> through = abs(flow.flux.values[x < 1e-9]).sum()
    >>> bool(abs(through - 1 / 6) < 0.01)
    True
    """

    def __init__(self, complex: CellsLike, *, viscosity: float = 1.0, no_slip: Any = True,
                 pressure_on: Any = False, engine: str = "auto") -> None:
        self._complex = complex = as_cells(complex)
        self._solver = _core.StokesSolver(complex._cells, viscosity,
                                          facet_marks(complex, no_slip),
                                          facet_marks(complex, pressure_on), engine)

    def solve(self, *, force: Form | None = None, through: npt.ArrayLike | None = None,
              along: npt.ArrayLike | None = None, vorticity: npt.ArrayLike | None = None,
              pressure: npt.ArrayLike | None = None) -> StokesFlow:
        """Solves for the flow. Ignores values at cells where they do not apply.

        Parameters
        ----------
        force : Cochain or array_like, optional
            The flux of f, a primal (n-1)-form.
        through : array_like, optional
            Flux through the boundary facets with a known flux.
        along : array_like, optional
            Tangential velocity: integrals of the star of the flux over the duals of (n-2)-cells
            within the boundary, as from `boundary_de_rham`. This star is u for odd n, else -u.
        vorticity : array_like, optional
            Vorticity on slip facets, a primal (n-2)-form.
        pressure : array_like, optional
            Pressure at facets where it is known, one value per (n-1)-cell.
        """
        n = self._complex.dim
        none = np.zeros(self._complex.size(n - 1))
        values = values_of(self._complex, none if force is None else force, "primal", n - 1,
                           "values of the force")
        known = (or_none(of_kind(through, "fluxes", ("primal", n - 1)), "fluxes"),
                 or_none(along, "velocities along the boundary"),
                 or_none(of_kind(vorticity, "vorticities", ("primal", n - 2)), "vorticities"),
                 or_none(pressure, "pressures"))
        flux, found, head, report = self._solver.solve(("primal", n - 1, values), known)
        return StokesFlow(made(flux, self._complex), made(found, self._complex),
                          made(head, self._complex), report)
