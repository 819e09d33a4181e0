# SPDX-License-Identifier: MIT
"""What evolutions, waves and flows have in common: they run, stop and can be resumed."""
from __future__ import annotations

import os
from typing import Any, Iterator, Sequence

import numpy.typing as npt

from . import _core
from ._arrays import Floats, floats
from ._cells import Cells
from ._vertices import form_at_vertices


class Run:
    """A computation in time: an `Evolution`, `Waves`, a `Flow`.

    Attributes
    ----------
    time : float
    forms : tuple of numpy.ndarray
        Now, values that conditions fix included.
    """

    _run: _core.Run
    _complex: Cells
    _kinds: Sequence[tuple[str, int]] # side and degree of each form

    @property
    def time(self) -> float:
        return self._run.time()

    @property
    def forms(self) -> tuple[Floats, ...]:
        return self._told(self._run.forms())

    def _told(self, forms: Sequence[Floats]) -> tuple[Floats, ...]:
        """Forms as they are given: those of vertices with all that were given."""
        return tuple(form_at_vertices(self._complex, values, side, degree)
                     for values, (side, degree) in zip(forms, self._kinds))

    def march(self, until: float) -> bool:
        """Marches to this time, or to the first event; whether it was one.

        Waves and flows take steps of one length: they end after the one that ends nearest to it.
        Ctrl-C ends a march behind its last good step.
        """
        return self._run.march(until)

    def frames(self, times: npt.ArrayLike, *,
               checkpoint: str | os.PathLike[str] | None = None) -> Iterator[tuple[Any, ...]]:
        """Marches to each of these ascending times, and gives the time and the forms there; the
        last ones are those of an event, if there is one.

        Parameters
        ----------
        times : array_like
        checkpoint : str or os.PathLike, optional
            A file that keeps what is there before the next time is marched to, and of waves and
            flows every minute. Where it is there already, the run goes on from it, to the times
            behind it alone. It belongs to a run with the same cells, stars, conditions, start,
            coefficients, steps and `label`, and to times that begin alike.

        Raises
        ------
        InvalidInput
            For a checkpoint of another run; and where the run calls functions and has no `label`,
            which says what they compute.

        Examples
        --------
        >>> import numpy as np, polydec
        >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
        >>> run = polydec.Evolution(square, np.ones(9), reaction=lambda t, u: -u)
        >>> for t, u in run.frames([0.5, 1.0]):
        ...     print(t, round(u[0], 4))
        0.5 0.6065
        1.0 0.3679
        """
        frames = self._run.frames(floats(times, "times").tolist(), os.fspath(checkpoint or ""))
        while frames.next():
            yield (self.time, *self.forms)

    def state(self) -> list[Floats]:
        """What changes beside the time, for `resume`."""
        return self._run.state()

    def resume(self, time: float, state: Sequence[Floats]) -> None:
        """Goes on from what `state` gave at this time, with the same steps."""
        self._run.resume(time, [floats(values, "values of a state") for values in state])
