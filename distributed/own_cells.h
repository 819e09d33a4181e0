// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "distributed/discretize.h"

#include <optional>

namespace polydec {

/// The n-cells of a rank with all their faces, as in one process: a separate mesh, without
/// neighbors.
struct OwnCells {
    Merging merging;    ///< its n-cells are the own cells, in their order
    Points points;      ///< of its vertices, in units of the mesh
    Points at_vertices; ///< the given numbers at them
};

/// Collective: gathers the pieces of own n-cells. `of_vertices` has a row of numbers for each local
/// vertex, to be gathered along. None if a rank owns no n-cell.
std::optional<OwnCells> own_cells(const Ranks& ranks, const DistributedMesh& mesh,
                                  const Points& of_vertices);

} // namespace polydec
