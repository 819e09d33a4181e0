// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <utility>
#include <vector>

namespace polydec {

using Edge = std::pair<Index, Index>; ///< the lesser end first

/// The edges of all simplices, ascending, each once.
std::vector<Edge> edges_of(const Simplices& simplices);

} // namespace polydec
