// SPDX-License-Identifier: MIT
#include "io/meshes/gmsh_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace polydec {

const GmshKind& gmsh_kind(std::int64_t type, const GmshSource& source) {
    static constexpr std::array kinds{GmshKind{15, 0, 1}, GmshKind{1, 1, 2}, GmshKind{2, 2, 3},
                                      GmshKind{3, 2, 4}, GmshKind{4, 3, 4}};
    for (const auto& kind : kinds)
        if (kind.type == type)
            return kind;
    constexpr std::array solids{"hexahedra", "prisms", "pyramids"};
    if (type >= 5 && type <= 7) {
        source.fail(fmt::format("the mesh has {}; expected tetrahedra, triangles, quadrangles or "
                                "lines; split them before",
                                solids[static_cast<std::size_t>(type - 5)]));
    }
    source.fail(fmt::format("the mesh has cells of Gmsh's type {}, which are curved or of second "
                            "or higher order; expected lines, triangles, quadrangles or "
                            "tetrahedra of first order; set Mesh.ElementOrder = 1 and mesh again",
                            type));
}

bool is_gmsh_keyword(std::string_view word) {
    constexpr std::size_t longest = 60;
    const auto is_letter = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    };
    return word.size() > 1 && word.size() < longest && word[0] == '$' &&
           std::all_of(word.begin() + 1, word.end(), is_letter);
}

GmshSection read_gmsh_nodes(GmshSource& source) {
    const auto blocks = source.size("the number of blocks");
    const Index nodes = source.count("nodes", {.sizes = 1, .reals = 3});
    source.size("the least number of a node");
    source.size("the largest number of a node");
    return {blocks, nodes};
}

GmshSection read_gmsh_elements(GmshSource& source) {
    const auto blocks = source.size("the number of blocks");
    const Index elements = source.count("elements", {.sizes = 2});
    source.size("the least number of an element");
    source.size("the largest number of an element");
    return {blocks, elements};
}

void check_all_there(const GmshSource& source, const GmshSection& section, Index records,
                     std::string_view plural) {
    if (records < section.records) {
        source.fail(fmt::format("{} {} are promised, but the blocks have {}; expected as many; "
                                "export it again",
                                section.records, plural, records));
    }
}

GmshNodeBlock read_gmsh_node_block(GmshSource& source, Index before, Index promised) {
    const auto dimension = source.dimension();
    source.integer("the number of an entity");
    const bool has_parameters = source.integer("0, or 1 with parameters") != 0;
    const Index count = source.count("nodes of a block", {.sizes = 1, .reals = 3});
    if (count > promised - before) {
        source.fail(fmt::format("a block of {} nodes, but only {} of {} are left; expected the "
                                "sum that was promised; export it again",
                                count, promised - before, promised));
    }
    return {count, has_parameters ? static_cast<int>(dimension) : 0};
}

GmshElementBlock read_gmsh_element_block(GmshSource& source, Index left) {
    const auto dimension = source.dimension();
    const auto entity = source.integer("the number of an entity");
    const auto& kind = gmsh_kind(source.integer("the type of elements"), source);
    const auto corners = static_cast<std::size_t>(kind.corners);
    const Index count = source.count("elements of a block", {.sizes = 1 + corners});
    if (count > left) {
        source.fail(fmt::format("a block of {} elements, but only {} are left; expected the "
                                "sum that was promised; export it again",
                                count, left));
    }
    return {kind, dimension, entity, count};
}

Index read_old_gmsh_node_count(GmshSource& source) {
    return source.count_on_line("nodes", {.integers = 1, .reals = 3});
}

Index read_old_gmsh_element_count(GmshSource& source) {
    return source.count_on_line("elements", {.integers = 2});
}

OldGmshElementBlock read_old_gmsh_element_block(GmshSource& source, Index left) {
    const auto& kind = gmsh_kind(source.integer("the type of an element"), source);
    const auto count =
        source.format().order.has_value() ? source.integer("the number of elements") : 1;
    const auto tags = source.integer("the number of tags");
    if (count < 1 || count > left || tags < 0) {
        source.fail(fmt::format("a block of {} elements with {} tags, where {} elements are left; "
                                "expected numbers that fit; export it again",
                                count, tags, left));
    }
    return {kind, static_cast<Index>(count), tags};
}

} // namespace polydec
