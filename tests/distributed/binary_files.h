// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// How binary files of a mesh differ, as far as their formats have that.
struct BinaryKind {
    std::endian order = std::endian::little;
    bool is_old = false;       ///< Gmsh 2.2
    bool is_narrow = false;    ///< 4 bytes for numbers of records, floats for doubles
    bool is_scrambled = false; ///< nodes have numbers with gaps, in no order
    bool has_more = false;     ///< other properties, arrays, sections, and cells of the boundary
    int block = 1000;          ///< most records in a block
};

/// Triangles.
std::string binary_ply(const Mesh& mesh, const BinaryKind& kind);

/// Edges, triangles or tetrahedra.
std::string binary_gmsh(const Mesh& mesh, const BinaryKind& kind);
std::string binary_vtu(const Mesh& mesh, const BinaryKind& kind);

} // namespace polydec::test
