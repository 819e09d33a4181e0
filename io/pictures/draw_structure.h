// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_solid.h"

namespace polydec {

/// What a drawing for lessons shows of the cells of a surface, or of a mesh in the plane.
struct StructureOptions {
    bool duals = false;        ///< dual edges, red where negative, between dots at centers of cells
    bool numbers = false;      ///< of vertices, edges and cells, as matrices count them
    bool orientations = false; ///< heads on edges, and arrows around cells
    bool circumcircles = false; ///< of the cells, with their centers
    bool words = true;          ///< below the drawing what each kind of line is
    SolidView view = {};        ///< from where a surface in space is seen, title and width
};

/// The structure of a mesh as a drawing that explains itself: merged cells, edges that were merged
/// away, and what else is asked for, with a line of words for each kind. Of a surface in space what
/// is nearer hides what is farther; a mesh in the plane is seen from above. O(p log p) for p
/// triangles.
///
/// Throws InvalidInput for cells that are no polygons, for edges that were flipped, for numbers
/// that would be too small to be read, naming the width at which they are not, and like draw_solid.
SvgDrawing draw_structure(const Discretization& mesh, const StructureOptions& options = {});

} // namespace polydec
