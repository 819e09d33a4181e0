// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Hints to the processor that this address will be read soon, where it cannot guess: entries of a
/// table in random order. No other effect.
inline void prefetch(const void* address) {
    __builtin_prefetch(address);
}

} // namespace polydec
