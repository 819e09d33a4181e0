# SPDX-License-Identifier: MIT
"""Problems in time: heat and waves."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, floats
from ._cells import Form, as_form
from ._complex import CellsLike, as_cells, facet_marks


class HeatSolver:
    """Steps of the heat equation du/dt = -Delta u for forms, with one factorization.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    time_step : float
    degree, side
        Of the forms.
    scheme : {"backward_euler", "crank_nicolson"}
        Of first order in time, and smoothing; or of second.
    engine : str
        A name of `backends`.
    essential : bool or array of bool or callable, optional
        As for `spectrum`.
    """

    def __init__(self, complex: CellsLike, time_step: float, *, degree: int = 0,
                 side: str = "primal", scheme: str = "backward_euler", essential: Any = None,
                 engine: str = "auto") -> None:
        complex = as_cells(complex)
        marked = [] if essential is None else facet_marks(complex, essential)
        self._kind = side, degree
        self._solver = _core.HeatSolver(complex._calculus, marked, side, degree, time_step, scheme,
                                        engine)

    def step(self, u: Form, steps: int = 1) -> Floats:
        """The values so many steps later. Ctrl-C ends it between two steps."""
        side, degree = self._kind
        return self._solver.step(*as_form(u, degree, side), steps)[2]


def heat(complex: CellsLike, u: Form, time_step: float, steps: int = 1, *, degree: int = 0,
         side: str = "primal", scheme: str = "backward_euler", essential: Any = None,
         engine: str = "auto") -> Floats:
    """The values of a form after so many steps of the heat equation.

    Parameters are those of `HeatSolver`; for several runs make one of these.

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
    complex : Cells, or a mesh as `discretize` takes it
    k : int
    time_step : float
        Below `stable_step`.
    """

    def __init__(self, complex: CellsLike, k: int, time_step: float) -> None:
        complex = as_cells(complex)
        self._waves = _core.Leapfrog(complex._calculus, k, time_step)
        self.time_step = time_step

    def step(self, E: npt.ArrayLike, B: npt.ArrayLike, steps: int = 1) -> tuple[Floats, Floats]:
        """E and B so many steps later. Ctrl-C ends it between two steps."""
        return self._waves.step(floats(E, "values of E"), floats(B, "values of B"), steps)

    def energy(self, E: npt.ArrayLike, B: npt.ArrayLike) -> float:
        """What every step conserves."""
        return self._waves.energy(floats(E, "values of E"), floats(B, "values of B"))


def stable_step(complex: CellsLike, k: int) -> float:
    """The length that time steps of `Leapfrog` must stay below.

    >>> import polydec
    >>> grid = polydec.discretize(polydec.meshes.kuhn([10], [1.0]))
    >>> round(polydec.stable_step(grid, 0), 3)      # h = 0.1, and waves run 1 per unit of time
    0.1
    """
    return _core.stable_step(as_cells(complex)._calculus, k)


def wave(complex: CellsLike, E: npt.ArrayLike, time: float, B: npt.ArrayLike | None = None, *,
         k: int = 0, time_step: float | None = None) -> tuple[Floats, Floats]:
    """E and B of a wave after some time, by steps of equal length, at most 0.9 `stable_step`.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    E, B : array_like, shapes (size(k),) and (size(k+1),)
        At the time 0, and half a step later; B is 0 if left out.
    time : float
    k : int
        Degree of E.
    time_step : float, optional
        The longest step.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(16, 16))
    >>> x = np.cos(np.pi * square.points[:, 0])
    >>> E, B = polydec.wave(square, x, 2.0)           # one period
    >>> bool(abs(E - x).max() < 0.02)
    True
    """
    complex = as_cells(complex)
    longest = 0.9 * stable_step(complex, k) if time_step is None else time_step
    steps = max(1, int(np.ceil(time / longest)))
    waves = Leapfrog(complex, k, time / steps)
    return waves.step(E, np.zeros(complex.size(k + 1)) if B is None else B, steps)
