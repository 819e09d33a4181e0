// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/gmsh_source.h"

#include <cstdint>
#include <string_view>

namespace polydec {

/// The cells that are read, by Gmsh's number of their type.
struct GmshKind {
    int type = 0;
    int dimension = 0;
    int corners = 0;
    int nodes = 0; ///< the corners and, of cells of higher order, others behind them
};

/// Throws InvalidInput for cells of other types: leaving them out would silently make a hole.
const GmshKind& gmsh_kind(std::int64_t type, const GmshSource& source);

/// Whether a word begins a section, or ends one: a dollar sign and a name.
bool is_gmsh_keyword(std::string_view word);

/// What the first numbers of Nodes and Elements promise, in version 4.
struct GmshSection {
    std::int64_t blocks = 0;
    Index records = 0;
};
GmshSection read_gmsh_nodes(GmshSource& source);
GmshSection read_gmsh_elements(GmshSource& source);

/// Throws InvalidInput if the blocks had fewer records than promised.
void check_all_there(const GmshSource& source, const GmshSection& section, Index records,
                     std::string_view plural);

/// What stands in front of a block. All throw InvalidInput where it has more records than are left.
struct GmshNodeBlock {
    Index count = 0;
    int parameters = 0; ///< behind the coordinates of each node
};
GmshNodeBlock read_gmsh_node_block(GmshSource& source, Index before, Index promised);

struct GmshElementBlock {
    GmshKind kind;
    std::size_t entity_dimension = 0;
    std::int64_t entity = 0;
    Index count = 0;
};
GmshElementBlock read_gmsh_element_block(GmshSource& source, Index left);

/// The same of versions 1 and 2, where a text file has blocks of one element, and nodes have no
/// blocks.
Index read_old_gmsh_node_count(GmshSource& source);
Index read_old_gmsh_element_count(GmshSource& source);

struct OldGmshElementBlock {
    GmshKind kind;
    Index count = 1;
    std::int64_t tags = 0; ///< in front of the corners of each
};
OldGmshElementBlock read_old_gmsh_element_block(GmshSource& source, Index left);

} // namespace polydec
