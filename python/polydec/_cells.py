# SPDX-License-Identifier: MIT
"""Cells and their operators."""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np
import numpy.typing as npt
import scipy.sparse.linalg

from . import _core
from ._arrays import Floats, Integers, floats, matrix_parts
from ._cochain import Form, as_form, check_side
from ._errors import InvalidInput


class Cells:
    """Oriented cells of degrees 0 to n, their Hodge stars, and the operators on their forms.

    A primal k-form has one value per k-cell. A dual j-form has one value per dual of an (n-j)-cell.
    The cells of a mesh are a `Complex`; `Cells.of` takes user-defined cells. Matrices are
    ``scipy.sparse.csr_matrix``. Stored arrays are returned as read-only views.
    """

    def __init__(self, cells: _core.Cells) -> None:
        self._cells = cells

    @classmethod
    def of(cls, incidences: Sequence[Any], volumes: Sequence[npt.ArrayLike],
           dual_volumes: Sequence[npt.ArrayLike]) -> Cells:
        """User-defined cells of any shape.

        Parameters
        ----------
        incidences : sequence of n sparse matrices
            The coboundaries d_0 .. d_(n-1) with integer entries; d_k has one row per (k+1)-cell.
        volumes, dual_volumes : sequences of n + 1 arrays
            One number per cell of each degree.

        Examples
        --------
        A circle of four edges of length 1:

        >>> import numpy as np, polydec, scipy.sparse as sp
        >>> d = sp.csr_matrix(np.roll(np.eye(4), 1, axis=1) - np.eye(4))
        >>> circle = polydec.Cells.of([d], [np.ones(4), np.ones(4)], [np.ones(4), np.ones(4)])
        >>> circle.betti_numbers()
        [1, 1]
        """
        def parts(k: int, d: Any) -> Any:
            data, columns, begins, width = matrix_parts(d, f"d_{k}")
            if (data != np.round(data)).any() or (abs(data) > 127).any():
                raise InvalidInput(f"d_{k} has entries other than small whole numbers")
            return data, columns, begins, width

        return cls(_core.Cells(
            [parts(k, d) for k, d in enumerate(incidences)],
            [floats(v, f"volumes of degree {k}") for k, v in enumerate(volumes)],
            [floats(v, f"dual volumes of degree {k}") for k, v in enumerate(dual_volumes)]))

    @property
    def dim(self) -> int:
        """Dimension n."""
        return self._cells.dimension

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of cells of each degree, 0 to n."""
        return tuple(self._cells.size(k) for k in range(self.dim + 1))

    def size(self, k: int, side: str = "primal") -> int:
        """Number of values of a k-form on this side; 0 if the degree does not exist."""
        check_side(side)
        return self._cells.size(k if side == "primal" else self.dim - k)

    def __len__(self) -> int:
        return self.dim + 1

    def __getitem__(self, k: int) -> Degree:
        if not 0 <= k <= self.dim:
            raise IndexError(f"degree {k} is out of range: expected 0 to {self.dim}")
        return Degree(self, k)

    # ---- topology

    def incidence(self, k: int) -> Any:
        """d_k with entries -1, 0, 1 of type int8: a view of the stored matrix.

        Products of such matrices overflow beyond 127; use `d` for arithmetic.
        """
        return self._cells.incidence(k)

    def d(self, k: int, side: str = "primal") -> Any:
        """Exterior derivative of k-forms, size(k+1) x size(k). On dual forms it is
        ``(-1)**i d_(i-1)^T`` with i = n - k. Needs no metric; ``d(k+1) @ d(k)`` is exactly zero.

        >>> import polydec
        >>> square = polydec.discretize(polydec.meshes.grid(1, 1))
        >>> square.d(0).shape, square.d(1).toarray()
        ((4, 4), array([[-1.,  1., -1.,  1.]]))
        """
        return self._cells.d(side, k)

    def boundary(self, k: int, side: str = "primal") -> Any:
        """Boundary of k-chains, size(k-1) x size(k): the transpose of ``d(k-1, side)``."""
        return self._cells.boundary(side, k)

    def coface_counts(self, k: int) -> Integers:
        """Number of (k+1)-cells around each k-cell: 1 at facets of the boundary."""
        return self._cells.coface_counts(k)

    def boundary_facets(self) -> npt.NDArray[np.bool_]:
        """Marks the (n-1)-cells on the boundary."""
        return np.asarray(self.coface_counts(self.dim - 1) == 1)

    def betti_numbers(self) -> list[int]:
        """Betti numbers b_0 .. b_n."""
        return list(map(int, self._cells.betti_numbers()))

    def homology_generators(self, k: int) -> Any:
        """A basis of the k-th homology: b_k integer columns, each a cycle."""
        return self._cells.homology_generators(k)

    # ---- metric

    def volumes(self, k: int) -> Floats:
        """k-volumes of the k-cells, 1 for vertices: a view of the stored array."""
        return self._cells.volumes(k)

    def dual_volumes(self, k: int) -> Floats:
        """Signed (n-k)-volumes of the duals of the k-cells: a view of the stored array.

        The duals of a mesh lie between the centers of `discretize`, by default circumcenters,
        whatever its stars and materials.
        """
        return self._cells.dual_volumes(k)

    def star(self, k: int) -> Any:
        """Hodge star of primal k-forms: its diagonal, or a matrix if the star is not diagonal.

        Circumcentric stars are ratios of dual to primal volumes, ``dual_volumes(k) / volumes(k)``.
        Barycentric stars take duals between centroids instead, and materials weight the parts of
        each dual. Galerkin and hybrid stars are sparse matrices.
        """
        return self._cells.star(k)

    def inverse_star(self, k: int) -> Any:
        """Inverse Hodge star, from dual (n-k)-forms to primal k-forms.

        Returns the diagonal. If the star is a matrix, its inverse would be dense; a
        ``scipy.sparse.linalg.LinearOperator`` that solves with the star is returned instead.

        Raises
        ------
        InvalidInput
            If the star of a cell is zero; ``degree`` and ``cells`` name it.
        """
        if self._cells.is_diagonal(k):
            return self._cells.inverse_star(k)
        return _Operator(self._cells.size(k), self._cells.size(k),
                         lambda x: self._cells.solve_star(k, x))

    def zeros(self, k: int) -> Integers:
        """The k-cells whose star counts as zero."""
        return self._cells.zeros(k)

    def negatives(self, k: int) -> Integers:
        """The k-cells whose star is negative."""
        return self._cells.negatives(k)

    def codifferential(self, k: int, side: str = "primal") -> Any:
        """Codifferential, from k-forms to (k-1)-forms: the adjoint of d in the inner products.

        Returns a ``LinearOperator`` if it needs the inverse of a star that is a matrix.
        """
        if self._inverts(side, k, laplacian=False):
            return self._applied(self._cells.codifferential_of, side, k, k - 1)
        return self._cells.codifferential(side, k)

    def laplacian(self, k: int, side: str = "primal") -> Any:
        """Laplace-de Rham operator on k-forms, d delta + delta d.

        Returns a ``LinearOperator`` if it needs the inverse of a star that is a matrix.

        >>> import polydec
        >>> c = polydec.discretize(polydec.meshes.well_centered(4))
        >>> abs(c.star(0)[:, None] * c.laplacian(0).toarray() - c.stiffness(0)).max() < 1e-13
        True
        """
        if self._inverts(side, k, laplacian=True):
            return self._applied(self._cells.laplacian_of, side, k, k)
        return self._cells.laplacian(side, k)

    def stiffness(self, k: int) -> Any:
        """Stiffness matrix ``star(k) * laplacian(k)`` of primal k-forms: symmetric and sparse.

        Raises InvalidInput where it would invert a star that is a matrix."""
        return self._cells.stiffness(k)

    def dual_boundary_derivative(self, j: int) -> Any:
        """Matrix of the boundary values' contribution to the derivative of a dual j-form."""
        return self._cells.dual_boundary_derivative(j)

    def inner_product(self, a: Form, b: Form, k: int | None = None,
                      side: str = "primal") -> float:
        """L2 product of two forms of the same side and degree.

        Arrays `a` and `b` need a degree and a side; a `Cochain` stores both.
        """
        left, right = as_form(self, a, k, side), as_form(self, b, k, side)
        if left[:2] != right[:2]:
            raise InvalidInput(f"the inner product of a {left[0]} {left[1]}-form and a {right[0]} "
                               f"{right[1]}-form is not defined: expected forms of the same kind")
        return self._cells.inner_product(left, right)

    def norm(self, form: Form, k: int | None = None, side: str = "primal") -> float:
        """Square root of the inner product of a form with itself."""
        return self._cells.norm(as_form(self, form, k, side))

    # ---- other stars, other cells

    def with_star(self, k: int, star: Any) -> Cells:
        """The same cells with a symmetric positive definite sparse matrix as the star of k-forms."""
        return Cells(self._cells.with_star(k, matrix_parts(star, f"the star of degree {k}")))

    def _inverts(self, side: str, k: int, laplacian: bool) -> bool:
        """Whether the operator is dense because it contains the inverse of a star matrix."""
        check_side(side)
        cells = k if side == "primal" else self.dim - k
        inverted = [cells - 1] if side == "primal" else [cells]
        if laplacian:
            inverted = [cells - 1, cells]
        return any(0 <= i <= self.dim and not self._cells.is_diagonal(i) for i in inverted)

    def _applied(self, operator: Any, side: str, k: int, to: int) -> Any:
        return _Operator(self.size(to, side), self.size(k, side),
                         lambda x: operator((side, k, x))[2])

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(map(str, self.shape))} cells)"


class Degree:
    """The cells of one degree, with the attribute names of PyDEC.

    Attributes
    ----------
    d, boundary, star, star_inv, num_simplices, primal_volume, dual_volume
        As in PyDEC; stars are diagonal sparse matrices.
    """

    def __init__(self, cells: Cells, k: int) -> None:
        self._cells = cells
        self._k = k

    @property
    def num_simplices(self) -> int:
        return self._cells.size(self._k)

    @property
    def d(self) -> Any:
        return self._cells.d(self._k)

    @property
    def boundary(self) -> Any:
        return self._cells.boundary(self._k)

    @property
    def star(self) -> Any:
        return _matrix(self._cells.star(self._k))

    @property
    def star_inv(self) -> Any:
        return _matrix(self._cells.inverse_star(self._k))

    @property
    def primal_volume(self) -> Floats:
        return self._cells.volumes(self._k)

    @property
    def dual_volume(self) -> Floats:
        return self._cells.dual_volumes(self._k)

    def __repr__(self) -> str:
        return f"{self.num_simplices} {self._k}-cells"


def _matrix(star: Any) -> Any:
    return scipy.sparse.diags(star, format="csr") if isinstance(star, np.ndarray) else star


class _Operator(scipy.sparse.linalg.LinearOperator):  # type: ignore[misc]
    """An operator that contains a linear solve. Has `toarray`, as sparse matrices do."""

    def __init__(self, rows: int, columns: int, apply: Any) -> None:
        super().__init__(np.dtype(np.float64), (rows, columns))
        self._apply = apply

    def _matvec(self, x: npt.NDArray[Any]) -> Any:
        if np.iscomplexobj(x):
            return self._matvec(x.real) + 1j * self._matvec(x.imag)
        return self._apply(np.ascontiguousarray(x, np.float64).ravel())

    def toarray(self) -> Floats:
        """The dense matrix of the operator: one product per column."""
        columns = [self.matvec(column) for column in np.eye(self.shape[1])]
        return np.array(columns).reshape(self.shape[::-1]).T
