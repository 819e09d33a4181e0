// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace polydec {

/// How well x solves A x = b, in one process or over ranks; 0 for b = 0 and x = 0.
struct SolutionQuality {
    double residual = 0;       ///< |b - A x| / |b|, 2-norm
    double backward_error = 0; ///< |b - A x| / (|A| |x| + |b|), maximum norm

    /// To be trusted: a residual of at most 1e-6 and a backward error of at most 1e-10, or either
    /// as large as was wished for.
    bool is_good(double wished = 0) const;

    /// What to say of a solution that is not.
    std::string failure() const;
};

} // namespace polydec
