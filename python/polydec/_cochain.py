# SPDX-License-Identifier: MIT
"""Discrete forms with their degree and side."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Values, at_places, floats
from ._errors import InvalidInput
from ._vertices import form_at_cells, mesh_of

if TYPE_CHECKING:
    from ._cells import Cells


def check_side(side: str) -> None:
    """Raises InvalidInput for a name that is no side."""
    if side not in ("primal", "dual"):
        raise InvalidInput(f'side is "{side}": expected "primal" or "dual"')


class Cochain:
    """A discrete k-form: its integrals over the oriented k-cells, primal or dual.

    Parameters
    ----------
    values : array_like
        One number per cell. A primal 0-form may also have one per input vertex.
    degree : int
    side : {"primal", "dual"}
    complex : Cells
        The cells that carry the form.

    Examples
    --------
    >>> import polydec
    >>> c = polydec.discretize(polydec.meshes.well_centered(4))
    >>> u = polydec.Cochain(c.points[:, 0], 0, "primal", c)
    >>> round(u.d().norm(), 12)          # |grad x| = 1 on the unit square
    1.0
    >>> (u + 2 * u).d().d()
    Cochain(primal 2-form, 96 values)
    """

    __array_priority__ = 20.0 # numpy scalars times a form are forms

    def __init__(self, values: npt.ArrayLike, degree: int, side: str = "primal",
                 complex: Cells | None = None) -> None:
        check_side(side)
        self.values: Floats = floats(values, f"values of the {side} {degree}-form")
        self.degree = degree
        self.side = side
        self._complex = complex
        if complex is not None:
            self.values = form_at_cells(complex, self.values, side, degree)
        if complex is not None and len(self.values) != complex.size(degree, side):
            raise InvalidInput(f"a {side} {degree}-form of {len(self.values)} values is given: "
                               f"expected {complex.size(degree, side)}")

    @property
    def complex(self) -> Cells:
        """The cells that carry the form. Raises `InvalidInput` if none were given."""
        if self._complex is None:
            raise InvalidInput("the form has no complex: expected a form that knows its complex")
        return self._complex

    def _made(self, operator: Any) -> Cochain:
        return made(operator((self.side, self.degree, self.values)), self.complex)

    def d(self) -> Cochain:
        """Exterior derivative, a (k+1)-form."""
        return self._made(self.complex._cells.d_of)

    def star(self) -> Cochain:
        """Hodge star, an (n-k)-form on the other side."""
        return self._made(self.complex._cells.star_of)

    def delta(self) -> Cochain:
        """Codifferential, a (k-1)-form."""
        return self._made(self.complex._cells.codifferential_of)

    def laplacian(self) -> Cochain:
        """Laplace-de Rham operator."""
        return self._made(self.complex._cells.laplacian_of)

    def wedge(self, other: Cochain) -> Cochain:
        """Exterior product with another form of the same side."""
        left, right = as_form(self.complex, self), as_form(self.complex, other)
        return made(product(self.complex, left, right), self.complex)

    def norm(self) -> float:
        """L2 norm."""
        return self.complex.norm(self)

    def _same(self, other: Cochain) -> None:
        if (self.side, self.degree, len(self.values)) != (other.side, other.degree,
                                                          len(other.values)):
            raise InvalidInput(f"{self!r} and {other!r} are not of the same kind")

    def _with(self, values: Floats) -> Cochain:
        return Cochain(values, self.degree, self.side, self._complex)

    def __add__(self, other: Cochain) -> Cochain:
        self._same(other)
        return self._with(self.values + other.values)

    def __sub__(self, other: Cochain) -> Cochain:
        self._same(other)
        return self._with(self.values - other.values)

    def __mul__(self, factor: float) -> Cochain:
        return self._with(self.values * float(factor))

    __rmul__ = __mul__

    def __truediv__(self, divisor: float) -> Cochain:
        return self._with(self.values / float(divisor))

    def __neg__(self) -> Cochain:
        return self._with(-self.values)

    def __len__(self) -> int:
        return len(self.values)

    def __array__(self, dtype: Any = None) -> npt.NDArray[Any]:
        return np.asarray(self.values, dtype=dtype)

    def __repr__(self) -> str:
        return f"Cochain({self.side} {self.degree}-form, {len(self.values)} values)"


#: An array of values, or a `Cochain`, which stores its side and degree.
Form = Union[Cochain, npt.ArrayLike]


def as_form(cells: Cells, form: Form, degree: int | None = None,
            side: str = "primal") -> tuple[str, int, Floats]:
    """Side, degree and values of a `Cochain`, or of an array with its degree and side. An array may
    have one value per input vertex."""
    if isinstance(form, Cochain):
        return form.side, form.degree, form.values
    if degree is None:
        raise InvalidInput("an array is given without a degree: expected a Cochain, or an array "
                           "and the degree of the form")
    values = floats(form, f"values of the {side} {degree}-form")
    return side, degree, form_at_cells(cells, values, side, degree)


def of_kind(given: Any, name: str, *kinds: tuple[str, int]) -> Any:
    """What is given. Raises InvalidInput for a `Cochain` of another side and degree than these."""
    if isinstance(given, Cochain) and (given.side, given.degree) not in kinds:
        expected = " or ".join(f"a {side} {degree}-form" for side, degree in kinds)
        raise InvalidInput(f"{name}: {given!r} is given: expected {expected}")
    return given


def values_of(cells: Cells, form: Form, side: str, degree: int, name: str) -> Floats:
    """Values of a form of this kind, given as a `Cochain` or an array."""
    values = floats(of_kind(form, name, (side, degree)), name)
    return form_at_cells(cells, values, side, degree)


def function_values(cells: Cells, given: Form | Values, places: Floats, name: str,
                    side: str = "primal") -> Floats:
    """Values of a 0-form, given as a `Cochain`, or by values at its places."""
    if isinstance(given, Cochain):
        return values_of(cells, given, side, 0, name)
    return form_at_cells(cells, at_places(given, places, name), side, 0)


def made(form: tuple[str, int, Floats], cells: Cells) -> Cochain:
    """A form from C++. One of a degree that does not exist has no values and no cells."""
    side, degree, values = form
    return Cochain(values, degree, side, cells if len(values) else None)


def product(cells: Cells, left: tuple[str, int, Floats], right: tuple[str, int, Floats],
            weights: str = "uniform") -> tuple[str, int, Floats]:
    """Exterior product of two forms on one side."""
    return _core.product(mesh_of(cells), weights, left, right)
