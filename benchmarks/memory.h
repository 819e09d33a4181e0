// SPDX-License-Identifier: MIT
#pragma once

namespace polydec::benchmarks {

/// Whether this program counts what it allocates: it does with the C library glibc and without
/// sanitizers, by standing in for malloc and its relatives, behind which operator new and Eigen
/// are. Memory that a library maps by itself is not counted.
bool counts_memory();

/// Bytes allocated now.
double live_bytes();

/// The most bytes allocated at a time since forget_peak().
double peak_bytes();
void forget_peak();

} // namespace polydec::benchmarks
