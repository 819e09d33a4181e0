// SPDX-License-Identifier: MIT
#pragma once

namespace polydec::benchmarks {

/// Bytes read plus bytes written in a second by memcpy of blocks that no cache holds, one thread:
/// the bound for whatever reads its input and writes its output once. The best of several copies,
/// measured at the first call.
double copy_bandwidth();

/// Makes copy_bandwidth() measure small blocks, which are touched in no time, and say nothing.
void measure_bandwidth_roughly();

} // namespace polydec::benchmarks
