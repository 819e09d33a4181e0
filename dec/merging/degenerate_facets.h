// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <vector>

namespace polydec {

/// Criterion by which a facet between two n-simplices counts as degenerate.
enum class MergeCriterion {
    dual_length, ///< relative dual length |V(f)| / l(f), l twice the circumradius of the facet
    angle,       ///< Schier's test: the angles opposite to the facet add up to pi (radians)
    none,        ///< nothing is merged
};

struct MergeOptions {
    MergeCriterion criterion = MergeCriterion::dual_length;
    /// Mesh files carry six or seven significant digits. Merging everything below 1e-3 moves a
    /// Poisson error by less than 0.1 %. So 1e-4 catches cells that were meant to be cospherical.
    double tolerance = 1e-4;
};

/// Facets within the tolerance, before any guard, by number of cofaces. Only facets with two
/// cofaces can merge; the others matter because no inverse star exists on them.
struct DegenerateFacets {
    Index interior = 0;
    Index boundary = 0;
    Index branching = 0;
    std::vector<bool> marks = {}; ///< one per facet

    bool operator[](Index facet) const { return marks[facet]; }
};

} // namespace polydec
