// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"
#include "meshes/polygons.h"

#include <filesystem>

namespace polydec {

/// Writes a mesh in the format of the extension. .nsc holds every mesh, and so does .pdm (binary,
/// with the tags of cells; see PdmLayout). .mesh (MEDIT) holds edges, triangles and tetrahedra in
/// R^2 and R^3, with tags and tagged facets; .off, .obj, .ply and .stl (both binary) hold triangles
/// in R^2 (with z = 0) and R^3; .obj also edges. Numbers read back exactly, except in
/// STL, which has floats and no vertex numbers. Only MEDIT and .pdm keep tags. The file appears
/// whole or not at all.
///
/// Throws InvalidInput if the format cannot hold the mesh, for NaN or infinite coordinates, a
/// vertex number out of range, a wrong number of tags, or like check_facet_tags; IoError if writing
/// fails.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Writes polygons as .off, .obj or .ply (binary) in R^N with N <= 3; missing coordinates become 0.
/// Throws like the other overload.
void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh);

} // namespace polydec
