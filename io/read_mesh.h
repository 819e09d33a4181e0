// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <filesystem>

namespace polydec {

/// Reads a mesh; the extension says the format, in any case of its letters: .off, .obj, .ply
/// (ascii, binary of both byte orders) and .stl (ascii, binary) give triangles in R^3, .mesh
/// (MEDIT, ascii) its tetrahedra or else its triangles or else its edges, .nsc simplices of any
/// dimension.
///
/// Vertices keep their numbers; an STL file has none, so that equal points become one vertex,
/// numbered by first appearance. Polygons are split as `split_polygons` does. Nothing else is
/// repaired: double cells, cells without volume and unused vertices are left for the checks of the
/// complex.
///
/// Throws IoError if the file cannot be read, InvalidInput "path:line: what; expected; advice" if
/// it is malformed, has coordinates that are not finite, no vertices or no cells.
Mesh read_mesh(const std::filesystem::path& path);

} // namespace polydec
