// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"

namespace polydec {

/// Collective: for each n-simplex here the sign that is coherent across facets with two cofaces, by
/// changing as few of the given signs as possible in each part, over all ranks; the part's first
/// simplex decides ties. Simplices given as 0 connect nothing. 0 where no signs are coherent.
std::vector<std::int8_t> coherent(const Ranks& ranks, const LocalComplex& local,
                                  const std::vector<std::int8_t>& given);

/// Collective: orients the n-simplices like SimplicialComplex on one rank: coherently in each
/// orientable part, over all ranks, by reversing as few as possible; the part's first simplex
/// decides ties.
void orient(const Ranks& ranks, const Stars& stars, LocalComplex& local);

} // namespace polydec
