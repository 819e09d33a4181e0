# SPDX-License-Identifier: MIT
"""Discretized meshes."""
from __future__ import annotations

import json
import warnings
from typing import Any, Callable, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats, matrix_parts
from ._cell_data import CellNumbers, cell_data
from ._cells import Cells
from ._cochain import Cochain
from ._errors import InvalidInput, PolydecWarning, told, warn
from ._given import MeshLike, as_mesh
from ._merging import Merging
from ._mesh import LengthMesh, Mesh
from ._periodic import PeriodicMesh
from ._vertices import points_of

Progress = Callable[[str], object]
#: Cells, or a mesh to make them from.
CellsLike = Union[Cells, MeshLike]


class CellList(NamedTuple):
    """The cells of one degree: cell i has ``corners[offsets[i]:offsets[i + 1]]``."""

    offsets: Integers
    corners: Integers

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def cell(self, i: int) -> Integers:
        """The corners of cell i."""
        return self.corners[self.offsets[i]:self.offsets[i + 1]]


class Polygons(NamedTuple):
    """Polygons: ``corners[offsets[i]:offsets[i + 1]]`` are rows of `points` around polygon i."""

    points: Floats
    offsets: Integers
    corners: Integers


class Complex(Cells):
    """A mesh discretized by `discretize`: its cells, merged where they are cospherical.

    All members of `Cells` refer to the merged cells. Values of primal 0-forms are at `points`,
    those of dual 0-forms at `dual_sites()`.

    Attributes
    ----------
    points : numpy.ndarray, shape (vertices, N)
        All input vertices; no columns if only edge lengths are known. For a mesh made by `periodic`
        or `glue`, the first position of each vertex in the box.
    vertices : numpy.ndarray of int, shape (size(0),)
        The input vertices that cells use: the 0-cells, in the order of matrices and cochains.
    input : Cells
        The input simplices, not merged.
    merging : Merging
        The simplices in each cell, and the maps between both.
    """

    def __init__(self, mesh: _core.Discretization, given: Mesh | LengthMesh | None,
                 options: dict[str, Any]) -> None:
        super().__init__(mesh)
        self._mesh = mesh
        self._given = given
        self._options = options

    @property
    def points(self) -> Floats:
        return points_of(self._mesh)

    @property
    def vertices(self) -> Integers:
        return self._mesh.vertices

    @property
    def box(self) -> Complex:
        """The box of a mesh made by `periodic` or `glue`, with cells cut along the seams, for
        pictures. For any other mesh, the mesh itself."""
        return Complex(self._mesh.placed(), None, self._options) if self._mesh.is_glued else self

    def _on_box(self, k: int, values: Floats) -> Floats:
        """A number or row per k-cell of `box`; nan inside larger cells that a seam cuts."""
        if not self._mesh.is_glued:
            return values
        numbers = self._mesh.cells_of_places(k)
        placed = values[numbers]
        placed[numbers < 0] = np.nan
        return placed

    @property
    def input(self) -> Cells:
        return Cells(self._mesh.input_cells)

    @property
    def pieces(self) -> Cells:
        """The simplices before merging: the input, or the triangles after flips."""
        return Cells(self._mesh.pieces_cells)

    @property
    def merging(self) -> Merging:
        return Merging(self, self._mesh)

    @property
    def options(self) -> dict[str, Any]:
        """The options that were given to `discretize`."""
        return dict(self._options)

    @property
    def warnings(self) -> list[str]:
        """Defects of the input, and how they were handled."""
        return [told(text) for text in self._mesh.warnings]

    @property
    def tags(self) -> Integers:
        """The tag of each n-cell, 0 where the tags of its simplices differ; or empty."""
        return self._mesh.tags

    @property
    def facet_tags(self) -> Integers:
        """The tag of each (n-1)-cell; or empty."""
        return self._mesh.facet_tags

    def facets_in(self, *groups: str | int) -> npt.NDArray[np.bool_]:
        """Marks the (n-1)-cells in these groups of the file, given by names or tags; for example
        ``essential=plate.facets_in("wall", "lid")``.

        Raises
        ------
        InvalidInput
            For an unknown group; the text lists the groups of the file.
        """
        return np.array(self._mesh.facets_in([str(group) for group in groups]), dtype=bool)

    @property
    def unit(self) -> float:
        """Unit of length of the computations, mostly 1. All results are in units of the input."""
        return self._mesh.unit

    @property
    def star_kind(self) -> str:
        """Kind of the stars: "circumcentric", "galerkin", "hybrid", "barycentric" or "own".

        Where "automatic" took Galerkin's, the star of functions is a diagonal between centroids."""
        return self._mesh.star_kind

    def boundary_vertices(self) -> Integers:
        """The vertices on the boundary, ascending. Raises InvalidInput if there is no boundary."""
        return self.vertices[self._mesh.boundary_vertices()]

    def vertices_in(self, *groups: str | int) -> Integers:
        """The vertices of n-cells, or else of facets, in these groups of the file, ascending.

        Groups are given by names or tags. Raises InvalidInput for an unknown group.
        """
        return self.vertices[self._mesh.vertices_on([str(group) for group in groups])]

    def report(self) -> dict[str, Any]:
        """Properties of the mesh, and the operators that exist on it: the output of
        ``polydec info --json`` with the same stars.

        >>> import polydec
        >>> report = polydec.discretize(polydec.meshes.torus(8, 6)).report()
        >>> report["betti"]["merged"], report["orientable"], report["cells"]["merged"]
        ([1, 2, 1], True, [48, 96, 48])
        """
        result: dict[str, Any] = json.loads(self._mesh.report())
        for key in ("advice", "warnings"):
            result[key] = [told(text) for text in result[key]]
        return result

    # ---- places

    def centers(self, k: int) -> Floats:
        """Circumcenters of the k-cells, one row each."""
        return self._mesh.centers(k)

    def centroids(self, k: int) -> Floats:
        """Centroids of the k-cells, one row each: the positions of vector fields from forms."""
        return self._mesh.centroids(k)

    def dual_sites(self) -> Floats:
        """Positions of values of dual 0-forms: centers or centroids of n-cells, by the stars."""
        return self._mesh.dual_sites()

    def facet_sites(self) -> Floats:
        """Positions of boundary values and boundary fluxes: a point on each (n-1)-cell."""
        return self._mesh.facet_sites()

    def cells(self, k: int) -> CellList:
        """The vertices of the k-cells: in cyclic order for k = 2, else ascending.

        >>> import polydec
        >>> square = polydec.discretize(polydec.meshes.grid(1, 1)).cells(2)
        >>> len(square), square.cell(0)
        (1, array([1, 0, 2, 3], dtype=int32))
        """
        begins, corners = self._mesh.cells(k)
        return CellList(begins, self.vertices[corners])

    def polygons(self) -> Polygons:
        """The 2-cells of a surface in space; after flips, cut along the edges of the input."""
        return Polygons(*self._mesh.polygons())

    # ---- stars

    def with_star(self, k: int, star: Any) -> Complex:
        """A copy with a symmetric positive definite sparse matrix as the star of k-forms."""
        parts = matrix_parts(star, f"the star of degree {k}")
        return Complex(self._mesh.with_star(k, parts), None, self._options)

    def with_stars(self, kind: str) -> Complex:
        """A copy with stars of another kind, as in the option ``star`` of `discretize`, without
        materials and stars of your own."""
        return Complex(self._mesh.with_stars(kind), self._given, {**self._options, "star": kind})

    def with_material(self, k: int, weights: CellNumbers) -> Complex:
        """A copy with the star of k-forms weighted by positive numbers on cells. A diagonal star
        becomes a weighted sum of signed shares; other stars become Galerkin's. The weights replace
        former ones of this degree, and other degrees keep theirs; a star of your own is refused.
        Integrals of fields, flats, products and proxy vectors do not depend on the weights; where
        Galerkin's star takes the place of another, dual ones change. Weights: one number, one per
        input cell in input order (simplices, or polygons and solids before splitting), a
        dual 0-form, or a function of the centroids of the n-cells.
        For Maxwell's primal 1-form E: permittivity in degree 1, 1 / permeability in degree 2.

        >>> import numpy as np, polydec
        >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
        >>> heavy = square.with_material(0, np.full(32, 3.0)) # of 32 triangles
        >>> np.allclose(heavy.star(0), 3 * square.star(0))
        True
        """
        data = cell_data(self, weights, "weights")
        return Complex(self._mesh.with_material(k, data), None, self._options)

    def with_conductivity(self, kappa: CellNumbers, side: str = "primal") -> Complex:
        """A copy whose Delta on functions is ``-div kappa grad``; see `with_material`."""
        data = cell_data(self, kappa, "conductivities")
        return Complex(self._mesh.with_conductivity(side, data), None, self._options)

    def with_electric_material(self, permittivity: CellNumbers | None,
                               permeability: CellNumbers | None = None, *,
                               degree: int = 1, side: str = "primal") -> Complex:
        """A copy on which forms of this degree and side are electric fields E, with energies
        ``permittivity |E|^2`` and ``|B|^2 / permeability``; see `with_material`. None leaves a star
        as it is. Raises InvalidInput, naming the cell, unless both are positive.

        >>> import numpy as np, polydec
        >>> box = polydec.discretize(polydec.meshes.kuhn([2, 2, 2]))
        >>> glass = box.with_electric_material(lambda x: np.where(x[:, 2] > 0.5, 4.0, 1.0))
        """
        data = [cell_data(self, permittivity, "permittivity"),
                cell_data(self, permeability, "permeability")]
        return Complex(self._mesh.with_electric_material(side, degree, *data), None, self._options)

    def cell_means(self, k: int, weights: CellNumbers) -> Floats:
        """Means of cell data around each k-cell, for example losses for `Waves`. Takes numbers as
        `with_material` does, but >= 0."""
        return self._mesh.cell_means(k, cell_data(self, weights, "weights"))

    def material_star(self, k: int, weights: CellNumbers) -> Any:
        """Galerkin star of k-forms, weighted cell by cell; see `with_material`."""
        return self._mesh.material_star(k, cell_data(self, weights, "weights"))

    def conductivity_star(self, tensors: npt.ArrayLike) -> Any:
        """Galerkin star of (n-1)-forms for symmetric n x n conductivities, one per input cell."""
        return self._mesh.tensor_star(floats(tensors, "tensors", 3))

    # ---- forms

    def cochain(self, values: npt.ArrayLike, degree: int, side: str = "primal") -> Cochain:
        """A discrete form on these cells."""
        return Cochain(values, degree, side, self)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._given is None:
            raise InvalidInput("a complex made by box, with_star or with a material cannot be "
                               "pickled: pickle the one that it was made of, and make it again")
        return _made_again, (self._given, self._options)


def _made_again(given: Mesh | LengthMesh, options: dict[str, Any]) -> Complex:
    return discretize(given, **options)


def discretize(mesh: MeshLike, *, tolerance: float = 1e-4,
               angle_tolerance: float | None = None, merge: bool = True, delaunay: str | None = None,
               materials: str = "join", star: str = "automatic", centers: str = "circumcenters",
               refine: float | None = None, progress: Progress | None = None) -> Complex:
    """Discretizes a mesh: builds the complex, merges cospherical simplices, computes stars.

    Parameters
    ----------
    mesh : Mesh, LengthMesh, PeriodicMesh, path, pair of array_like, or meshio.Mesh
        Anything `as_mesh` takes, such as ``"bunny.off"`` or ``(points, triangles)``.
    tolerance : float
        Merges across facets with a relative dual length up to this.
    angle_tolerance : float, optional
        Instead, merges where the angles opposite a facet sum to pi within this many radians.
    merge : bool
        False keeps all simplices.
    delaunay : {None, "flips", "flips_and_splits"}
        Flips edges of the surface, and splits boundary edges, until no dual is negative.
    materials : {"join", "keep_apart"}
        Whether simplices of different tags may become one cell.
    star : {"automatic", "circumcentric", "galerkin", "hybrid", "barycentric"}
        Kind of the Hodge stars. "automatic" takes circumcentric stars if they are positive, as on
        Delaunay meshes without right or obtuse angles opposite the boundary, and another positive
        kind otherwise; see `star_kind`.
    centers : {"circumcenters", "centroids"}
        Centers that duals connect; with centroids nothing is merged, and stars are barycentric:
        in degrees 1 .. n-1 errors need not shrink.
    refine : float, optional
        First bisects simplices until no edge is longer. Parts keep tags and values.
    progress : callable, optional
        Called with the name (str) of each stage as it begins. An exception stops the work.

    Returns
    -------
    Complex

    Raises
    ------
    InvalidInput
        For unusable input; ``cells`` and ``vertices`` say where.

    Examples
    --------
    >>> import polydec
    >>> cube = polydec.discretize(polydec.meshes.kuhn([2, 2, 2]))
    >>> cube.shape        # 8 cubes, not 48 tetrahedra
    (27, 54, 36, 8)
    """
    options = dict(tolerance=tolerance, angle_tolerance=angle_tolerance, merge=merge,
                   delaunay=delaunay, materials=materials, star=star, centers=centers, refine=refine)
    criterion = "none" if not merge else "dual_length" if angle_tolerance is None else "angle"
    given = as_mesh(mesh)
    core = given._glued if isinstance(given, PeriodicMesh) else given._mesh
    made = _core.discretize(core, criterion, tolerance if angle_tolerance is None else angle_tolerance,
                            delaunay or "off", materials, star, centers, refine, progress)
    warn(made.warnings)
    return Complex(made, given, options)


def _without_options(mesh: MeshLike, in_units: bool, star: str = "automatic") -> Complex:
    """Discretizes a mesh with default options. Ignores the warning about its unit of length if
    results are in the units of the input."""
    if not in_units:
        return discretize(mesh, star=star)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "the lengths of the mesh are far from 1", PolydecWarning)
        return discretize(mesh, star=star)


def as_cells(given: CellsLike, in_units: bool = False) -> Cells:
    """Returns cells unchanged, and discretizes a mesh with default options."""
    return given if isinstance(given, Cells) else _without_options(given, in_units)


def as_complex(given: CellsLike, in_units: bool = False, star: str = "automatic") -> Complex:
    """As `as_cells`, for functions that need positions of cells. A mesh gets these stars."""
    if isinstance(given, Cells) and not isinstance(given, Complex):
        raise InvalidInput(f"only {given!r} is given: expected the Complex that discretize returns "
                           "for a mesh, since positions of cells are needed")
    return given if isinstance(given, Complex) else _without_options(given, in_units, star)
