# SPDX-License-Identifier: MIT
"""Problems at rest: Poisson's, Darcy's, Hodge decompositions."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _core
from ._arrays import Floats, Values, at_places
from ._cell_data import CellNumbers, cell_data
from ._cells import Form, as_form
from ._cochain import Cochain
from ._complex import CellsLike, Complex, as_cells
from ._conditions import conditions_of, conditions_or_none
from ._vertices import at_cells, at_vertices
from ._engines import Solution


class PoissonSolver:
    """Solves ``-div kappa grad u = f``, for kappa = 1 ``Delta u = f``, with one factorization.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    side : {"primal", "dual"}
        Where u has its values: at vertices, or at circumcenters of n-cells.
    essential : bool or array of bool or callable or str or list of str
        Where on the boundary u is given (Dirichlet): everywhere, nowhere, or one mark for each
        (n-1)-cell; elsewhere its normal derivative is (Neumann). A callable takes all facet sites,
        an array (size(n-1), N), and returns marks; groups of the file are given by their names.
    robin : float, array_like or callable, optional
        Where u is not given, its normal derivative plus this coefficient times u is (Robin):
        positive, one for all facets or one for each; where it is 0 the normal derivative is given.
    fixed : array_like or callable or str, optional
        Vertices at which u is given besides, inside as well, of primal 0-forms: as sources of
        `geodesic_distance`.
    conductivity : float, array_like, Cochain or callable, optional
        kappa > 0: one for each cell of the input, in its order (simplices, or polygons and solids
        that were split), a dual 0-form, or a function of the centroids of the n-cells.
    engine : str
        A name of `backends`.

    Attributes
    ----------
    sites, boundary_sites, flux_sites : numpy.ndarray
        Places of f and u, of boundary values, and of normal derivatives, a row each. Of primal
        forms all vertices that were given; where no cell uses one data do not matter, and u is
        nan.

    Raises
    ------
    InvalidInput
        Where dual 0-forms make no sense or an interior dual has no length; ``cells`` says where.
    """

    def __init__(self, complex: CellsLike, *, side: str = "primal", essential: Any = True,
                 robin: Values | None = None, fixed: Any = None,
                 conductivity: CellNumbers | None = None, engine: str = "auto") -> None:
        complex = as_cells(complex, in_units=True)
        self._solver = _core.PoissonSolver(complex._cells, side,
                                           conditions_of(complex, essential, robin, fixed),
                                           cell_data(complex, conductivity, "conductivities"), engine)
        self._complex = complex
        self._are_vertices = side == "primal"
        self.sites = self._solver.sites
        self.boundary_sites = self._solver.boundary_sites
        if self._are_vertices and isinstance(complex, Complex):
            self.sites = self.boundary_sites = complex.points
        self.flux_sites = self._solver.flux_sites

    def _at_vertices(self, rows: Floats) -> Floats:
        return at_vertices(self._complex, rows) if self._are_vertices else rows

    def _at_cells(self, rows: Floats) -> Floats:
        return at_cells(self._complex, rows) if self._are_vertices else rows

    def solve(self, f: Values = 0.0, boundary: Values = 0.0, flux: Values = 0.0) -> Solution:
        """u at the sites.

        Parameters
        ----------
        f : float or array or callable
            At `sites`; a callable takes all of them, (m, N), and returns m values. Several
            problems may be given at once, a column each.
        boundary : float or array or callable
            u at `boundary_sites`; other than essential places do not matter.
        flux : float or array or callable
            The derivative along the outward normal, times kappa, at `flux_sites`; where there is
            Robin's condition with its coefficient times u added.
        """
        given = at_places(f, self.sites, "values of f")
        right = self._at_cells(given)
        columns = 1 if right.ndim == 1 else right.shape[1]

        def table(values: Values, places: Floats, name: str) -> Floats:
            array = at_places(values, places, name)
            return np.ascontiguousarray(np.broadcast_to(
                array.reshape(len(array), -1), (len(array), columns)))

        values, report = self._solver.solve(
            right.reshape(len(right), -1),
            self._at_cells(table(boundary, self.boundary_sites, "boundary values")),
            table(flux, self.flux_sites, "normal derivatives"))
        return Solution(self._at_vertices(values.reshape(right.shape)), report)


def poisson(complex: CellsLike, f: Values = 0.0, boundary: Values = 0.0, flux: Values = 0.0, *,
            side: str = "primal", essential: Any = True, robin: Values | None = None,
            fixed: Any = None, conductivity: CellNumbers | None = None,
            engine: str = "auto") -> Solution:
    """Solves ``-div kappa grad u = f``: a `PoissonSolver` made for one solve.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(8))
    >>> plane = lambda x: 1 + 2 * x[:, 0] - x[:, 1]
    >>> u = polydec.poisson(square, 0.0, plane)           # a linear function comes out exactly
    >>> bool(abs(u.values - plane(square.points)).max() < 1e-12)
    True
    """
    solver = PoissonSolver(complex, side=side, essential=essential, robin=robin, fixed=fixed,
                           conductivity=conductivity, engine=engine)
    return solver.solve(f, boundary, flux)


@dataclass(frozen=True)
class DarcyFlow:
    """Pressure, a dual 0-form, and flux, a primal (n-1)-form, and how the solve went."""

    pressure: Cochain
    flux: Cochain
    report: dict[str, Any]


class DarcySolver:
    """Flow through a porous medium: flux = -kappa grad p, div flux = source, balanced in each cell.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    essential : bool or array of bool or callable
        Facets of the boundary where the pressure is given; elsewhere the outflow is.
    conductivity : float, array_like, Cochain or callable, optional
        kappa > 0, as `PoissonSolver` takes it.
    engine : str
    """

    def __init__(self, complex: CellsLike, *, essential: Any = True,
                 conductivity: CellNumbers | None = None, engine: str = "auto") -> None:
        self._complex = complex = as_cells(complex)
        self._solver = _core.DarcySolver(complex._cells, conditions_of(complex, essential),
                                         cell_data(complex, conductivity, "conductivities"), engine)
        self.sites = self._solver.sites
        self.facet_sites = self._solver.facet_sites

    def solve(self, source: Values = 0.0, pressure: Values = 0.0,
              outflow: Values = 0.0) -> DarcyFlow:
        """Of a source per volume at `sites`, pressures and outflow per area at `facet_sites`."""
        pressures, flux, report = self._solver.solve(
            at_places(source, self.sites, "sources"),
            at_places(pressure, self.facet_sites, "pressures"),
            at_places(outflow, self.facet_sites, "values of the outflow"))
        return DarcyFlow(Cochain(pressures[2], pressures[1], pressures[0], self._complex),
                         Cochain(flux[2], flux[1], flux[0], self._complex), report)


def darcy(complex: CellsLike, source: Values = 0.0, pressure: Values = 0.0,
          outflow: Values = 0.0, *, essential: Any = True,
          conductivity: CellNumbers | None = None, engine: str = "auto") -> DarcyFlow:
    """A `DarcySolver` made for one solve.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.hexagons(4))
    >>> flow = polydec.darcy(square, source=1.0)
    >>> np.allclose(square.d(1) @ flow.flux.values, square.volumes(2))
    True
    """
    solver = DarcySolver(complex, essential=essential, conductivity=conductivity, engine=engine)
    return solver.solve(source, pressure, outflow)


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
