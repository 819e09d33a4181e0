# SPDX-License-Identifier: MIT
"""Boxes without walls."""
from __future__ import annotations

from typing import Any, Callable, Sequence

import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats
from ._complex import Complex, mesh_of
from ._errors import InvalidInput
from ._fields import coefficients
from ._given import MeshLike, as_mesh
from ._mesh import LengthMesh, Mesh


class PeriodicMesh(LengthMesh):
    """A mesh glued to itself along translations, as `periodic` makes it, by the lengths of its edges.

    `discretize` takes it as every mesh.

    Attributes
    ----------
    points : numpy.ndarray
        Of each vertex its first place in the box.
    numbers : numpy.ndarray
        Of each vertex of the box its number here.
    """

    __slots__ = ("_box", "points", "numbers")

    def __init__(self, box: Mesh, translations: Sequence[npt.ArrayLike]) -> None:
        self._box = _core.PeriodicMesh(
            box._mesh, [floats(each, "a translation") for each in translations])
        self._mesh = self._box.quotient
        self.points: Floats = self._box.points
        self.numbers: Integers = self._box.vertices

    def de_rham(self, complex: Complex, k: int, form: Callable[[Floats], Any], *,
                quadrature_degree: int = 5) -> Floats:
        """Integrals of a k-form with these periods over the cells, where they lie in the box;
        `complex` is what `discretize` made of this, and the form as for `polydec.de_rham`."""
        return self._box.de_rham(mesh_of(complex), k, coefficients(form, self.points.shape[1], k),
                                 quadrature_degree)


def periodic(mesh: MeshLike, translations: Sequence[npt.ArrayLike]) -> PeriodicMesh:
    """Glues vertices of a mesh that differ by a translation: a torus that no R^n holds.

    Parameters
    ----------
    mesh : Mesh, or what `as_mesh` makes one of
    translations : sequence of array_like, shape (N,)
        Such as ``[[1, 0], [0, 1]]`` for the unit square.

    Raises
    ------
    InvalidInput
        If a translation takes no vertex to one, or there are fewer than three cells along it.

    Examples
    --------
    >>> import polydec
    >>> box = polydec.periodic(polydec.meshes.grid(4, 4), [[1, 0], [0, 1]])
    >>> mesh = polydec.discretize(box)
    >>> mesh.shape, mesh.betti_numbers()
    ((16, 32, 16), [1, 2, 1])
    """
    given = as_mesh(mesh)
    if not isinstance(given, Mesh):
        raise InvalidInput("a mesh without points is given: expected one with points, which "
                           "translations move")
    return PeriodicMesh(given, translations)
