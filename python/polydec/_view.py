# SPDX-License-Identifier: MIT
"""Output for viewers: pages for browsers, and grids for ParaView."""
from __future__ import annotations

import html
import os
from pathlib import Path
from typing import Any, Iterator, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, as_array, floats
from ._cochain import Cochain, Form
from ._complex import CellsLike, Complex, as_complex
from ._errors import InvalidInput, IoError
from ._spectra import Spectrum
from ._vertices import form_at_cells

#: One form or array of vectors, several with names, or the modes of a spectrum.
Fields = Union[Form, Mapping[str, Form], Spectrum]
_Named = tuple[str, str, int, Floats, str]


class Page:
    """An HTML page of cells with forms; it needs no network.

    A notebook displays a page that is the last value of a notebook cell.

    Attributes
    ----------
    html : str
        The whole page.
    """

    def __init__(self, text: str) -> None:
        self.html = text

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the page to a file for any browser.

        Raises
        ------
        IoError
            If the file cannot be written; ``path`` names it.
        """
        try:
            Path(path).write_text(self.html, encoding="utf-8")
        except OSError as error:
            raise IoError(f"cannot write {os.fspath(path)}: {error.strerror}",
                          path=os.fspath(path)) from None

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="560" '
                'style="border: 0" title="polydec"></iframe>')

    def __repr__(self) -> str:
        return f"Page({len(self.html) / 1e6:.2f} MB; save it, or show it in a notebook)"


def file_and_up(complex: Complex, up: str | None) -> tuple[str, int | None]:
    """The mesh file, empty if unknown, and the number of the axis that is to point up."""
    if up not in (None, "x", "y", "z"):
        raise InvalidInput(f"up is {up!r}: expected None, 'x', 'y' or 'z'")
    return getattr(complex._given, "_file", ""), None if up is None else "xyz".index(up)


def view(complex: CellsLike, fields: Fields | None = None, *, degree: int | None = None,
         side: str = "primal", times: Sequence[float] | None = None, title: str = "polydec",
         facts: Sequence[str] = (), up: str | None = None, length_unit: str = "") -> Page:
    """An interactive page of the merged cells with fields: to rotate, cut and click.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
        Dimension 1 to 3, with at most 3 coordinates.
    fields : Cochain, array_like, mapping of str to these, or Spectrum, optional
        Forms of any degrees and sides, and vectors: arrays with a row of 2 or 3 numbers for each
        vertex or n-cell. The page opens with the first one; its readers choose among them. Vectors,
        1-forms and (n-1)-forms have arrows. A `Spectrum` shows all modes, the table of eigenvalues
        and the certificate.
    degree, side
        Degree and side of arrays; by default the length of an array gives the degree, 0 or n.
    times : sequence of float, optional
        Times of the columns of arrays, along the last axis; the page plays them.
    title : str
    facts : sequence of str
        Paragraphs beside the picture.
    up : {None, "x", "y", "z"}
        The axis that points up; by default y for meshes from .obj, .ply and .off files, else z.
    length_unit : str
        Name of the unit of length, such as "mm", for the scale bar and the legend.

    Returns
    -------
    Page

    Raises
    ------
    InvalidInput
        For arrays of wrong sizes, and for cells that cannot be drawn.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(2))
    >>> page = polydec.view(sphere, sphere.volumes(2), degree=2, title="Areas")
    >>> "Areas" in page.html and "https://" not in page.html
    True
    >>> x, y, z = sphere.points.T
    >>> wind = np.stack([-y, x, 0 * z], axis=1)
    >>> page = polydec.view(sphere, {"wind": wind, "height": z, "area": sphere.volumes(2)})
    """
    complex = as_complex(complex)
    conventions = (*file_and_up(complex, up), length_unit)
    if isinstance(fields, Spectrum):
        return Page(_core.page_of_modes(complex._mesh, fields, title, [*facts], conventions))
    columns = by_name(fields)
    steps = []
    if times is not None:
        steps = [(f"{time:g}", _forms(complex, _at(columns, i, len(times)), degree, side))
                 for i, time in enumerate(times)]
        columns = _at(columns, 0, len(times))
    forms = _forms(complex, columns, degree, side)
    return Page(_core.page(complex._mesh, forms, steps, title, [*facts], conventions))


def write_vtu(path: str | os.PathLike[str], complex: CellsLike, forms: Fields | None = None, *,
              degree: int | None = None, side: str = "primal", float32: bool = False) -> None:
    """Writes the cells with their fields for ParaView. Fields on vertices become point data, fields
    on n-cells cell data. Forms on edges or faces are cell data if all fields are on these, else
    field data; 1-forms and (n-1)-forms also give vectors at vertices, as NAME_vector.

    Parameters
    ----------
    path : str or os.PathLike
    complex : Complex, or a mesh as `discretize` takes it
    forms, degree, side
        As for `view`.
    float32 : bool
        Writes points and values with 7 digits instead of 16.

    Raises
    ------
    InvalidInput
        As for `view`.
    IoError
        If the file cannot be written; ``path`` names it.

    Examples
    --------
    >>> import os, polydec, tempfile
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(2))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     polydec.write_vtu(folder + "/z.vtu", sphere, {"z": sphere.points[:, 2]})
    ...     os.listdir(folder)
    ['z.vtu']
    """
    complex = as_complex(complex)
    given = _forms(complex, by_name(forms), degree, side)
    _core.write_vtu(os.fspath(path), complex._mesh, given, float32)


class Series:
    """Pictures at ascending times: a .pvd file for ParaView, an .html page that plays, or a .png or
    .svg picture of one step.

    A .pvd file grows step by step, and is readable after a kill. A page is written at the end.

    Parameters
    ----------
    path : str or os.PathLike
        Must end with .pvd, .html, .png or .svg.
    complex : Complex, or a mesh as `discretize` takes it
    title : str
    times : sequence of float
        Times of the steps already in a .pvd file, to append to it; empty starts a new file.

    Raises
    ------
    IoError
        If the path cannot be written.

    Examples
    --------
    >>> import os, polydec, tempfile
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(2))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     with polydec.Series(os.path.join(folder, "film.pvd"), sphere) as film:
    ...         for t in (0.0, 0.5):
    ...             film.add(t, {"u": t * sphere.points[:, 2]})
    ...     sorted(os.listdir(folder))
    ['film', 'film.pvd']
    """

    def __init__(self, path: str | os.PathLike[str], complex: CellsLike, *,
                 title: str = "polydec", times: Sequence[float] = ()) -> None:
        self._complex = as_complex(complex)
        self._series = _core.Series(os.fspath(path), self._complex._mesh, title, [*times])

    def add(self, time: float, forms: Fields, *, degree: int | None = None,
            side: str = "primal") -> None:
        """Adds a step with forms as for `view`; the names must be the same at every time."""
        self._series.add(time, _forms(self._complex, by_name(forms), degree, side))

    def close(self) -> None:
        """Writes remaining output. Called at the end of a ``with`` block."""
        self._series.close()

    def __enter__(self) -> Series:
        return self

    def __exit__(self, *error: object) -> None:
        if error[0] is None:
            self.close()


def by_name(fields: Fields | None) -> dict[str, Form]:
    """One field is called "values", modes mode_0, mode_1 and so on; None has no fields."""
    if fields is None:
        return {}
    if isinstance(fields, Spectrum):
        return {f"mode_{i}": Cochain(mode, fields.degree, fields.side)
                for i, mode in enumerate(fields.modes.T)}
    return dict(fields) if isinstance(fields, Mapping) else {"values": fields}


def _at(fields: Mapping[str, Form], i: int, times: int) -> dict[str, Form]:
    """Column i of each field; of vectors entry i of the last axis."""
    result: dict[str, Form] = {}
    for name, values in fields.items():
        table = floats(values, name, 3 if np.ndim(values) == 3 else 2)
        if table.shape[-1] != times:
            raise InvalidInput(f"{name} has {table.shape[-1]} columns: expected one for each of "
                               f"{times} times")
        result[name] = table[..., i]
    return result


def _forms(complex: Complex, fields: Mapping[str, Form], degree: int | None, side: str,
           top: int | None = None) -> list[_Named]:
    """Arrays without a degree are on vertices or on cells of degree `top`, by default n."""
    forms = []
    for name, values in fields.items():
        if not isinstance(values, Cochain):
            values = form_at_cells(complex, as_array(values, name), side, degree)
            k = _degree(complex, values, side, top) if degree is None else degree
            if values.ndim == 2:
                forms.append((name, *_place(complex, name, k, side), floats(values, name, 2),
                              "vectors"))
                continue
            values = Cochain(values, k, side)
        forms.append((name, values.side, values.degree, values.values,
                      f"{values.side} {values.degree}-form"))
    return forms


def _place(complex: Complex, name: str, k: int, side: str) -> tuple[str, int]:
    """Of vectors: vertices or n-cells, as the side and degree of forms with values there."""
    cells = k if side == "primal" else complex.dim - k
    if cells not in (0, complex.dim):
        raise InvalidInput(f"{name} has vectors on cells of degree {cells}: expected a row for "
                           f"each of {complex.size(0)} vertices or {complex.size(complex.dim)} "
                           f"{complex.dim}-cells")
    return ("primal" if cells == 0 else "dual"), 0


def _top(complex: Complex, values: npt.NDArray[Any], top: int | None) -> int:
    """Degree of the cells, besides vertices, that have values; vectors are those of n-cells."""
    return complex.dim if top is None or values.ndim == 2 else top


def _degree(complex: Complex, values: npt.NDArray[Any], side: str, top: int | None) -> int:
    k = _top(complex, values, top)
    low, high = (0, k) if side == "primal" else (complex.dim - k, complex.dim)
    return low if values.shape[:1] == (complex.size(low, side),) else high


def on_box(complex: Complex, fields: Mapping[str, Form], top: int, degree: int | None = None,
           side: str = "primal") -> Iterator[tuple[str, int, Floats]]:
    """Fields on vertices or cells of degree `top`, vectors on vertices or n-cells: names, the degree
    of the cells, and values on the cells of `box`."""
    for name, side, k, values, what in _forms(complex, fields, degree, side, top):
        cells = k if side == "primal" else complex.dim - k
        last = _top(complex, values, top)
        if cells not in (0, last) or len(values) != complex.size(cells):
            raise InvalidInput(f"{name} ({what}) has {len(values)} values: expected "
                               f"{complex.size(0)} on vertices or {complex.size(last)} on "
                               f"{last}-cells")
        yield name, cells, complex._on_box(cells, values)
