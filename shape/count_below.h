// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

struct CountOptions {
    int degree = 0; ///< of forms: 0, n, or 1 on a surface; see ShapeSpectrumOptions
    /// 1: linear and Crouzeix-Raviart functions, bounds of order 2; 2: quadratic functions and the
    /// hybrid method of degree 1, of order 4.
    int level = 2;
    std::string linear_solver = "auto"; ///< that counts by inertia
};

/// Bounds of the number of eigenvalues of a shape below some number.
struct CountBelow {
    Index at_least = 0;
    std::optional<Index> at_most = {};      ///< none where simplices are too large
    std::vector<Index> too_large = {};      ///< these
    std::vector<std::string> warnings = {}; ///< of these
};

/// How many eigenvalues of forms on the shape lie below s, proved by two counts of inertia: at
/// least as many as conforming functions have, at most as many as nonconforming ones have after
/// their mass is enlarged. See docs/what-is-proved.md. Not covered: the inertia is counted in
/// floating-point numbers; InertiaCounter says where it is trusted, and where it is not s moves by
/// 1e-6 of it at most, to the safe side. Does not depend on units, numbering and embedding. Throws
/// InvalidInput for another level or degree, s that is no number, and shapes that check refuses;
/// SolverFailure where no count can be trusted.
CountBelow count_below(const Shape& shape, double s, const CountOptions& options = {});

} // namespace polydec
