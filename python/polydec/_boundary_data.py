# SPDX-License-Identifier: MIT
"""Data on the boundary."""
from __future__ import annotations

from typing import Any, Callable, Mapping

import numpy.typing as npt

from . import _core
from ._arrays import Floats, Values, at_places, is_given, or_none
from ._complex import Complex
from ._errors import InvalidInput
from ._vertices import mesh_of


def boundary_data(*, values: npt.ArrayLike | None = None,
                  codifferential: npt.ArrayLike | None = None, flow: npt.ArrayLike | None = None,
                  derivative_flow: npt.ArrayLike | None = None
                  ) -> tuple[Floats, Floats, Floats, Floats]:
    """Boundary data in the form that C++ takes."""
    return (or_none(values, "values on the boundary"),
            or_none(codifferential, "values of the codifferential on the boundary"),
            or_none(flow, "values of the flow"),
            or_none(derivative_flow, "values of the flow of the derivative"))


def check_use(require_use: Callable[[str, str, str], None], degree: int,
              data: Mapping[str, Any]) -> None:
    """Raises InvalidInput, naming them, for boundary data that apply nowhere. `require_use` belongs
    to the `FormSpace` of the forms."""
    def given(*names: str) -> str:
        return next((name for name in names if is_given(data.get(name))), "")

    if degree == 0 and given("codifferential", "flow"):
        raise InvalidInput(f"{given('codifferential', 'flow')} is given for 0-forms, which have none "
                           "on the boundary: expected values of u, or of its derivative")
    require_use(given("boundary", "values", "codifferential"),
                given("flux", "flow", "derivative_flow"), "")


def outward_flow(complex: Complex, derivatives: Values, side: str = "primal") -> Floats:
    """The `derivative_flow` of 0-forms for given outward normal derivatives on the boundary.

    Parameters
    ----------
    complex : Complex
    derivatives : float, array_like or callable
        Values at `Complex.facet_sites`; only boundary facets matter.
    side : str

    Examples
    --------
    >>> import numpy as np, polydec
    >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
    >>> solver = polydec.PoissonSolver(square, essential=lambda p: p[:, 0] < 0.01)
    >>> pulled = polydec.outward_flow(square, lambda p: p[:, 0] > 0.99)     # u = x
    >>> u = solver.solve(derivative_flow=pulled).form
    >>> bool(abs(u.values - square.points[:, 0]).max() < 1e-12)
    True
    """
    return _core.outward_flow(mesh_of(complex), side,
                              at_places(derivatives, complex.facet_sites(), "outward derivatives"))
