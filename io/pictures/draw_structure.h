// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_solid.h"

namespace polydec {

/// Options of a drawing that explains the cells of a surface, or of a plane mesh.
struct StructureOptions {
    bool duals = false;         ///< dual edges, red where negative, between dots at cell centers
    bool numbers = false;       ///< of vertices, edges and cells, as in matrices
    bool orientations = false;  ///< arrow heads on edges, and arrows around cells
    bool circumcircles = false; ///< of the cells, with their centers
    bool words = true;          ///< a legend of the kinds of lines below the drawing
    SolidView view = {};        ///< view of a surface in space, title and width
};

/// An annotated drawing of a mesh: merged cells, edges removed by merging, and the selected
/// options, with a line of legend for each kind. For a surface in space, nearer parts hide farther
/// ones; a plane mesh is seen from above. O(p log p) for p triangles.
///
/// Throws InvalidInput for cells that are not polygons, for flipped edges, for numbers too small to
/// read, naming a sufficient width, and like draw_solid.
SvgDrawing draw_structure(const Discretization& mesh, const StructureOptions& options = {});

} // namespace polydec
