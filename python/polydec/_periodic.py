# SPDX-License-Identifier: MIT
"""Periodic boxes, and other meshes glued to themselves."""
from __future__ import annotations

from typing import Any, Callable, Sequence

import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats
from ._errors import InvalidInput
from ._given import MeshLike, as_mesh
from ._mesh import LengthMesh, Mesh


class PeriodicMesh(LengthMesh):
    """A mesh glued to itself, made by `periodic` or `glue`. It stores edge lengths, and the
    positions of its simplices in the box.

    `discretize` takes it like any mesh. Functions of position are evaluated in the box, and
    pictures show the box.

    Attributes
    ----------
    box : Mesh
        The input mesh.
    points : numpy.ndarray
        The first position of each vertex in the box.
    numbers : numpy.ndarray
        For each vertex of the box, its vertex number here.
    """

    __slots__ = ("_glued", "points", "numbers")

    def __init__(self, glued: _core.PeriodicMesh) -> None:
        self._glued = glued
        self._mesh = glued.quotient
        self.points: Floats = glued.points
        self.numbers: Integers = glued.vertices

    @property
    def box(self) -> Mesh:
        return Mesh._of(self._glued.box)

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (self.box, LengthMesh._of(self._mesh), self.numbers, self.points)


def _unpickled(box: Mesh, quotient: LengthMesh, numbers: Integers, points: Floats) -> PeriodicMesh:
    return PeriodicMesh(_core.PeriodicMesh(box._mesh, quotient._mesh, numbers, points))


def periodic(mesh: MeshLike, translations: Sequence[npt.ArrayLike]) -> PeriodicMesh:
    """Glues vertices of a mesh that differ by a translation: a torus given by edge lengths.

    Parameters
    ----------
    mesh : Mesh, or what `as_mesh` makes one of
    translations : sequence of array_like, shape (N,)
        For example ``[[1, 0], [0, 1]]`` for the unit square.

    Raises
    ------
    InvalidInput
        If a translation maps no vertex to a vertex, or has fewer than three cells along it.

    Examples
    --------
    >>> import polydec
    >>> box = polydec.periodic(polydec.meshes.grid(4, 4), [[1, 0], [0, 1]])
    >>> mesh = polydec.discretize(box)
    >>> mesh.shape, mesh.betti_numbers()
    ((16, 32, 16), [1, 2, 1])
    """
    box = _with_points(mesh)
    return PeriodicMesh(_core.periodic(
        box._mesh, [floats(each, "a translation") for each in translations]))


def glue(mesh: MeshLike, isometries: Sequence[Callable[[Floats], Any]]) -> PeriodicMesh:
    """Glues vertices of a mesh that isometries map to each other, such as a Klein bottle or a cone.

    Parameters
    ----------
    mesh : Mesh, or what `as_mesh` makes one of
    isometries : sequence of callable
        Each takes points, one per row, and returns their images.

    Raises
    ------
    InvalidInput
        If an isometry maps no vertex to another, maps an edge to no edge or to one of another
        length, or has fewer than three cells along it.

    Examples
    --------
    >>> import numpy as np, polydec
    >>> up, twist = lambda p: p + [0, 1], lambda p: np.column_stack([p[:, 0] + 1, 1 - p[:, 1]])
    >>> bottle = polydec.discretize(polydec.glue(polydec.meshes.grid(6, 6), [up, twist]))
    >>> bottle.shape, bottle.betti_numbers()
    ((36, 72, 36), [1, 1, 0])
    """
    box = _with_points(mesh)
    return PeriodicMesh(_core.glue(
        box._mesh, [floats(each(box.points), "places", 2) for each in isometries]))


def _with_points(mesh: MeshLike) -> Mesh:
    given = as_mesh(mesh)
    if not isinstance(given, Mesh):
        raise InvalidInput("the mesh has no points: expected a mesh with points, which the "
                           "translations or isometries map to others")
    return given
