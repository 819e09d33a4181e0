# SPDX-License-Identifier: MIT
"""Time-dependent problems: the heat equation, and reaction-diffusion of forms."""
from __future__ import annotations

import functools
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np

from . import _core
from ._arrays import Floats, Values, floats, is_given, whole
from ._boundary_data import boundary_data, check_use
from ._cells import Cells
from ._cochain import Cochain, Form, as_form, of_kind, values_of
from ._complex import CellsLike, as_cells
from ._conditions import space_of
from ._errors import InvalidInput
from ._run import Run
from ._vertices import form_at_cells

_Data = tuple[Floats, Floats, Floats, Floats]
_names = {"values", "codifferential", "flow", "derivative_flow"}

#: One form, or several coupled forms.
Forms = Union[Form, Sequence[Form]]


class Evolution(Run):
    """Time evolution of forms: ``du_i/dt = -nu_i Delta u_i + f_i(t, u_1, u_2, ..)``.

    Diffusion is implicit, so the tolerances alone limit the steps, however fine the mesh is.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    start : Cochain or array_like, or a sequence of these
        Initial forms: one unknown or several, of any sides and degrees.
    degree, side
        Degree and side of unknowns given as arrays.
    diffusion : float or sequence of float
        nu >= 0, one for all unknowns or one for each; length squared over time.
    reaction : callable, optional
        ``reaction(t, u_1, u_2, ..)`` takes the time and one array per unknown. It returns non-stiff
        rates: an array or a tuple of arrays, in which None and 0 mean no rate. A source depends on
        time only.
    essential : bool or array of bool or callable, optional
        As for `spectrum`, for all unknowns that diffuse. Without it, the default conditions hold.
    robin : float, array_like or callable, optional
        Coefficients of Robin's condition on facets that are not essential (by default then all):
        the outflow is the coefficient times the trace. As for `PoissonSolver`, for all unknowns.
    fixed : array_like or callable or str, optional
        Vertices with given values of primal 0-forms, as for `PoissonSolver`.
    boundary : float, array_like, dict or callable, optional
        Values on essential facets, 0 by default: one per k-cell for primal k-forms, one per facet
        for dual 0-forms. Or a dict of all data with the names of `PoissonSolver.solve` and
        "values", such as ``{"derivative_flow": outward_flow(complex, 1.0)}``. Or a function of time
        that returns one of these. For several unknowns: a sequence of these, or None.
    event : callable, optional
        ``event(t, u_1, u_2, ..)``: a march stops where its value crosses 0.
    time : float
        Initial time.
    integrator : str
        Engine name of kind "integrator"; see `backends`.
    relative_tolerance : float
        Error bound of a step, relative to each value.
    absolute_tolerance : float, optional
        Error bound of a step, relative to the size of each cell: for 0-forms, of values. By default
        a thousandth of `relative_tolerance` times the largest coefficient of the unknown so far.
    first_step, largest_step : float, optional
        First and largest step of adaptive stepping, the first at most the largest; 0: any.
    fixed_step : float, optional
        Length of equal steps; 0 means steps from the tolerances.
    most_steps : int
        Largest number of steps in one march.
    engine : str
        Linear solver; see `backends`.
    label : str
        States what the functions compute, including their parameters. A run that calls functions
        needs a label for checkpoints.

    Raises
    ------
    InvalidInput
        If forms do not fit the cells, or the integrator does not support the problem. Also for
        boundary data that apply to no facet of a mesh with boundary, and for conditions if no
        unknown diffuses.
    SolverFailure
        From a march, if rates are not finite or steps become too short.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.icosphere(8))
    >>> z = sphere.points[:, 2]                     # Delta z = 2 z, so that a source of 2 z keeps it
    >>> run = polydec.Evolution(sphere, z, diffusion=1.0, reaction=lambda t, u: 2 * z)
    >>> run.march(1.0)
    False
    >>> bool(abs(run.forms[0] - z).max() < 0.01)
    True
    """

    def __init__(self, complex: CellsLike, start: Forms, *, degree: int = 0, side: str = "primal",
                 diffusion: float | Sequence[float] = 0.0,
                 reaction: Callable[..., Any] | None = None, essential: Any = None,
                 robin: Values | None = None, fixed: Any = None, boundary: Any = None,
                 event: Callable[..., Any] | None = None,
                 time: float = 0.0, integrator: str = "runge-kutta",
                 relative_tolerance: float = 1e-5, absolute_tolerance: float | None = None,
                 first_step: float = 0.0, largest_step: float = 0.0, fixed_step: float = 0.0,
                 most_steps: int = 1_000_000, engine: str = "auto",
                 label: str = "") -> None:
        self._complex = complex = as_cells(complex, in_units=True)
        unknowns = [as_form(complex, form, degree, side) for form in _several(start)]
        self._kinds = [(form[0], form[1]) for form in unknowns]
        coefficients = floats(np.full(len(unknowns), diffusion) if np.ndim(diffusion) == 0
                              else diffusion, "coefficients of diffusion")
        if len(coefficients) != len(unknowns):
            raise InvalidInput(f"{len(coefficients)} coefficients of diffusion are given: expected "
                               f"one, or one for each of {len(unknowns)} unknowns")
        if not coefficients.any() and any(each is not None for each in (essential, robin, fixed)):
            raise InvalidInput("essential, robin or fixed are given, but the diffusion that obeys "
                               "them is 0: give a diffusion, or none of these conditions")

        @functools.cache
        def space(side: str, degree: int, diffuses: bool) -> _core.FormSpace:
            """One for all unknowns of a kind: functions that choose cells are called once."""
            conditions = (essential, robin, fixed) if diffuses else (None,)
            return space_of(self._complex, side, degree, *conditions)

        at_boundary = _each(boundary, len(unknowns))
        if not any(map(callable, (reaction, event, *at_boundary))):
            label = label or "constant data" # which are compared as they are
        spaces = [space(*kind, bool(nu)) for kind, nu in zip(self._kinds, coefficients)]
        given = [(on, form[2], float(nu), _at_boundary(each, complex, on, *kind))
                 for on, kind, form, nu, each in zip(spaces, self._kinds, unknowns, coefficients,
                                                     at_boundary)]
        self._run = _core.evolution(
            given, self._rates(reaction), self._number(event), time,
            integrator, (relative_tolerance, absolute_tolerance, first_step, largest_step, fixed_step,
             most_steps), engine, label)

    def _rates(self, reaction: Callable[..., Any] | None) -> Any:
        """The reaction with the signature that C++ calls: lists of arrays in and out."""
        if reaction is None:
            return None
        called = reaction

        def rate(given: Any, side: str, degree: int) -> Floats:
            if not is_given(given):
                return np.zeros(0)
            return values_of(self._complex, given, side, degree, "rates of the reaction")

        def rates(time: float, forms: list[Floats]) -> list[Floats]:
            given = called(time, *self._told(forms))
            several = (given,) if len(self._kinds) == 1 and not isinstance(given, tuple) else given
            if len(several) != len(self._kinds):
                raise InvalidInput(f"the reaction gives rates of {len(several)} unknowns: "
                                   f"expected {len(self._kinds)}")
            return [rate(each, *kind) for each, kind in zip(several, self._kinds)]

        return rates

    def _number(self, event: Callable[..., Any] | None) -> Any:
        if event is None:
            return None
        called = event
        return lambda time, forms: float(called(time, *self._told(forms)))

    @property
    def report(self) -> dict[str, Any]:
        """Work counts: ``engine``, ``steps``, ``rejected``, ``evaluations`` of the reaction,
        ``stiff_evaluations``, ``preparations``, ``solves``, ``last_step``."""
        return self._run.report()


def heat(complex: CellsLike, u: Form, time_step: float, steps: int = 1, *, degree: int = 0,
         side: str = "primal", integrator: str = "backward-euler", essential: Any = None,
         robin: Values | None = None, fixed: Any = None, engine: str = "auto") -> Floats:
    """Values of a form after `steps` steps of the heat equation du/dt = -Delta u, each of length
    `time_step`. Runs one `Evolution`; see there for the other parameters.

    Backward Euler is first-order in time. It creates no new extrema of functions if their stars are
    diagonal and positive; Galerkin stars are not diagonal. "implicit-midpoint" is second-order.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.icosphere(8))
    >>> z = polydec.heat(sphere, sphere.points[:, 2], 0.01, 10)      # decays by about exp(-2 t)
    >>> bool(0.81 < z.max() < 0.83)
    True
    """
    run = Evolution(complex, u, degree=degree, side=side, diffusion=1.0, essential=essential,
                    robin=robin, fixed=fixed, integrator=integrator, fixed_step=time_step,
                    engine=engine)
    run.march(whole(steps, "steps") * time_step)
    return run.forms[0]


def _several(start: Forms) -> list[Form]:
    if isinstance(start, (list, tuple)) and start and all(
            isinstance(each, Cochain) or np.ndim(each) > 0 for each in start):
        return list(start)
    return [start] # type: ignore[list-item]


def _each(boundary: Any, unknowns: int) -> Sequence[Any]:
    if unknowns == 1:
        return [boundary]
    given = [None] * unknowns if boundary is None else boundary
    if not isinstance(given, (list, tuple)) or len(given) != unknowns:
        raise InvalidInput(f"boundary values are not a sequence of {unknowns} entries: expected "
                           "values or None for each unknown")
    return given


def _at_boundary(boundary: Any, cells: Cells, space: _core.FormSpace, side: str,
                 degree: int) -> Callable[[float], _Data] | None:
    """Boundary data as a function of time. Primal forms need values on all their cells. Dual forms
    need values on all cells whose duals within the boundary have the degree of the form."""
    if boundary is None:
        return None
    k = degree if side == "primal" else cells.dim - degree - 1
    size, name = cells.size(k), "values on the boundary"
    require_use = functools.lru_cache(space.require_use)

    def trace(given: Any) -> Floats:
        given = of_kind(given, name, ("primal", k))
        made = floats(np.full(size, given) if np.ndim(given) == 0 else given, name)
        made = form_at_cells(cells, made, "primal", k)
        if len(made) != size:
            raise InvalidInput(f"{len(made)} values on the boundary are given: expected {size}")
        return made

    def data(time: float) -> _Data:
        given = boundary(time) if callable(boundary) else boundary
        if isinstance(given, Mapping):
            unknown = set(given) - _names
            if unknown:
                raise InvalidInput(f"boundary data have the unknown name {min(unknown)!r}: "
                                   "expected " + ", ".join(sorted(_names)))
            check_use(require_use, degree, given)
            values = given.get("values")
            return boundary_data(**{**given, "values": trace(values) if is_given(values) else None})
        check_use(require_use, degree, {"boundary": given})
        return boundary_data(values=trace(given))

    return data
