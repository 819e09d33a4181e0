# SPDX-License-Identifier: MIT
"""Incompressible flow, shallow water, and transport by fluxes."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Values, at_places, floats, or_none
from ._cells import Cells
from ._cochain import Form, values_of
from ._complex import CellsLike, Complex, as_complex
from ._conditions import facet_marks
from ._run import Run
from ._vertices import at_cells, mesh_of


def _fluxes(complex: Cells, w: Form) -> Floats:
    return values_of(complex, w, "primal", complex.dim - 1, "fluxes")


def _densities(complex: Cells, values: Form) -> Floats:
    return values_of(complex, values, "dual", 0, "densities")


def _vorticities(complex: Cells, values: Form | None) -> Floats:
    return np.zeros(0) if values is None else values_of(complex, values, "primal", complex.dim - 2,
                                                        "values of the rotation")


class IncompressibleFlow:
    """The equations of incompressible flow on surfaces and in solids, in any dimension n >= 2:
    ``du/dt + i_u omega = -dB - nu delta omega``, ``div u = 0``.

    The state is the flux w of u through facets, a primal (n-1)-form with ``d w = 0``. It contains
    the harmonic part of u. Without viscosity and open boundary, energy is conserved.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
    viscosity : float
        nu, length squared over time.
    no_slip : bool or array of bool or callable
        Boundary facets with no-slip walls. The flow slips along all other facets that are not open.
        A callable takes all facet sites, (size(n-1), N), and returns marks.
    open : bool or array of bool or callable
        Facets with total pressure 0, where flow enters and leaves freely.
    boundary_flux : array_like, optional
        Flux through each facet; only boundary facets that are not open count.
    wall_velocity : array_like or callable, optional
        Velocity of no-slip walls: one row of N components per facet site.
    rotation : array_like, optional
        Vorticity of the frame, such as a planet: a primal (n-2)-form.
    engine : str
        Engine name; see `backends`.

    Raises
    ------
    InvalidInput
        For branching or inconsistently oriented cells, stars that are not positive, and boundary
        fluxes that do not balance; ``cells`` says where. Also for marks, fluxes and velocities that
        apply to no facet of a mesh with boundary.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(6))
    >>> flow = polydec.IncompressibleFlow(sphere)
    >>> w = flow.project(sphere.d(0) @ sphere.points[:, 2])     # as a rigid body turns
    >>> run = polydec.Flow(flow, w, 0.1)
    >>> run.march(1.0)
    False
    >>> after = run.forms[0]
    >>> bool(abs(flow.energy(after) / flow.energy(w) - 1) < 1e-10)
    True
    """

    def __init__(self, complex: CellsLike, *, viscosity: float = 0.0, no_slip: Any = False,
                 open: Any = False, boundary_flux: npt.ArrayLike | None = None,
                 wall_velocity: Values | None = None, rotation: npt.ArrayLike | None = None,
                 engine: str = "auto") -> None:
        self._complex = complex = as_complex(complex)
        walls = np.zeros((0, 0)) if wall_velocity is None else _rows(wall_velocity,
                                                                     complex.facet_sites())
        none = np.zeros(0)
        self._flow = _core.IncompressibleFlow(
            complex._mesh, viscosity, facet_marks(complex, no_slip), facet_marks(complex, open),
            none if boundary_flux is None else _fluxes(complex, boundary_flux), walls,
            _vorticities(complex, rotation), engine)

    def project(self, flux: npt.ArrayLike) -> Floats:
        """The nearest divergence-free flow to these fluxes with the prescribed boundary fluxes. Warns
        if only rounding errors are left of the given fluxes, and the fluid is at rest."""
        return self._flow.project(_fluxes(self._complex, flux))

    def vorticity(self, w: npt.ArrayLike) -> Floats:
        """Vorticity, a primal (n-2)-form; for n = 2 at vertices."""
        return self._flow.vorticity(_fluxes(self._complex, w))

    def inertia(self, w: npt.ArrayLike) -> Floats:
        """Acceleration by inertia along the duals of facets, gradient part included."""
        return self._flow.inertia(_fluxes(self._complex, w))

    def friction(self, w: npt.ArrayLike) -> Floats:
        """Acceleration by friction along the duals of facets; linear in w."""
        return self._flow.friction(_fluxes(self._complex, w))

    def rate(self, w: npt.ArrayLike) -> Floats:
        """dw/dt."""
        return self._flow.rate(_fluxes(self._complex, w))

    def momentum(self, w: npt.ArrayLike) -> Floats:
        """``star w``: u along the duals of facets."""
        return self._flow.momentum(_fluxes(self._complex, w))

    def pressure(self, w: npt.ArrayLike) -> Floats:
        """Pressure over density, a dual 0-form, with mean 0 if no facet is open."""
        return self._flow.pressure(_fluxes(self._complex, w))

    def circulations(self, w: npt.ArrayLike) -> Floats:
        """``star z``: circulations around the (n-2)-cells. On a closed surface their sum is 0."""
        return self._flow.circulations(_fluxes(self._complex, w))

    def energy(self, w: npt.ArrayLike) -> float:
        """Kinetic energy ``w . star w / 2``."""
        return self._flow.energy(_fluxes(self._complex, w))

    def dissipation(self, w: npt.ArrayLike) -> float:
        """Rate of energy loss by friction if walls are at rest: ``nu |omega|^2``."""
        return self._flow.dissipation(_fluxes(self._complex, w))

    def divergence(self, w: npt.ArrayLike) -> float:
        """Largest net flux out of a cell, relative to its fluxes."""
        return self._flow.divergence(_fluxes(self._complex, w))

    def exchange_time(self, w: npt.ArrayLike) -> float:
        """Shortest time in which the content of a cell is exchanged; infinity at rest."""
        return self._flow.exchange_time(_fluxes(self._complex, w))


def _rows(values: Values, places: Floats) -> Floats:
    """One row per point, from rows, from one row for all, or from a function of the points."""
    if not callable(values) and np.ndim(values) == 1:
        values = np.tile(floats(values, "velocities"), (len(places), 1))
    return at_places(values, places, "velocities", 2)


def flow_of_vorticity(complex: Complex, vorticity: npt.ArrayLike) -> Floats:
    """Fluxes of the flow on a surface with this vorticity at the vertices, in 1 / time, without
    harmonic part. On closed surfaces the mean of the vorticity is removed.

    >>> import polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> z = sphere.points[:, 2]
    >>> flow = polydec.IncompressibleFlow(sphere)
    >>> bool(abs(flow.vorticity(polydec.flow_of_vorticity(sphere, z)) - z).max() < 1e-9)
    True
    """
    values = values_of(complex, vorticity, "primal", 0, "values of the vorticity")
    return _core.flow_of_vorticity(mesh_of(complex), values)


def flow_of_velocity(complex: Complex, velocity: npt.ArrayLike) -> Floats:
    """Fluxes of a velocity field with one row of N components per vertex, linear in between.
    `IncompressibleFlow.project` removes their divergence.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> w = polydec.flow_of_velocity(square, np.tile([1.0, 0.0], (square.size(0), 1)))
    >>> bool(abs(square.d(1) @ w).max() < 1e-12)
    True
    """
    rows = np.ascontiguousarray(at_cells(complex, floats(velocity, "velocities", 2)))
    return _core.flow_of_velocity(mesh_of(complex), rows)


def flux_through_boundary(complex: Complex, velocity: Values) -> Floats:
    """Fluxes of velocities through boundary facets, 0 elsewhere: ``boundary_flux`` of
    `IncompressibleFlow`. `velocity` is one row of N components, one row per facet site, or a
    function of the facet sites.

    >>> import polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> w = polydec.flux_through_boundary(square, [1.0, 0.0])
    >>> round(abs(w).sum(), 12)                   # in on one side, and out on the other
    2.0
    """
    return _core.flux_through_boundary(mesh_of(complex), _rows(velocity, complex.facet_sites()))


class Flow(Run):
    """Time integration of an incompressible flow, with one factorization for all steps.

    Parameters
    ----------
    equations : IncompressibleFlow
    w : Cochain or array_like
        Fluxes at time 0, as returned by `IncompressibleFlow.project`. `forms` contains only w.
    time_step : float
        At most about `IncompressibleFlow.exchange_time`.
    scheme : {"implicit_midpoint", "imex"}
        Implicit midpoint is second-order, and conserves energy without viscosity. A warning tells
        of friction at rates above 2 / time_step, which it does not follow. IMEX is third-order,
        with explicit inertia and implicit friction.
    tolerance : float
        Implicit midpoint only: relative change of the flow in the last pass.
    most_passes : int
    """

    def __init__(self, equations: IncompressibleFlow, w: npt.ArrayLike, time_step: float, *,
                 scheme: str = "implicit_midpoint", tolerance: float = 1e-13,
                 most_passes: int = 100) -> None:
        self._complex = equations._complex
        self._kinds = [("primal", self._complex.dim - 1)]
        self._run = _core.flow(equations._flow, _fluxes(self._complex, w), time_step, scheme,
                               tolerance, most_passes)

    @property
    def time_step(self) -> float:
        """Length of a step."""
        return self._run.time_step()


class ShallowWater:
    """Shallow water on surfaces: ``dh/dt + div(h u) = 0``,
    ``du/dt + i_(h u) q = -d(|u|^2 / 2 + g (h + b))``, q the potential vorticity.

    The depth h has one value per cell (a dual 0-form); u is stored as its flux through edges.
    Walls are impermeable, with free slip. Mass is conserved to rounding, energy up to the error of
    the time steps.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
        Needs positive diagonal stars.
    gravity : float
        g.
    rotation : array_like, optional
        Vorticity of the frame at vertices; for a planet, 2 Omega sin(latitude).
    bottom : array_like, optional
        Height b of the bottom in each cell.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> water = polydec.ShallowWater(sphere, rotation=2 * sphere.points[:, 2])
    >>> depth, flux = 1 + 0.1 * sphere.centers(2)[:, 0], np.zeros(sphere.size(1))
    >>> start = [sphere.cochain(depth, 0, "dual"), sphere.cochain(flux, 1)]
    >>> run = polydec.Evolution(sphere, start, reaction=water)
    >>> run.march(0.5)
    False
    >>> bool(abs(water.mass(*run.forms) / water.mass(depth, flux) - 1) < 1e-13)
    True
    """

    def __init__(self, complex: CellsLike, *, gravity: float = 1.0,
                 rotation: npt.ArrayLike | None = None,
                 bottom: npt.ArrayLike | None = None) -> None:
        self._complex = complex = as_complex(complex)
        self._water = _core.ShallowWater(
            complex._mesh, gravity, _vorticities(complex, rotation),
            np.zeros(0) if bottom is None else values_of(complex, bottom, "dual", 0,
                                                         "heights of the bottom"))

    def rate(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> tuple[Floats, Floats]:
        """dh/dt and the rate of the flux."""
        return self._water.rate(*self._state(depth, flux))

    def __call__(self, t: float, depth: npt.ArrayLike,
                 flux: npt.ArrayLike) -> tuple[Floats, Floats]:
        """The rates as the reaction of an `Evolution` of depth (a dual 0-form) and flux. Not a
        number where the depth is not above 0, so that a step is taken again, shorter."""
        return self._water.reaction(t, *self._state(depth, flux))

    def stable_step(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """Stable time step for waves and advection."""
        return self._water.stable_step(*self._state(depth, flux))

    def mass(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """The volume of all water."""
        return self._water.mass(*self._state(depth, flux))

    def energy(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """Kinetic plus potential energy, over density."""
        return self._water.energy(*self._state(depth, flux))

    def potential_vorticity(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> Floats:
        """q at the vertices."""
        return self._water.potential_vorticity(*self._state(depth, flux))

    def potential_enstrophy(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """The sum of ``h q^2 / 2`` over the duals of vertices."""
        return self._water.potential_enstrophy(*self._state(depth, flux))

    def _state(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> tuple[Floats, Floats]:
        return _densities(self._complex, depth), _fluxes(self._complex, flux)


class FluxTransport:
    """Transport of a density by fluxes: ``d rho/dt + div(rho u) = 0``. Conserves mass to rounding.

    The density rho is a dual 0-form, one value per n-cell. The flux of u is a primal (n-1)-form.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
    sampling : {"upwind", "centered"}
        Density at a facet. "upwind" takes the upwind cell: first-order, no new extrema. "centered"
        takes the mean of both cells: second-order.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.hexagons(8))
    >>> flow = polydec.poisson(square, 1.0, side="dual").flux.values
    >>> carried = polydec.FluxTransport(square)
    >>> rho, dt = np.ones(square.size(2)), 0.9 * carried.stable_step(flow)
    >>> lost = dt * carried.outflow(carried.mass_flux(flow, rho))
    >>> after = rho + dt * carried.rate(flow, rho)
    >>> bool(abs(carried.mass(after) + lost - carried.mass(rho)) < 1e-14)
    True
    """

    def __init__(self, complex: CellsLike, *, sampling: str = "upwind") -> None:
        self._complex = complex = as_complex(complex)
        self._transport = _core.FluxTransport(complex._mesh, sampling)

    def mass_flux(self, flux: npt.ArrayLike, density: npt.ArrayLike,
                  outside: npt.ArrayLike | None = None) -> Floats:
        """Mass flux through each facet. `outside` has the densities at inflow facets."""
        return self._transport.mass_flux(*self._given(flux, density, outside))

    def rate(self, flux: npt.ArrayLike, density: npt.ArrayLike,
             outside: npt.ArrayLike | None = None) -> Floats:
        """d rho/dt in each n-cell."""
        return self._transport.rate(*self._given(flux, density, outside))

    def stable_step(self, flux: npt.ArrayLike) -> float:
        """Time step in which the outflow of some cell equals its content."""
        return self._transport.stable_step(_fluxes(self._complex, flux))

    def mass(self, density: npt.ArrayLike) -> float:
        """Total mass: the sum of density times volume."""
        return self._transport.mass(_densities(self._complex, density))

    def outflow(self, mass_flux: npt.ArrayLike) -> float:
        """Rate of mass loss through the boundary."""
        return self._transport.outflow(_fluxes(self._complex, mass_flux))

    def _given(self, flux: npt.ArrayLike, density: npt.ArrayLike,
               outside: npt.ArrayLike | None) -> tuple[Floats, Floats, Floats]:
        return (_fluxes(self._complex, flux), _densities(self._complex, density),
                or_none(outside, "densities outside"))
