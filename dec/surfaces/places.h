// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_metric.h"
#include "dec/surfaces/overlay.h"

#include <optional>

namespace polydec {

/// Where the pieces lie in space: places in them, told by barycentric coordinates, as combinations
/// of the mesh's vertices. On simplices these are the coordinates. After flips a piece is laid over
/// the triangles of the input that it crosses, and a place is a combination of the vertices of the
/// one that it is found in; beyond an edge it is looked for in the triangles behind, laid flat one
/// after the other, and beyond the boundary it goes on as the corners of the last one lie.
class Places {
public:
    /// points are those of the discretization, with rows for vertices that splits have made.
    Places(const Passage& passage, const Points& points);

    /// Values at vertices, a row per point, continued linearly on the simplices of the input: at a
    /// place in each k-piece with these coordinates, k+1 in a row. size(k) x the columns of values.
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
    std::vector<Index> begins_;      // of the parts of each piece; empty where nothing was flipped
    std::optional<Cofaces> cofaces_; // and neither are these needed there
};

} // namespace polydec
