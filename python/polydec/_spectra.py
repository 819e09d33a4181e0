# SPDX-License-Identifier: MIT
"""Eigenvalues, with a proof that none is missing."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, MatrixParts, Values, floats, matrix_parts
from ._complex import CellsLike, Progress, as_cells
from ._conditions import space_of


@dataclass(frozen=True)
class Certificate:
    """Proof that no eigenvalue is missing, by Sylvester's law of inertia.

    `shift` lies above all returned values. The mesh has `below_shift` eigenvalues below `shift`;
    `returned_below_shift` of these were computed; `complete` states whether these are all.
    """

    shift: float
    below_shift: int
    returned_below_shift: int
    complete: bool


@dataclass(frozen=True)
class Eigenpairs:
    """Smallest eigenpairs, with error bounds and a certificate.

    Attributes
    ----------
    eigenvalues : numpy.ndarray
        Ascending, with multiplicity.
    modes : numpy.ndarray
        Columns of norm 1; none, with a warning, if they exceed double precision.
    radii : numpy.ndarray
        Bound of the distance between each eigenvalue and the exact one.
    residuals : numpy.ndarray
        ``|A x - lambda M x| / |M x|``.
    certificate : Certificate
    linear_solver, eigen_solver : str
        The engines used.
    rough : list of int
        Indices of eigenvalues lost in rounding errors.
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
    """Smallest eigenpairs of a Laplace-de Rham operator. Modes are forms of `side` and `degree`.

    `coarseness` estimates, on surfaces, how far the largest eigenvalue is from that of the shape
    itself, relative to it; no bound. None where `shape_spectrum` does not enclose the eigenvalues.
    """

    side: str = "primal"
    degree: int = 0
    coarseness: float | None = None


def _eigenpairs(parts: dict[str, Any]) -> dict[str, Any]:
    return {**parts, "certificate": Certificate(**parts["certificate"]),
            "rough": parts["rough"].tolist()}


def spectrum(complex: CellsLike, *, degree: int = 0, count: int = 10, side: str = "primal",
             essential: Any = None, robin: Values | None = None, fixed: Any = None,
             coexact: bool = False, certified: bool = True, linear_solver: str = "auto", eigen_solver: str = "auto",
             progress: Progress | None = None) -> Spectrum:
    """Smallest eigenpairs of the Laplacian on forms, proved complete.

    Parameters
    ----------
    complex : Cells, or a mesh as `discretize` takes it
    degree, side
        Degree and side of the forms.
    count : int
        Number of eigenpairs.
    essential : bool or array of bool or callable, optional
        Boundary facets where the forms are 0 (Dirichlet's condition for 0-forms). Elsewhere the
        flux is 0 (Neumann's). A callable takes all facet sites, (size(n-1), N), and returns marks.
        Default conditions: natural for primal forms, zero values for dual forms.
    robin : float, array_like or callable, optional
        Coefficients of Robin's condition on other facets, as for `Evolution`; not with `coexact`.
    fixed : array_like or callable or str, optional
        Vertices where primal 0-forms are 0, also interior ones, as for `PoissonSolver`.
    coexact : bool
        Whether to compute only eigenpairs of delta d on coexact forms.
    certified : bool
        False skips the proof.
    linear_solver, eigen_solver : str
        Engine names; see `backends`.
    progress : callable, optional
        Called with a description of each iteration step. An exception stops the work.

    Returns
    -------
    Spectrum

    Raises
    ------
    InvalidInput
        If a star that must be positive is not; ``cells`` says where.
    SolverFailure
        If the eigenpairs cannot be computed or proved complete.

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
    space = space_of(complex, side, degree, essential, robin, fixed)
    parts = _core.spectrum(space, count, coexact, certified, linear_solver, eigen_solver, progress)
    return Spectrum(**_eigenpairs(parts), side=side, degree=degree)


def smallest_eigenpairs(A: Any, M: Any = None, count: int = 10, *, certified: bool = True,
                        linear_solver: str = "auto", eigen_solver: str = "auto",
                        progress: Progress | None = None) -> Eigenpairs:
    """Smallest eigenpairs of ``A x = lambda M x`` for sparse matrices, proved complete.

    Unlike ``scipy.sparse.linalg.eigsh``, it provably misses no copy of a multiple eigenvalue.

    Parameters
    ----------
    A : sparse matrix
        Symmetric.
    M : sparse matrix or array, optional
        Symmetric positive definite, or its diagonal; the identity by default.
    count : int
        Number of algebraically smallest eigenpairs.
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
