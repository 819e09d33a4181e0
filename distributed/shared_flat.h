// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/facet_classes.h"

namespace polydec {

/// Collective: gives flat n-simplices to the classes of their neighbors, as absorb_flat does for
/// the whole. Those that hang together, with the classes beside them, decide on one rank what
/// becomes of them. `free` marks facets between two n-simplices that may vanish, right for every
/// facet here; first has for each n-simplex the number of the first one of its class.
void absorb_flat(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                 const FacetDefects& defects, const std::vector<std::uint8_t>& free,
                 double tolerance, std::vector<GlobalIndex>& first);

} // namespace polydec
