# SPDX-License-Identifier: MIT
"""A mesh made ready for calculus."""
from __future__ import annotations

import json
import warnings
from typing import Any, Callable, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Integers, floats, matrix_parts
from ._cell_data import CellNumbers, cell_data
from ._cells import Cells, Form, as_form
from ._cochain import Cochain
from ._errors import InvalidInput, PolydecWarning, told, warn
from ._given import MeshLike, as_mesh
from ._lists import CellList, Polygons
from ._mesh import LengthMesh, Mesh
from ._periodic import PeriodicMesh
from ._vertices import points_of

Progress = Callable[[str], object]
#: Cells, or a mesh that they are made of.
CellsLike = Union[Cells, MeshLike]


class Complex(Cells):
    """A mesh made ready for calculus by `discretize`: its cells, merged where they are cospherical.

    All that is said of `Cells` is said of the merged cells. Places of values are `points` for
    primal 0-forms and `centers` for others.

    Attributes
    ----------
    points : numpy.ndarray, shape (vertices, N)
        Of all vertices that were given; without columns if only lengths are known. Of a mesh that
        `periodic` or `glue` made, their first places in its box.
    vertices : numpy.ndarray of int, shape (size(0),)
        Which of them are 0-cells, as matrices and cochains have them: those that cells use.
    input : Cells
        The simplices that were given, by themselves.
    merging : Merging
        What the cells are made of.
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
        """Of a mesh that `periodic` or `glue` made the box, with cells cut along the seams, as
        pictures show it; of any other the mesh itself."""
        return Complex(self._mesh.placed(), None, self._options) if self._mesh.is_glued else self

    def _on_box(self, k: int, values: Floats) -> Floats:
        """A number for each k-cell of `box`; nan inside of larger cells that a seam has cut."""
        if not self._mesh.is_glued:
            return values
        numbers = self._mesh.cells_of_places(k)
        return np.where(numbers < 0, np.nan, values[numbers])

    @property
    def input(self) -> Cells:
        return Cells(self._mesh.input_cells)

    @property
    def pieces(self) -> Cells:
        """What was merged: the simplices that were given, or the triangles after flips."""
        return Cells(self._mesh.pieces_cells)

    @property
    def merging(self) -> Merging:
        return Merging(self)

    @property
    def options(self) -> dict[str, Any]:
        """Those of `discretize` that it was made with."""
        return dict(self._options)

    @property
    def warnings(self) -> list[str]:
        """What was untidy in the input, and what was done about it."""
        return [told(text) for text in self._mesh.warnings]

    @property
    def tags(self) -> Integers:
        """Of each n-cell the tag of its simplices, 0 where they have different ones; or empty."""
        return self._mesh.tags

    @property
    def facet_tags(self) -> Integers:
        """Of each (n-1)-cell the tag of its facets; or empty."""
        return self._mesh.facet_tags

    def facets_in(self, *groups: str | int) -> npt.NDArray[np.bool_]:
        """Of each (n-1)-cell whether it is in one of these groups of the file, which are given by
        their names or tags; say ``essential=plate.facets_in("wall", "lid")``.

        Raises
        ------
        InvalidInput
            For a group that there is not, with the names of those there are.
        """
        return np.array(self._mesh.facets_in([str(group) for group in groups]), dtype=bool)

    @property
    def unit(self) -> float:
        """The length, in those of the input, that points and volumes are measured in: mostly 1."""
        return self._mesh.unit

    @property
    def star_kind(self) -> str:
        """Which stars it has: "circumcentric", "galerkin", "hybrid", "barycentric" or "own"."""
        return self._mesh.star_kind

    def boundary_vertices(self) -> Integers:
        """The vertices on the boundary, ascending. Raises InvalidInput if there is none."""
        return self.vertices[self._mesh.boundary_vertices()]

    def vertices_in(self, *groups: str | int) -> Integers:
        """The vertices of n-cells, or else of facets, in these groups of the file, ascending.

        Groups are given by names or tags. Raises InvalidInput for one that there is not.
        """
        return self.vertices[self._mesh.vertices_on([str(group) for group in groups])]

    def report(self) -> dict[str, Any]:
        """What the mesh is, and what can be done on it: what ``polydec info --json`` says
        with the same stars.

        >>> import polydec
        >>> report = polydec.discretize(polydec.meshes.torus(8, 6)).report()
        >>> report["betti"]["merged"], report["orientable"], report["cells"]["merged"]
        ([1, 2, 1], True, [48, 96, 48])
        """
        result: dict[str, Any] = json.loads(self._mesh.report())
        result["advice"] = [told(text) for text in result["advice"]]
        return result

    # ---- places

    def centers(self, k: int) -> Floats:
        """Circumcenters of the k-cells, a row each."""
        return self._mesh.centers(k)

    def centroids(self, k: int) -> Floats:
        """Centroids of the k-cells, where vector fields made of forms belong, a row each."""
        return self._mesh.centroids(k)

    def dual_sites(self) -> Floats:
        """Where values of dual 0-forms are: centers of the n-cells, or centroids by the stars."""
        return self._mesh.dual_sites()

    def facet_sites(self) -> Floats:
        """Where values on the boundary and through it are: places on the (n-1)-cells."""
        return self._mesh.facet_sites()

    def cells(self, k: int) -> CellList:
        """The vertices of the k-cells: around them for k = 2, else ascending.

        >>> import polydec
        >>> square = polydec.discretize(polydec.meshes.grid(1, 1)).cells(2)
        >>> len(square), square.cell(0)
        (1, array([1, 0, 2, 3], dtype=int32))
        """
        begins, corners = self._mesh.cells(k)
        return CellList(begins, self.vertices[corners])

    def polygons(self) -> Polygons:
        """The 2-cells of a surface as they lie in space, after flips cut along the input's edges."""
        return Polygons(*self._mesh.polygons())

    # ---- stars

    def with_star(self, k: int, star: Any) -> Complex:
        """The same with a symmetric positive definite sparse matrix as the star of k-forms."""
        parts = matrix_parts(star, f"the star of degree {k}")
        return Complex(self._mesh.with_star(k, parts), None, self._options)

    def with_stars(self, kind: str) -> Complex:
        """The same with stars of another kind, as the option ``star`` of `discretize`."""
        return Complex(self._mesh.with_stars(kind), self._given, {**self._options, "star": kind})

    def with_material(self, k: int, weights: CellNumbers) -> Complex:
        """The same with the star of k-forms weighted by positive numbers of cells: signed shares of
        a diagonal, else Galerkin's of the material. Numbers are one for all, one for each cell of
        the input in its order (simplices, or polygons and solids that were split), a dual 0-form,
        or a function of the centroids of the n-cells.

        For Maxwell's primal 1-forms E weight degree 1 by permittivity, degree 2 by 1 / permeability.

        >>> import numpy as np, polydec
        >>> square = polydec.discretize(polydec.meshes.grid(4, 4))
        >>> heavy = square.with_material(0, np.full(32, 3.0)) # of 32 triangles
        >>> np.allclose(heavy.star(0), 3 * square.star(0))
        True
        """
        data = cell_data(self, weights, "weights")
        return Complex(self._mesh.with_material(k, data), None, self._options)

    def with_conductivity(self, kappa: CellNumbers, side: str = "primal") -> Complex:
        """The same with stars that make Delta of functions ``-div kappa grad`` (see `with_material`)."""
        data = cell_data(self, kappa, "conductivities")
        return Complex(self._mesh.with_conductivity(side, data), None, self._options)

    def cell_means(self, k: int, weights: CellNumbers) -> Floats:
        """The mean around each k-cell of numbers of cells, as `with_material` takes them but at
        least 0, such as the losses that `Waves` take."""
        return self._mesh.cell_means(k, cell_data(self, weights, "weights"))

    def material_star(self, k: int, weights: CellNumbers) -> Any:
        """Galerkin's star of k-forms, each n-cell's part times its weight (see `with_material`)."""
        return self._mesh.material_star(k, cell_data(self, weights, "weights"))

    def conductivity_star(self, tensors: npt.ArrayLike) -> Any:
        """Galerkin's star of (n-1)-forms by symmetric n x n conductivities of the input's cells."""
        return self._mesh.tensor_star(floats(tensors, "tensors", 3))

    # ---- forms

    def cochain(self, values: npt.ArrayLike, degree: int, side: str = "primal") -> Cochain:
        """A form on these cells."""
        return Cochain(values, degree, side, self)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._given is None:
            raise InvalidInput("a complex with stars of its own cannot be pickled: pickle what it "
                               "was made of, and take with_star again")
        return _made_again, (self._given, self._options)


def _made_again(given: Mesh | LengthMesh, options: dict[str, Any]) -> Complex:
    return discretize(given, **options)


class Merging:
    """What the cells of a `Complex` are made of, and the maps between these and the simplices.

    Forms on simplices are those on ``complex.input``; `lift` and `diamond` are of the pieces, which
    are the same unless edges were flipped.
    """

    def __init__(self, complex: Complex) -> None:
        self._complex = complex
        self._mesh = complex._mesh

    @property
    def is_identity(self) -> bool:
        """Whether nothing was merged."""
        return self._mesh.is_identity

    def diamond(self, k: int) -> Any:
        """The orientation, 1 or -1, of each k-piece in its cell: a view, of type int8.

        Primal k-forms on pieces are mapped to cells by it, and the map commutes with d.
        """
        return self._mesh.diamond(k)

    def carriers(self, k: int) -> tuple[Integers, Integers]:
        """Of each k-piece the cell in whose interior it lies: dimensions and numbers."""
        return self._mesh.carriers(k)

    def lift(self, k: int) -> Any:
        """Primal k-forms on cells as forms on pieces: ``diamond(k) @ lift(k)`` is the identity, and
        it commutes with d."""
        return self._mesh.lift(k)

    def to_merged(self, form: Form, degree: int | None = None, side: str = "primal") -> Cochain:
        """The form on merged cells of a form on the input's simplices: sums, or means of duals."""
        return self._form(_core.transfer(self._mesh, "to_merged", *as_form(self._complex, form, degree, side)),
                          self._complex)

    def to_input(self, form: Form, degree: int | None = None, side: str = "primal") -> Cochain:
        """The form on the input's simplices of a form on merged cells: shares by volume, or copies.

        Before derivatives take `lifted`.
        """
        return self._form(_core.transfer(self._mesh, "to_input", *as_form(self._complex, form, degree, side)),
                          self._complex.input)

    def lifted(self, form: Form, degree: int | None = None) -> Cochain:
        """The primal form on the input's simplices that has the same d there as on the cells."""
        return self._form(_core.transfer(self._mesh, "lifted", *as_form(self._complex, form, degree)),
                          self._complex.input)

    def consistency(self, form: Form, degree: int | None = None,
                    side: str = "dual") -> dict[str, Any]:
        """How far a dual form on the simplices is from being one on merged cells.

        A dict of ``worst``, the largest deviation, and ``cell``, ``found``, ``expected`` and
        ``description`` of where it is.
        """
        return _core.consistency(self._mesh, *as_form(self._complex, form, degree, side))

    @staticmethod
    def _form(parts: tuple[str, int, Floats], cells: Cells) -> Cochain:
        side, degree, values = parts
        return Cochain(values, degree, side, cells)


def discretize(mesh: MeshLike, *, tolerance: float = 1e-4,
               angle_tolerance: float | None = None, merge: bool = True,
               delaunay: str | None = None, materials: str = "join", star: str = "automatic",
               centers: str = "circumcenters", progress: Progress | None = None) -> Complex:
    """Makes a mesh ready for calculus: complex, merging of cospherical simplices, volumes, stars.

    Parameters
    ----------
    mesh : Mesh, LengthMesh, PeriodicMesh, path, pair of array_like, or meshio.Mesh
        As `as_mesh` takes it: ``"bunny.off"`` and ``(points, triangles)`` will do.
    tolerance : float
        Facets with a relative dual length up to this are merged across.
    angle_tolerance : float, optional
        Merge instead where the angles opposite to a facet add up to pi within so many radians.
    merge : bool
        False: nothing is merged.
    delaunay : {None, "flips", "flips_and_splits"}
        Whether edges of a surface are flipped before, and boundary edges split, until no dual is
        negative. The surface stays as it is.
    materials : {"join", "keep_apart"}
        Whether simplices of different tags may become one cell.
    star : {"automatic", "circumcentric", "galerkin", "hybrid", "barycentric"}
        The kind of the Hodge stars. "automatic" is circumcentric wherever that is positive, so on
        every mesh that is Delaunay after merging, and else positive all the same (see `star_kind`).
    centers : {"circumcenters", "centroids"}
        Between which centers duals are; with centroids nothing is merged.
    progress : callable, optional
        Told the name of each stage, a str, as it begins. What it raises ends the work.

    Returns
    -------
    Complex

    Raises
    ------
    InvalidInput
        For what cannot be used; ``cells`` and ``vertices`` say where.

    Examples
    --------
    >>> import polydec
    >>> cube = polydec.discretize(polydec.meshes.kuhn([2, 2, 2]))
    >>> cube.shape        # 8 cubes, not 48 tetrahedra
    (27, 54, 36, 8)
    """
    options = {"tolerance": tolerance, "angle_tolerance": angle_tolerance, "merge": merge,
               "delaunay": delaunay, "materials": materials, "star": star, "centers": centers}
    criterion = "none" if not merge else "dual_length" if angle_tolerance is None else "angle"
    given = as_mesh(mesh)
    core = given._glued if isinstance(given, PeriodicMesh) else given._mesh
    made = _core.discretize(core, criterion,
                            tolerance if angle_tolerance is None else angle_tolerance,
                            delaunay or "off", materials, star, centers, progress)
    warn(made.warnings)
    return Complex(made, given, options)


def _without_options(mesh: MeshLike, in_units: bool, star: str = "automatic") -> Complex:
    """A mesh as `discretize` makes it ready; where answers are in the units of the input, whichever
    it is measured in, nothing is to be said of these."""
    if not in_units:
        return discretize(mesh, star=star)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "the lengths of the mesh are far from 1", PolydecWarning)
        return discretize(mesh, star=star)


def mesh_of(complex: Complex) -> _core.Discretization:
    """What is behind a complex on which values are given; nothing else will do."""
    if not isinstance(complex, Complex):
        raise InvalidInput(f"something of the type {type(complex).__name__} is given: expected the "
                           "Complex that discretize makes of a mesh, since forms are on its cells")
    return complex._mesh


def as_cells(given: CellsLike, in_units: bool = False) -> Cells:
    """Cells as they are, and a mesh discretized without options."""
    return given if isinstance(given, Cells) else _without_options(given, in_units)


def as_complex(given: CellsLike, in_units: bool = False, star: str = "automatic") -> Complex:
    """Likewise, for what needs the places of cells; a mesh gets these stars."""
    if isinstance(given, Cells) and not isinstance(given, Complex):
        raise InvalidInput(f"{given!r} alone are given: expected the Complex that discretize makes "
                           "of a mesh, since places of cells are needed")
    return given if isinstance(given, Complex) else _without_options(given, in_units, star)
