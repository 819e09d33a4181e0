// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace polydec::test {

struct NamedMesh {
    std::string name; ///< letters, digits, underscores
    Mesh mesh;
};

/// The family that laws are checked on: n = 1..5, flat and curved, closed and bounded, obtuse,
/// branching, pinched, non-orientable, of several components; golden, generated, made by hand.
/// Nothing in it is untidy but unused vertex numbers.
const std::vector<NamedMesh>& meshes();

/// One of the family. Throws std::out_of_range if there is none of that name.
const Mesh& mesh_named(std::string_view name);

/// The names of all of them.
std::vector<std::string> names_of_meshes();

/// Whether the mesh is full-dimensional, N = n, so that every merged cell is flat.
bool is_flat(const Mesh& mesh);

} // namespace polydec::test
