// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "meshes/tetgen/tetgen_input.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// The files that go to TetGen and come from it. The readers of mesh files know more formats and
/// all of their variants, but stand to the right of meshes/ in the chain; these know only what
/// TetGen itself writes.
namespace polydec {

/// The input as .smesh, counted from 0; its triangles have the numbers of their patches from 1.
std::string smesh_text(const TetgenInput& input);

/// Points, tetrahedra, and faces with the facet that each is on, as TetGen wrote them. Throw
/// SolverFailure if a file is not what it writes: a link, a folder or a pipe, counts that its size
/// cannot hold, numbers missing, too many or out of range.
Points read_tetgen_points(const std::filesystem::path& path);
Simplices read_tetgen_cells(const std::filesystem::path& path, Eigen::Index points);
std::pair<Simplices, std::vector<Index>> read_tetgen_faces(const std::filesystem::path& path,
                                                           Eigen::Index points, Index facets);

/// Pairs of facets, from 0 and each once, that a run of TetGen with -d says cross or are the same.
std::vector<std::pair<Index, Index>> crossing_facets(const std::string& output, Index facets);

} // namespace polydec
