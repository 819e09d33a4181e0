// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"
#include "meshes/polygons.h"

#include <filesystem>

namespace polydec {

/// Writes a mesh; the extension says the format. .nsc holds every mesh, and .pdm (binary,
/// with the tags of cells; see PdmLayout); .mesh (MEDIT) edges,
/// triangles and tetrahedra in R^2 and R^3, with their tags and facets with tags; .off, .obj, .ply
/// (ascii) and .stl (binary) triangles in R^2, where z becomes 0, and R^3, .obj edges too. Numbers
/// read back exactly, except in STL: its numbers are floats and it has no vertex numbers. Tags are
/// kept in MEDIT and .pdm alone. The file appears whole or not at all.
///
/// Throws InvalidInput if the mesh does not fit the format, has NaN or infinite coordinates or a
/// vertex number that is out of range, tags, but not one for each cell, or facets with tags that
/// are none (check_facet_tags); IoError if writing fails.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Writes polygons as .off, .obj or .ply (ascii) in R^N with N <= 3, where missing coordinates
/// become 0. Throws like the other one.
void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh);

} // namespace polydec
