// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "meshes/weld.h"

#include <cstdint>
#include <string>
#include <vector>

namespace polydec {

// Warnings about unusual meshes; each function adds nothing to `warnings` if all is usual. Numbers
// refer to the whole mesh, wherever its parts are.

void warn_of_orientation(std::int64_t turned, std::int64_t cells, bool orientable,
                         std::vector<std::string>& warnings);

/// facets: number of facets with three or more cells.
void warn_of_branching(std::int64_t facets, std::vector<std::string>& warnings);

std::int64_t branching_facets(const CellComplex& complex);

void warn_of_overlaps(const SimplicialComplex& complex, const Points& points,
                      std::vector<std::string>& warnings);

/// Some simplices, of which the first few are named by the numbers of their corners.
struct NamedSimplices {
    std::int64_t count = 0;
    std::vector<std::vector<Index>> first = {};
};
NamedSimplices named(const Pieces& complex, int k, const std::vector<Index>& simplices);

/// For the Overlaps of a mesh with so many cells.
void warn_of_overlaps(const NamedSimplices& folded, std::int64_t cells, const NamedSimplices& wound,
                      std::vector<std::string>& warnings);

/// For a mesh of dimension n.
void warn_of_unjoined(const UnjoinedBoundary& boundary, int n, std::vector<std::string>& warnings);

void warn_of_flips(const IntrinsicStatistics& flips, double unit,
                   std::vector<std::string>& warnings);

/// flat: cells that stayed alone; nearly: facets that would be degenerate at the wider tolerance
/// but are not at the merge's tolerance. Corners may be off their sphere by about as much.
void warn_of_jitter(std::int64_t flat, std::int64_t nearly, double wider,
                    std::vector<std::string>& warnings);

void warn_of_unit(double unit, std::vector<std::string>& warnings);

} // namespace polydec
