// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"
#include "complex/merging.h"
#include "dec/metric/geometry.h"

#include <functional>
#include <optional>
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

struct CosphericalMerging {
    Merging merging;
    DegenerateFacets degenerate;
    int rounds = 0;    ///< number of times a class of facets without a proper cell was split again
    Geometry geometry; ///< of the pieces: duals between circumcenters, one for all pieces of a
                       ///< cell; marks the flat pieces of cells with other pieces
};

/// Facets that merging keeps, one entry per facet; without entries, none.
struct KeptFacets {
    std::vector<bool> stay = {};  ///< marks of facets that are not removed
    std::vector<Index> tags = {}; ///< (n-1)-cells join only facets with equal tags
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
/// Time O(incidences + f log f), f the number of degenerate facets. Throws InvalidInput for a
/// tolerance that is negative or not finite, and for a wrong number of marks or tags.
CosphericalMerging merge_cospherical(const Geometry& geometry, const MergeOptions& options = {},
                                     const KeptFacets& facets = {});

/// Volumes of cells, with duals set to 0 (see HodgeStar::zeros) where a center lies beyond the
/// boundary but within the tolerance: below an (n-1)-cell with one coface and degenerate pieces
/// alone, which is asked of few. Such centers, moved there by rounding or jitter, count as lying on
/// the boundary.
CellVolumes without_duals_beyond_the_boundary(const CellVolumes& volumes,
                                              const CofaceCounts& cofaces,
                                              const std::function<bool(Index cell)>& is_degenerate);

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
