# SPDX-License-Identifier: MIT
"""Engines: what solves systems, and one's own."""
from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, floats, matrix_parts


@dataclass(frozen=True)
class Backend:
    """An engine that is known: `kind` is "linear", "eigen", "integrator" or "mesher".

    `how_to_get` names package and option of one that is not `available`.
    """

    name: str
    kind: str
    available: bool
    description: str
    how_to_get: str


def backends() -> list[Backend]:
    """Every engine that is known, the missing ones too. Loads every module there is.

    >>> import polydec
    >>> "eigen.ldlt" in [engine.name for engine in polydec.backends() if engine.available]
    True
    """
    return [Backend(**engine) for engine in _core.engines()]


def load_engine(name: str | os.PathLike[str]) -> None:
    """Loads the module of an engine, by its name as "cholmod", or a shared library by its path.

    Engines of that name need not be loaded: they are when one is first asked for by its name, or
    chosen by ``engine="auto"``. This tells at once whether they can be.

    Raises
    ------
    BackendUnavailable
        If there is no module of that name, or it cannot be loaded; the text says why.
    IoError
        If the file cannot be loaded.

    Examples
    --------
    >>> import polydec
    >>> polydec.load_engine("eigen")            # always there
    >>> try:
    ...     polydec.load_engine("none/such.so")
    ... except polydec.IoError as error:
    ...     print(error.path.endswith("such.so"))
    True
    """
    text = os.fspath(name)
    if os.sep in text or text.endswith(".so"):
        _core.load_engine(str(Path(text).resolve()))
    else:
        _core.load_named_engine(text)


def register_linear_solver(name: str, factorize: Callable[[Any], Callable[[Floats], Any]]) -> None:
    """Makes an engine of one's own known under a name, which options ``engine`` then take.

    Parameters
    ----------
    name : str
    factorize : callable
        Takes a ``csr_matrix`` and returns a function that takes right-hand sides, a column each,
        and returns as many solutions. Residuals are checked as those of every engine.

    Examples
    --------
    >>> import numpy as np, polydec, scipy.sparse as sp, scipy.sparse.linalg
    >>> polydec.register_linear_solver("superlu", lambda A: sp.linalg.splu(A.tocsc()).solve)
    >>> polydec.solve(sp.diags([2.0, 4.0]), [1.0, 1.0], engine="superlu").values
    array([0.5 , 0.25])
    """
    _core.register_linear_solver(name, factorize)


def register_eigen_solver(name: str, largest: Callable[..., Any]) -> None:
    """Makes an eigensolver of one's own known under a name.

    Parameters
    ----------
    name : str
    largest : callable
        ``largest(A, count, krylov_dimension, tolerance, start)`` takes a symmetric
        ``scipy.sparse.linalg.LinearOperator``, and returns the `count` algebraically largest
        eigenvalues and their orthonormal vectors, columns, in any order.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> def dense(A, count, krylov_dimension, tolerance, start):
    ...     values, vectors = np.linalg.eigh(A @ np.eye(A.shape[0]))
    ...     return values[-count:], vectors[:, -count:]
    >>> polydec.register_eigen_solver("dense", dense)
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> polydec.spectrum(square, count=3, eigen_solver="dense").eigen_solver
    'dense'
    """
    from scipy.sparse.linalg import LinearOperator

    def called(apply: Any, size: int, count: int, dimension: int, tolerance: float,
               start: Floats) -> tuple[Floats, Floats]:
        A = LinearOperator((size, size), dtype=np.float64,
                           matvec=lambda x: apply(np.ascontiguousarray(x, np.float64).ravel()))
        values, vectors = largest(A, count, dimension, tolerance, start)
        order = np.argsort(values)[::-1]
        return (floats(np.asarray(values)[order], "eigenvalues"),
                floats(np.asarray(vectors)[:, order], "eigenvectors", 2))

    _core.register_eigen_solver(name, called)


@dataclass(frozen=True)
class Solution:
    """What a solve gives, and how it went; an array wherever one is asked for.

    Attributes
    ----------
    values : numpy.ndarray
    report : dict
        ``engine``, ``iterations``, ``residual``, ``backward_error``, ``tried``; of problems with
        free components also ``free_components``, and ``incompatible``, the part of the data that no
        solution can give.
    """

    values: Floats
    report: dict[str, Any]

    def __array__(self, dtype: Any = None) -> npt.NDArray[Any]:
        return np.asarray(self.values, dtype=dtype)


def solve(A: Any, b: npt.ArrayLike, *, engine: str = "auto", symmetric: bool | None = None,
          positive: bool = False) -> Solution:
    """Solves ``A x = b`` by an engine, with a check of the residual.

    Parameters
    ----------
    A : sparse matrix
        Square.
    b : array_like
        A right-hand side, or several, a column each.
    engine : str
        A name of `backends`.
    symmetric : bool, optional
        Whether A is symmetric; looked at if not said.
    positive : bool
        Whether it is known to be positive definite, too.

    Examples
    --------
    >>> import numpy as np, polydec, scipy.sparse as sp
    >>> A = sp.diags([[-1.0] * 3, [2.0] * 4, [-1.0] * 3], [-1, 0, 1])
    >>> polydec.solve(A, np.ones(4)).values
    array([2., 3., 3., 2.])
    """
    parts = matrix_parts(A, "A")
    if symmetric is None:
        rows = A.tocsr() if hasattr(A, "tocsr") else np.asarray(A)
        symmetric = positive or (rows.shape[0] == rows.shape[1] and abs(rows - rows.T).max() == 0)
    given = floats(b, "b", np.ndim(b) or 1)
    columns = given.reshape(len(given), -1)
    values, report = _core.solve(parts, columns, engine, bool(symmetric), positive)
    return Solution(values.reshape(given.shape), report)


def set_memory_limit(size: int) -> None:
    """How many bytes a mesh may take; what needs more is refused with `IoError`.

    >>> import polydec
    >>> polydec.set_memory_limit(8 << 30)
    """
    _core.set_memory_limit(size)
