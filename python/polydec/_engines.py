# SPDX-License-Identifier: MIT
"""Engines that solve linear systems and eigenproblems, and user-defined engines."""
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
    """A known engine, with its `name` and a `description`; `kind` is "linear", "eigen", "integrator" or
    "mesher".

    If it is not `available`, `how_to_get` names the package and the option to add it. `license` is
    the SPDX expression of the code behind it.
    """

    name: str
    kind: str
    available: bool
    description: str
    how_to_get: str
    license: str


def backends() -> list[Backend]:
    """Lists all known engines, including missing ones. Loads every available module.

    >>> import polydec
    >>> "eigen.ldlt" in [engine.name for engine in polydec.backends() if engine.available]
    True
    """
    return [Backend(**engine) for engine in _core.engines()]


def load_engine(name: str | os.PathLike[str]) -> None:
    """Loads an engine module by name, such as "cholmod", or a shared library by path.

    Modules also load on first use, by name or by the choice of ``engine="auto"``. This function
    reports at once whether loading succeeds.

    Raises
    ------
    BackendUnavailable
        If no module has this name, or the module cannot be loaded; the text says why.
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
    """Registers a user-defined linear solver under a name that options ``engine`` accept.

    Parameters
    ----------
    name : str
    factorize : callable
        Takes a ``csr_matrix`` and returns a function from right-hand sides, one column each, to
        solutions. Residuals are checked as for every engine.

    Examples
    --------
    >>> import numpy as np, polydec, scipy.sparse as sp, scipy.sparse.linalg
    >>> polydec.register_linear_solver("superlu", lambda A: sp.linalg.splu(A.tocsc()).solve)
    >>> polydec.solve(sp.diags([2.0, 4.0]), [1.0, 1.0], engine="superlu").values
    array([0.5 , 0.25])
    """
    _core.register_linear_solver(name, factorize)


def register_eigen_solver(name: str, largest: Callable[..., Any]) -> None:
    """Registers a user-defined eigensolver under a name.

    Parameters
    ----------
    name : str
    largest : callable
        ``largest(A, count, krylov_dimension, tolerance, start)`` takes a symmetric
        ``scipy.sparse.linalg.LinearOperator``, which ends with the call. It returns the `count`
        algebraically largest eigenvalues, in any order, and their orthonormal eigenvectors as
        columns.

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
        values, vectors = floats(values, "eigenvalues"), floats(vectors, "eigenvectors", 2)
        order = np.argsort(values)[::-1]
        return values[order], np.ascontiguousarray(vectors[:, order])

    _core.register_eigen_solver(name, called)


@dataclass(frozen=True)
class Solution:
    """The solution of a linear system, with a report. Converts to an array of its values.

    Attributes
    ----------
    values : numpy.ndarray
    report : dict
        ``engine``, ``iterations``, ``residual``, ``backward_error``, ``tried``. Problems with free
        components add ``free_components`` and ``incompatible``, the part of the data that no
        solution can match.
    """

    values: Floats
    report: dict[str, Any]

    def __array__(self, dtype: Any = None) -> npt.NDArray[Any]:
        return np.asarray(self.values, dtype=dtype)


def solve(A: Any, b: npt.ArrayLike, *, engine: str = "auto", symmetric: bool | None = None,
          positive: bool = False) -> Solution:
    """Solves ``A x = b`` with an engine, and checks the residual.

    Parameters
    ----------
    A : sparse matrix
        Square.
    b : array_like
        One right-hand side, or several as columns.
    engine : str
        Engine name; see `backends`.
    symmetric : bool, optional
        Whether A is symmetric; checked by default.
    positive : bool
        Whether A is also known to be positive definite.

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
        symmetric = positive or (rows.shape[0] == rows.shape[1] and (rows != rows.T).sum() == 0)
    given = floats(b, "b", np.ndim(b) or 1)
    columns = given if given.ndim == 2 else given[:, np.newaxis]
    values, report = _core.solve(parts, columns, engine, bool(symmetric), positive)
    return Solution(values.reshape(given.shape), report)


def set_memory_limit(size: int) -> None:
    """Sets the largest size of a mesh in bytes. Larger meshes raise `IoError`.

    >>> import polydec
    >>> polydec.set_memory_limit(8 << 30)
    """
    _core.set_memory_limit(size)
