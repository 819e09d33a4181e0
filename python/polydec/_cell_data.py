# SPDX-License-Identifier: MIT
"""Data on cells, such as conductivities."""
from __future__ import annotations

from typing import Any, Callable, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, at_places, floats
from ._cells import Cells
from ._cochain import Cochain, values_of
from ._errors import InvalidInput

#: Data on cells: one number for all; one for each input cell, in input order; a dual 0-form; or a
#: function of all centroids of the n-cells.
CellNumbers = Union[float, npt.ArrayLike, Cochain, Callable[[Floats], Any]]


def cell_data(cells: Cells, given: CellNumbers | None, name: str) -> _core.CellData:
    """Data on cells in the form that C++ takes."""
    if given is None:
        return _core.CellData(np.zeros(0), False)
    if isinstance(given, Cochain):
        return _core.CellData(values_of(cells, given, "dual", 0, name), True)
    if callable(given):
        places = getattr(cells, "centroids", None)
        if places is None:
            raise InvalidInput(f"{name}: a function of positions is given for cells without a "
                               "mesh, which have no positions: give a dual 0-form")
        return _core.CellData(at_places(given, places(cells.dim), name), True)
    if np.ndim(given) == 0:
        return _core.CellData(floats(np.full(cells.size(cells.dim), given), name), True)
    return _core.CellData(floats(given, name), False)
