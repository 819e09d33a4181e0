// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace polydec {

/// The most memory that this process has used so far, in bytes.
std::int64_t peak_memory();

} // namespace polydec
