# SPDX-License-Identifier: MIT
"""Forms from functions and vector fields, vector fields from forms, and products."""
from __future__ import annotations

from math import comb
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, as_array, floats
from ._cochain import Cochain, Form, as_form, made, product, values_of
from ._complex import Complex
from ._errors import InvalidInput
from ._vertices import at_vertices, form_at_cells, mesh_of


def _vectors(complex: Complex, field: npt.ArrayLike, side: str = "primal") -> Floats:
    """Rows for 0-cells, from rows for all input vertices; on the dual side rows for n-cells."""
    return np.ascontiguousarray(form_at_cells(complex, floats(field, "vectors", 2), side, 0))


def _given_back(complex: Complex, form: tuple[str, int, Floats], *given: Form) -> Any:
    """A Cochain if one was given, else an array of values."""
    return made(form, complex) if any(isinstance(each, Cochain) for each in given) else form[2]


def de_rham(complex: Complex, k: int, form: Callable[[Floats], Any], *,
            side: str = "primal", quadrature_degree: int = 5) -> Floats:
    """The de Rham map: integrals of a smooth k-form over the cells, or over their duals.

    Parameters
    ----------
    complex : Complex
    k : int
        Degree of the form.
    form : callable
        Called once with all quadrature points, (m, N). Returns the coefficients of dx_I for the
        k-subsets I of 0..N-1 in lexicographic order, (m, N over k), or (m,) for one coefficient.
        For k = 1 these are the components of a field, and the integrals are its circulations. For
        the flux of a field see `flux_form`.
    side : {"primal", "dual"}
    quadrature_degree : int
        Integrates polynomials up to this degree exactly.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> round(polydec.de_rham(square, 2, lambda x: x[:, 0] * x[:, 1]).sum(), 12)
    0.25
    >>> dx = polydec.de_rham(square, 1, lambda x: [1, 0] + 0 * x)
    >>> np.allclose(dx, square.d(0) @ square.points[:, 0])
    True
    """
    return _core.de_rham(mesh_of(complex), side, k, coefficients(form, complex.points.shape[1], k),
                         quadrature_degree)[2]


def coefficients(form: Callable[[Floats], Any], width: int,
                 k: int) -> Callable[[Floats], Floats]:
    """A k-form on R^N, N = `width`, as a function that returns N over k numbers per point."""
    components = comb(width, k) if 0 <= k <= width else 0

    def rows(points: Floats) -> Floats:
        values = as_array(form(points), "values of the form")
        if values.shape == () and components == 1:
            values = np.full(len(points), values[()])
        if values.ndim == 1 and components == 1:
            values = values[:, None]
        if values.shape != (len(points), components):
            raise InvalidInput(f"the form returned an array of shape {values.shape} at "
                               f"{len(points)} points: expected ({len(points)}, {components})")
        return floats(values, "values of the form", 2)

    return rows


def boundary_de_rham(complex: Complex, j: int, form: Callable[[Floats], Any], *,
                     quadrature_degree: int = 5) -> Floats:
    """Integrals of a smooth j-form over boundary duals: the duals of boundary (n-j-1)-cells within
    the boundary. Other cells have value 0. Boundary data of dual forms consist of such integrals.
    For `form` and `quadrature_degree` see `de_rham`.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> x = polydec.boundary_de_rham(square, 0, lambda p: p[:, 0])       # at facet sites
    >>> on = square.boundary_facets()
    >>> np.allclose(x[on], square.facet_sites()[on, 0])
    True
    """
    return _core.boundary_de_rham(mesh_of(complex), j,
                                  coefficients(form, complex.points.shape[1], j),
                                  quadrature_degree)


def flux_form(field: Callable[[Floats], Any]) -> Callable[[Floats], Floats]:
    """The (N-1)-form for `de_rham` whose integrals are the fluxes of a vector field.

    They are positive outward for cells of positive determinant, such as counterclockwise triangles.
    `flow_of_velocity` and `flux_sharp` follow the cells instead: for clockwise ones the signs differ.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> flux = polydec.de_rham(square, 1, polydec.flux_form(lambda x: x))   # of divergence 2
    >>> np.allclose(square.d(1) @ flux, 2 * square.volumes(2))
    True
    """
    def coefficients(points: Floats) -> Floats:
        values = floats(field(points), "values of the field", 2)
        signs = (-1.0) ** np.arange(values.shape[1])
        return np.ascontiguousarray((values * signs)[:, ::-1])

    return coefficients


def wedge(complex: Complex, a: Form, b: Form, *, degrees: tuple[int, int] | None = None,
          side: str = "primal", weights: str = "uniform") -> Any:
    """Exterior product of two forms on the same side.

    Parameters
    ----------
    complex : Complex
    a, b : Cochain or array_like
        Arrays need `degrees` and `side`. Returns a Cochain if a or b is a Cochain.
    weights : {"uniform", "circumcentric"}
        Weights for primal forms. Uniform weights satisfy Leibniz' rule exactly; circumcentric
        weights are Hirani's. Dual forms take none, so only the default.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(3, 3))
    >>> dx, dy = (square.cochain(x, 0).d() for x in square.points.T)
    >>> np.allclose(dx.wedge(dy), square.volumes(2))
    True
    """
    k, l = degrees if degrees is not None else (None, None)
    left, right = as_form(complex, a, k, side), as_form(complex, b, l, side)
    return _given_back(complex, product(complex, left, right, weights), a, b)


def primal_dual_wedge(complex: Complex, a: Form, b: Form, *, degree: int | None = None) -> Floats:
    """Product of a primal k-form and a dual (n-k)-form: one number per k-cell.

    For ``b = star a`` the numbers sum to the squared norm. Arrays need the degree k of a.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> a = square.cochain(square.points[:, 0], 0).d()
    >>> np.isclose(polydec.primal_dual_wedge(square, a, a.star()).sum(), a.norm() ** 2)
    True
    """
    left = as_form(complex, a, degree, "primal")
    right = as_form(complex, b, None if degree is None else complex.dim - degree, "dual")
    return _core.primal_dual_wedge(mesh_of(complex), left, right)


def flat(complex: Complex, kind: str, field: npt.ArrayLike) -> Cochain:
    """The 1-form of a vector field.

    Parameters
    ----------
    kind : {"ppp", "pdp", "dpp", "ppd", "pdd", "dpd"}
        The three letters give the position of the vectors (p: vertices, d: n-cells), their
        interpolation, and the edges of the 1-form (p: primal, d: dual).
    field : array_like, shape (vertices or n-cells, N)

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> form = polydec.flat(square, "ppp", np.ones_like(square.points))
    >>> np.allclose(polydec.sharp_pp(square, form), 1.0)
    True
    """
    rows = _vectors(complex, field, "dual" if kind.startswith("d") else "primal")
    return made(_core.flat(mesh_of(complex), kind, rows), complex)


def sharp_pp(complex: Complex, form: Form) -> Floats:
    """Vectors at vertices from a primal 1-form, (vertices, N). Exact for constant fields.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> np.allclose(polydec.sharp_pp(square, square.d(0) @ square.points[:, 1]), [0, 1])
    True
    """
    return at_vertices(complex, _core.sharp_pp(mesh_of(complex), as_form(complex, form, 1)))


def sharp_pd(complex: Complex, form: Form) -> Floats:
    """Vectors at centroids of n-cells from a primal 1-form, (size(n), N).

    Exact for differentials of linear functions on flat cells of any shape. Hence
    ``sharp_pd(c, c.d(0) @ u)`` is the gradient of u; see `gradient`.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.hexagons(4))
    >>> np.allclose(polydec.sharp_pd(square, square.d(0) @ square.points[:, 1]), [0, 1])
    True
    """
    return _core.sharp_pd(mesh_of(complex), as_form(complex, form, 1))


def flux_sharp(complex: Complex, form: Form) -> Floats:
    """Vectors at centroids of n-cells from fluxes, a primal (n-1)-form; (size(n), N).

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> east = polydec.flux_form(lambda x: [1, 0] + 0 * x)
    >>> np.allclose(polydec.flux_sharp(square, polydec.de_rham(square, 1, east)), [1, 0])
    True
    """
    return _core.flux_sharp(mesh_of(complex), as_form(complex, form, complex.dim - 1))


def gradient(complex: Complex, u: Form) -> Floats:
    """Gradient of a primal 0-form at the centroids of the n-cells, (size(n), N): ``sharp_pd d u``.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.hexagons(4))
    >>> np.allclose(polydec.gradient(square, square.points @ [3, -1]), [3, -1])
    True
    """
    return sharp_pd(complex, complex.d(0) @ values_of(complex, u, "primal", 0, "u"))


def whitney_at_centroids(complex: Complex, form: Form, *, degree: int | None = None) -> Floats:
    """Whitney interpolation of a primal k-form at the centroids of the input simplices.

    Returns one row of N over k coefficients per simplex. Exact for constant forms on flat meshes.
    Arrays need their degree k.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> dx = square.cochain(square.points[:, 0], 0).d()
    >>> np.allclose(polydec.whitney_at_centroids(square, dx), [1, 0])
    True
    """
    return _core.whitney_at_centroids(mesh_of(complex), as_form(complex, form, degree))


def whitney_form(complex: Complex, form: Form, top: int, barycentric: npt.ArrayLike, *,
                 degree: int | None = None) -> Floats:
    """Whitney interpolation of a primal k-form at a point of n-simplex `top` of the input.

    Parameters
    ----------
    complex : Complex
    form : Cochain or array_like
        Arrays need their degree k in `degree`.
    top : int
        Number of the n-simplex in `complex.input`, not the row of the mesh.
    barycentric : array_like, shape (n + 1,)
        Barycentric coordinates of the point in the simplex, for its vertices in ascending order;
        they sum to 1.

    Returns
    -------
    numpy.ndarray, shape (N over k,)
        The coefficients of dx_I.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> dx = square.cochain(square.points[:, 0], 0).d()
    >>> polydec.whitney_form(square, dx, 0, np.ones(3) / 3).round(12) + 0.0
    array([1., 0.])
    """
    return _core.whitney_form(mesh_of(complex), as_form(complex, form, degree), top,
                              floats(barycentric, "barycentric coordinates"))


def interior_product(complex: Complex, field: npt.ArrayLike, k: int, *,
                     sampling: str = "centered") -> Any:
    """Interior product i_X on primal k-forms, a sparse matrix, size(k-1) x size(k).

    Parameters
    ----------
    complex : Complex
    field : array_like, shape (size(0), N)
        X at the vertices.
    sampling : {"centered", "upwind"}
        Which simplices around a cell sample the form: all of them, or the one nearest to -X; of
        several equally near, the mean by volume.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> X = np.tile([2.0, 0.0], (square.size(0), 1))
    >>> dx = square.d(0) @ square.points[:, 0]
    >>> np.allclose(polydec.interior_product(square, X, 1) @ dx, 2.0)     # i_X dx
    True
    """
    return _core.interior_product(mesh_of(complex), _vectors(complex, field), k, sampling)


def lie_derivative(complex: Complex, field: npt.ArrayLike, k: int, *,
                   sampling: str = "centered") -> Any:
    """Lie derivative of primal k-forms, ``i_X d + d i_X``, a sparse matrix. It commutes with
    d; with upwind sampling, the matrix minus `inflow` does.

    For the parameters see `interior_product`. Upwind sampling of functions needs a mesh without
    vertices added by splits: use ``delaunay="flips"``.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> X = square.points                             # which stretches areas at the rate 2
    >>> L = polydec.lie_derivative(square, X, 0)
    >>> abs(square.d(0) @ L - polydec.lie_derivative(square, X, 1) @ square.d(0)).max() < 1e-12
    True
    """
    return _core.lie_derivative(mesh_of(complex), _vectors(complex, field), k, sampling)


def inflow(complex: Complex, field: npt.ArrayLike, k: int) -> Any:
    """Inflow rate of exterior values of a k-form, for the upwind `lie_derivative`.

    Returns a sparse matrix with one row per k-cell. For the parameters see `interior_product`.

    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> X = np.tile([1.0, 0.0], (square.size(0), 1))
    >>> polydec.inflow(square, X, 0).shape[0] == square.size(0)
    True
    """
    return _core.inflow(mesh_of(complex), _vectors(complex, field), k)


class LieDerivative:
    """Matrix-free Lie derivative of primal k-forms, for vector fields that change in every step.

    Agrees to rounding with `lie_derivative`, `interior_product` and `inflow`, in a fraction of the
    time, with the same limits.

    Parameters
    ----------
    complex : Complex
    k : int
        Degree of the forms.
    sampling : {"centered", "upwind"}
        Which simplices around a cell sample the form.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.well_centered(4))
    >>> X = square.points
    >>> form = square.d(0) @ square.points[:, 0]              # dx, which grows at the rate 1
    >>> L = polydec.LieDerivative(square, 1)
    >>> np.allclose(L(X, form), polydec.lie_derivative(square, X, 1) @ form)
    True
    """

    def __init__(self, complex: Complex, k: int, *, sampling: str = "centered") -> None:
        self._complex = complex
        self._k = k
        self._lie = _core.LieDerivative(mesh_of(complex), k, sampling)

    def __call__(self, field: npt.ArrayLike, form: Form) -> Any:
        """``L_X`` of a form, a k-form; `field` has one row of N components per vertex."""
        return self._applied(self._lie.lie_derivative, field, form)

    def interior_product(self, field: npt.ArrayLike, form: Form) -> Any:
        """``i_X`` of a form, a (k-1)-form; empty for k = 0."""
        return self._applied(self._lie.interior_product, field, form)

    def inflow(self, field: npt.ArrayLike, outside: Form) -> Any:
        """Contribution of exterior values of a k-form to ``-L_X`` where the field flows in."""
        return self._applied(self._lie.inflow, field, outside)

    def _applied(self, operator: Any, field: npt.ArrayLike, form: Form) -> Any:
        given = as_form(self._complex, form, self._k)
        return _given_back(self._complex, operator(_vectors(self._complex, field), given), form)
