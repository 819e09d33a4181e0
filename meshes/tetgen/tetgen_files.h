// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "meshes/tetgen/tetgen_input.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// The files exchanged with TetGen. The readers of mesh files know more formats with all variants,
/// but follow meshes/ in the order of layers; these know only TetGen's own output.
namespace polydec {

/// The input as .smesh, numbered from 0; triangles carry the numbers of their patches from 1.
std::string smesh_text(const TetgenInput& input);

/// Points, tetrahedra, and faces with their facets, as TetGen wrote them. Throw SolverFailure if a
/// file is not TetGen's: a link, a folder or a pipe, counts too large for its size, or numbers that
/// are missing, surplus or out of range.
Points read_tetgen_points(const std::filesystem::path& path);
Simplices read_tetgen_cells(const std::filesystem::path& path, Eigen::Index points);
std::pair<Simplices, std::vector<Index>> read_tetgen_faces(const std::filesystem::path& path,
                                                           Eigen::Index points, Index facets);

/// Pairs of facets, from 0 and each once, that a run of TetGen with -d reports as crossing or
/// equal.
std::vector<std::pair<Index, Index>> crossing_facets(const std::string& output, Index facets);

} // namespace polydec
