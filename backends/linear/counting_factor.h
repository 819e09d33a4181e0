// SPDX-License-Identifier: MIT
#pragma once

#include "base/index.h"

#include <cstdint>
#include <limits>

namespace polydec {

/// A sparse factorization of Eigen's that knows whether it fits: Eigen counts the factor's entries
/// in 32 bits and writes beyond its arrays where they wrap around.
template <class Factorization>
class CountingFactor : public Factorization {
public:
    /// Whether there are as few entries as can be counted, known after analyzePattern().
    bool fits() const {
        return this->m_nonZerosPerCol.template cast<std::int64_t>().sum() <=
               std::numeric_limits<Index>::max();
    }
};

} // namespace polydec
