// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page_faces.h"
#include "io/pages/page_fields.h"
#include "io/pictures/draw_solid.h"

#include <vector>

namespace polydec {

/// How a page opens, so that the place where its field is largest is seen.
struct Opening {
    SolidView view = {};
    /// A solid is cut across axis `side` % 3, seen from its positive end if `side` is below 3, else
    /// from its negative one. It keeps the cells whose center lies up to `percent` of the way from
    /// the center that is furthest from the eye to the nearest one. 100: no cut.
    int side = 0, percent = 100;

    /// For each cell, whether the cut keeps it.
    std::vector<bool> kept(const PageFaces& faces, const Points& points) const;
};

/// The first of four views around the axis that shows a place where the field is nearly as large as
/// anywhere. If none does, a solid is cut in half, or through such a place; solids with vectors
/// always are, in their middle part. Points have three coordinates.
Opening opening_of(const Page& page, const Points& points, const PageFaces& faces,
                   const ShownField& shown);

} // namespace polydec
