// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

namespace polydec {

/// A simplicial complex of any dimension n >= 1: all faces of given top simplices. It may be
/// bounded, disconnected, branching (three or more cells at a facet) or non-orientable.
///
/// Simplices of each degree are numbered by the lexicographic order of their ascending vertex
/// lists, so the numbering does not depend on the order of the input. k-simplices, k < n, are
/// oriented by ascending vertex number; n-simplices keep the orientation of the input, made
/// coherent in each part that is orientable (by turning the fewest).
class SimplicialComplex : public Pieces {
public:
    /// Top simplices: one row of n+1 vertex numbers >= 0 each. Vertices that no simplex uses do not
    /// belong to the complex: its 0-simplices are those used, in ascending order, and points,
    /// fields and forms have a row for each of these (see vertex_points). Time O(cells log(largest
    /// vertex degree)), memory also of the order of the largest vertex number. Throws InvalidInput,
    /// naming the rows, for repeated corners or two rows on the same vertices; IoError if its
    /// estimated size is above memory_limit().
    explicit SimplicialComplex(const Simplices& tops);

    /// The row of the constructor's argument that n-simplex s was.
    Index input_row(Index s) const {
        check_number("the input row of simplex", s, 0, size(dimension()) - 1);
        return (*input_rows_)[s];
    }

    /// Number of n-simplices whose orientation differs from the input's, to be coherent.
    Index turned() const { return turned_; }

private:
    struct Sorted {
        Pieces pieces;
        std::vector<Index> input_rows;
        Index turned;
    };
    static Sorted sorted(const Simplices& tops);
    explicit SimplicialComplex(Sorted sorted);

    std::shared_ptr<const std::vector<Index>> input_rows_;
    Index turned_;
};

} // namespace polydec
