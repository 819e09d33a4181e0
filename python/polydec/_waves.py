# SPDX-License-Identifier: MIT
"""Wave equations for forms, and absorbing layers."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats
from ._cochain import Form, as_form, values_of
from ._complex import CellsLike, Complex, as_cells
from ._conditions import space_of
from ._errors import InvalidInput
from ._run import Run
from ._vertices import mesh_of

#: A source of a wave: takes the time, returns rates.
Source = Callable[[float], Any]


@dataclass(frozen=True)
class AbsorbingLayer:
    """A layer along the bounding box of a mesh that absorbs outgoing waves.

    Attributes
    ----------
    width : float
        Width of the layer, a length; 0 for no layer.
    kind : {"automatic", "stretched", "conducting"}
        "stretched" coordinates are perfectly matched, but need axis-parallel cells in the layer.
        "conducting" works on any cells. "automatic" prefers "stretched" where possible.
    sides : sequence of pairs of bool
        For each coordinate, whether its low and its high end have a layer; empty for all.
    reflection : float
        Reflection of a wave at normal incidence in the limit of small cells.
    power : float
        The rate of decay grows with this power of the depth.
    """

    width: float
    kind: str = "automatic"
    sides: Sequence[Tuple[bool, bool]] = ()
    reflection: float = 1e-6
    power: float = 3.0


class Waves(Run):
    """Waves of k-forms on either side: E, a k-form at time t, and B, a (k+1)-form at t - dt / 2.

    A step is ``B -= dt d E``, ``E += dt delta B``: Maxwell's equations for k = 1 in space, the
    scalar wave equation for k = 0. On ``FormSpace(complex, k, essential=True).inside`` E vanishes on the
    boundary; otherwise primal forms have no outflow.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    E : Cochain or array_like
        E at time 0.
    B : array_like, optional
        B half a step earlier; by default E starts at rest.
    degree, side
        Degree and side of E if it is an array.
    time_step : float, optional
        Below `stable_step`; by default 0.9 times `stable_step`.
    essential : bool or array of bool or callable, optional
        As for `spectrum`, with values 0. For 1-forms in space these facets are a perfect conductor,
        the others a symmetry wall. E and B still have values on all cells. Needs a `Complex`.
    loss, upper_loss : float or array_like, optional
        Decay rates of E and of B, one per value; 1 / time. For Maxwell's equations `loss` is the
        conductivity over the permittivity. A warning tells of rates above 2 / time_step.
    layer : float or AbsorbingLayer, optional
        An absorbing layer, or its width. Needs a `Complex`.
    source, upper_source : callable, optional
        Take a time; return the terms added to dE/dt and dB/dt, one number per value. `source` is
        called at the middle of every step, `upper_source` at its beginning.
    label : str
        States what the sources compute, including their parameters. Waves with sources need a label
        for checkpoints.

    Raises
    ------
    InvalidInput
        For unstable steps, and for stars that are not positive.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> line = polydec.discretize(polydec.meshes.kuhn([100], [10.0]))
    >>> pulse = np.exp(-10 * (line.points[:, 0] - 5) ** 2)
    >>> waves = polydec.Waves(line, pulse, time_step=0.05, layer=2.0)     # 2 at both ends
    >>> waves.march(20.0)
    False
    >>> bool(abs(waves.forms[0]).max() < 1e-4)                # nothing comes back
    True
    """

    def __init__(self, complex: CellsLike, E: Form, B: npt.ArrayLike | None = None, *,
                 degree: int = 0, side: str = "primal", time_step: float | None = None,
                 essential: Any = None, loss: npt.ArrayLike | None = None,
                 upper_loss: npt.ArrayLike | None = None,
                 layer: float | AbsorbingLayer | None = None, source: Source | None = None,
                 upper_source: Source | None = None, label: str = "") -> None:
        self._complex = complex = as_cells(complex, in_units=True)
        side, degree, values = as_form(complex, E, degree, side)
        self._kinds = (side, degree), (side, degree + 1)
        given = layer if isinstance(layer, AbsorbingLayer) else AbsorbingLayer(layer or 0.0)
        absorbing = None
        if given.width != 0:
            if not isinstance(complex, Complex):
                raise InvalidInput("an absorbing layer needs the positions of cells: expected the "
                                   "Complex that discretize returns for a mesh, not just cells")
            absorbing = (mesh_of(complex), given.width, given.kind,
                         [(bool(a), bool(b)) for a, b in given.sides],
                         given.reflection, given.power)
        self._run = _core.waves(
            space_of(complex, side, degree, essential), values, time_step or 0.0,
            (self._values(loss, 0), self._values(upper_loss, 1), self._values(B, 1)),
            absorbing, self._called(source, 0), self._called(upper_source, 1), label)

    @property
    def time_step(self) -> float:
        """Length of a step."""
        return self._run.time_step()

    @property
    def layer(self) -> str:
        """Kind of the layer in use; "automatic" without a layer."""
        return self._run.layer()

    @property
    def energy(self) -> float:
        """Current energy. Steps conserve it without sources, losses and a layer."""
        return self._run.energy()

    def _values(self, given: npt.ArrayLike | None, which: int) -> Floats:
        """One value per cell of E or B."""
        if given is None:
            return np.zeros(0)
        side, degree = self._kinds[which]
        if np.ndim(given) == 0:
            return np.full(self._complex.size(degree, side), given, np.float64)
        return values_of(self._complex, given, side, degree, "values of a wave")

    def _called(self, source: Source | None, which: int) -> Callable[[float], Floats] | None:
        if source is None:
            return None
        called = source
        return lambda time: self._values(called(time), which)


def stable_step(complex: CellsLike, degree: int = 0, *, side: str = "primal",
                essential: Any = None) -> float:
    """Upper limit of the time steps of `Waves`, for the same arguments.

    >>> import polydec
    >>> grid = polydec.discretize(polydec.meshes.kuhn([10], [1.0]))
    >>> round(polydec.stable_step(grid), 3)         # h = 0.1, and waves run 1 per unit of time
    0.1
    """
    complex = as_cells(complex, in_units=True)
    return _core.stable_step(space_of(complex, side, degree, essential))


def wave(complex: CellsLike, E: Form, time: float, B: npt.ArrayLike | None = None, *,
         degree: int = 0, side: str = "primal", time_step: float | None = None,
         essential: Any = None, **words: Any) -> tuple[Floats, Floats]:
    """E and B of `Waves` after some time. Equal steps end there, of length at most `time_step` or,
    by default, 0.9 `stable_step`. Other `words` are keyword arguments of `Waves`.

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
    side, degree, values = as_form(complex, E, degree, side)
    longest = time_step or 0.9 * stable_step(complex, degree, side=side, essential=essential)
    waves = Waves(complex, values, B, degree=degree, side=side, essential=essential,
                  time_step=_core.equal_step(time, longest), **words)
    waves.march(time)
    return waves.forms[0], waves.forms[1]
