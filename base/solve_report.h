// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <limits>
#include <string>
#include <vector>

namespace polydec {

/// Report on the last solve; in a SolverFailure, on the progress made.
struct SolveReport {
    std::string engine = {};     ///< the engine that succeeded, or failed
    Index iterations = 0;        ///< largest over the right-hand sides; 0 for direct engines
    double residual = 0.0;       ///< largest |b - A x| / |b| over the right-hand sides, 2-norm
    double backward_error = 0.0; ///< largest |b - A x| / (|A| |x| + |b|), maximum norm
    std::vector<std::string> tried = {}; ///< engines in order, failed ones with the reason

    /// Report of an engine that failed; quantities that it did not measure are NaN.
    static SolveReport failed(const std::string& engine, Index iterations = 0,
                              double residual = std::numeric_limits<double>::quiet_NaN(),
                              double backward_error = std::numeric_limits<double>::quiet_NaN()) {
        return {engine, iterations, residual, backward_error, {engine}};
    }
};

} // namespace polydec
