// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

namespace polydec {

/// An end of a half-edge.
enum class FanEnd { tail, head };

/// Visits the corners of the triangles around a vertex in order, from a boundary half-edge that
/// ends there to the next one. A corner is given by the half-edge that starts at it. Gluings may
/// reverse the orientation along the way.
template <class Visit>
void for_each_corner(const GluedSurface& surface, Index boundary_halfedge, FanEnd end,
                     Visit visit) {
    Index entered = boundary_halfedge;
    bool at_tail = end == FanEnd::tail;
    while (entered >= 0) {
        const Index corner = at_tail ? entered : GluedSurface::next(entered);
        visit(corner);
        const Index exit = at_tail ? GluedSurface::previous(entered) : GluedSurface::next(entered);
        const bool tail_of_exit = exit == corner;
        entered = surface.partner(exit);
        if (entered >= 0)
            at_tail = surface.sign(entered) == surface.sign(exit) ? tail_of_exit : !tail_of_exit;
    }
}

} // namespace polydec
