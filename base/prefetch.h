// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Tells the processor that this will be read soon, where it cannot guess: entries of a table in
/// disorder. Means nothing otherwise.
inline void prefetch(const void* address) {
    __builtin_prefetch(address);
}

} // namespace polydec
