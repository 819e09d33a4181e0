// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "complex/surfaces/glued_surface.h"

#include <vector>

namespace polydec {

/// The triangles of a glued surface as ordered pieces, with the same numbers and the same
/// orientations of triangles.
struct OrderedSurface {
    Pieces pieces;
    Vector directions; ///< per edge 1 or -1: whether it has the same direction in the surface
};

/// Orders the corners so that edges run from the lower vertex to the higher one, and loops so that
/// no triangle is a cycle. names[v] is the number of vertex v in messages.
OrderedSurface in_order(const GluedSurface& surface, std::vector<Index> names);

} // namespace polydec
