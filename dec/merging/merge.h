// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/merging/degenerate_facets.h"
#include "dec/metric/geometry.h"

namespace polydec {

struct CosphericalMerging {
    Merging merging;
    DegenerateFacets degenerate;
    int rounds = 0;    ///< number of times a class of facets without a proper cell was split again
    Geometry geometry; ///< of the pieces: duals between circumcenters, one for all pieces of a
                       ///< cell; marks the flat pieces of cells with other pieces
};

/// Merges n-simplices across facets with degenerate duals; then, in descending degree, merges faces
/// wherever exactly two remain that lie straight across each other. No dual cell of the result is
/// degenerate. Facets on the boundary or with three or more cofaces never merge; vertices stay.
///
/// Near-cospherical is not transitive. So unions are made in ascending order of defect, equal
/// defects together or not at all, and rejected when the sum of defects exceeds 10 tolerances.
/// Every merged cell is checked to be a ball. The result does not depend on the order of the input.
///
/// Flat simplices have no meaningful circumcenter. In solids in space they become pieces of a
/// neighbor on whose sphere they lie (see absorb_flat); all others stay cells. In R^n every simplex
/// between two pieces of a cell is removed, and the pieces have one center.
///
/// `stays`: empty, or one mark per facet that must not merge whatever its dual.
/// Time O(incidences + f log f), f the number of degenerate facets. Throws InvalidInput for a
/// tolerance that is negative or not finite, and for a wrong number of marks.
CosphericalMerging merge_cospherical(const Geometry& geometry, const MergeOptions& options = {},
                                     const std::vector<bool>& stays = {});

/// Volumes of merged cells, with duals set to 0 (see HodgeStar::zeros) where a center lies beyond
/// the boundary but within the tolerance. Such centers, moved there by rounding or jitter, count as
/// lying on the boundary.
CellVolumes without_duals_beyond_the_boundary(const CellVolumes& volumes, const Merging& merging,
                                              const DegenerateFacets& degenerate);

} // namespace polydec
