// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "complex/pieces.h"

namespace polydec {

struct SortedRows;

/// A simplicial complex of any dimension n >= 1: all faces of the given top simplices. It may have
/// a boundary, be disconnected, branching (three or more cells at a facet) or non-orientable.
///
/// Simplices of each degree are numbered in the lexicographic order of their ascending vertex
/// lists, so the numbering does not depend on the order of the input. k-simplices, k < n, are
/// oriented by ascending vertex number. n-simplices keep their orientation in the input, made
/// coherent in each orientable part by turning as few as possible.
class SimplicialComplex : public Pieces {
public:
    /// Top simplices: one row of n+1 vertex numbers >= 0 each. Vertices of no simplex are not part
    /// of the complex: its 0-simplices are the used vertices, ascending, and points, fields and
    /// forms have one row per used vertex (see vertex_points). Time O(cells log(largest vertex
    /// degree)); memory also of the order of the largest vertex number. Throws InvalidInput, naming
    /// the rows, for repeated corners or two rows with the same vertices; IoError if its estimated
    /// size exceeds memory_limit().
    explicit SimplicialComplex(const Simplices& tops);

    /// A part of a complex, e.g. on one of several machines. Corners are positions in `names`, the
    /// vertex numbers for messages, which are ascending and all used; so simplices are in the order
    /// of the whole. May be empty. Throws likewise.
    SimplicialComplex(const Simplices& tops, std::vector<Index> names);

    /// The same with other orientations of the n-simplices, 1 or -1 relative to the order of their
    /// corners; the caller knows whether they are coherent. Throws InvalidInput for a wrong number
    /// of orientations.
    SimplicialComplex oriented(std::vector<std::int8_t> orientations, bool orientable) const;

    /// The k-simplex with these ascending vertex numbers (see vertex_number); -1 if there is none.
    /// Time O(k log(size(k))).
    Index find(int k, std::span<const Index> vertices) const;

    /// The row of the constructor's argument that became n-simplex s.
    Index input_row(Index s) const {
        check_number("the input row of simplex", s, 0, size(dimension()) - 1);
        return (*input_rows_)[s];
    }

    /// Number of n-simplices whose input orientation was reversed to make orientations coherent.
    Index turned() const { return turned_; }

private:
    SimplicialComplex(const Pieces& pieces, std::vector<Index> input_rows, Index turned);
    static SimplicialComplex sorted(const Simplices& tops);
    static SimplicialComplex with_faces(SortedRows tops, std::vector<Index> names);

    Shared<const std::vector<Index>> input_rows_;
    Index turned_;
};

} // namespace polydec
