# SPDX-License-Identifier: MIT
"""Pictures, and conversion to meshes of other packages."""
from __future__ import annotations

import functools
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, as_array
from ._cochain import Cochain, Form, as_form
from ._complex import CellList, CellsLike, Complex, Polygons, as_complex
from ._errors import InvalidInput
from ._spectra import Spectrum
from ._vertices import at_vertices
from ._view import Fields, by_name, file_and_up, on_box


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


def plot(complex: CellsLike, values: Fields | None = None, *, degree: int | None = None,
         side: str = "primal", ax: Any = None, bar: str | None = "",
         up: str | None = None, **style: Any) -> Any:
    """Draws the cells with matplotlib, colored by a function, a form or vectors.

    Each merged cell is one polygon. A solid shows its boundary; a glued mesh shows its box. Up to
    4000 polygons have edges. Surfaces in space are lit; new axes look from the direction of pages.

    Parameters
    ----------
    values : Cochain, array_like, mapping of str to these, or Spectrum, optional
        A primal 0-form, shown as its mean over each polygon; a form on the polygons, of primal
        degree 2 or dual degree n - 2; or any array with one number per polygon. A 1-form, or an
        array with a vector per vertex or n-cell, shows the lengths of its vectors, with arrows.
        Several fields, or modes, are drawn beside each other.
    degree, side
        Degree and side of an array; by default its length gives the degree.
    ax : matplotlib axes, optional
        New axes by default; three-dimensional for points in space. For several fields, as many.
    bar : str or None
        Label of the color bar; the names of several fields are added. None draws no bar.
    up : {"x", "y", "z"}, optional
        The axis of space that points up, as in `view`.
    **style
        Options of matplotlib's ``PolyCollection`` or ``Poly3DCollection``, such as ``cmap``. By
        default the colors are those of pages: one map for values of one sign, a map symmetric
        around 0 for values of both.

    Returns
    -------
    matplotlib axes
        The polygons are ``ax.collections[-1]``, which works with ``plt.colorbar``. For a mapping or
        a spectrum, an array of axes.

    Examples
    --------
    >>> import matplotlib, polydec
    >>> matplotlib.use("Agg")
    >>> hexagons = polydec.discretize(polydec.meshes.hexagons(4))
    >>> ax = polydec.plot(hexagons, hexagons.volumes(2), bar="area")
    >>> len(ax.collections[-1].get_paths()) == hexagons.size(2)
    True
    """
    complex = as_complex(complex)
    points, polygons, seen = _polygons(complex.box)
    fields: Mapping[str, Form | None] = {"": None}
    if isinstance(values, (Mapping, Spectrum)):
        fields = by_name(values)
    elif values is not None:
        fields = {"": values}
    if not fields:
        raise InvalidInput("no field is given: expected at least one in the mapping, or none at all")
    axis, eye = _core.first_view(*file_and_up(complex, up))
    angles = None if points.shape[1] == 2 else _angles(eye, axis)
    axes = _new_axes(len(fields), angles) if ax is None else np.ravel(ax)
    if len(axes) != len(fields):
        raise InvalidInput(f"{len(axes)} axes for {len(fields)} fields: expected one for each")
    edges = {"edgecolor": "#333333", "linewidth": 0.4}
    if len(polygons) > _MOST_WITH_EDGES:
        edges = {"edgecolor": "none", "linewidth": 0, "antialiased": False}
    light = None if angles is None else _core.brightness(_seen(_normals(polygons), eye, axis))
    for own, (name, field) in zip(axes, fields.items()):
        colors, vectors = (None, None) if field is None else _shown(complex, field, degree, side, seen)
        look = {**edges, **style}
        if colors is not None:
            look = {**_color_style(colors, look), **look}
        if light is None:
            collection = _draw_in_plane(own, polygons, colors, vectors, look)
        else:
            collection = _draw_in_space(own, polygons, light, colors, vectors, look)
        if colors is not None and bar is not None:
            label = " ".join(filter(None, (bar, name)))
            own.figure.colorbar(collection, ax=own, label=label, shrink=0.8)
    return axes if isinstance(values, (Mapping, Spectrum)) else axes[0]


def _new_axes(count: int, angles: tuple[float, float, float] | None) -> npt.NDArray[Any]:
    """In a figure that is larger for several, but not wider than a page; in space from these angles."""
    import matplotlib.pyplot as plt

    columns = int(np.ceil(np.sqrt(count)))
    rows = -(-count // max(columns, 1))
    size = np.array(plt.rcParams["figure.figsize"])
    figure = plt.figure(figsize=size * (columns, rows) * min(1, 12.8 / (columns * size[0])),
                        layout="constrained" if count > 1 else None)
    axes = [figure.add_subplot(rows, columns, 1 + i, projection=None if angles is None else "3d")
            for i in range(count)]
    for ax in axes if angles is not None else ():
        ax.view_init(*angles)
    return np.array(axes)


_MOST_WITH_EDGES = 4000
_masked: Any = np.ma  # which has no types
_PLAIN, _INK = "#e4e9ef", "#222222"
_FACE_NAMES = ("facecolor", "facecolors", "color")


def _angles(eye: Floats, axis: int) -> tuple[float, float, float]:
    """Elevation, azimuth and roll of matplotlib for a direction where this axis points up."""
    x, y, z = eye
    # without roll the third axis points up
    right, up, _ = _seen(np.eye(3)[axis], eye, 2)
    return (float(np.degrees(np.arctan2(z, np.hypot(x, y)))), float(np.degrees(np.arctan2(y, x))),
            float(np.degrees(np.arctan2(right, up))))


def _color_style(colors: Floats, style: Mapping[str, Any]) -> dict[str, Any]:
    """Map and limits of pages, unless there are others."""
    from matplotlib.colors import LinearSegmentedColormap

    if "cmap" in style:
        return {} if "norm" in style else {"clim": (colors.min(), colors.max())}
    names, low, high = _core.colors(colors.min(), colors.max())
    found: dict[str, Any] = {"cmap": LinearSegmentedColormap.from_list("polydec", names, 1024)}
    if "norm" not in style:
        found["clim"] = (low, high)
    return found


def _draw_in_plane(ax: Any, polygons: list[Floats], colors: Floats | None, vectors: Floats | None,
                   style: dict[str, Any]) -> Any:
    from matplotlib.collections import PolyCollection

    if vectors is not None:
        places, kept, rays, _ = _arrows(polygons, vectors)
        ax.quiver(*places[kept].T, *rays.T, color=_INK, angles="xy", scale_units="xy", scale=1,
                  pivot="mid", width=0.0025, zorder=3)
    collection = PolyCollection(polygons, **style)
    if colors is not None:
        collection.set_array(colors)
    elif not style.keys() & set(_FACE_NAMES):
        collection.set_facecolor(_PLAIN)
    ax.add_collection(collection)
    ax.autoscale_view()
    ax.set_aspect("equal")
    return collection


def _draw_in_space(ax: Any, polygons: list[Floats], light: Floats, colors: Floats | None,
                   vectors: Floats | None, style: dict[str, Any]) -> Any:
    from matplotlib.colors import to_rgba_array

    corners = np.concatenate(polygons)
    darts = [] if vectors is None else _darts(polygons, vectors)
    light = np.concatenate([light, np.ones(len(darts))])
    if colors is None:
        given = [style.pop(name) for name in _FACE_NAMES if name in style]
        faces = np.broadcast_to(to_rgba_array((given or [_PLAIN])[0]), (len(light), 4)).copy()
        faces[:, :3] *= light[:, None]
        style["facecolor"] = faces
    collection = _lit_collection()(polygons + darts, light, **style)
    if colors is not None:
        # arrows are among the polygons, so that those in front of them hide them
        values = np.concatenate([colors, np.full(len(darts), np.nan)])
        collection.set_array(_masked.masked_invalid(values))
    ax.add_collection3d(collection)
    for axis, bounds in zip("xyz", np.stack([corners.min(0), corners.max(0)], axis=1)):
        getattr(ax, f"set_{axis}lim")(bounds)
    ax.set_box_aspect(np.maximum(np.ptp(corners, axis=0), 1e-9))
    return collection


@functools.lru_cache(maxsize=1)
def _lit_collection() -> Any:
    from matplotlib.colors import to_rgba
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    class LitCollection(Poly3DCollection):  # type: ignore[misc]
        """Polygons whose mapped colors are darkened; masked values are ink."""

        def __init__(self, polygons: list[Floats], light: Floats, **style: Any) -> None:
            self._light = light
            super().__init__(polygons, **style)

        def to_rgba(self, x: Any, *args: Any, **options: Any) -> Any:
            colors = np.array(super().to_rgba(x, *args, **options))
            if colors.shape == (len(self._light), 4):
                colors[:, :3] *= self._light[:, None]
                colors[_masked.getmaskarray(x)] = to_rgba(_INK)
            return colors

    return LitCollection


def _normals(polygons: list[Floats]) -> Floats:
    """Normals times twice the areas, by Newell."""
    return np.array([np.cross(p[:-1] - p[0], p[1:] - p[0]).sum(axis=0) for p in polygons])


def _seen(directions: Floats, eye: Floats, axis: int) -> Floats:
    """Their parts to the right, up and to the eye."""
    eye = eye / np.linalg.norm(eye)
    right = np.cross(np.eye(3)[axis], eye)
    right /= np.linalg.norm(right)
    axes: Floats = np.stack([right, np.cross(eye, right), eye])
    return np.asarray(directions @ axes.T)


def _arrows(polygons: list[Floats], vectors: Floats) -> tuple[Floats, Integers, Floats, float]:
    """Centers of the polygons; those with an arrow, one in each cube of a grid, so that none meet;
    their arrows, of length 1 cube at most; the size of a cube."""
    places = np.array([p.mean(axis=0) for p in polygons])
    low = places.min(axis=0)
    size = float(np.linalg.norm(places.max(axis=0) - low)) / 28 or 1.0
    cubes = (places - low) / size
    off = np.linalg.norm(cubes - np.floor(cubes) - 0.5, axis=1)
    order = np.lexsort((off, *np.floor(cubes).T))
    _, first = np.unique(np.floor(cubes[order]), axis=0, return_index=True)
    kept = order[first]
    lengths = np.linalg.norm(vectors, axis=1)
    kept = kept[lengths[kept] > 0.02 * lengths.max()]
    rays = vectors[kept] / np.sqrt(lengths[kept] * lengths.max())[:, None]
    return places, kept, 0.9 * size * rays, size


def _darts(polygons: list[Floats], vectors: Floats) -> list[Floats]:
    """Arrows as polygons, on both sides of the surface."""
    places, kept, rays, size = _arrows(polygons, vectors)
    normals = _normals([polygons[i] for i in kept])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    shape = np.array([[-0.5, -0.05], [0.1, -0.05], [0.1, -0.2], [0.5, 0],
                      [0.1, 0.2], [0.1, 0.05], [-0.5, 0.05]])
    return [place + turn * 0.3 * size * normal + shape @ np.stack([ray, np.cross(normal, ray)])
            for place, ray, normal in zip(places[kept], rays, normals) for turn in (-1, 1)]


def _shown(complex: Complex, values: Form, degree: int | None, side: str,
           seen: Integers) -> tuple[Floats, Floats | None]:
    """The number of each polygon, and its vector for fields of vectors."""
    if isinstance(values, Cochain):
        side, degree = values.side, values.degree
    if degree == 1 and complex.dim > 1 and as_array(values, "values").ndim == 1 and not (
            side == "dual" and complex.dim == 3):
        values = _core.vectors_at_cells(complex._mesh, as_form(complex, values, 1, side))
        degree, side = 0, "dual"
    (_, k, placed), = on_box(complex, {"values": values}, 2, degree, side)
    shown = _at_polygons(complex.box, k, placed, seen)
    return (shown, None) if shown.ndim == 1 else (np.linalg.norm(shown, axis=1), shown)


def _at_polygons(box: Complex, k: int, values: Floats, seen: Integers) -> Floats:
    """Values of vertices, of polygons or, for the surface of a solid, of its cells."""
    if k == 0:
        lists = box.cells(2)
        sums = np.add.reduceat(at_vertices(box, values)[lists.corners], lists.offsets[:-1])
        return np.asarray((sums.T / np.diff(lists.offsets)).T[seen])
    return np.asarray(values[seen if k == 2 else abs(box.d(2)).tocsc()[:, seen].indices])


def to_meshio(complex: Complex, forms: Fields | None = None) -> Any:
    """A ``meshio.Mesh`` of the cells: lines, polygons grouped by number of corners, or tetrahedra.
    `forms` on vertices or n-cells, as for `view`, become its data. Raises InvalidInput for merged
    polyhedra.

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
    for name, k, placed in on_box(complex, by_name(forms), n):
        if k == 0:
            point_data[name] = at_vertices(box, placed)
        else:
            cell_data[name] = [placed[of_size] for of_size in numbers]
    return meshio.Mesh(points, blocks, point_data=point_data, cell_data=cell_data)


def _positive(points: Floats, corners: Integers) -> Integers:
    """Tetrahedra, reordered for positive determinants."""
    edges = points[corners[:, 1:]] - points[corners[:, :1]]
    turned = corners.copy()
    inverted = np.linalg.det(edges) < 0
    turned[inverted, 2:] = turned[inverted, :1:-1]
    return turned


def to_pyvista(complex: Complex, forms: Fields | None = None) -> Any:
    """A ``pyvista.PolyData`` of the visible 2-cells, with forms on vertices or on 2-cells, as for
    `view`."""
    import pyvista

    box = complex.box
    points, polygons, seen = _polygons(box)
    lists: CellList | Polygons = box.cells(2) if complex.dim == 3 else box.polygons()
    faces = [np.concatenate([[b - a], lists.corners[a:b]])
             for a, b in zip(lists.offsets[seen], lists.offsets[seen + 1])]
    result = pyvista.PolyData(np.pad(points, ((0, 0), (0, 3 - points.shape[1]))),
                              np.concatenate(faces))
    for name, k, placed in on_box(complex, by_name(forms), 2):
        if k == 0:
            result.point_data[name] = placed if len(placed) == len(points) else \
                at_vertices(box, placed)
        else:
            result.cell_data[name] = _at_polygons(box, k, placed, seen)
    return result
