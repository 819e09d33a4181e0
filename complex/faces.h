// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// The distinct facets of simplices, and which of them bounds which.
struct Faces {
    Simplices simplices; ///< ascending lists in lexicographic order
    IncidenceMatrix
        coboundary;            ///< of each simplex its facets: (-1)^i if vertex number i is lacking
    std::vector<Index> counts; ///< number of simplices around each face
};

/// All facets of the given simplices: rows of m ascending vertex numbers, m >= 2, in lexicographic
/// order. For each simplex they are listed in ascending order, since leaving out a later vertex
/// gives the smaller list.
Faces faces_of(const Simplices& simplices);

/// Rows of ascending vertex numbers >= 0 in lexicographic order, and where each stood before.
struct SortedRows {
    Simplices rows;
    std::vector<Index> order;
};
SortedRows sorted_rows(const Simplices& rows);

} // namespace polydec
