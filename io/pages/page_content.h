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

/// The axis of a page that points up, 0 to 2: the one that its text names, else that of its mesh
/// file. Throws InvalidInput like upright_view.
int upward_axis(const Page& page);

/// Points or vectors with three coordinates; those that they lack are 0.
Points in_space(const Points& points);

/// What a page shows: the faces of its mesh or else of its grid, and all its fields; and how it
/// opens. Of four views around the axis it takes the one that shows most of its paths; without any,
/// the first that shows where the field is largest, or else nearly as large; from below if none
/// from above does. If none does at all, a solid is cut in half, or through such a place; solids
/// with vectors always are, in their middle part. Of the cuts that the eye sees, it is the one in
/// front or else one that opens clearly more.
struct PageContent {
    /// Throws InvalidInput like check_grid, page_faces and page_fields. The page must outlive this.
    explicit PageContent(const Page& page);
    PageContent(const PageContent&) = delete;
    PageContent& operator=(const PageContent&) = delete;

    const Page& page;
    const Points points; ///< three coordinates each
    PageFaces faces;
    std::vector<PageField> fields;
    ShownField shown;
    Opening opening;

    /// The faces that are seen as it opens.
    PageFaces visible() const { return faces.visible(opening.kept(faces, points)); }
};

} // namespace polydec
