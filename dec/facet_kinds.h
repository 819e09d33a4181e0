// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merge.h"

namespace polydec {

/// Pairs of n-simplices that share a facet with no third one, by kind. Source: Schier, section 4
/// and Fig. 2, for triangles; here in every dimension.
struct FacetKinds {
    Index well_centered = 0; ///< both contain their circumcenters inside, and the dual is positive
    Index delaunay = 0;      ///< the dual is positive, but a circumcenter lies outside
    Index non_delaunay = 0;  ///< the dual is negative
    Index cospherical = 0;   ///< the dual has no extent within the tolerance: concyclic triangles
};

/// Counts the pairs of each kind. volumes are those of `complex`; of the options the criterion and
/// the tolerance matter (the relative dual length where nothing is to be merged).
FacetKinds facet_kinds(const SimplicialComplex& complex, const Points& points,
                       const CellVolumes& volumes, const MergeOptions& options = {});

} // namespace polydec
