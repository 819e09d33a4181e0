// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace polydec {

/// The residual and backward error of x in A x = b, in one process or over ranks; 0 for b = x = 0.
struct SolutionQuality {
    double residual = 0;       ///< |b - A x| / |b|, 2-norm
    double backward_error = 0; ///< |b - A x| / (|A| |x| + |b|), maximum norm

    /// True for a residual of at most 1e-6 and a backward error of at most 1e-10, or at most
    /// `wished` if that is larger.
    bool is_good(double wished = 0) const;

    /// The message for a solution that is not good.
    std::string failure() const;
};

} // namespace polydec
