// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "complex/surfaces/glued_surface.h"

#include <vector>

namespace polydec {

/// The triangles of a glued surface as ordered pieces, which keep all numbers, and the orientations
/// of the triangles.
struct OrderedSurface {
    Pieces pieces;
    Vector directions; ///< 1 or -1 for each edge: whether it runs as it does in the surface
};

/// Edges are to run from the lower vertex to the higher one, loops such that no triangle is a
/// circle. names[v] is what vertex v is called.
OrderedSurface in_order(const GluedSurface& surface, std::vector<Index> names);

} // namespace polydec
