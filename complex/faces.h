// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// The order that sorts rows lexicographically. Rows hold vertex numbers >= 0.
std::vector<Index> lexicographic_order(const Simplices& rows);

struct Faces {
    Simplices simplices;       ///< distinct faces, ascending lists in lexicographic order
    std::vector<Index> of;     ///< of[s * m + j]: face of simplex s that lacks its vertex m - 1 - j
    std::vector<Index> counts; ///< number of simplices around each face
};

/// All facets of the given simplices (rows of m ascending vertex numbers, m >= 2). For each simplex
/// they are listed in ascending order, since leaving out a later vertex gives the smaller list.
Faces faces_of(const Simplices& simplices);

} // namespace polydec
