# SPDX-License-Identifier: MIT
"""Long runs: what they keep to be gone on with."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np

from . import _core
from ._arrays import Floats, floats
from ._complex import Complex


@dataclass(frozen=True)
class Checkpoint:
    """How far a computation in time got: `step`, `time`, and a list of arrays, the `state`."""

    step: int
    time: float
    state: list[Floats]


def fingerprint(*things: Any) -> int:
    """A number of 64 bits by which what a run belongs to is known again.

    Parameters
    ----------
    *things : Complex, array_like, float or str
        Mesh, data, options: all that another run may have otherwise.

    Examples
    --------
    >>> import polydec
    >>> polydec.fingerprint("heat", 0.1) == polydec.fingerprint("heat", 0.2)
    False
    """
    made = _core.Fingerprint()
    for thing in things:
        if isinstance(thing, Complex):
            made.add_mesh(thing._mesh)
        elif isinstance(thing, str):
            made.add_text(thing)
        elif np.ndim(thing) == 0:
            made.add_number(float(thing))
        else:
            made.add_numbers(floats(np.ravel(thing), "numbers of a fingerprint"))
    return made.value()


def write_checkpoint(path: str | os.PathLike[str], state: Sequence[Any], *, step: int = 0,
                     time: float = 0.0, problem: int = 0) -> None:
    """Writes how far a run got, whole or not at all.

    Parameters
    ----------
    path : str or os.PathLike
    state : sequence of array_like
    step : int
    time : float
    problem : int
        What it belongs to, a `fingerprint`.

    Raises
    ------
    IoError
        If writing fails; ``path`` says where.

    Examples
    --------
    >>> import os, polydec, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = os.path.join(folder, "run.checkpoint")
    ...     polydec.write_checkpoint(file, [[1.0, 2.0]], step=3, time=0.3)
    ...     polydec.read_checkpoint(file)
    Checkpoint(step=3, time=0.3, state=[array([1., 2.])])
    """
    _core.write_checkpoint(os.fspath(path), problem, step, time,
                           [floats(values, "values of a state") for values in state])


def read_checkpoint(path: str | os.PathLike[str], problem: int = 0) -> Checkpoint:
    """What `write_checkpoint` wrote, to the same bits.

    Raises
    ------
    InvalidInput
        If it belongs to another `problem`, or is damaged.
    IoError
        If it cannot be read.

    Examples
    --------
    >>> import polydec
    >>> try:
    ...     polydec.read_checkpoint("none.checkpoint")
    ... except polydec.IoError as error:
    ...     print(error.path)
    none.checkpoint
    """
    return Checkpoint(*_core.read_checkpoint(os.fspath(path), problem))
