# SPDX-License-Identifier: MIT
"""Waves of forms by leapfrog steps."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, floats
from ._complex import CellsLike, as_cells
from ._conditions import conditions_or_none
from ._errors import InvalidInput
from ._vertices import form_at_cells, form_at_vertices

#: Rates that are added to those of a wave, at a time.
Source = Callable[[float], Any]


@dataclass(frozen=True)
class AbsorbingLayer:
    """A layer along the sides of the box around a mesh in which outgoing waves die away.

    Attributes
    ----------
    width : float
        In units of length; 0: no layer.
    kind : {"automatic", "stretched", "conducting"}
        Stretched coordinates are perfectly matched, and need cells parallel to the axes in the
        layer; conducting are any; automatic is the first where it can be.
    sides : sequence of pairs of bool
        For each coordinate whether there is a layer at its low and at its high end; empty: all.
    reflection : float
        Of a wave that comes straight, if cells were infinitely small.
    power : float
        Of the depth, with which the rate of decay grows.
    """

    width: float
    kind: str = "automatic"
    sides: Sequence[Tuple[bool, bool]] = ()
    reflection: float = 1e-6
    power: float = 3.0


@dataclass(frozen=True)
class WaveState:
    """All that is known of a wave at one time.

    Attributes
    ----------
    E : numpy.ndarray
        At `time`.
    B : numpy.ndarray
        Half a step before.
    time : float
    memory : tuple of numpy.ndarray
        Of an absorbing layer; empty: nothing has come there.
    """

    E: Floats
    B: Floats
    time: float = 0.0
    memory: Tuple[Floats, Floats] = (np.zeros(0), np.zeros(0))


class Leapfrog:
    """Waves of k-forms of either side: E a k-form at whole times, B a (k+1)-form at half times.

    A step is ``B -= dt d E`` and ``E += dt delta B``. For k = 1 in space these are Maxwell's
    equations, for k = 0 the scalar wave equation. On ``complex.conditioned(degree=k)`` E vanishes on
    the boundary; else, of primal forms, nothing flows out.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    k : int
    time_step : float
        Below `stable_step`.
    side : {"primal", "dual"}
    essential : bool or array of bool or callable, optional
        As for `spectrum`, with values 0: for 1-forms in space a perfect conductor, elsewhere a
        symmetry wall. E and B have values for all cells nevertheless. Needs a `Complex`.
    loss, upper_loss : float or array_like, optional
        Rates of decay of E and of B by themselves, for each value; 1 / time. For Maxwell's
        equations the conductivity over the permittivity.
    layer : float or AbsorbingLayer, optional
        Of this width. Needs a `Complex`.

    Raises
    ------
    InvalidInput
        For steps that are not stable, and for stars that are not positive.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> line = polydec.discretize(polydec.meshes.kuhn([100], [10.0]))
    >>> pulse = np.exp(-10 * (line.points[:, 0] - 5) ** 2)
    >>> waves = polydec.Leapfrog(line, 0, 0.05, layer=2.0)     # 2 at both ends
    >>> end = waves.march(polydec.WaveState(pulse, np.zeros(100)), 400)
    >>> end.time, bool(abs(end.E).max() < 1e-4)                # nothing comes back
    (20.0, True)
    """

    def __init__(self, complex: CellsLike, k: int, time_step: float, *, side: str = "primal",
                 essential: Any = None, loss: npt.ArrayLike | None = None,
                 upper_loss: npt.ArrayLike | None = None,
                 layer: float | AbsorbingLayer | None = None) -> None:
        self._complex = complex = as_cells(complex, in_units=True)
        self._E, self._B = (side, k), (side, k + 1)
        given = layer if isinstance(layer, AbsorbingLayer) else AbsorbingLayer(layer or 0.0)
        self._waves = _core.Leapfrog(
            complex._cells, side, k, conditions_or_none(complex, essential),
            time_step, self._losses(loss, *self._E), self._losses(upper_loss, *self._B),
            (given.width, given.kind, [(bool(a), bool(b)) for a, b in given.sides],
             given.reflection, given.power))
        self._has_layer = given.width > 0
        self.time_step = time_step

    @property
    def layer(self) -> str:
        """What kind its layer has become; "automatic" where there is none."""
        return self._waves.layer()

    def march(self, state: WaveState, steps: int = 1, *, source: Source | None = None,
              upper_source: Source | None = None) -> WaveState:
        """The wave so many steps later. Ctrl-C ends it between two steps.

        Parameters
        ----------
        state : WaveState
        steps : int
        source, upper_source : callable, optional
            Take a time and return what is added to dE/dt, and to dB/dt, then: a number for each
            value. They are called for the middle of every step, and for its beginning.
        """
        E, B, *memory = self._waves.march(
            (*self._fields(state.E, state.B), *state.memory), steps, state.time,
            self._called(source, *self._E), self._called(upper_source, *self._B))
        return WaveState(form_at_vertices(self._complex, E, *self._E),
                         form_at_vertices(self._complex, B, *self._B),
                         state.time + steps * self.time_step, (memory[0], memory[1]))

    def step(self, E: npt.ArrayLike, B: npt.ArrayLike, steps: int = 1) -> tuple[Floats, Floats]:
        """E and B so many steps later, without sources and without a layer, whose memory `march`
        keeps. Ctrl-C ends it between two steps."""
        if self._has_layer:
            raise InvalidInput("the waves have an absorbing layer, whose memory a pair of E and B "
                               "lacks: march a WaveState")
        end = self.march(WaveState(floats(E, "values of E"), floats(B, "values of B")), steps)
        return end.E, end.B

    def energy(self, E: npt.ArrayLike, B: npt.ArrayLike) -> float:
        """What every step conserves, without sources and losses."""
        return self._waves.energy(*self._fields(E, B))

    def _fields(self, E: npt.ArrayLike, B: npt.ArrayLike) -> tuple[Floats, Floats]:
        return (form_at_cells(self._complex, floats(E, "values of E"), *self._E),
                form_at_cells(self._complex, floats(B, "values of B"), *self._B))

    def _losses(self, loss: npt.ArrayLike | None, side: str, degree: int) -> Floats:
        if loss is None:
            return np.zeros(0)
        if np.ndim(loss) == 0:
            return np.full(self._complex.size(degree, side), loss, np.float64)
        return form_at_cells(self._complex, floats(loss, "losses"), side, degree)

    def _called(self, source: Source | None, side: str,
                degree: int) -> Callable[[float], Floats] | None:
        if source is None:
            return None
        called = source
        return lambda time: form_at_cells(
            self._complex, floats(called(time), "values of a source"), side, degree)


def stable_step(complex: CellsLike, k: int, *, side: str = "primal",
                essential: Any = None) -> float:
    """The length that time steps of `Leapfrog` must stay below; its arguments are those.

    >>> import polydec
    >>> grid = polydec.discretize(polydec.meshes.kuhn([10], [1.0]))
    >>> round(polydec.stable_step(grid, 0), 3)      # h = 0.1, and waves run 1 per unit of time
    0.1
    """
    complex = as_cells(complex, in_units=True)
    return _core.stable_step(complex._cells, side, k, conditions_or_none(complex, essential))


def wave(complex: CellsLike, E: npt.ArrayLike, time: float, B: npt.ArrayLike | None = None, *,
         k: int = 0, side: str = "primal", time_step: float | None = None, essential: Any = None,
         loss: npt.ArrayLike | None = None, upper_loss: npt.ArrayLike | None = None,
         layer: float | AbsorbingLayer | None = None, source: Source | None = None,
         upper_source: Source | None = None) -> tuple[Floats, Floats]:
    """E and B of a wave after some time, by steps of equal length, at most 0.9 `stable_step`.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    E, B : array_like, shapes (size(k),) and (size(k+1),)
        At the time 0, and half a step before; B is 0 if left out.
    time : float
    k : int
        Degree of E.
    time_step : float, optional
        The longest step.
    side, essential, loss, upper_loss, layer
        As for `Leapfrog`.
    source, upper_source
        As for its `march`.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(16, 16))
    >>> x = np.cos(np.pi * square.points[:, 0])
    >>> E, B = polydec.wave(square, x, 2.0)           # one period
    >>> bool(abs(E - x).max() < 0.02)
    True
    """
    complex = as_cells(complex, in_units=True)
    longest = time_step
    if longest is None:
        longest = 0.9 * stable_step(complex, k, side=side, essential=essential)
    steps = max(1, int(np.ceil(time / longest)))
    waves = Leapfrog(complex, k, time / steps, side=side, essential=essential, loss=loss,
                     upper_loss=upper_loss, layer=layer)
    begin = np.zeros(complex.size(k + 1, side)) if B is None else floats(B, "values of B")
    end = waves.march(WaveState(floats(E, "values of E"), begin), steps, source=source,
                      upper_source=upper_source)
    return end.E, end.B
