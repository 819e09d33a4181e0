# SPDX-License-Identifier: MIT
"""Two-sided bounds of eigenvalues and Poisson errors of the shape itself."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from . import _core
from ._arrays import Floats, Values, at_places
from ._boundary_data import check_use
from ._cell_data import CellNumbers, cell_data
from ._cells import Cells
from ._cochain import Form, function_values
from ._complex import CellsLike, Complex, Progress, as_complex, discretize
from ._conditions import space_of
from ._vertices import at_vertices


class CountBelow(NamedTuple):
    """Bounds `at_least` and `at_most` of the number of eigenvalues below a number; `at_most` is
    None on coarse meshes."""

    at_least: int
    at_most: int | None


@dataclass(frozen=True)
class ShapeSpectrum:
    """The smallest eigenvalues of a shape, each between `lower` and `upper`.

    Attributes
    ----------
    lower, upper : numpy.ndarray
        Ascending, with multiplicity.
    zeros : int
        Number of eigenvalues known to be 0.
    count_at : float
        A number above these eigenvalues.
    count : CountBelow
        Number of eigenvalues below `count_at`.
    modes : numpy.ndarray
        Columns: approximate eigenfunctions at vertices, nan at unused ones; no column for 1-forms.
    simplices, flips, factorizations : int
        Number of simplices, of edges flipped beforehand, and of inertia counts in the proof.
    """

    lower: Floats
    upper: Floats
    zeros: int
    count_at: float
    count: CountBelow
    modes: Floats
    simplices: int
    flips: int
    factorizations: int

    @property
    def widths(self) -> Floats:
        """Relative widths (upper - lower) / upper; 0 where the eigenvalue is known to be 0."""
        widths: Floats = np.zeros(len(self.upper))
        positive = slice(self.zeros, None)
        widths[positive] = 1 - self.lower[positive] / self.upper[positive]
        return widths

    def __repr__(self) -> str:
        pairs = [f"[{low:.6g}, {high:.6g}]" for low, high in zip(self.lower, self.upper)]
        shown = ", ".join(pairs[:4] + [".."] * (len(pairs) > 4))
        return f"ShapeSpectrum({len(pairs)} values {shown})"


def _shape(mesh: CellsLike, essential: Any, robin: Any, conductivity: Any,
           density: Any) -> tuple[Complex, tuple[_core.Discretization, _core.FormSpace,
                                                 _core.CellData, _core.CellData]]:
    """A mesh without merging, and what C++ takes of its shape."""
    complex = as_complex(mesh) if isinstance(mesh, Cells) else discretize(mesh, merge=False,
                                                                          star="galerkin")
    return complex, (complex._mesh, space_of(complex, "primal", 0, essential, robin),
                     cell_data(complex, conductivity, "conductivities"),
                     cell_data(complex, density, "densities"))


def shape_spectrum(mesh: CellsLike, *, degree: int = 0, count: int = 10, level: int = 2,
                   width: float = 0.0, max_triangles: int = 0, essential: Any = None,
                   robin: Values | None = None, conductivity: CellNumbers | None = None,
                   density: CellNumbers | None = None, flips: bool = True,
                   linear_solver: str = "auto", eigen_solver: str = "auto",
                   progress: Progress | None = None) -> ShapeSpectrum:
    """Encloses the smallest eigenvalues of the Laplacian on the shape (the continuous problem).

    The shape is a plane domain, a solid, or a polyhedral surface, which may branch and need not be
    orientable. Every bound is proved; see "What is proved" in the documentation.

    Parameters
    ----------
    mesh : a mesh as `discretize` takes it, or a Complex without merging
    degree : int
        0 for functions; the dimension for densities; on surfaces also 1.
    count : int
        Number of eigenvalues.
    level : {1, 2}
        Bounds of order 2 or 4.
    width : float
        Warns if (upper - lower) / upper exceeds this.
    max_triangles : int
        Bisects simplices up to this number while widths exceed `width`; 0: no bisection.
    essential, robin
        As for `spectrum`, for forms of this degree.
    conductivity, density : float, array_like, Cochain or callable, optional
        kappa and rho in -div kappa grad u = lambda rho u.
    flips : bool
        Whether to flip edges of surfaces first; flips change no eigenvalue.
    linear_solver, eigen_solver : str
        Engine names; see `backends`.
    progress : callable, optional
        Called with a description of each step. An exception stops the work.

    Raises
    ------
    InvalidInput
        For weights that are not positive.
    SolverFailure
        If eigenvalues cannot be computed or counted.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.meshes.grid(8, 8)
    >>> found = polydec.shape_spectrum(square, count=1, essential=True)
    >>> bool(found.lower[0] <= 2 * np.pi ** 2 <= found.upper[0] and found.widths[0] < 1e-3)
    True
    """
    complex, shape = _shape(mesh, essential, robin, conductivity, density)
    found = _core.shape_spectrum(*shape, flips, degree, count, level, width, max_triangles,
                                 linear_solver, eigen_solver, progress)
    found["count"] = CountBelow(*found["count"])
    found["modes"] = at_vertices(complex, found["modes"])
    return ShapeSpectrum(**found)


def count_below(mesh: CellsLike, s: float, *, degree: int = 0, level: int = 2,
                essential: Any = None, robin: Values | None = None,
                conductivity: CellNumbers | None = None, density: CellNumbers | None = None,
                flips: bool = True, linear_solver: str = "auto") -> CountBelow:
    """Two bounds of the number of eigenvalues of the shape below s, proved by inertia counts.

    Parameters
    ----------
    s : float
    mesh, degree, level, essential, robin, conductivity, density, flips, linear_solver
        As for `shape_spectrum`.

    Examples
    --------
    >>> import polydec
    >>> polydec.count_below(polydec.meshes.grid(8, 8), 25, essential=True)    # 2 pi^2, then 5 pi^2
    CountBelow(at_least=1, at_most=1)
    """
    _, shape = _shape(mesh, essential, robin, conductivity, density)
    return CountBelow(*_core.count_below(*shape, flips, s, degree, level, linear_solver))


@dataclass(frozen=True)
class PoissonError:
    """Upper bounds of the error of values u_h of a primal Poisson problem.

    Attributes
    ----------
    energy : float
        Error of the gradient: the norm of ``kappa^(1/2) grad(u - u_h)``, plus Robin's
        ``alpha^(1/2) (u - u_h)``, for u_h linear on simplices.
    averaged_gradient : float
        Error of the mean of grad u_h and an equilibrated flux; half of `energy` if f is constant on
        simplices.
    size : float
        The norm of ``kappa^(1/2) grad u_h``.
    oscillation : float
        Contribution of the linear parts of f.
    l2 : float or None
        L2 norm of u - u_h, up to constants if u is; None if not requested or not provable.
    shares : numpy.ndarray
        Share of each simplex in ``energy**2``; refine where it is large.
    """

    energy: float
    averaged_gradient: float
    size: float
    oscillation: float
    l2: float | None
    shares: Floats


def _problem(complex: CellsLike, f: Form | Values, flux: Values, essential: Any, robin: Any,
             conductivity: Any, **others: Form | Values
             ) -> tuple[tuple[_core.Discretization, _core.FormSpace, _core.CellData, Floats, Floats],
                        list[Floats]]:
    """What C++ takes of a problem, and values at vertices of other functions, by their names."""
    mesh = as_complex(complex, in_units=True)
    space = space_of(mesh, "primal", 0, essential, robin, otherwise=True)
    kappa = cell_data(mesh, conductivity, "conductivities")
    source, *functions = (function_values(mesh, given, mesh.points, f"values of {name}")
                          for name, given in {"f": f, **others}.items())
    through = at_places(flux, mesh.facet_sites(), "normal derivatives")
    check_use(space.require_use, 0, {"flux": flux})
    return (mesh._mesh, space, kappa, source, through), functions


def poisson_error(complex: CellsLike, u: Form | Values, f: Form | Values = 0.0,
                  flux: Values = 0.0, *, essential: Any = None, robin: Values | None = None,
                  conductivity: CellNumbers | None = None, l2_limit: int = 50_000,
                  engine: str = "auto") -> PoissonError:
    """A proved bound of the error of any approximate solution u of ``-div kappa grad u = f``.

    Data are interpolated: f linear on each simplex, boundary values linear and `flux` constant on
    each facet. If u is unique up to constants only, the mean of f is subtracted.

    Parameters
    ----------
    u : float, array_like, Cochain or callable
        Values at the vertices, including boundary values.
    f, flux, essential, robin, conductivity, engine
        As for `PoissonSolver` and its `solve`.
    l2_limit : int
        Largest number of simplices for which `l2`, the most expensive part, is computed; 0: never.

    Examples
    --------
    >>> import polydec
    >>> square = polydec.discretize(polydec.meshes.grid(16, 16))
    >>> u = polydec.poisson(square, 1.0).values
    >>> error = polydec.poisson_error(square, u, 1.0)
    >>> torsion = 0.0351442537                          # of the unit square: the square of |grad u|
    >>> (torsion - error.size ** 2) ** 0.5 < error.energy < 0.04
    True
    """
    problem, (given,) = _problem(complex, f, flux, essential, robin, conductivity, u=u)
    return PoissonError(**_core.poisson_error(*problem, given, l2_limit, engine))


def goal_interval(complex: CellsLike, u: Form | Values, f: Form | Values = 0.0,
                  flux: Values = 0.0, goal: Form | Values = 1.0, *, essential: Any = None,
                  robin: Values | None = None, conductivity: CellNumbers | None = None,
                  engine: str = "auto") -> tuple[float, float, float]:
    """Two bounds of the integral of goal times the solution over the shape, and an estimate.

    For the parameters see `poisson_error`. `goal` is given at vertices, and linear on simplices.

    Returns
    -------
    tuple
        lower, guess, upper

    Examples
    --------
    >>> import polydec
    >>> square = polydec.discretize(polydec.meshes.grid(16, 16))
    >>> low, _, high = polydec.goal_interval(square, polydec.poisson(square, 1.0).values, 1.0)
    >>> low < 0.0351442537 < high < low + 1e-3
    True
    """
    problem, (given, weights) = _problem(complex, f, flux, essential, robin, conductivity, u=u,
                                         goal=goal)
    return _core.goal_interval(*problem, given, weights, engine)
