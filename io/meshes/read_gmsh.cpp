// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"
#include "io/meshes/gmsh_blocks.h"
#include "io/meshes/gmsh_groups.h"
#include "io/meshes/gmsh_source.h"
#include "io/meshes/readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace polydec {

namespace {

class GmshReader {
public:
    explicit GmshReader(const SourceFile& file) : file_(file), scanner_(file.name, file.text) {}

    Mesh read() {
        while (!scanner_.at_end())
            read_section();
        if (!has_elements_)
            scanner_.fail("the file ends without the section $Elements; expected $MeshFormat, "
                          "$Nodes and $Elements; export it again as MSH 4.1");
        Mesh mesh = std::move(cells_).mesh(std::move(points_), file_);
        mesh.groups = std::move(names_);
        return mesh;
    }

private:
    void read_section() {
        const Scanner place = scanner_;
        const auto keyword = scanner_.word("a section");
        if (!is_gmsh_keyword(keyword))
            place.fail(fmt::format(
                "{} is outside the sections; expected a keyword such as $Nodes; check the format",
                quote_word(keyword)));
        const auto name = keyword.substr(1);
        if (name == "MeshFormat") {
            require(place, !has_format_, "no other $MeshFormat");
            format_ = read_gmsh_format(scanner_);
            has_format_ = true;
        } else if (name == "PhysicalNames") {
            names_ = read_gmsh_names(scanner_, format_);
        } else if (name == "Entities" || name == "PartitionedEntities") {
            require(place, has_format_ && format_.major_version == 4, "$MeshFormat of version 4");
            auto source = open_section();
            groups_.read(source, name == "PartitionedEntities");
        } else if (name == "Nodes" || name == "NOD") {
            require(place, has_format_ != (name == "NOD") && !has_nodes_,
                    "$MeshFormat and no other $Nodes");
            read_nodes();
            has_nodes_ = true;
        } else if (name == "Elements" || name == "ELM") {
            require(place, has_nodes_ && has_format_ != (name == "ELM") && !has_elements_,
                    "$Nodes and no other $Elements");
            format_.major_version == 4 ? read_elements() : read_old_elements();
            has_elements_ = true;
        } else {
            skip_section(place, name);
        }
        read_end(name);
    }

    void require(const Scanner& place, bool fits, const char* before) const {
        if (!fits)
            place.fail(fmt::format(
                "a section at the wrong place; expected {} before it; check the format", before));
    }

    void read_end(std::string_view name) {
        const bool is_old = name == "NOD" || name == "ELM";
        const auto expected = fmt::format("${}{}", is_old ? "END" : "End", name);
        const auto word = scanner_.word(expected);
        if (word != expected)
            scanner_.fail(fmt::format(
                "{} where the section ends; expected {}; correct the number of its records",
                quote_word(word), expected));
    }

    void skip_section(const Scanner& place, std::string_view name) {
        if (name == "ParametricNodes")
            place.fail("the section $ParametricNodes of an old version; expected $Nodes; export it "
                       "again with -format msh41");
        const auto end = end_of_gmsh_section(scanner_.rest(), fmt::format("$End{}", name));
        if (end == std::string_view::npos)
            place.fail(fmt::format(
                "the section ${0} has no end; expected $End{0}; export it again, it seems cut off",
                name));
        scanner_.bytes(end, "a section");
    }

    void read_point(GmshSource& source, Index vertex) {
        for (int axis = 0; axis < 3; ++axis)
            points_(vertex, axis) =
                source.scanner().as_coordinate(source.real("a coordinate"), vertex);
    }

    /// In version 4, bytes begin behind the line of the keyword.
    GmshSource open_section() {
        if (format_.order && format_.major_version == 4)
            scanner_.end_line("the keyword of a section");
        return {scanner_, format_};
    }

    void read_nodes() {
        auto source = open_section();
        const auto section = read_gmsh_nodes(source);
        points_.resize(section.records, 3);
        Index begin = 0;
        for (std::int64_t block = 0; block < section.blocks; ++block)
            begin += read_node_block(source, begin);
        check_all_there(source, section, begin, "nodes");
        if (const auto twice = nodes_.close())
            source.fail(fmt::format(
                "the node {} occurs twice; expected each number once; renumber the nodes", *twice));
    }

    /// Numbers first, then places, each maybe with its parameters on the curve or surface; up to
    /// version 4.0 each place behind its number.
    Index read_node_block(GmshSource& source, Index begin) {
        const auto block = read_gmsh_node_block(source, begin, static_cast<Index>(points_.rows()));
        const bool numbers_first = format_.numbers_first();
        for (Index vertex = begin; numbers_first && vertex < begin + block.count; ++vertex)
            nodes_.add(source.number("the number of a node"), vertex);
        for (Index vertex = begin; vertex < begin + block.count; ++vertex) {
            if (!numbers_first)
                nodes_.add(source.number("the number of a node"), vertex);
            read_point(source, vertex);
            source.skip_reals(block.parameters);
        }
        return block.count;
    }

    void read_cell(GmshSource& source, const GmshKind& kind, Index tag) {
        std::array<Index, 8> corners{};
        for (int i = 0; i < kind.corners; ++i) {
            const auto number = source.number("a node of an element");
            const auto vertex = nodes_.find(number);
            if (!vertex)
                source.fail(fmt::format("the node {} is not in the section $Nodes; expected one of "
                                        "its numbers; correct it or add the node",
                                        number));
            corners[i] = *vertex;
        }
        cells_.add(kind.dimension, std::span(corners).first(kind.corners), tag);
        for (int i = kind.corners; i < kind.nodes; ++i)
            source.number("a node of an element");
        cells_.leave_out_nodes(kind.nodes - kind.corners);
    }

    void read_elements() {
        auto source = open_section();
        const auto section = read_gmsh_elements(source);
        Index count = 0;
        for (std::int64_t block = 0; block < section.blocks; ++block)
            count += read_element_block(source, section.records - count);
        check_all_there(source, section, count, "elements");
    }

    Index read_element_block(GmshSource& source, Index left) {
        const auto block = read_gmsh_element_block(source, left);
        const auto tags = groups_.tags_of(block.entity_dimension, block.entity);
        for (Index element = 0; element < block.count; ++element) {
            source.number("the number of an element");
            read_cell(source, block.kind, tags.front());
            for (const Index other : tags.subspan(1))
                cells_.add_tag(block.kind.dimension, other);
        }
        return block.count;
    }

    /// In versions 1 and 2 each element has tags of its own, the physical group first. A binary
    /// file puts type and number of tags in front of elements that share them.
    void read_old_elements() {
        GmshSource source(scanner_, format_);
        const bool is_binary = format_.order.has_value();
        const Index elements = read_gmsh_elements(source).records;
        for (Index element = 0; element < elements;) {
            if (!is_binary)
                source.integer("the number of an element");
            const auto block = read_old_gmsh_element_block(source, elements - element);
            for (Index i = 0; i < block.count; ++i) {
                if (is_binary)
                    source.integer("the number of an element");
                const Index tag = read_tags(source, block.tags);
                if (format_.major_version == 1)
                    read_number_of_nodes(source, block.kind);
                read_cell(source, block.kind, tag);
            }
            element += block.count;
        }
    }

    static void read_number_of_nodes(GmshSource& source, const GmshKind& kind) {
        const auto nodes = source.integer("the number of nodes");
        if (nodes != kind.nodes)
            source.fail(fmt::format(
                "an element of Gmsh's type {1} has {0} nodes; expected {2}; export it again", nodes,
                kind.type, kind.nodes));
    }

    static Index read_tags(GmshSource& source, std::int64_t count) {
        Index first = 0;
        for (std::int64_t i = 0; i < count; ++i) {
            const auto tag = source.integer("a tag");
            first = i == 0 ? group_tag(tag, source) : first;
        }
        return first;
    }

    const SourceFile& file_;
    Scanner scanner_;
    GmshFormat format_;
    bool has_format_ = false;
    bool has_elements_ = false;
    bool has_nodes_ = false;
    GmshGroups groups_;
    std::vector<GroupName> names_;
    Points points_;
    NumberTable nodes_;
    CellLists cells_;
};

} // namespace

Mesh read_gmsh(const SourceFile& file) {
    return GmshReader(file).read();
}

} // namespace polydec
