// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"

namespace polydec {

/// Collective: see Ownership::graph.
std::vector<int> owners_by_graph(const Ranks& ranks, const MeshSlice& slice);

} // namespace polydec
