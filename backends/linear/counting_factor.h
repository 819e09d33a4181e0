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
    /// Whether the number of entries fits; known after analyzePattern().
    bool fits() const {
        return this->m_nonZerosPerCol.template cast<std::int64_t>().sum() <=
               std::numeric_limits<Index>::max();
    }
};

} // namespace polydec
