// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "meshes/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace polydec {

/// The treatment of cells without volume.
enum class CellsWithoutVolume {
    leave_out, ///< omitted if no slit opens; otherwise an error
    keep,      ///< also omitted if no slit opens; the others stay, for callers that accept them
};

/// The mesh without cells that a complex cannot have: cells with a repeated corner, cells on the
/// vertices of an earlier one, cells without volume (n! times the volume at most 1e-12 times the
/// longest edge to the n). The mesh's warnings name omitted cells and isolated vertices; these
/// vertices stay, so that no vertex number changes. Cells keep their order and tags, facets theirs.
/// Messages use the numbers of the given mesh, from 0. Any n >= 0 and N >= n.
///
/// A cell without volume is omitted only if at most one of its facets belongs to another remaining
/// cell: otherwise a slit would open between former neighbors. Throws InvalidInput, naming cell and
/// vertices, for a cell without volume that must stay; for coordinates that are not finite, vertex
/// numbers out of range, n > N, a wrong number of tags; like check_facet_tags; and if no cell
/// remains.
Mesh tidy(Mesh mesh, CellsWithoutVolume flat = CellsWithoutVolume::leave_out);

/// The cells without volume that stay.
struct FlatCellsKept {
    std::vector<Index> rows;    ///< of the tidied mesh, ascending
    std::vector<Index> numbers; ///< in the given one
};

/// The same, keeping cells without volume and listing them in `kept`.
Mesh tidy(Mesh mesh, FlatCellsKept& kept);

/// Tidies the mesh likewise and returns its complex. Most meshes need no tidying, which takes
/// longer than the complex: only those that the complex refuses, and those with cells without
/// volume.
SimplicialComplex tidied_complex(Mesh& mesh, FlatCellsKept& kept);

/// Throws the InvalidInput of tidy for these kept cells of the tidied mesh.
[[noreturn]] void refuse(const Mesh& mesh, const FlatCellsKept& cells);

/// Throws InvalidInput, naming cell, vertex or facet, for coordinates that are not finite, vertex
/// numbers out of range, cells of a higher dimension than the space, a wrong number of tags, and
/// like check_facet_tags.
void check_mesh(const Mesh& mesh);

/// Adds a warning to the mesh that names the vertices of no cell. Uses only the number of points,
/// not their coordinates.
void warn_of_isolated_vertices(Mesh& mesh);

/// The text of that warning for `count` vertices, given the first ones, up to most_listed.
std::string isolated_vertices(const std::vector<std::int64_t>& first, std::size_t count);

/// The mesh without flat boundary cells, which mesh generators make if boundary points are slightly
/// off a plane: simplices over nearly collinear or coplanar points of the hull. They lie on no
/// neighbor's sphere, so they cannot be merged. Removing them changes the region by as much as the
/// points are off; the mesh's warnings report it.
///
/// A cell is flat if a height is at most 1/100 of the shortest edge at its corners. It is removed
/// if some of its facets, but not n, belong to no other cell, and the face shared by its other
/// facets is not on the boundary. So the region stays what it was, except for its skin, and no
/// vertex is lost. Cells are removed in rounds, none of which has two cells with a common vertex,
/// in spatial order of their corners; so results do not depend on numbers. Time O(cells log cells),
/// and one round per layer of flat cells. Throws InvalidInput like tidy, whose flat cells it keeps,
/// and unless N = n >= 2.
Mesh peeled(Mesh mesh);

} // namespace polydec
