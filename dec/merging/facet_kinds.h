// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/merging/merge.h"

#include <optional>

namespace polydec {

/// Pairs of n-simplices that share a facet with no third one, by where their circumcenters lie as
/// seen from this facet. Source: Schier, section 4.2 and Fig. 2, for triangles; here in every
/// dimension.
struct FacetKinds {
    Index well_centered = 0; ///< each on its own side, or on the facet: the dual crosses the facet
    Index delaunay = 0;      ///< both on one side, in the right order: the dual is positive
    Index non_delaunay = 0;  ///< in the wrong order: the dual is negative
    Index cospherical = 0;   ///< in one place within the tolerance: concyclic triangles
};

/// Counts the pairs of each kind. Of the options the criterion and the tolerance matter (the
/// relative dual length where nothing is to be merged).
FacetKinds facet_kinds(const Geometry& geometry, const MergeOptions& options = {});

/// A tolerance by which many more pairs of cells would merge, as where coordinates are rounded to
/// few digits.
struct LooserTolerance {
    double tolerance = 0; ///< 10 or 100 times that of the options
    Index pairs = 0;      ///< cospherical by it, and not by theirs
};

/// Such a tolerance, if by one more than a tenth of the facets between two n-simplices were
/// degenerate besides. None for other criteria than the relative dual length.
std::optional<LooserTolerance> looser_tolerance(const Geometry& geometry,
                                                const MergeOptions& options);

/// What a merging has joined.
struct MergedPairs {
    Index facets = 0; ///< removed (n-1)-simplices, each between two n-simplices; a surface's edges
    Index simplices = 0; ///< n-simplices beside at least one of them: concyclic triangles
};

/// Counts the pairs that were merged, after all guards; compare FacetKinds::cospherical.
/// Source: Schier, Table 2, counts concyclic triangles in this way.
MergedPairs merged_pairs(const Merging& merging);

} // namespace polydec
