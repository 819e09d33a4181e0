// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/coface_counts.h"

#include <memory>
#include <vector>

namespace polydec {

/// Different simplices: rows of ascending vertex numbers, below `vertices`, in lexicographic order.
struct SortedSimplices {
    std::shared_ptr<const Simplices> rows;
    Index vertices = 0;
    std::vector<Index> begins; ///< of each block of vertices (see block_size): where its rows begin
};

/// The distinct facets of simplices, and which of them bounds which.
struct Faces {
    SortedSimplices simplices;
    std::shared_ptr<const Simplices> table; ///< of each simplex its facets, that without its last
                                            ///< vertex first
    CofaceCounts counts;                    ///< number of simplices around each face
    bool are_coherent = false; ///< known: two simplices at a facet have opposite signs there
};

/// All facets of the given simplices of at least two vertices, all of which are used. For each
/// simplex they are listed in ascending order, since leaving out a later vertex gives the smaller
/// list. `signs` orients the simplices against the order of their vertices; without them nothing is
/// known of coherence.
Faces faces_of(const SortedSimplices& simplices, const std::vector<std::int8_t>& signs = {});

/// Rows of vertex numbers sorted, where each stood before, and the signs of their permutations.
struct SortedRows {
    SortedSimplices simplices;
    std::vector<Index> order;
    std::vector<std::int8_t> signs;
    bool are_simplices = true; ///< no row has a vertex twice or is there twice
};
SortedRows sorted_rows(const Simplices& rows, Index vertices);

} // namespace polydec
