# SPDX-License-Identifier: MIT
"""Input conversion: arrays of any layout become arrays for C++, or raise an error by name."""
from __future__ import annotations

import operator
from typing import Any, Callable, Mapping, Tuple, Union

import numpy as np
import numpy.typing as npt
import scipy.sparse

from ._errors import InvalidInput

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int32]
MatrixParts = Tuple[Floats, Integers, Integers, int]
#: Values at points: one for all, one for each, or a function of the points.
Values = Union[float, npt.ArrayLike, Callable[[Floats], Any]]
#: The same on facets, or a number for each group of the file, 0 elsewhere.
OnFacets = Union[Values, Mapping[str, float]]


def as_array(values: Any, name: str) -> npt.NDArray[Any]:
    """Numbers of any type and shape. Raises InvalidInput for masked entries."""
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):
        raise InvalidInput(f"{name} have masked entries: expected values everywhere; fill them")
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise InvalidInput(f"{name} are not an array: {error}") from None
    if array.dtype == object:
        raise InvalidInput(f"{name} are not an array of numbers: rows have different lengths, or "
                           "entries are not numbers")
    return array


def _shape(array: npt.NDArray[Any], name: str, dimensions: int) -> None:
    if array.ndim != dimensions:
        wanted = "a row for each" if dimensions == 2 else "a list of numbers"
        raise InvalidInput(f"{name} have the shape {array.shape}: expected {wanted}, "
                           f"{dimensions} axes")


def floats(values: npt.ArrayLike, name: str, dimensions: int = 1) -> Floats:
    """C-contiguous real numbers. Raises InvalidInput for complex numbers and other shapes."""
    array = as_array(values, name)
    if array.dtype.kind not in "fiub":
        raise InvalidInput(f"{name} are of the type {array.dtype}: expected real numbers")
    if array.size == 0 and array.ndim < dimensions:
        array = array.reshape((0,) * dimensions)
    _shape(array, name, dimensions)
    return np.ascontiguousarray(array, dtype=np.float64)


def or_none(values: npt.ArrayLike | None, name: str) -> Floats:
    """The same; no numbers if nothing is given."""
    return np.zeros(0) if values is None else floats(values, name)


def is_given(values: Any) -> bool:
    """Whether data are other than None and the number 0."""
    return values is not None and bool(np.ndim(values) > 0 or values != 0)


def integers(values: npt.ArrayLike, name: str, dimensions: int = 1) -> Integers:
    """Whole numbers of 32 bits. Raises InvalidInput for other values, fractions included."""
    array = as_array(values, name)
    if array.size == 0 and array.ndim < dimensions:
        array = array.reshape((0,) * dimensions)
    _shape(array, name, dimensions)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise InvalidInput(f"{name} are of the type {array.dtype}: expected whole numbers")
    limits = np.iinfo(np.int32)
    if array.dtype.itemsize >= 4 and array.dtype != np.int32 and array.size > 0:
        outside = (array > limits.max) | (array < limits.min)
        if outside.any():
            place = tuple(int(i) for i in np.argwhere(outside)[0])
            raise InvalidInput(f"{name}: {array[place]} in row {place[0]} does not fit into "
                               "32 bits", cells=[place[0]] if dimensions == 2 else [])
    return np.ascontiguousarray(array, dtype=np.int32)


def whole(value: Any, name: str) -> int:
    """A whole number. Raises InvalidInput for a fraction or anything else."""
    try:
        return operator.index(value)
    except TypeError:
        raise InvalidInput(f"{name} is {value!r}: expected a whole number") from None


def called(given: Any, places: Floats, name: str) -> Any:
    """What a function returns at these places; anything else as it is. Raises InvalidInput for a
    function where positions are unknown."""
    if not callable(given):
        return given
    if places.shape[1] == 0:
        raise InvalidInput(f"only lengths are known, but {name} by a function need points: give "
                           "an array, or a mesh with points")
    return given(places)


def at_places(values: Values, places: Floats, name: str, dimensions: int = 1) -> Floats:
    """One value per point, or one row for 2 dimensions, given directly or by a function of all
    points; or one value for all."""
    array = as_array(called(values, places, name), name)
    if array.ndim == 0 and dimensions == 1:
        array = np.full(len(places), array[()])
    result = floats(array, name, dimensions)
    if len(result) != len(places):
        one = "one, or " if dimensions == 1 else ""
        raise InvalidInput(f"{len(result)} {name} are given: expected {one}{len(places)}")
    return result


def matrix_parts(matrix: Any, name: str) -> MatrixParts:
    """CSR arrays of a sparse or dense matrix: sorted rows, no duplicate entries."""
    if not scipy.sparse.issparse(matrix):
        matrix = scipy.sparse.csr_matrix(floats(matrix, name, 2))
    if np.dtype(matrix.dtype).kind not in "fiub":
        raise InvalidInput(f"{name} is of the type {matrix.dtype}: expected real numbers")
    rows = _checked(matrix, name).tocsr()
    if not rows.has_canonical_format:
        rows = rows.copy() if rows is matrix else rows
        rows.sum_duplicates()
    return (floats(rows.data, name), integers(rows.indices, name), integers(rows.indptr, name),
            int(rows.shape[1]))


def _checked(matrix: Any, name: str) -> Any:
    """The matrix, whose indices scipy checks only when asked; it would read beyond arrays."""
    if not hasattr(matrix, "indptr"):
        return matrix
    try:
        if (np.diff(matrix.indptr) < 0).any():
            raise ValueError("indptr is not ascending")
        matrix.check_format(full_check=True)
    except ValueError as error:
        raise InvalidInput(f"{name} has wrong indices: {error}; expected row and column numbers "
                           f"within its shape {matrix.shape}") from None
    return matrix
