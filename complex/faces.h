// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/coface_counts.h"

#include <memory>
#include <vector>

namespace polydec {

/// Distinct simplices: rows of ascending vertex numbers, below `vertices`, in lexicographic order.
struct SortedSimplices {
    std::shared_ptr<const Simplices> rows;
    Index vertices = 0;
    std::vector<Index> begins; ///< for each block of vertices (see block_size), its first row
};

/// The distinct facets of simplices, and their incidences.
struct Faces {
    SortedSimplices simplices;
    std::shared_ptr<const Simplices> table; ///< of each simplex its facets, that without its last
                                            ///< vertex first
    CofaceCounts counts;                    ///< number of simplices around each face
    bool are_coherent = false; ///< known: two simplices at a facet have opposite signs there
};

/// All facets of the given simplices, which have at least two vertices and are all used. A simplex
/// lists its facets in ascending order, since leaving out a later vertex gives the smaller list.
/// `signs` orients the simplices relative to the order of their vertices; without signs, coherence
/// is unknown.
Faces faces_of(const SortedSimplices& simplices, const std::vector<std::int8_t>& signs = {});

/// Sorted rows of vertex numbers, their previous positions, and the signs of their permutations.
struct SortedRows {
    SortedSimplices simplices;
    std::vector<Index> order;
    std::vector<std::int8_t> signs;
    bool are_simplices = true; ///< no row has a repeated vertex or occurs twice
};
SortedRows sorted_rows(const Simplices& rows, Index vertices);

} // namespace polydec
