# SPDX-License-Identifier: MIT
"""Eigenvalues, with the proof that none is missing."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, MatrixParts, Values, floats, matrix_parts
from ._complex import CellsLike, Progress, as_cells
from ._conditions import conditions_or_none


@dataclass(frozen=True)
class Certificate:
    """Proof that no eigenvalue is missing, by Sylvester's law of inertia.

    `below_shift` eigenvalues of this mesh lie below `shift`, which is behind all values returned, and
    `returned_below_shift` were computed.
    """

    shift: float
    below_shift: int
    returned_below_shift: int
    complete: bool


@dataclass(frozen=True)
class Eigenpairs:
    """Smallest eigenpairs, and how good they are.

    Attributes
    ----------
    eigenvalues : numpy.ndarray
        Ascending, with multiplicity.
    modes : numpy.ndarray
        Columns, of norm 1.
    radii : numpy.ndarray
        Of each eigenvalue: how far the exact one is at most.
    residuals : numpy.ndarray
        ``|A x - lambda M x| / |M x|``.
    certificate : Certificate
    linear_solver, eigen_solver : str
        The engines that did it.
    rough : list of int
        Values that rounding hides.
    """

    eigenvalues: Floats
    modes: Floats
    radii: Floats
    residuals: Floats
    certificate: Certificate
    linear_solver: str
    eigen_solver: str
    rough: list[int]

    def __repr__(self) -> str:
        shown = ", ".join(f"{value:.6g}" for value in self.eigenvalues[:6])
        more = ", .." if len(self.eigenvalues) > 6 else ""
        proved = "complete" if self.certificate.complete else "not proved complete"
        return f"{type(self).__name__}({len(self.eigenvalues)} values {shown}{more}; {proved})"


@dataclass(frozen=True, repr=False)
class Spectrum(Eigenpairs):
    """Smallest eigenpairs of a Laplace-de Rham operator: modes are forms of a side and degree."""

    side: str = "primal"
    degree: int = 0


def _eigenpairs(parts: dict[str, Any]) -> dict[str, Any]:
    return {**parts, "certificate": Certificate(**parts["certificate"])}


def spectrum(complex: CellsLike, *, degree: int = 0, count: int = 10, side: str = "primal",
             essential: Any = None, robin: Values | None = None, fixed: Any = None,
             coexact: bool = False, certified: bool = True, linear_solver: str = "auto", eigen_solver: str = "auto",
             progress: Progress | None = None) -> Spectrum:
    """The smallest eigenpairs of the Laplacian of forms, proved complete.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Of the forms.
    count : int
        How many.
    essential : bool or array of bool or callable, optional
        Facets of the boundary where the forms are 0 (for 0-forms Dirichlet's condition); elsewhere
        nothing flows through (Neumann's). A callable takes all facet sites, (size(n-1), N), and
        marks them. Without it primal forms have no condition, dual ones are 0 on the boundary.
    robin : float, array_like or callable, optional
        Coefficients of Robin's condition where facets are not essential, as for `Evolution`; not
        for coexact forms alone.
    fixed : array_like or callable or str, optional
        Vertices at which primal 0-forms are 0, inside as well, as for `PoissonSolver`.
    coexact : bool
        Whether only those of delta d on coexact forms are asked for.
    certified : bool
        False waives the proof.
    linear_solver, eigen_solver : str
        Names of engines; see `backends`.
    progress : callable, optional
        Told what is being done, at each step of the iteration. What it raises ends the work.

    Returns
    -------
    Spectrum

    Raises
    ------
    InvalidInput
        If a star is not positive that must be; ``cells`` says where.
    SolverFailure
        If the eigenpairs cannot be had or proved.

    Examples
    --------
    >>> import polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(6))
    >>> modes = polydec.spectrum(sphere, count=9)
    >>> modes.eigenvalues.round(1) + 0.0     # l (l + 1)
    array([0., 2., 2., 2., 6., 6., 6., 6., 6.])
    >>> modes.certificate.complete
    True
    """
    complex = as_cells(complex, in_units=True)
    conditions = conditions_or_none(complex, essential, robin, fixed)
    parts = _core.spectrum(complex._cells, side, degree, count, conditions, coexact, certified,
                           linear_solver, eigen_solver, progress)
    return Spectrum(**_eigenpairs(parts), side=side, degree=degree)


def smallest_eigenpairs(A: Any, M: Any = None, count: int = 10, *, certified: bool = True,
                        linear_solver: str = "auto", eigen_solver: str = "auto",
                        progress: Progress | None = None) -> Eigenpairs:
    """The smallest eigenpairs of ``A x = lambda M x``, proved complete, of any sparse matrices.

    Unlike ``scipy.sparse.linalg.eigsh`` it misses no copy of a multiple eigenvalue, and proves it.

    Parameters
    ----------
    A : sparse matrix
        Symmetric.
    M : sparse matrix or array, optional
        Symmetric positive definite, or its diagonal; the identity by default.
    count : int
        How many, the algebraically smallest.
    certified, linear_solver, eigen_solver, progress
        As in `spectrum`.

    Examples
    --------
    >>> import numpy as np, polydec, scipy.sparse as sp
    >>> A = sp.diags(np.repeat([1.0, 2.0, 5.0], 4))
    >>> pairs = polydec.smallest_eigenpairs(A, count=6)
    >>> pairs.eigenvalues.round(12)
    array([1., 1., 1., 1., 2., 2.])
    """
    parts = matrix_parts(A, "A")
    if M is None:
        M = np.ones(parts[3])
    mass: Floats | MatrixParts = floats(M, "M") if np.ndim(M) == 1 else matrix_parts(M, "M")
    return Eigenpairs(**_eigenpairs(_core.smallest_eigenpairs(
        parts, mass, count, certified, linear_solver, eigen_solver, progress)))
