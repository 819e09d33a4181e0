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
    std::string linear_solver = "auto"; ///< computes inertia
};

/// Bounds on the number of eigenvalues of a shape below a given number.
struct CountBelow {
    Index at_least = 0;
    std::optional<Index> at_most = {};      ///< none if simplices are too large
    std::vector<Index> too_large = {};      ///< these
    std::vector<std::string> warnings = {}; ///< about these
};

/// The number of eigenvalues of forms on the shape below s, bounded by two counts of inertia: from
/// below by conforming functions, from above by nonconforming functions with enlarged mass. See
/// docs/what-is-proved.md. The proof does not cover rounding in the inertia: InertiaCounter decides
/// where a count can be trusted; elsewhere s moves by at most 1e-6 of s to the safe side. Does not
/// depend on units, numbering and embedding. Throws InvalidInput for another level or degree, an s
/// that is not finite, and like check; SolverFailure if no count can be trusted.
CountBelow count_below(const Shape& shape, double s, const CountOptions& options = {});

} // namespace polydec
