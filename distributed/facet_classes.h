// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/facet_defects.h"
#include "dec/metric/centers.h"
#include "distributed/local_complex.h"

namespace polydec {

/// By degree: simplices that must not be removed; 1 or 0.
using KeptSimplices = std::vector<std::vector<std::uint8_t>>;

/// What the cells of highest dimension are made of.
struct FacetClasses {
    std::vector<GlobalIndex> first;    ///< of each n-simplex: number of the first one of its cell
    std::vector<std::uint8_t> removed; ///< facets
    bool any = false, exact = true;    ///< on all ranks: facets are removed; all without defect
};

/// Collective: measures the facets like the whole, right for every facet here. Throws InvalidInput
/// if n-simplices are flat where that matters.
FacetDefects measure_facets(const Ranks& ranks, const LocalComplex& local,
                            const CellVolumes& volumes, const MergeOptions& options);

/// Collective: joins n-simplices across degenerate facets. Links that hang together are joined on
/// one rank.
FacetClasses join_facets(const Ranks& ranks, const LocalComplex& local, const FacetDefects& defects,
                         double tolerance, const std::vector<std::uint8_t>& kept);

/// Collective: where the cells of a complex in space have their centers.
Centers shared_centers(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                       const FacetClasses& classes);

} // namespace polydec
