// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// A simplicial complex of any dimension n >= 1: all faces of given top simplices. It may be
/// bounded, disconnected, branching (three or more cells at a facet) or non-orientable.
///
/// Simplices of each degree are numbered by the lexicographic order of their ascending vertex
/// lists, so the numbering does not depend on the order of the input. k-simplices, k < n, are
/// oriented by ascending vertex number; n-simplices keep the orientation of the input, made
/// coherent in each part that is orientable (by turning the fewest).
class SimplicialComplex : public CellComplex {
public:
    /// Top simplices: one row of n+1 vertex numbers >= 0 each. Vertices that no simplex uses do not
    /// belong to the complex. Time O(cells log(largest vertex degree)), memory also of the order
    /// of the largest vertex number. Throws InvalidInput, naming the rows, for repeated corners or
    /// two rows on the same vertices; IoError if its estimated size is above memory_limit().
    explicit SimplicialComplex(const Simplices& tops);

    /// Ascending vertex lists: size(k) x (k+1). The rows of simplices(0) are the vertices used.
    const Simplices& simplices(int k) const& {
        check_number("the table of simplices of degree", k, 0, dimension());
        return simplices_[k];
    }
    Simplices simplices(int k) && { return simplices(k); }

    /// The face of k-simplex s, k >= 1, that lacks its vertex number `omitted` (0..k in ascending
    /// order). Read in the innermost loops, so s and omitted are not checked.
    Index face(int k, Index s, int omitted) const {
        check_number("a face of a simplex of degree", k, 1, dimension());
        return coboundary(k - 1).innerIndexPtr()[s * (k + 1) + (k - omitted)];
    }

    /// The row of the constructor's argument that n-simplex s was.
    Index input_row(Index s) const {
        check_number("the input row of simplex", s, 0, size(dimension()) - 1);
        return input_rows_[s];
    }

    /// Orientation of n-simplex s against the ascending order of its vertices: 1 or -1.
    int orientation(Index s) const {
        check_number("the orientation of simplex", s, 0, size(dimension()) - 1);
        return orientations_[s];
    }

    /// Whether the n-simplices could be oriented coherently across facets with two cofaces.
    bool orientable() const { return orientable_; }

    /// Number of n-simplices whose orientation differs from the input's, to be coherent.
    Index turned() const { return turned_; }

private:
    std::vector<Simplices> simplices_;
    std::vector<Index> input_rows_;
    std::vector<std::int8_t> orientations_;
    bool orientable_ = true;
    Index turned_ = 0;
};

} // namespace polydec
