// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/metric/geometry.h"

namespace polydec {

/// By what a facet between two n-simplices is called degenerate.
enum class MergeCriterion {
    dual_length, ///< relative dual length |V(f)| / l(f), l twice the circumradius of the facet
    angle,       ///< Schier's test: the angles opposite to the facet add up to pi (radians)
    none,        ///< nothing is merged
};

struct MergeOptions {
    MergeCriterion criterion = MergeCriterion::dual_length;
    /// Mesh files carry six or seven digits whatever they print, and merging all below 1e-3 moves
    /// a Poisson error by less than 0.1 %: 1e-4 catches what was meant to be cospherical.
    double tolerance = 1e-4;
};

/// Facets within the tolerance, before any guard, by number of cofaces. Only those with two can
/// merge; the others are worth knowing about since no inverse star exists on them.
struct DegenerateFacets {
    Index interior = 0;
    Index boundary = 0;
    Index branching = 0;
    std::vector<bool> marks = {}; ///< one for each facet

    bool operator[](Index facet) const { return marks[facet]; }
};

struct CosphericalMerging {
    Merging merging;
    DegenerateFacets degenerate;
    int rounds = 0;    ///< how often a class of facets that made no proper cell was split up again
    Geometry geometry; ///< of the pieces: duals between circumcenters, those of a cell's pieces in
                       ///< one place; marks the flat pieces of cells that have others
};

/// Merges n-simplices across facets whose dual is degenerate, then downwards their faces wherever
/// exactly two are left that lie straight across each other, so that no dual cell of the result is
/// degenerate. Facets on the boundary or with three or more cofaces never merge; vertices stay.
///
/// Since near-cospherical is not transitive, unions are made in ascending defect, equal ones
/// together or not at all, and refused when the accumulated defect passes 10 tolerances; and every
/// merged cell is checked to be a ball. So the result does not depend on the order of the input.
///
/// Flat simplices have no circumcenter of meaning: in solids in space they become pieces of a
/// neighbor on whose sphere they lie (see absorb_flat); others, and those in other dimensions, stay
/// cells. In R^n all that lies between two pieces of a cell goes, and their duals have one center.
///
/// `stays` may mark facets that are to stay whatever their duals, one entry for each.
/// Time O(incidences + f log f), f the number of degenerate facets. Throws InvalidInput for a
/// tolerance that is negative or not finite, and for another number of marks.
CosphericalMerging merge_cospherical(const Geometry& geometry, const MergeOptions& options = {},
                                     const std::vector<bool>& stays = {});

/// Volumes of merged cells, with duals of 0 (see HodgeStar::zeros) where a center lies beyond the
/// boundary, but within the tolerance: whatever rounding or jitter made of them, such centers count
/// as lying on it.
CellVolumes without_duals_beyond_the_boundary(const CellVolumes& volumes, const Merging& merging,
                                              const DegenerateFacets& degenerate);

} // namespace polydec
