// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_structure.h"

#include <optional>

namespace polydec {

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
