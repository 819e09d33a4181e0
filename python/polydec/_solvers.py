# SPDX-License-Identifier: MIT
"""Problems: Poisson's, Darcy's, Hodge decompositions, heat, waves, distances."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Values, at_places, floats, integers, marks
from ._cells import Cells, Form, as_form
from ._cochain import Cochain
from ._complex import Complex
from ._engines import Solution
from ._errors import InvalidInput


def _facet_sites(complex: Cells) -> Floats:
    return complex.facet_sites() if isinstance(complex, Complex) else np.zeros((0, 0))


def _marks(complex: Cells, essential: Any) -> list[bool]:
    return marks(essential, _facet_sites(complex), complex.size(complex.dim - 1))


def _conductivity(values: Any) -> Floats:
    return floats([] if values is None else values, "conductivities")


class PoissonSolver:
    """Solves ``-div kappa grad u = f``, for kappa = 1 ``Delta u = f``, with one factorization.

    Parameters
    ----------
    complex : Cells
    side : {"primal", "dual"}
        Where u has its values: at vertices, or at circumcenters of n-cells.
    essential : bool or array of bool or callable
        Where on the boundary u is given (Dirichlet): everywhere, nowhere, or one mark for each
        (n-1)-cell; elsewhere its normal derivative is (Neumann). A callable takes all facet sites,
        an array (size(n-1), N), and returns marks.
    conductivity : array_like, optional
        kappa > 0 of each n-cell.
    engine : str
        A name of `backends`.

    Attributes
    ----------
    sites, boundary_sites, flux_sites : numpy.ndarray
        Places of f and u, of boundary values, and of normal derivatives, a row each.

    Raises
    ------
    InvalidInput
        Where dual 0-forms make no sense or an interior dual has no length; ``cells`` says where.
    """

    def __init__(self, complex: Cells, *, side: str = "primal", essential: Any = True,
                 conductivity: npt.ArrayLike | None = None, engine: str = "auto") -> None:
        self._solver = _core.PoissonSolver(complex._calculus, side, _marks(complex, essential),
                                           _conductivity(conductivity), engine)
        self.sites = self._solver.sites
        self.boundary_sites = self._solver.boundary_sites
        self.flux_sites = self._solver.flux_sites

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
            The derivative along the outward normal, times kappa, at `flux_sites`.
        """
        right = at_places(f, self.sites, "values of f")
        columns = 1 if right.ndim == 1 else right.shape[1]

        def table(values: Values, places: Floats, name: str) -> Floats:
            array = at_places(values, places, name)
            return np.ascontiguousarray(np.broadcast_to(
                array.reshape(len(array), -1), (len(array), columns)))

        values, report = self._solver.solve(
            right.reshape(len(right), -1), table(boundary, self.boundary_sites, "boundary values"),
            table(flux, self.flux_sites, "normal derivatives"))
        return Solution(values.reshape(right.shape), report)


def poisson(complex: Cells, f: Values = 0.0, boundary: Values = 0.0, flux: Values = 0.0, *,
            side: str = "primal", essential: Any = True,
            conductivity: npt.ArrayLike | None = None, engine: str = "auto") -> Solution:
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
    solver = PoissonSolver(complex, side=side, essential=essential, conductivity=conductivity,
                           engine=engine)
    return solver.solve(f, boundary, flux)
