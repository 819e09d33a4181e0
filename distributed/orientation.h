// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"

namespace polydec {

/// Collective: orients the n-simplices like SimplicialComplex does on one rank: coherently in each
/// part, over all ranks, that is orientable, by turning the fewest of them; ties are decided by the
/// part's first simplex.
void orient(const Ranks& ranks, const Stars& stars, LocalComplex& local);

} // namespace polydec
