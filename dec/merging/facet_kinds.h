// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/merging/merge.h"

#include <optional>

namespace polydec {

/// Numbers of pairs of n-simplices that share a facet with no third simplex, by the positions of
/// their circumcenters relative to the facet. Source: Schier, section 4.2 and Fig. 2, for
/// triangles; extended to every dimension.
struct FacetKinds {
    Index well_centered = 0; ///< each center on its own side, or on the facet: the dual crosses it
    Index delaunay = 0;      ///< both centers on one side, in the right order: the dual is positive
    Index non_delaunay = 0;  ///< in the wrong order: the dual is negative
    Index cospherical = 0;   ///< centers coincide within the tolerance: concyclic triangles
};

/// Counts the pairs of each kind. Uses the criterion and the tolerance of the options (the relative
/// dual length if the criterion is none).
FacetKinds facet_kinds(const Geometry& geometry, const MergeOptions& options = {});

/// A tolerance at which many more pairs of cells would merge, e.g. because coordinates are rounded
/// to few digits.
struct LooserTolerance {
    double tolerance = 0; ///< 10 or 100 times the tolerance of the options
    Index pairs = 0;      ///< cospherical at this tolerance but not at the options' one
};

/// Such a tolerance, if at it more than a tenth of the facets between two n-simplices would become
/// degenerate in addition. Empty for criteria other than the relative dual length.
std::optional<LooserTolerance> looser_tolerance(const Geometry& geometry,
                                                const MergeOptions& options);

/// Pairs that a merging has joined.
struct MergedPairs {
    Index facets = 0; ///< removed (n-1)-simplices, each between two n-simplices; edges of a surface
    Index simplices = 0; ///< n-simplices beside at least one of these: concyclic triangles
};

/// Counts the merged pairs, after all guards; compare FacetKinds::cospherical.
/// Source: Schier, Table 2, counts concyclic triangles in this way.
MergedPairs merged_pairs(const Merging& merging);

} // namespace polydec
