// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merge.h"
#include "meshes/mesh.h"

#include <functional>
#include <string>
#include <string_view>

namespace polydec {

/// A mesh made ready for calculus: its complex, merged where cells are cospherical, and the metric.
/// Each member can be made by itself; this bundle only holds them together.
struct Discretization {
    Points points; ///< a row per vertex number of the input
    Merging merging;
    CellVolumes input_volumes; ///< of the simplices
    CellVolumes volumes;       ///< of the merged cells
    MergeOptions options;
    DegenerateFacets degenerate;
    std::vector<std::string> warnings; ///< what was untidy in the input, and what was done about it
    std::vector<Index> tags = {};      ///< of each merged n-cell the tag of its simplices, 0 where
                                       ///< they have different ones; or empty

    const SimplicialComplex& input() const { return merging.input(); }
    const CellComplex& complex() const { return merging.merged(); }
    int dimension() const { return complex().dimension(); }
};

/// The whole way from a mesh to its merged complex and volumes. Untidy input is tidied with a
/// warning (see tidy). Each stage (complex, volumes, merge) is told as it begins, if anyone
/// listens. Throws InvalidInput, naming the cell or vertex, for what cannot be used.
Discretization discretize(Mesh mesh, const MergeOptions& options = {},
                          const std::function<void(std::string_view)>& stage = {});

} // namespace polydec
