// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/surfaces/geodesic_distance.h"
#include "tools/answer.h"

#include <vector>

namespace polydec::tools {

/// A shortest path, from a vertex of the file.
struct ToldPath {
    Index to;
    SurfacePath path;
};

struct Distances {
    DistanceMethod method = DistanceMethod::exact;
    std::vector<Index> from;
    Index farthest = 0;
    Index raised = 0; ///< negative values, raised to 0
    double max = 0, mean = 0;
    std::vector<ToldPath> paths; ///< with the sources' numbers in the file

    void write(JsonWriter& json) const;
    void write(Text& text) const;
};

/// "exact up to rounding", or the accuracy of the other method.
const char* accuracy(DistanceMethod method);

} // namespace polydec::tools
