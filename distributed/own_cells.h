// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "distributed/discretize.h"

#include <optional>

namespace polydec {

/// The n-cells that a rank owns with all their faces, as one process has them: a mesh of its own,
/// without anything of the neighbors.
struct OwnCells {
    Merging merging;    ///< its n-cells are the own ones, in their order
    Points points;      ///< of its vertices, in units of the mesh
    Points at_vertices; ///< what was given for them
};

/// Collective: brings the pieces of own n-cells together. `of_vertices` has a row of numbers for
/// each local vertex, to be brought along; none where a rank owns no n-cell.
std::optional<OwnCells> own_cells(const Ranks& ranks, const DistributedMesh& mesh,
                                  const Points& of_vertices);

} // namespace polydec
