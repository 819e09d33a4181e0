# SPDX-License-Identifier: MIT
"""Common base of evolutions, waves and flows: run, stop and resume."""
from __future__ import annotations

import os
from typing import Any, Iterator, Sequence

import numpy.typing as npt

from . import _core
from ._arrays import Floats, floats
from ._cells import Cells
from ._complex import Progress
from ._errors import told
from ._vertices import form_at_vertices


class Run:
    """A time-dependent computation: an `Evolution`, `Waves` or a `Flow`.

    Attributes
    ----------
    time : float
    forms : tuple of numpy.ndarray
        Current values, including values fixed by conditions.
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
        """Forms as users see them: forms on vertices have one value per input vertex."""
        return tuple(form_at_vertices(self._complex, values, side, degree)
                     for values, (side, degree) in zip(forms, self._kinds))

    def march(self, until: float, *, progress: Progress | None = None) -> bool:
        """Marches to this time, or to the first event. Returns whether an event stopped it.

        Waves and flows take equal steps, and stop after the step that ends nearest to `until`.
        Ctrl-C stops a march after its last good step. A march of more than ten seconds calls
        `progress` once, after its first steps, with a sentence (str): number and length of steps,
        what limits them, estimated time, memory, and the argument that changes the steps. Pass
        `print` to see it.

        Raises
        ------
        InvalidInput
            For a time in the past or before the start.
        """
        return self._run.march(until, _in_words_of_python(progress))

    def frames(self, times: npt.ArrayLike, *,
               checkpoint: str | os.PathLike[str] | None = None,
               progress: Progress | None = None) -> Iterator[tuple[Any, ...]]:
        """Marches to each of these ascending times, and yields the time and the forms there. An
        event, if there is one, gives the last frame.

        Parameters
        ----------
        times : array_like
        checkpoint : str or os.PathLike, optional
            A file that stores the state before each next time; for waves and flows also every
            minute. If the file exists, the run resumes from it and yields only later times. It must
            come from a run with the same cells, stars, conditions, start, coefficients, steps and
            `label`, and with the same leading times.
        progress : callable, optional
            As for `march`, for all times together.

        Raises
        ------
        InvalidInput
            For a checkpoint of another run, and for a run that calls functions without a `label`
            that states what they compute.

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
        frames = self._run.frames(floats(times, "times").tolist(), os.fspath(checkpoint or ""),
                                  _in_words_of_python(progress))
        while frames.next():
            yield (self.time, *self.forms)

    def state(self) -> list[Floats]:
        """The state apart from the time, for `resume`."""
        return self._run.state()

    def resume(self, time: float, state: Sequence[Floats]) -> None:
        """Resumes from a result of `state` at this time, with the same steps."""
        self._run.resume(time, [floats(values, "values of a state") for values in state])


def _in_words_of_python(progress: Progress | None) -> Progress | None:
    if progress is None:
        return None
    say = progress
    return lambda text: say(told(text))
