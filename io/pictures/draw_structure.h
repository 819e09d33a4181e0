// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "io/pictures/draw_solid.h"
#include "io/pictures/svg_drawing.h"

#include <optional>

namespace polydec {

/// Options of a drawing that explains the cells of a surface or of a chain of edges.
struct StructureOptions {
    bool duals = false; ///< dual edges, red where negative, between dots at cell centers
    bool dual_orientations = false; ///< arrow heads on dual edges, by dual_derivative
    bool centroids = false;         ///< the barycentric dual, between centroids, is drawn instead
    std::optional<Index> cell = {}; ///< a vertex of the input, whose dual cell is filled
    bool numbers = false;           ///< of vertices, edges and cells, as in matrices
    bool orientations = false;      ///< arrow heads on edges, and arrows around cells
    bool circumcircles = false;     ///< of the cells, with their centers
    bool words = true;              ///< a legend of the kinds of lines below the drawing
    SolidView view = {};            ///< view of a surface in space, title and width
};

/// An annotated drawing of a mesh: merged cells, edges removed by merging, and the selected
/// options, with a line of legend for each kind. No number overlaps another. For a surface in
/// space, nearer parts hide farther ones; a plane mesh is seen from above. O(p log p) for p cells,
/// quadratic in their number if they are numbered.
///
/// Throws InvalidInput for cells of dimension above 2, for flipped edges, for numbers too small to
/// read, naming a sufficient width, for a dual cell on the side turned away, and like
/// cells_of_vertices, dual_rings and draw_solid.
SvgDrawing draw_structure(const Discretization& mesh, const StructureOptions& options = {});

/// The boundary matrix of the k-cells, 1 <= k <= n <= 3, as a table: a row for each (k-1)-cell and
/// a column for each k-cell, with their numbers in the colors of draw_structure. Throws
/// InvalidInput for another k, and above 60 rows or columns.
SvgDrawing draw_boundary(const CellComplex& complex, int k);

/// Options of a drawing for a lesson.
struct LessonOptions {
    StructureOptions structure = {};
    bool both_duals = false;        ///< the barycentric dual in a second drawing
    std::optional<int> matrix = {}; ///< the boundary matrix of the cells of this degree
    /// How far the cells of a solid move from its middle, in parts of their distance from it.
    double explode = 0;
};

/// A drawing that explains a mesh of dimension 1 to 3, with others beside it: draw_structure, or
/// for solids draw_solid with the cells apart and their numbers where they are seen. Throws
/// InvalidInput like these, kept_cells and draw_boundary; for options of surfaces on a solid; and
/// unless 0 <= explode is finite, and 0 on other meshes.
SvgDrawing draw_lesson(const Discretization& mesh, const LessonOptions& options = {});

} // namespace polydec
