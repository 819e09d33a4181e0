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
    complex : Cells
    essential : bool or array of bool or callable
        Facets of the boundary where the pressure is given; elsewhere the outflow is.
    conductivity : array_like, optional
        kappa > 0 of each n-cell.
    engine : str
    """

    def __init__(self, complex: Cells, *, essential: Any = True,
                 conductivity: npt.ArrayLike | None = None, engine: str = "auto") -> None:
        self._complex = complex
        self._solver = _core.DarcySolver(complex._calculus, _marks(complex, essential),
                                         _conductivity(conductivity), engine)
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


def darcy(complex: Cells, source: Values = 0.0, pressure: Values = 0.0, outflow: Values = 0.0, *,
          essential: Any = True, conductivity: npt.ArrayLike | None = None,
          engine: str = "auto") -> DarcyFlow:
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
    """Hodge decompositions of forms of one side and degree."""

    def __init__(self, complex: Cells, *, degree: int, side: str = "primal",
                 engine: str = "auto") -> None:
        self._complex = complex
        self._kind = side, degree
        self._solver = _core.HodgeSolver(complex._calculus, side, degree, engine)

    def decompose(self, form: Form) -> HodgeParts:
        """The parts of a form."""
        side, degree = self._kind

        def made(parts: tuple[str, int, Floats]) -> Cochain:
            of, k, values = parts
            return Cochain(values, k, of, self._complex if len(values) else None)

        return HodgeParts(*map(made, self._solver.decompose(*as_form(form, degree, side))))

    def harmonic_forms(self) -> Floats:
        """Columns of norm 1, closed and coclosed, orthogonal to each other: Betti number many."""
        return self._solver.harmonic_forms()


def hodge_decomposition(complex: Cells, form: Form, *, degree: int | None = None,
                        side: str = "primal", engine: str = "auto") -> HodgeParts:
    """The Hodge decomposition of a form. For conditions on the boundary see `Cells.conditioned`.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> torus = polydec.discretize(polydec.meshes.torus(12, 8))
    >>> form = torus.cochain(np.cos(np.arange(torus.size(1))), 1)
    >>> parts = polydec.hodge_decomposition(torus, form)
    >>> np.allclose(parts.exact + parts.coexact + parts.harmonic, form)
    True
    """
    given_side, k, values = as_form(form, degree, side)
    solver = HodgeSolver(complex, degree=k, side=given_side, engine=engine)
    return solver.decompose(Cochain(values, k, given_side, complex))


def harmonic_forms(complex: Cells, degree: int, *, side: str = "primal",
                   engine: str = "auto") -> Floats:
    """A basis of the harmonic forms, a column each.

    >>> import polydec
    >>> polydec.harmonic_forms(polydec.discretize(polydec.meshes.torus(12, 8)), 1).shape
    (192, 2)
    """
    return HodgeSolver(complex, degree=degree, side=side, engine=engine).harmonic_forms()


class HeatSolver:
    """Steps of the heat equation du/dt = -Delta u for forms, with one factorization.

    Parameters
    ----------
    complex : Cells
    time_step : float
    degree, side
        Of the forms.
    scheme : {"backward_euler", "crank_nicolson"}
    essential : bool or array of bool or callable, optional
        As for `spectrum`.
    """

    def __init__(self, complex: Cells, time_step: float, *, degree: int = 0, side: str = "primal",
                 scheme: str = "backward_euler", essential: Any = None,
                 engine: str = "auto") -> None:
        marked = [] if essential is None else _marks(complex, essential)
        self._kind = side, degree
        self._solver = _core.HeatSolver(complex._calculus, marked, side, degree, time_step, scheme,
                                        engine)

    def step(self, u: Form, steps: int = 1) -> Floats:
        """The values so many steps later. Ctrl-C ends it between two steps."""
        side, degree = self._kind
        return self._solver.step(*as_form(u, degree, side), steps)[2]


def heat(complex: Cells, u: Form, time_step: float, steps: int = 1, *, degree: int = 0,
         side: str = "primal", scheme: str = "backward_euler", essential: Any = None,
         engine: str = "auto") -> Floats:
    """The values of a form after so many steps of the heat equation.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.icosphere(8))
    >>> z = polydec.heat(sphere, sphere.points[:, 2], 0.01, 10)      # decays by about exp(-2 t)
    >>> bool(0.81 < z.max() < 0.83)
    True
    """
    solver = HeatSolver(complex, time_step, degree=degree, side=side, scheme=scheme,
                        essential=essential, engine=engine)
    return solver.step(u, steps)


class Leapfrog:
    """Waves of primal k-forms: E a k-form at whole times, B a (k+1)-form at half times.

    For k = 1 in space these are Maxwell's equations, for k = 0 the scalar wave equation. On
    ``complex.conditioned(degree=k)`` E vanishes on the boundary; else nothing flows out.

    Parameters
    ----------
    complex : Cells
    k : int
    time_step : float
        Below `stable_step`.
    """

    def __init__(self, complex: Cells, k: int, time_step: float) -> None:
        self._waves = _core.Leapfrog(complex._calculus, k, time_step)
        self.time_step = time_step

    def step(self, E: npt.ArrayLike, B: npt.ArrayLike, steps: int = 1) -> tuple[Floats, Floats]:
        """E and B so many steps later. Ctrl-C ends it between two steps."""
        return self._waves.step(floats(E, "values of E"), floats(B, "values of B"), steps)

    def energy(self, E: npt.ArrayLike, B: npt.ArrayLike) -> float:
        """What every step conserves."""
        return self._waves.energy(floats(E, "values of E"), floats(B, "values of B"))


def stable_step(complex: Cells, k: int) -> float:
    """The length that time steps of `Leapfrog` must stay below."""
    return _core.stable_step(complex._calculus, k)


def wave(complex: Cells, E: npt.ArrayLike, time: float, B: npt.ArrayLike | None = None, *,
         k: int = 0, time_step: float | None = None) -> tuple[Floats, Floats]:
    """E and B of a wave after some time, by steps of equal length, at most 0.9 `stable_step`.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(16, 16))
    >>> x = np.cos(np.pi * square.points[:, 0])
    >>> E, B = polydec.wave(square, x, 2.0)           # one period
    >>> bool(abs(E - x).max() < 0.02)
    True
    """
    longest = 0.9 * stable_step(complex, k) if time_step is None else time_step
    steps = max(1, int(np.ceil(time / longest)))
    waves = Leapfrog(complex, k, time / steps)
    return waves.step(E, np.zeros(complex.size(k + 1)) if B is None else B, steps)


class GeodesicDistance:
    """Distances along a surface by the heat method, with two factorizations for all sources."""

    def __init__(self, complex: Complex, *, time_scale: float = 4.0, engine: str = "auto") -> None:
        self._solver = _core.GeodesicDistance(complex._mesh, time_scale, engine)

    def to(self, sources: npt.ArrayLike) -> Floats:
        """The distance of every vertex from the nearest source vertex."""
        return self._solver.to(integers(np.atleast_1d(np.asarray(sources)), "sources"))[0]


def geodesic_distance(complex: Complex, sources: npt.ArrayLike, *, time_scale: float = 4.0,
                      engine: str = "auto") -> Floats:
    """The distance of every vertex from the nearest source vertex, along the surface.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.icosphere(12))
    >>> north = int(sphere.points[:, 2].argmax())
    >>> far = polydec.geodesic_distance(sphere, north).max()
    >>> bool(abs(far - np.pi) < 0.05)
    True
    """
    return GeodesicDistance(complex, time_scale=time_scale, engine=engine).to(sources)


class ParallelTransport:
    """Tangent vectors carried along shortest ways over a two-sided surface.

    A vector is a complex number in the polar coordinates of its vertex: its argument is the angle
    from `directions`, the unit vectors in space along the reference edge of each vertex, in the
    direction in which the triangles are oriented. After flips edges have no direction in space, and
    `directions` is not to be had.
    """

    def __init__(self, complex: Complex, *, time_scale: float = 4.0, engine: str = "auto") -> None:
        self._complex = complex
        self._solver = _core.ParallelTransport(complex._mesh, time_scale, engine)

    @property
    def reference(self) -> Any:
        """The edge of each vertex that has angle 0, as a row (vertex, vertex it leads to)."""
        return self._solver.reference(self._complex._mesh)

    @property
    def directions(self) -> Floats:
        """The unit vector along it, a row for each vertex."""
        ends = self.reference
        edges = self._complex.points[ends[:, 1]] - self._complex.points[ends[:, 0]]
        return np.asarray(edges / np.linalg.norm(edges, axis=1)[:, None])

    def extend(self, sources: npt.ArrayLike, vectors: npt.ArrayLike) -> npt.NDArray[np.complex128]:
        """A vector at every vertex from one at each source vertex."""
        given = np.atleast_1d(np.asarray(vectors, dtype=np.complex128))
        real, imaginary = self._solver.extend(
            integers(np.atleast_1d(np.asarray(sources)), "sources"),
            floats(given.real, "vectors"), floats(given.imag, "vectors"))
        return np.asarray(real + 1j * imaginary)
