// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

namespace polydec {

struct SortedRows;

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

    /// A part of a complex, such as one of many machines holds: corners are places among `names`,
    /// which ascend, are all used and what messages call the vertices; so simplices stand in the
    /// order of the whole. There may be none. Throws likewise.
    SimplicialComplex(const Simplices& tops, std::vector<Index> names);

    /// The same with other orientations of the n-simplices, 1 or -1 against the order of their
    /// corners, of which the caller knows whether they are coherent. Throws InvalidInput for
    /// another number of them.
    SimplicialComplex oriented(std::vector<std::int8_t> orientations, bool orientable) const;

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
    static Sorted with_faces(SortedRows tops, std::vector<Index> names);
    explicit SimplicialComplex(Sorted sorted);

    std::shared_ptr<const std::vector<Index>> input_rows_;
    Index turned_;
};

} // namespace polydec
