// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <string>
#include <vector>

namespace polydec {

/// What a file or a generator gives: points of R^N and top simplices of one dimension n.
struct Mesh {
    Points points;       ///< one row per vertex, N columns
    Simplices simplices; ///< one row per n-simplex, n+1 columns; order gives orientation
    std::vector<std::string> warnings; ///< what was untidy and how it was handled
    std::vector<Index> tags = {}; ///< of each simplex the number of its physical group or region,
                                  ///< 0 for none; or empty

    int ambient_dimension() const { return static_cast<int>(points.cols()); }
    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

} // namespace polydec
