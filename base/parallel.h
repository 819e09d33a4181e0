// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>

namespace polydec {

/// Calls work(begin, end) for parts of `size` items, the last one shorter, that make up 0 .. count
/// - 1. Parts run on as many threads as OpenMP has (OMP_NUM_THREADS), or sequentially in a build
/// without OpenMP. The parts depend only on count and size, so results per part are bitwise the
/// same for any number of threads; `work` must write only data of its part. If parts throw, the
/// exception of the first such part is rethrown when all have ended.
void for_each_part(Index count, Index size, const std::function<void(Index, Index)>& work);

/// Disables threads from here on: for a process forked from a process with threads, which it does
/// not inherit.
void use_one_thread();

} // namespace polydec
