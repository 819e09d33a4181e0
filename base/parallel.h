// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>

namespace polydec {

/// Calls work(begin, end) for parts of `size` items, the last one shorter, that make up
/// 0 .. count - 1; several at once on as many threads as OpenMP has (OMP_NUM_THREADS), or one after
/// the other in a build without it. The parts depend on count and size alone, so what is computed
/// for a part is the same bit by bit for any number of threads; what work writes must belong to its
/// part. If parts throw, the exception of the first of them is passed on when all have ended.
void for_each_part(Index count, Index size, const std::function<void(Index, Index)>& work);

/// From here on all is done one after the other: for a process that was forked from one with
/// threads, which it does not have.
void use_one_thread();

} // namespace polydec
