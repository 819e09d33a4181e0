// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/facet_classes.h"

namespace polydec {

/// Collective: adds flat n-simplices to the classes of their neighbors, as absorb_flat does for the
/// whole mesh. One rank decides for all connected flat simplices and the classes beside them.
/// `free` marks facets between two n-simplices that may vanish, valid for every facet here; `first`
/// has for each n-simplex the number of the first one in its class.
void absorb_flat(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                 const FacetDefects& defects, const std::vector<std::uint8_t>& free,
                 double tolerance, std::vector<GlobalIndex>& first);

} // namespace polydec
