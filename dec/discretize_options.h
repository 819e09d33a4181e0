// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/star_kind.h"
#include "dec/merging/merge.h"
#include "dec/metric/centers.h"

namespace polydec {

/// Whether the edges of a surface are flipped before it is merged, so that no dual edge is
/// negative. The surface and its vertices stay as they are. Source: see intrinsic_delaunay.
enum class Delaunay {
    off,
    flips,           ///< of interior edges; boundary edges keep negative duals
    flips_and_splits ///< boundary edges are divided too, until every dual is positive
};

/// Whether simplices of different materials, as the tags of a mesh tell them, may become pieces of
/// one cell.
enum class Materials {
    join,      ///< what is cospherical merges; a cell of several materials has the tag 0
    keep_apart ///< facets between different tags stay, so that every cell has the tag of its
               ///< pieces, and so do facets that have a tag of their own
};

/// How a mesh is made ready for calculus: what is merged, as MergeOptions, and what else is done.
struct DiscretizeOptions {
    MergeCriterion criterion = MergeOptions{}.criterion;
    double tolerance = MergeOptions{}.tolerance;
    Delaunay delaunay = Delaunay::off;
    Materials materials = Materials::join;
    /// Other centers than circumcenters need no merging: nothing is merged then.
    Centers centers = {};
    StarKind star = StarKind::automatic; ///< see choose_stars

    operator MergeOptions() const { return {criterion, tolerance}; }
};

} // namespace polydec
