// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_layout.h"
#include "dec/surfaces/passage.h"

#include <optional>

namespace polydec {

/// Positions of the pieces in space: a place in a piece, given by barycentric coordinates, as a
/// combination of the mesh's vertices. On simplices these are the coordinates. After flips a piece
/// is laid over the triangles of the input that it crosses; a place combines the vertices of the
/// triangle that contains it. Beyond an edge, the search continues in the triangles behind, laid
/// flat one after the other; beyond the boundary, the plane of the last triangle is extended.
class Places {
public:
    /// `points`: of the discretization, with rows for vertices added by splits.
    Places(const Passage& passage, const Points& points);

    /// Values at vertices, one row per point, interpolated linearly on the simplices of the input,
    /// at a place in each k-piece: row of k+1 coordinates. size(k) x the columns of values.
    Points at(int k, const Points& coordinates, const Points& values) const;

private:
    struct Place {
        Index piece; ///< of highest dimension
        Vector coordinates;
    };
    struct Term {
        Index point;
        double weight;
    };

    void go_on(SimplexLayout& layout, Place& place) const;
    std::vector<Term> combination(Place place) const;

    Passage passage_;
    Overlay overlay_;
    std::vector<Index> begins_;      // of the parts of each piece; empty if nothing was flipped
    std::optional<Cofaces> cofaces_; // none if nothing was flipped
};

} // namespace polydec
