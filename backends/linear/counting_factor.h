// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <cstdint>
#include <limits>

namespace polydec {

/// A sparse factorization of Eigen's that detects overflow: Eigen counts the factor's entries in 32
/// bits and writes beyond its arrays if the count wraps around.
template <class Factorization>
class CountingFactor : public Factorization {
public:
    /// The number of entries below the diagonal; known after analyzePattern().
    std::int64_t entries() const {
        const auto* starts = this->m_matrix.outerIndexPtr(); // in each version of Eigen
        std::int64_t count = 0;
        for (Eigen::Index column = 0; column < this->m_matrix.cols(); ++column)
            count += static_cast<std::uint32_t>(starts[column + 1]) -
                     static_cast<std::uint32_t>(starts[column]);
        return count;
    }

    bool fits() const { return entries() <= std::numeric_limits<Index>::max(); }
};

} // namespace polydec
