// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"
#include "io/meshes/gmsh_groups.h"
#include "io/meshes/gmsh_source.h"
#include "io/meshes/readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

namespace polydec {

namespace {

/// The cells that are read, by Gmsh's number of their type.
struct Kind {
    int type;
    int dimension;
    int corners;
};

constexpr std::array kinds{Kind{15, 0, 1}, Kind{1, 1, 2}, Kind{2, 2, 3}, Kind{3, 2, 4},
                           Kind{4, 3, 4}};

/// Leaving other cells out would silently make a hole in the mesh.
const Kind& kind_of(std::int64_t type, const GmshSource& source) {
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

/// A section begins with a dollar sign and a name.
bool is_keyword(std::string_view word) {
    constexpr std::size_t longest = 60;
    const auto is_letter = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    };
    return word.size() > 1 && word.size() < longest && word[0] == '$' &&
           std::all_of(word.begin() + 1, word.end(), is_letter);
}

class GmshReader {
public:
    explicit GmshReader(const SourceFile& file) : file_(file), scanner_(file.name, file.text) {}

    Mesh read() {
        while (!scanner_.at_end())
            read_section();
        if (!has_elements_) {
            scanner_.fail("the file ends without the section $Elements; expected $MeshFormat, "
                          "$Nodes and $Elements; export it again as MSH 2.2 or 4.1");
        }
        Mesh mesh = std::move(cells_).mesh(std::move(points_));
        if (groups_.ambiguous() > 0) {
            mesh.warnings.push_back(fmt::format("entities of the model in more than one "
                                                "physical group, of which the first is the tag: {}",
                                                groups_.ambiguous()));
        }
        return mesh;
    }

private:
    void read_section() {
        const Scanner place = scanner_;
        const auto keyword = scanner_.word("a section");
        if (!is_keyword(keyword)) {
            place.fail(fmt::format("{} stands outside of the sections; expected a keyword such as "
                                   "$Nodes; check the format",
                                   quote_word(keyword)));
        }
        const auto name = keyword.substr(1);
        if (name == "MeshFormat") {
            require(place, !has_format_, "no other $MeshFormat");
            format_ = read_gmsh_format(scanner_);
            has_format_ = true;
        } else if (name == "Entities" || name == "PartitionedEntities") {
            require(place, has_format_ && format_.major_version == 4, "$MeshFormat of version 4.1");
            auto source = open_section();
            groups_.read(source, name == "PartitionedEntities");
        } else if (name == "Nodes") {
            require(place, has_format_ && !has_nodes_, "$MeshFormat and no other $Nodes");
            format_.major_version == 4 ? read_nodes() : read_old_nodes();
            has_nodes_ = true;
        } else if (name == "Elements") {
            require(place, has_nodes_ && !has_elements_, "$Nodes and no other $Elements");
            format_.major_version == 4 ? read_elements() : read_old_elements();
            has_elements_ = true;
        } else {
            skip_section(place, name);
        }
        read_end(name);
    }

    void require(const Scanner& place, bool fits, const char* before) const {
        if (!fits) {
            place.fail(fmt::format("a section at the wrong place; expected {} before it; check "
                                   "the format",
                                   before));
        }
    }

    void read_end(std::string_view name) {
        const auto expected = fmt::format("$End{}", name);
        const auto word = scanner_.word(expected);
        if (word != expected) {
            scanner_.fail(fmt::format("{} where the section ends; expected {}; correct the number "
                                      "of its records",
                                      quote_word(word), expected));
        }
    }

    /// What a skipped section holds may be bytes; its end is looked for at the beginning of a line.
    void skip_section(const Scanner& place, std::string_view name) {
        if (name == "NOD" || name == "ParametricNodes") {
            place.fail(fmt::format("the section ${} of an old version; expected MSH 2.2 or 4.1; "
                                   "export it again with -format msh41",
                                   name));
        }
        const auto rest = scanner_.rest();
        const auto mark = fmt::format("$End{}", name);
        auto end = rest.find(mark);
        while (end != std::string_view::npos && rest[end - 1] != '\n' && rest[end - 1] != '\r')
            end = rest.find(mark, end + 1);
        if (end == std::string_view::npos) {
            place.fail(fmt::format("the section ${0} has no end; expected $End{0}; export it "
                                   "again, it seems cut off",
                                   name));
        }
        scanner_.bytes(end, "a section");
    }

    void read_point(GmshSource& source, Index vertex) {
        for (int axis = 0; axis < 3; ++axis) {
            points_(vertex, axis) =
                source.scanner().as_coordinate(source.real("a coordinate"), vertex);
        }
    }

    void close_nodes(const GmshSource& source) {
        if (const auto twice = nodes_.close()) {
            source.fail(fmt::format("the node {} is there twice; expected every number once; "
                                    "number the nodes again",
                                    *twice));
        }
    }

    /// In version 4, bytes begin behind the line of the keyword.
    GmshSource open_section() {
        if (format_.order)
            scanner_.end_line("the keyword of a section");
        return {scanner_, format_};
    }

    /// In version 2, the number of records is text even where these are bytes.
    Index old_count(const char* plural, const GmshSource::Record& record) {
        const Index count = scanner_.count(plural, 0);
        GmshSource(scanner_, format_).check(count, plural, record);
        scanner_.end_line("the line of their number");
        return count;
    }

    void read_old_nodes() {
        GmshSource source(scanner_, format_);
        points_.resize(old_count("nodes", {.integers = 1, .reals = 3}), 3);
        for (Index vertex = 0; vertex < points_.rows(); ++vertex) {
            nodes_.add(source.integer("the number of a node"), vertex);
            read_point(source, vertex);
        }
        close_nodes(source);
    }

    void read_nodes() {
        auto source = open_section();
        const auto blocks = source.size("the number of blocks");
        points_.resize(source.count("nodes", {.sizes = 1, .reals = 3}), 3);
        source.size("the least number of a node");
        source.size("the largest number of a node");
        Index begin = 0;
        for (std::int64_t block = 0; block < blocks; ++block)
            begin += read_node_block(source, begin);
        if (begin < points_.rows()) {
            source.fail(fmt::format("{} nodes are promised, but the blocks have {}; expected as "
                                    "many; export it again",
                                    points_.rows(), begin));
        }
        close_nodes(source);
    }

    /// Numbers first, then places, each maybe with its parameters on the curve or surface.
    Index read_node_block(GmshSource& source, Index begin) {
        const auto dimension = source.dimension();
        source.integer("the number of an entity");
        const bool has_parameters = source.integer("0, or 1 with parameters") != 0;
        const Index count = source.count("nodes of a block", {.sizes = 1, .reals = 3});
        if (count > points_.rows() - begin) {
            source.fail(fmt::format("a block of {} nodes, but only {} of {} are left; expected the "
                                    "sum that was promised; export it again",
                                    count, points_.rows() - begin, points_.rows()));
        }
        for (Index vertex = begin; vertex < begin + count; ++vertex)
            nodes_.add(source.size("the number of a node"), vertex);
        for (Index vertex = begin; vertex < begin + count; ++vertex) {
            read_point(source, vertex);
            source.skip_reals(has_parameters ? static_cast<int>(dimension) : 0);
        }
        return count;
    }

    void read_cell(GmshSource& source, const Kind& kind, Index tag) {
        std::array<Index, 4> corners{};
        for (int i = 0; i < kind.corners; ++i) {
            const auto number = source.size("a node of an element");
            const auto vertex = nodes_.find(number);
            if (!vertex) {
                source.fail(fmt::format("the node {} is not in the section $Nodes; expected one "
                                        "of its numbers; correct it or add the node",
                                        number));
            }
            corners[static_cast<std::size_t>(i)] = *vertex;
        }
        cells_.add(kind.dimension, std::span(corners).first(static_cast<std::size_t>(kind.corners)),
                   tag, file_);
    }

    void read_elements() {
        auto source = open_section();
        const auto blocks = source.size("the number of blocks");
        const Index promised = source.count("elements", {.sizes = 2});
        source.size("the least number of an element");
        source.size("the largest number of an element");
        Index count = 0;
        for (std::int64_t block = 0; block < blocks; ++block)
            count += read_element_block(source, promised - count);
        if (count < promised) {
            source.fail(fmt::format("{} elements are promised, but the blocks have {}; expected "
                                    "as many; export it again",
                                    promised, count));
        }
    }

    Index read_element_block(GmshSource& source, Index most) {
        const auto dimension = source.dimension();
        const auto entity = source.integer("the number of an entity");
        const auto& kind = kind_of(source.integer("the type of elements"), source);
        const auto corners = static_cast<std::size_t>(kind.corners);
        const Index count = source.count("elements of a block", {.sizes = 1 + corners});
        if (count > most) {
            source.fail(fmt::format("a block of {} elements, but only {} are left; expected the "
                                    "sum that was promised; export it again",
                                    count, most));
        }
        const Index tag = groups_.tag_of(dimension, entity);
        for (Index element = 0; element < count; ++element) {
            source.size("the number of an element");
            read_cell(source, kind, tag);
        }
        return count;
    }

    /// In version 2 each element has tags of its own, the physical group first. A binary file puts
    /// type and number of tags in front of elements that share them.
    void read_old_elements() {
        GmshSource source(scanner_, format_);
        const bool is_binary = format_.order.has_value();
        const Index elements = old_count("elements", {.integers = 2});
        for (Index element = 0; element < elements;) {
            if (!is_binary)
                source.integer("the number of an element");
            const auto& kind = kind_of(source.integer("the type of an element"), source);
            const auto block = is_binary ? source.integer("the number of elements") : 1;
            const auto tags = source.integer("the number of tags");
            if (block < 1 || block > elements - element || tags < 0) {
                source.fail(fmt::format("a block of {} elements with {} tags, where {} elements "
                                        "are left; expected numbers that fit; export it again",
                                        block, tags, elements - element));
            }
            for (std::int64_t i = 0; i < block; ++i) {
                if (is_binary)
                    source.integer("the number of an element");
                read_cell(source, kind, read_tags(source, tags));
            }
            element += static_cast<Index>(block);
        }
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
    Points points_;
    NumberTable nodes_;
    CellLists cells_;
};

} // namespace

Mesh read_gmsh(const SourceFile& file) {
    return GmshReader(file).read();
}

} // namespace polydec
