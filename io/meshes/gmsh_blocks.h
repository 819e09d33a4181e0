// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/gmsh_source.h"

#include <cstdint>
#include <string_view>

namespace polydec {

/// The supported cells, by Gmsh's type number.
struct GmshKind {
    int type = 0;
    int dimension = 0;
    int corners = 0;
    int nodes = 0; ///< the corners, then for higher-order cells the other nodes
};

/// Whether a word begins or ends a section: a dollar sign and a name.
bool is_gmsh_keyword(std::string_view word);

/// Where a mark such as $EndNodes stands at the beginning of a line; npos if nowhere. A section
/// that is skipped may hold bytes.
std::size_t end_of_gmsh_section(std::string_view text, std::string_view mark);

/// The counts at the start of the sections Nodes and Elements; before version 4 all nodes are one
/// block, without a header.
struct GmshSection {
    std::int64_t blocks = 1;
    Index records = 0;
};
GmshSection read_gmsh_nodes(GmshSource& source);
GmshSection read_gmsh_elements(GmshSource& source);

/// Throws InvalidInput if the blocks had fewer records than announced.
void check_all_there(const GmshSource& source, const GmshSection& section, Index records,
                     std::string_view plural);

/// The header of a block. All readers throw InvalidInput if a block has more records than are left.
struct GmshNodeBlock {
    Index count = 0;
    int parameters = 0; ///< after the coordinates of each node
};
GmshNodeBlock read_gmsh_node_block(GmshSource& source, Index before, Index promised);

struct GmshElementBlock {
    GmshKind kind;
    std::size_t entity_dimension = 0;
    std::int64_t entity = 0;
    Index count = 0;
};
GmshElementBlock read_gmsh_element_block(GmshSource& source, Index left);

/// The same for versions 1 and 2. In text files each element is its own block.
struct OldGmshElementBlock {
    GmshKind kind;
    Index count = 1;
    std::int64_t tags = 0; ///< before the corners of each
};
OldGmshElementBlock read_old_gmsh_element_block(GmshSource& source, Index left);

} // namespace polydec
