// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"

namespace polydec {

/// Collective: orients the n-simplices like SimplicialComplex on one rank: coherently in each
/// orientable part, over all ranks, by reversing as few as possible; the part's first simplex
/// decides ties.
void orient(const Ranks& ranks, const Stars& stars, LocalComplex& local);

} // namespace polydec
