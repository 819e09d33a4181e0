// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <span>

namespace polydec {

/// A glued surface and the polygons that its triangles become without some of its edges.
struct MergedSurface {
    CellComplex merged;
    /// diamonds[k], k = 0..2, size of merged times size of triangles: the orientation 1 or -1 of
    /// each piece in its cell, 0 for removed edges. Cochain maps, as Merging::diamond.
    std::vector<IncidenceMatrix> diamonds;
};

/// Removes edges in the given order. An edge stays that would close a ring of triangles (it has one
/// cell on both sides already, or a single triangle) or lies on the boundary; so every polygon is a
/// disk. Cells are numbered in the order of their first pieces and oriented like them.
/// Near-linear time. Throws InvalidInput for an edge that there is not.
MergedSurface merge_triangles(const GluedSurface& surface, std::span<const Index> edges);

/// The surface as its incidence matrices, whose entries are sums of signs: 0 where a triangle lies
/// on both sides of an edge, or for loops, and 2 or -2 where it does so on a one-sided surface.
CellComplex cell_complex(const GluedSurface& surface);

/// The corners of a polygon, every vertex once, ascending; of an edge (k = 1) its ends. Throws
/// InvalidInput if there is no such cell.
std::vector<Index> vertices(const GluedSurface& surface, const MergedSurface& merging, int k,
                            Index cell);

} // namespace polydec
