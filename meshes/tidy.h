// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <string>
#include <vector>

namespace polydec {

/// What becomes of cells without volume.
enum class CellsWithoutVolume {
    leave_out, ///< where no slit opens; else they are refused
    keep,      ///< left out where no slit opens, too; the others stay, for who can do with them
};

/// The mesh without what makes no sense to a complex: cells with a repeated corner, cells on the
/// vertices of an earlier one, cells without volume (n! times the volume at most 1e-12 times the
/// longest edge to the n). What is left out is named in the mesh's warnings, as are vertices that
/// belong to no cell; those stay, so that no vertex number changes. Cells keep their order and
/// tags, facets theirs. Numbers in all messages are those of the given mesh, from 0. Any n >= 0 and
/// N >= n.
///
/// A cell without volume is left out only if at most one of its facets belongs to another cell that
/// stays: otherwise a slit would open between cells that were neighbors.
/// Throws InvalidInput, naming cell and vertices, for one that cannot be left out; for coordinates
/// that are not finite, vertex numbers out of range, n > N, tags of another number than the cells;
/// for facets with tags that are none (check_facet_tags); and if nothing is left.
Mesh tidy(Mesh mesh, CellsWithoutVolume flat = CellsWithoutVolume::leave_out);

/// Cells without volume that are kept.
struct FlatCellsKept {
    std::vector<Index> rows;    ///< of the tidied mesh, ascending
    std::vector<Index> numbers; ///< in the given one
};

/// The same, keeping cells without volume, and telling which.
Mesh tidy(Mesh mesh, FlatCellsKept& kept);

/// Throws the InvalidInput for these cells of the tidied mesh that tidy throws if it keeps none.
[[noreturn]] void refuse(const Mesh& mesh, const FlatCellsKept& cells);

/// Throws InvalidInput, naming cell, vertex or facet, for coordinates that are not finite, vertex
/// numbers out of range, cells of a higher dimension than the space, tags of another number than
/// the cells, and like check_facet_tags.
void check_mesh(const Mesh& mesh);

/// Names in the mesh's warnings the vertices that belong to no cell. Of the points only their
/// number matters.
void warn_of_isolated_vertices(Mesh& mesh);

/// What that says of so many vertices, of which these are the first, most_listed if there are.
std::string isolated_vertices(const std::vector<Index>& first, std::size_t count);

} // namespace polydec
