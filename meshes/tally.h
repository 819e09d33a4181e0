// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace polydec {

/// How often something untidy was met, and in which cell first.
struct Tally {
    std::size_t count = 0, first = 0;

    void add(std::size_t cell, std::size_t times = 1) {
        first = count == 0 ? cell : first;
        count += times;
    }
};

} // namespace polydec
