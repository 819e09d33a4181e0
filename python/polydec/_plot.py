# SPDX-License-Identifier: MIT
"""Pictures, and conversion to meshes of other packages."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from ._arrays import Floats, Integers, floats
from ._cells import Form, as_form
from ._cochain import Cochain
from ._complex import CellsLike, Complex, as_complex
from ._errors import InvalidInput
from ._lists import CellList, Polygons
from ._vertices import at_cells, at_vertices


def _polygons(complex: Complex) -> tuple[Floats, list[Floats], Integers]:
    """Corners in space of the visible 2-cells, and their numbers. Solids show their boundary."""
    if complex.dim == 3:
        cells = complex.cells(2)
        points, offsets, corners = complex.points, cells.offsets, cells.corners
        seen = np.flatnonzero(complex.boundary_facets())
    elif complex.dim == 2:
        points, offsets, corners = complex.polygons()
        seen = np.arange(len(offsets) - 1)
    else:
        raise InvalidInput(f"cannot draw a complex of dimension {complex.dim}: expected 2 or 3")
    starts = offsets[seen]
    return points, [points[corners[a:b]] for a, b in zip(starts, offsets[seen + 1])], seen


def plot(complex: CellsLike, values: Form | None = None, *, degree: int | None = None,
         side: str = "primal", ax: Any = None, **style: Any) -> Any:
    """Draws the cells with matplotlib, colored by a form on vertices or on visible cells.

    Each merged cell is one polygon. A solid shows its boundary; a glued mesh shows its box.

    Parameters
    ----------
    values : Cochain or array_like, optional
        A primal 0-form, shown as its mean over each polygon; a form on the polygons, of primal
        degree 2 or dual degree n - 2; or any array with one number per polygon.
    degree, side
        Degree and side of an array; by default its length gives the degree.
    ax : matplotlib axes, optional
        New axes by default; three-dimensional for points in space.
    **style
        Options of matplotlib's ``PolyCollection`` or ``Poly3DCollection``, such as ``cmap``.

    Returns
    -------
    matplotlib collection
        Works with ``plt.colorbar``; its axes are ``.axes``.

    Examples
    --------
    >>> import matplotlib, polydec
    >>> matplotlib.use("Agg")
    >>> hexagons = polydec.discretize(polydec.meshes.hexagons(4))
    >>> drawn = polydec.plot(hexagons, hexagons.volumes(2), cmap="viridis")
    >>> len(drawn.get_paths()) == hexagons.size(2)
    True
    """
    import matplotlib.pyplot as plt
    from matplotlib.collections import PolyCollection
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    complex = as_complex(complex)
    points, polygons, seen = _polygons(complex.box)
    in_plane = points.shape[1] == 2
    if ax is None:
        ax = plt.figure().add_subplot(projection=None if in_plane else "3d")
    style = {"edgecolor": "#333333", "linewidth": 0.4, **style}
    collection = (PolyCollection if in_plane else Poly3DCollection)(polygons, **style)
    if values is not None:
        collection.set_array(_colors(complex, values, degree, side, seen))
    elif not {"facecolor", "facecolors", "color"} & style.keys():
        collection.set_facecolor("#e4e9ef")
    if in_plane:
        ax.add_collection(collection)
        ax.autoscale_view()
        ax.set_aspect("equal")
    else:
        ax.add_collection3d(collection)
        corners = np.concatenate(polygons)
        for axis, bounds in zip("xyz", np.stack([corners.min(0), corners.max(0)], axis=1)):
            getattr(ax, f"set_{axis}lim")(bounds)
        ax.set_box_aspect(np.maximum(np.ptp(corners, axis=0), 1e-9))
    return collection


def _colors(complex: Complex, values: Form, degree: int | None, side: str,
            seen: Integers) -> Floats:
    if isinstance(values, Cochain):
        side, degree, array = as_form(complex, values, None)
    else:
        array = at_cells(complex, floats(values, "values"))
        if degree is None:
            side, degree = "primal", 0 if len(array) == complex.size(0) else 2
    cells = degree if side == "primal" else complex.dim - degree
    if cells not in (0, 2) or len(array) != complex.size(cells):
        raise InvalidInput(f"cannot show a {side} {degree}-form of {len(array)} values: "
                           f"expected {complex.size(0)} values on vertices or {complex.size(2)} "
                           "on 2-cells")
    array = complex._on_box(cells, array)
    if cells == 2:
        return np.asarray(array[seen])
    lists = complex.box.cells(2)
    sums = np.add.reduceat(at_vertices(complex.box, array)[lists.corners], lists.offsets[:-1])
    return np.asarray((sums / np.diff(lists.offsets))[seen])


def to_meshio(complex: Complex, forms: Mapping[str, npt.ArrayLike] | None = None) -> Any:
    """A ``meshio.Mesh`` of the cells: lines, polygons grouped by number of corners, or tetrahedra.
    `forms` on vertices or n-cells become its data. Raises InvalidInput for merged polyhedra.

    >>> import polydec
    >>> grid = polydec.discretize(polydec.meshes.grid(2, 2))
    >>> [block.type for block in polydec.to_meshio(grid).cells]
    ['quad']
    """
    import meshio

    n = complex.dim
    box = complex.box
    points = box.points
    lists = box.cells(n)
    sizes = np.diff(lists.offsets)
    if n not in (1, 2) and not (n == 3 and (sizes == 4).all()):
        raise InvalidInput("meshio does not support merged polyhedra: use write_vtu")
    names = {1: {2: "line"}, 2: {3: "triangle", 4: "quad"}, 3: {4: "tetra"}}[n]
    blocks, numbers = [], []
    for size in np.unique(sizes):
        of_size = np.flatnonzero(sizes == size)
        corners = lists.corners[lists.offsets[of_size][:, None] + np.arange(size)]
        if n == 3:
            corners = _positive(points, corners)
        blocks.append((names.get(int(size), f"polygon{size}" if meshio.__version__ < "5" else
                                 "polygon"), corners))
        numbers.append(of_size)
    point_data, cell_data = {}, {}
    for name, values in (forms or {}).items():
        array = at_cells(complex, floats(np.asarray(values), name))
        if len(array) == complex.size(0):
            point_data[name] = at_vertices(box, complex._on_box(0, array))
        elif len(array) == complex.size(n):
            array = complex._on_box(n, array)
            cell_data[name] = [array[of_size] for of_size in numbers]
        else:
            raise InvalidInput(f"{name} has {len(array)} values: expected {complex.size(0)} on "
                               f"vertices or {complex.size(n)} on {n}-cells")
    return meshio.Mesh(points, blocks, point_data=point_data, cell_data=cell_data)


def _positive(points: Floats, corners: Integers) -> Integers:
    """Tetrahedra, reordered for positive determinants."""
    edges = points[corners[:, 1:]] - points[corners[:, :1]]
    turned = corners.copy()
    inverted = np.linalg.det(edges) < 0
    turned[inverted, 2:] = turned[inverted, :1:-1]
    return turned


def to_pyvista(complex: Complex, forms: Mapping[str, npt.ArrayLike] | None = None) -> Any:
    """A ``pyvista.PolyData`` of the visible 2-cells, with forms on vertices or on 2-cells."""
    import pyvista

    box = complex.box
    points, polygons, seen = _polygons(box)
    lists: CellList | Polygons = box.cells(2) if complex.dim == 3 else box.polygons()
    faces = [np.concatenate([[b - a], lists.corners[a:b]])
             for a, b in zip(lists.offsets[seen], lists.offsets[seen + 1])]
    result = pyvista.PolyData(np.pad(points, ((0, 0), (0, 3 - points.shape[1]))),
                              np.concatenate(faces))
    for name, values in (forms or {}).items():
        array = at_cells(complex, floats(np.asarray(values), name))
        if len(array) == complex.size(0):
            array = complex._on_box(0, array)
            result.point_data[name] = array if len(array) == len(points) else \
                at_vertices(box, array)
        else:
            result.cell_data[name] = complex._on_box(2, array)[seen]
    return result
