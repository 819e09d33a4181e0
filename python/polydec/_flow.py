# SPDX-License-Identifier: MIT
"""Flows: incompressible ones, and what fluxes carry."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Values, at_places, floats
from ._cochain import Cochain
from ._complex import CellsLike, Complex, as_complex, mesh_of
from ._conditions import facet_marks
from ._run import Run
from ._vertices import at_cells


def _fluxes(w: npt.ArrayLike) -> Floats:
    return floats(w.values if isinstance(w, Cochain) else w, "fluxes")


class IncompressibleFlow:
    """The equations of incompressible flow on surfaces and in solids, in any dimension n >= 2:
    ``du/dt + i_u omega = -dB - nu delta omega``, ``div u = 0``.

    The state is the flux w of u through facets, a primal (n-1)-form with ``d w = 0``, so all of u
    is there, the harmonic part too. Without viscosity and open boundary its energy is kept.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
    viscosity : float
        nu, length squared over time.
    no_slip : bool or array of bool or callable
        Facets of the boundary with walls that hold the flow; along all others, which are not open,
        it slips. A callable takes all facet sites, (size(n-1), N), and returns marks.
    open : bool or array of bool or callable
        Facets where the total pressure is 0: the flow goes in and out as it likes.
    boundary_flux : array_like, optional
        Through each facet, of which those of the boundary count that are not open.
    wall_velocity : array_like or callable, optional
        Of walls without slip, a row of N components at each facet site.
    rotation : array_like, optional
        Vorticity of the frame, as of a planet: a primal (n-2)-form.
    engine : str
        A name of `backends`.

    Raises
    ------
    InvalidInput
        For cells that branch or are not oriented alike, stars that are not positive, and more that
        flows in than out; ``cells`` says where.

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
            none if boundary_flux is None else _fluxes(boundary_flux), walls,
            none if rotation is None else floats(rotation, "values of the rotation"), engine)

    def project(self, flux: npt.ArrayLike) -> Floats:
        """The flow with the fluxes at the boundary and without divergence that is nearest to these
        fluxes."""
        return self._flow.project(_fluxes(flux))

    def vorticity(self, w: npt.ArrayLike) -> Floats:
        """A primal (n-2)-form: for n = 2 the vorticity at vertices."""
        return self._flow.vorticity(_fluxes(w))

    def inertia(self, w: npt.ArrayLike) -> Floats:
        """What accelerates the flow along the duals of facets by its inertia, gradients left."""
        return self._flow.inertia(_fluxes(w))

    def friction(self, w: npt.ArrayLike) -> Floats:
        """The same by friction; linear in w."""
        return self._flow.friction(_fluxes(w))

    def rate(self, w: npt.ArrayLike) -> Floats:
        """dw/dt."""
        return self._flow.rate(_fluxes(w))

    def momentum(self, w: npt.ArrayLike) -> Floats:
        """``star w``: u along the duals of facets."""
        return self._flow.momentum(_fluxes(w))

    def pressure(self, w: npt.ArrayLike) -> Floats:
        """The pressure over the density, a dual 0-form, with mean 0 if no boundary is open."""
        return self._flow.pressure(_fluxes(w))

    def circulations(self, w: npt.ArrayLike) -> Floats:
        """Circulations around the (n-2)-cells, whose sum no flow on a closed surface changes."""
        return self._flow.circulations(_fluxes(w))

    def energy(self, w: npt.ArrayLike) -> float:
        """``w . star w / 2``."""
        return self._flow.energy(_fluxes(w))

    def dissipation(self, w: npt.ArrayLike) -> float:
        """The rate at which friction takes of it where walls rest: ``nu |omega|^2``."""
        return self._flow.dissipation(_fluxes(w))

    def divergence(self, w: npt.ArrayLike) -> float:
        """The largest sum of fluxes out of a cell, relative to its fluxes."""
        return self._flow.divergence(_fluxes(w))

    def exchange_time(self, w: npt.ArrayLike) -> float:
        """The time in which the content of some cell is exchanged; infinity at rest."""
        return self._flow.exchange_time(_fluxes(w))


def _rows(values: Values, places: Floats) -> Floats:
    """A row for each place: those given, one for all, or those of a function of the places."""
    if not callable(values) and np.ndim(values) == 1:
        values = np.tile(np.asarray(values, dtype=np.float64), (len(places), 1))
    rows = at_places(values, places, "velocities")
    return floats(rows, "velocities", 2)


def flow_of_vorticity(complex: Complex, vorticity: npt.ArrayLike) -> Floats:
    """The flux of the flow on a surface that has this vorticity at the vertices, 1 / time, without
    harmonic part; on closed surfaces the mean of the vorticity is removed.

    >>> import polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> z = sphere.points[:, 2]
    >>> flow = polydec.IncompressibleFlow(sphere)
    >>> bool(abs(flow.vorticity(polydec.flow_of_vorticity(sphere, z)) - z).max() < 1e-9)
    True
    """
    values = np.ascontiguousarray(at_cells(complex, floats(vorticity, "values of the vorticity")))
    return _core.flow_of_vorticity(mesh_of(complex), values)


def flow_of_velocity(complex: Complex, velocity: npt.ArrayLike) -> Floats:
    """The fluxes of a field of velocities at the vertices, a row of N for each, linear between them;
    `IncompressibleFlow.project` takes what divergence they have.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> w = polydec.flow_of_velocity(square, np.tile([1.0, 0.0], (square.size(0), 1)))
    >>> bool(abs(square.d(1) @ w).max() < 1e-12)
    True
    """
    rows = np.ascontiguousarray(at_cells(complex, floats(velocity, "velocities", 2)))
    return _core.flow_of_velocity(mesh_of(complex), rows)


def flux_through_boundary(complex: Complex, velocity: Values) -> Floats:
    """The fluxes of velocities at the facets of the boundary, 0 elsewhere: what `IncompressibleFlow`
    takes for ``boundary_flux``. `velocity` is a row of N for all facet sites, for each, or a
    function of them.

    >>> import polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> w = polydec.flux_through_boundary(square, [1.0, 0.0])
    >>> round(abs(w).sum(), 12)                   # in on one side, and out on the other
    2.0
    """
    return _core.flux_through_boundary(mesh_of(complex), _rows(velocity, complex.facet_sites()))


class Flow(Run):
    """An incompressible flow that runs, with one factorization for all steps.

    Parameters
    ----------
    equations : IncompressibleFlow
    w : Cochain or array_like
        At the time 0, as its `project` gives it; the only one of the `forms`.
    time_step : float
        At most about `IncompressibleFlow.exchange_time`.
    scheme : {"implicit_midpoint", "imex"}
        Of second order, which keeps the energy where there is no viscosity; or of third, with
        explicit inertia and implicit friction.
    tolerance : float
        Of the midpoint: change of the flow in the last pass, relative.
    most_passes : int
    """

    def __init__(self, equations: IncompressibleFlow, w: npt.ArrayLike, time_step: float, *,
                 scheme: str = "implicit_midpoint", tolerance: float = 1e-13,
                 most_passes: int = 100) -> None:
        self._complex = equations._complex
        self._kinds = [("primal", self._complex.dim - 1)]
        self._run = _core.flow(equations._flow, _fluxes(w), time_step, scheme, tolerance,
                               most_passes)

    @property
    def time_step(self) -> float:
        """How long its steps are."""
        return self._run.time_step()


class ShallowWater:
    """Shallow water on surfaces: ``dh/dt + div(h u) = 0``,
    ``du/dt + i_(h u) q = -d(|u|^2 / 2 + g (h + b))``, q the potential vorticity.

    The depth h has a value in each cell (a dual 0-form), and u is known by its flux through edges.
    Walls are not crossed, and slip. Mass is kept to rounding, and energy but for the steps in time.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
        With positive diagonal stars.
    gravity : float
        g.
    rotation : array_like, optional
        Vorticity of the frame at vertices, for a planet 2 Omega sin(latitude).
    bottom : array_like, optional
        Height b of the bottom in each cell.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> water = polydec.ShallowWater(sphere, rotation=2 * sphere.points[:, 2])
    >>> depth, flux = 1 + 0.1 * sphere.centers(2)[:, 0], np.zeros(sphere.size(1))
    >>> dt = 0.5 * water.stable_step(depth, flux)
    >>> later = water.step(depth, flux, dt, 10)
    >>> bool(abs(water.mass(*later) / water.mass(depth, flux) - 1) < 1e-13)
    True
    """

    def __init__(self, complex: CellsLike, *, gravity: float = 1.0,
                 rotation: npt.ArrayLike | None = None,
                 bottom: npt.ArrayLike | None = None) -> None:
        none = np.zeros(0)
        self._water = _core.ShallowWater(
            mesh_of(as_complex(complex)), gravity,
            none if rotation is None else floats(rotation, "values of the rotation"),
            none if bottom is None else floats(bottom, "heights of the bottom"))

    def rate(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> tuple[Floats, Floats]:
        """dh/dt, and the rate of the flux."""
        return self._water.rate(_densities(depth), _fluxes(flux))

    def step(self, depth: npt.ArrayLike, flux: npt.ArrayLike, time_step: float,
             steps: int = 1) -> tuple[Floats, Floats]:
        """Depth and flux so many steps of the length `time_step` later, by Runge and Kutta's classical
        scheme. Ctrl-C ends it between two steps."""
        return self._water.step(_densities(depth), _fluxes(flux), time_step, steps)

    def stable_step(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """A step that waves and the flow allow."""
        return self._water.stable_step(_densities(depth), _fluxes(flux))

    def mass(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """The volume of all water."""
        return self._water.mass(_densities(depth), _fluxes(flux))

    def energy(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """Kinetic and potential, over the density."""
        return self._water.energy(_densities(depth), _fluxes(flux))

    def potential_vorticity(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> Floats:
        """q at the vertices."""
        return self._water.potential_vorticity(_densities(depth), _fluxes(flux))

    def potential_enstrophy(self, depth: npt.ArrayLike, flux: npt.ArrayLike) -> float:
        """The sum of ``h q^2 / 2`` over the duals of vertices."""
        return self._water.potential_enstrophy(_densities(depth), _fluxes(flux))


class FluxTransport:
    """Transport of a density by fluxes: ``d rho/dt + div(rho u) = 0``, mass kept to rounding.

    The density rho is a dual 0-form, one value in each n-cell, and the flux of u a primal
    (n-1)-form.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
    sampling : {"upwind", "centered"}
        Through a facet goes the density of the cell that it leaves, of first order, without new
        extremes; or the mean of both, of second order.

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
        self._transport = _core.FluxTransport(mesh_of(as_complex(complex)), sampling)

    def mass_flux(self, flux: npt.ArrayLike, density: npt.ArrayLike,
                  outside: npt.ArrayLike | None = None) -> Floats:
        """Mass through each facet. `outside` has densities at facets where the flux comes in."""
        return self._transport.mass_flux(_fluxes(flux), _densities(density), _densities(outside))

    def rate(self, flux: npt.ArrayLike, density: npt.ArrayLike,
             outside: npt.ArrayLike | None = None) -> Floats:
        """d rho/dt of each n-cell."""
        return self._transport.rate(_fluxes(flux), _densities(density), _densities(outside))

    def stable_step(self, flux: npt.ArrayLike) -> float:
        """The time in which so much leaves some cell as is in it."""
        return self._transport.stable_step(_fluxes(flux))

    def mass(self, density: npt.ArrayLike) -> float:
        """The sum of density times volume."""
        return self._transport.mass(_densities(density))

    def outflow(self, mass_flux: npt.ArrayLike) -> float:
        """What crosses the boundary, outwards, per time."""
        return self._transport.outflow(_fluxes(mass_flux))


def _densities(values: npt.ArrayLike | None) -> Floats:
    if values is None:
        return np.zeros(0)
    return floats(values.values if isinstance(values, Cochain) else values, "densities")
