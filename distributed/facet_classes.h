// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/facet_defects.h"
#include "dec/metric/centers.h"
#include "distributed/local_complex.h"

namespace polydec {

/// By degree: flags of simplices that must not be removed, 1 or 0.
using KeptSimplices = std::vector<std::vector<std::uint8_t>>;

/// The pieces of the merged cells of highest dimension.
struct FacetClasses {
    std::vector<GlobalIndex> first;    ///< for each n-simplex: number of the first one in its cell
    std::vector<std::uint8_t> removed; ///< facets
    bool any = false, exact = true;    ///< on all ranks: facets are removed; all without defect
};

/// The class of an n-simplex; both are numbers of simplices.
struct SimplexClass {
    GlobalIndex simplex, first;
};

/// Collective: applies the classes found on other ranks to own n-simplices and their copies;
/// `first` has the class of each.
void take_classes(const Ranks& ranks, const LocalComplex& local, const Parcels<SimplexClass>& found,
                  std::vector<GlobalIndex>& first);

/// Collective: the shortest edge at each vertex, in the whole mesh.
Vector shortest_edges(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes);

/// Collective: measures the facets as in the whole mesh; valid for every facet here.
FacetDefects measure_facets(const Ranks& ranks, const LocalComplex& local,
                            const CellVolumes& volumes, const MergeOptions& options);

/// Collective: joins n-simplices across degenerate facets, and flat ones to their neighbors.
/// Connected links are joined on one rank.
FacetClasses join_facets(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                         const FacetDefects& defects, double tolerance,
                         const std::vector<std::uint8_t>& kept);

/// Collective: the centers of the cells of a complex in space. `flat` is empty or marks flat
/// n-simplices.
Centers shared_centers(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                       const FacetClasses& classes, const std::vector<bool>& flat);

} // namespace polydec
