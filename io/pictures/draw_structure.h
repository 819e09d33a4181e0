// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_solid.h"

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

} // namespace polydec
