// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace polydec {

/// Number of a cell, vertex or file record; 32 bits, so at most 2^31 - 1 cells of a degree.
using Index = std::int32_t;

} // namespace polydec
