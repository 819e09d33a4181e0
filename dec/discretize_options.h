// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/degenerate_facets.h"
#include "dec/metric/centers.h"
#include "dec/stars/star_kind.h"

#include <optional>

namespace polydec {

/// Whether the edges of a surface are flipped before merging, so that no dual edge is negative. The
/// surface and its vertices do not change. Source: see intrinsic_delaunay.
enum class Delaunay {
    off,
    flips,           ///< flips interior edges; boundary edges keep negative duals
    flips_and_splits ///< also splits boundary edges, until every dual is positive
};

/// Whether simplices of different materials (tags of the mesh) may become pieces of one cell.
enum class Materials {
    join,      ///< cospherical simplices merge; a cell of several materials has tag 0
    keep_apart ///< facets between different tags stay, so that every cell has the tag of its
               ///< pieces, and so do facets that have a tag of their own
};

/// How discretize prepares a mesh: the criterion of merging, as in MergeOptions, and other choices.
struct DiscretizeOptions {
    MergeCriterion criterion = MergeOptions{}.criterion;
    double tolerance = MergeOptions{}.tolerance;
    Delaunay delaunay = Delaunay::off;
    Materials materials = Materials::join;
    /// With centers other than circumcenters, nothing is merged: no merging is needed.
    Centers centers = {};
    StarKind star = StarKind::automatic; ///< see choose_stars
    /// No edge longer than this, in the units of the input: simplices are bisected before anything
    /// else is done (see refined).
    std::optional<double> refine = {};

    operator MergeOptions() const { return {criterion, tolerance}; }
};

} // namespace polydec
