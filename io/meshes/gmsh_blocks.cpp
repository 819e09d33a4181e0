// SPDX-License-Identifier: MIT
#include "io/meshes/gmsh_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace polydec {

namespace {

using Kind = GmshKind;

/// Corners come first in all orders.
constexpr std::array kinds{
    Kind{15, 0, 1, 1},   Kind{1, 1, 2, 2},   Kind{8, 1, 2, 3},    Kind{26, 1, 2, 4},
    Kind{27, 1, 2, 5},   Kind{28, 1, 2, 6},  Kind{2, 2, 3, 3},    Kind{9, 2, 3, 6},
    Kind{20, 2, 3, 9},   Kind{21, 2, 3, 10}, Kind{22, 2, 3, 12},  Kind{23, 2, 3, 15},
    Kind{24, 2, 3, 15},  Kind{25, 2, 3, 21}, Kind{3, 2, 4, 4},    Kind{10, 2, 4, 9},
    Kind{16, 2, 4, 8},   Kind{36, 2, 4, 16}, Kind{37, 2, 4, 25},  Kind{38, 2, 4, 36},
    Kind{39, 2, 4, 12},  Kind{4, 3, 4, 4},   Kind{11, 3, 4, 10},  Kind{29, 3, 4, 20},
    Kind{30, 3, 4, 35},  Kind{31, 3, 4, 56}, Kind{5, 3, 8, 8},    Kind{12, 3, 8, 27},
    Kind{17, 3, 8, 20},  Kind{92, 3, 8, 64}, Kind{93, 3, 8, 125}, Kind{6, 3, 6, 6},
    Kind{13, 3, 6, 18},  Kind{18, 3, 6, 15}, Kind{90, 3, 6, 40},  Kind{91, 3, 6, 75},
    Kind{7, 3, 5, 5},    Kind{14, 3, 5, 14}, Kind{19, 3, 5, 13},  Kind{118, 3, 5, 30},
    Kind{119, 3, 5, 55},
};

/// Refuses other types of cells: leaving them out would silently leave a hole.
const Kind& kind_of(std::int64_t type, const GmshSource& source) {
    for (const auto& kind : kinds)
        if (kind.type == type)
            return kind;
    source.fail(fmt::format("the mesh has cells of Gmsh's type {}; expected lines, triangles, "
                            "quadrangles, tetrahedra, hexahedra, prisms or pyramids, of order 4 at "
                            "most; set Mesh.ElementOrder = 1 and mesh again",
                            type));
}

GmshSection read_counts(GmshSource& source, std::string_view plural, std::string_view one,
                        const GmshSource::Record& record) {
    if (source.format().major_version < 4)
        return {1, source.count_on_line(plural, record)};
    const auto blocks = source.size("the number of blocks");
    const Index records = source.count(plural, record);
    if (!source.format().is_4_0()) {
        source.size(fmt::format("the least number of {}", one));
        source.size(fmt::format("the largest number of {}", one));
    }
    return {blocks, records};
}

std::pair<std::size_t, std::int64_t> read_entity(GmshSource& source) {
    const bool number_first = source.format().is_4_0();
    std::int64_t number = number_first ? source.integer("the number of an entity") : 0;
    const auto dimension = source.dimension();
    if (!number_first)
        number = source.integer("the number of an entity");
    return {dimension, number};
}

} // namespace

bool is_gmsh_keyword(std::string_view word) {
    constexpr std::size_t longest = 60;
    const auto is_letter = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    };
    return word.size() > 1 && word.size() < longest && word[0] == '$' &&
           std::all_of(word.begin() + 1, word.end(), is_letter);
}

std::size_t end_of_gmsh_section(std::string_view text, std::string_view mark) {
    auto end = text.find(mark);
    while (end != std::string_view::npos &&
           (end == 0 || (text[end - 1] != '\n' && text[end - 1] != '\r')))
        end = text.find(mark, end + 1);
    return end;
}

GmshSection read_gmsh_nodes(GmshSource& source) {
    return read_counts(source, "nodes", "a node", {.integers = 1, .reals = 3});
}

GmshSection read_gmsh_elements(GmshSource& source) {
    return read_counts(source, "elements", "an element", {.integers = 2});
}

void check_all_there(const GmshSource& source, const GmshSection& section, Index records,
                     std::string_view plural) {
    if (records < section.records)
        source.fail(fmt::format("the section announces {} {}, but its blocks have {}; expected "
                                "equal numbers; export it again",
                                section.records, plural, records));
}

GmshNodeBlock read_gmsh_node_block(GmshSource& source, Index before, Index promised) {
    if (source.format().major_version < 4)
        return {promised, 0};
    const auto [dimension, entity] = read_entity(source);
    const bool has_parameters = source.integer("0, or 1 with parameters") != 0;
    const Index count = source.count("nodes of a block", {.integers = 1, .reals = 3});
    if (count > promised - before)
        source.fail(fmt::format("a block of {} nodes, but only {} of {} are left; expected the "
                                "announced total; export it again",
                                count, promised - before, promised));
    return {count, has_parameters ? static_cast<int>(dimension) : 0};
}

GmshElementBlock read_gmsh_element_block(GmshSource& source, Index left) {
    const auto [dimension, entity] = read_entity(source);
    const Kind& kind = kind_of(source.integer("the type of elements"), source);
    const auto nodes = static_cast<std::size_t>(kind.nodes);
    const Index count = source.count("elements of a block", {.integers = 1 + nodes});
    if (count > left)
        source.fail(fmt::format("a block of {} elements, but only {} are left; expected the "
                                "announced total; export it again",
                                count, left));
    return {kind, dimension, entity, count};
}

OldGmshElementBlock read_old_gmsh_element_block(GmshSource& source, Index left) {
    const Kind& kind = kind_of(source.integer("the type of an element"), source);
    if (source.format().major_version == 1)
        return {kind, 1, 2}; // and behind the tags the number of nodes
    const auto count =
        source.format().order.has_value() ? source.integer("the number of elements") : 1;
    const auto tags = source.integer("the number of tags");
    if (count < 1 || count > left || tags < 0)
        source.fail(fmt::format("a block of {} elements with {} tags, but only {} elements are "
                                "left; expected the announced total; export it again",
                                count, tags, left));
    return {kind, static_cast<Index>(count), tags};
}

} // namespace polydec
