# SPDX-License-Identifier: MIT
"""Drawings for lessons."""
from __future__ import annotations

import os
from typing import Sequence

from . import _core
from ._complex import CellsLike, as_complex


class Drawing:
    """An SVG drawing. A notebook displays a drawing that is the last value of a notebook cell.

    Attributes
    ----------
    svg : str
        The text of the .svg file.
    """

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the drawing as .svg, or as .png or .pdf by the program rsvg-convert or cairosvg.

        Raises
        ------
        InvalidInput
            For another extension.
        BackendUnavailable
            For .png and .pdf, if neither program is on PATH.
        IoError
            If the file cannot be written; ``path`` names it.
        """
        _core.write_drawing(os.fspath(path), self.svg)

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"Drawing({len(self.svg) / 1e3:.1f} kB; save it, or show it in a notebook)"


def draw(complex: CellsLike, *, duals: bool = False, dual_orientations: bool = False,
         both_duals: bool = False, cell: int | None = None, matrix: int | None = None,
         explode: float = 0.0, numbers: bool = False, orientations: bool = False,
         circumcircles: bool = False, title: str = "", width: float = 720.0,
         eye: Sequence[float] = (1.0, -2.0, 1.2)) -> Drawing:
    """A drawing of a small mesh that explains its cells, for lessons.

    Parameters
    ----------
    complex : Complex, or a mesh as `discretize` takes it
        Dimension 1 to 3, with at most 3 coordinates.
    duals : bool
        Draws dual edges, red where negative, between dots at cell centers.
    dual_orientations : bool
        Draws the dual with arrow heads that show the orientations of dual edges.
    both_duals : bool
        Draws the circumcentric and the barycentric dual side by side.
    cell : int, optional
        A vertex of the input; its dual cell is filled.
    matrix : int, optional
        Degree of cells; their boundary matrix stands beside the drawing.
    explode : float
        Moves the cells of a solid apart, by this multiple of their distance from its middle.
    numbers : bool
        Numbers vertices, edges and cells like the matrices; of solids the cells.
    orientations : bool
        Draws arrow heads on edges, and arrows around cells.
    circumcircles : bool
        Draws circumcircles of the cells.
    title : str
    width : float
        Of each drawing, in pixels.
    eye : sequence of float
        Direction to the eye, for surfaces in space and solids.

    Returns
    -------
    Drawing

    Raises
    ------
    InvalidInput
        For cells that cannot be drawn, for numbers too small to read, for a vertex that no cell
        uses, and for options that do not fit the dimension.

    Examples
    --------
    >>> import polydec
    >>> hexagons = polydec.discretize(polydec.meshes.hexagons(3))
    >>> drawing = polydec.draw(hexagons, duals=True, cell=7, numbers=True)
    >>> "dual cell of vertex 7" in drawing.svg
    True
    """
    return Drawing(_core.draw(as_complex(complex)._mesh, duals, dual_orientations, both_duals, cell,
                              matrix, explode, numbers, orientations, circumcircles, title, width,
                              [*map(float, eye)]))
