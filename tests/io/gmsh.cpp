// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "tests/io/bytes.h"
#include "tests/io/support.h"

namespace polydec::test::in_gmsh {

using Cells = std::vector<std::vector<Index>>;

/// How a file is written: version 2.2 or 4.1, as text or as bytes.
struct Variant {
    bool is_old;
    bool is_binary;
    std::endian order = std::endian::native;
    bool is_narrow = false; ///< numbers of records of 4 bytes
};

const std::array variants{
    Variant{true, false},
    Variant{true, true, std::endian::little},
    Variant{true, true, std::endian::big},
    Variant{false, false},
    Variant{false, true, std::endian::little},
    Variant{false, true, std::endian::big},
    Variant{false, true, std::endian::little, true},
};

class Writer {
public:
    explicit Writer(const Variant& variant) : variant_(variant) {
        text_ = std::string("$MeshFormat\n") + (variant.is_old ? "2.2 " : "4.1 ") +
                (variant.is_binary ? "1 " : "0 ") + (variant.is_narrow ? "4\n" : "8\n");
        if (variant.is_binary)
            text_ += bytes_of(std::int32_t{1}, variant.order) + "\n";
        text_ += "$EndMeshFormat\n";
    }

    Writer& line(const std::string& text) {
        text_ += text + "\n";
        return *this;
    }
    Writer& integer(std::int32_t value) { return put(value); }
    Writer& size(std::int64_t value) {
        return variant_.is_narrow ? put(static_cast<std::int32_t>(value)) : put(value);
    }
    Writer& real(double value) { return put(value); }

    const std::string& text() const { return text_; }

private:
    template <typename Number>
    Writer& put(Number value) {
        text_ += variant_.is_binary ? bytes_of(value, variant_.order) : std::to_string(value) + " ";
        return *this;
    }

    Variant variant_;
    std::string text_;
};

/// Numbers of nodes with gaps and out of order, and where they are.
const std::array<std::int32_t, 5> numbers{7, 3, 100, 12, 5};
const std::array<std::array<double, 3>, 5> places{
    {{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, 1}, {1, 1, 1.25}}};

/// Two tetrahedra in the groups 11 and 12, with a boundary triangle of group 40.
std::string old_file(const Variant& variant) {
    Writer writer(variant);
    writer.line("$Nodes").line("5");
    for (std::size_t i = 0; i < 5; ++i)
        writer.integer(numbers[i]).real(places[i][0]).real(places[i][1]).real(places[i][2]);
    writer.line("").line("$EndNodes").line("$Elements").line("3");
    const auto element = [&](int number, int type, int group, const std::vector<int>& nodes) {
        if (variant.is_binary)
            writer.integer(type).integer(1).integer(2).integer(number);
        else
            writer.integer(number).integer(type).integer(2);
        writer.integer(group).integer(1);
        for (const int node : nodes)
            writer.integer(node);
    };
    element(1, 2, 40, {7, 3, 100});
    element(2, 4, 11, {7, 3, 100, 12});
    element(3, 4, 12, {3, 100, 12, 5});
    return writer.line("").line("$EndElements").text();
}

Writer& entity(Writer& writer, int number, int reals, const std::vector<int>& groups) {
    writer.integer(number);
    for (int i = 0; i < reals; ++i)
        writer.real(0.5);
    writer.size(static_cast<std::int64_t>(groups.size()));
    for (const int group : groups)
        writer.integer(group);
    return writer;
}

std::string new_file(const Variant& variant, const std::vector<int>& second_groups = {12}) {
    Writer writer(variant);
    writer.line("$Entities").size(1).size(0).size(1).size(2);
    entity(writer, 1, 3, {});
    entity(writer, 6, 6, {40}).size(1).integer(-3);
    entity(writer, 2, 6, second_groups).size(0);
    entity(writer, 1, 6, {11}).size(2).integer(6).integer(-7);
    writer.line("").line("$EndEntities").line("$Nodes");

    // Two blocks of nodes, the second with its parameters on a surface.
    writer.size(2).size(5).size(3).size(100);
    for (const std::size_t block : {0U, 1U}) {
        writer.integer(block == 0 ? 3 : 2).integer(1).integer(block == 0 ? 0 : 1);
        const std::size_t begin = block == 0 ? 0 : 3;
        const std::size_t end = block == 0 ? 3 : 5;
        writer.size(static_cast<std::int64_t>(end - begin));
        for (std::size_t i = begin; i < end; ++i)
            writer.size(numbers[i]);
        for (std::size_t i = begin; i < end; ++i) {
            writer.real(places[i][0]).real(places[i][1]).real(places[i][2]);
            for (std::size_t parameter = 0; parameter < 2 * block; ++parameter)
                writer.real(0.25);
        }
    }
    writer.line("").line("$EndNodes").line("$Elements").size(3).size(3).size(1).size(3);
    writer.integer(2).integer(6).integer(2).size(1).size(1).size(7).size(3).size(100);
    writer.integer(3).integer(1).integer(4).size(1).size(2).size(7).size(3).size(100).size(12);
    writer.integer(3).integer(2).integer(4).size(1).size(3).size(3).size(100).size(12).size(5);
    return writer.line("").line("$EndElements").text();
}

std::string file_of(const Variant& variant) {
    return variant.is_old ? old_file(variant) : new_file(variant);
}

const std::string old_start = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string new_start = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string square = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n";

TEST(Gmsh, TextAndBytesOfBothVersionsAndOrdersAreTheSame) {
    for (const auto& variant : variants) {
        const auto mesh = parse_mesh({"a.msh", file_of(variant)});
        ASSERT_EQ(mesh.points.rows(), 5);
        for (Eigen::Index i = 0; i < 5; ++i) {
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(mesh.points(i, axis),
                          places[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)]);
            }
        }
        expect_two_tetrahedra(mesh);
    }
}

TEST(Gmsh, TheMarkOfTheOrderIsNotAllThatIsRead) {
    // The twin of the proposition above: with the mark of the other order nothing fits.
    for (const auto& variant : variants) {
        if (variant.is_binary) {
            auto text = file_of(variant);
            const auto mark = text.find('\n', text.find('\n') + 1) + 1;
            std::reverse(text.begin() + static_cast<std::ptrdiff_t>(mark),
                         text.begin() + static_cast<std::ptrdiff_t>(mark) + 4);
            EXPECT_UNREADABLE("a.msh", text, "a.msh:");
        }
    }
}

TEST(Gmsh, TheFirstOfSeveralGroupsIsTheTagWhateverItsSign) {
    const auto mesh = parse_mesh({"a.msh", new_file(variants[3], {-9, 12})});
    EXPECT_EQ(mesh.tags, (std::vector<Index>{11, 9}));
    EXPECT_EACH_SAYS(mesh.warnings, {"1 second group", "cells", "first", "tag"});
}

TEST(Gmsh, FacetsAreInAllGroupsOfTheirCurve) {
    const std::string text =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 2 1 0\n3 0 0 0 0 1 0 2 6 7 0\n"
        "4 0 0 0 0 1 0 1 6 0\n5 0 0 0 1 1 0 1 9 0\n$EndEntities\n$Nodes\n1 4 1 4\n2 5 0 4\n"
        "1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n$Elements\n3 4 1 4\n1 3 1 1\n"
        "1 1 2\n1 4 1 1\n2 2 3\n2 5 2 2\n3 1 2 3\n4 1 3 4\n$EndElements\n";
    const auto mesh = parse_mesh({"a.msh", text});
    EXPECT_EQ(rows(mesh.facet_tags.simplices), (Cells{{0, 1}, {1, 2}, {0, 1}}));
    EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{6, 6, 7}));
    EXPECT_TRUE(mesh.warnings.empty());
}

TEST(Gmsh, GroupsHaveNamesOfAnySigns) {
    for (const auto& variant : variants) {
        auto text = file_of(variant);
        text.insert(text.find("$EndMeshFormat\n") + 15,
                    "$PhysicalNames\n3\n2 40 \"a wall, $EndMeshFormat\"\n3 -11 \"\"\n 12 \"old\" \n"
                    "$EndPhysicalNames\n");
        const auto mesh = parse_mesh({"a.msh", text});
        ASSERT_EQ(mesh.groups.size(), 3U);
        EXPECT_EQ(mesh.groups[0].dimension, 2);
        EXPECT_EQ(mesh.groups[0].tag, 40);
        EXPECT_EQ(mesh.groups[0].name, "a wall, $EndMeshFormat");
        EXPECT_EQ(mesh.groups[1].tag, 11); // as those of cells
        EXPECT_EQ(mesh.groups[1].name, "");
        EXPECT_EQ(mesh.groups[2].dimension, -1); // of files of version 2.0
        EXPECT_EQ(group_tags(mesh.groups, 2, {"old", "40", "a wall, $EndMeshFormat"}),
                  (std::vector<Index>{12, 40, 40}));
        EXPECT_EQ(group_tags(mesh.groups, 3, {"", "old"}), (std::vector<Index>{11, 12}));
        EXPECT_THROW(group_tags(mesh.groups, 1, {"a wall, $EndMeshFormat"}), InvalidInput);
    }
    const std::string start = old_start + "$PhysicalNames\n";
    for (const char* name : {"\"wall", "wall"})
        EXPECT_UNREADABLE("a.msh", start + "1\n2 7 " + name + "\n$EndPhysicalNames\n", "a.msh:6",
                          "physical name", "quotes");
    EXPECT_UNREADABLE("a.msh", start + "1\n2 7", "a.msh:6");
    EXPECT_UNREADABLE("a.msh", start + "9000\n2 7 \"a\"\n", "9000 physical names");
}

TEST(Gmsh, WithoutGroupsThereAreNoTags) {
    const auto mesh = read_from("a.msh", old_start + square +
                                             "$Elements\n2\n1 2 0 1 2 3\n2 2 2 0 1 1 3 4\n"
                                             "$EndElements\n");
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(mesh.tags.empty());
    EXPECT_TRUE(mesh.facet_tags.tags.empty());
}

TEST(Gmsh, QuadranglesAreSplitAndTheirTagsFollow) {
    const auto mesh = read_from(
        "a.msh", old_start + "$Comments\nanything $EndComment\nnot $EndComments\n$EndComments\n" +
                     square +
                     "$Elements\n4\n1 15 2 1 1 1\n2 1 2 1 1 1 2\n3 3 2 8 1 1 2 3 4\n"
                     "4 2 2 -9 1 3 2 1\n$EndElements\n$NodeData\n1\n\"x\"\n$EndNodeData\n");
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 3}, {1, 2, 3}, {2, 1, 0}}));
    EXPECT_EQ(mesh.tags, (std::vector<Index>{8, 8, 9}));
    EXPECT_EQ(rows(mesh.facet_tags.simplices), (Cells{{0, 1}}));
    EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{1}));
}

TEST(Gmsh, GroupsOfFacetsAreKeptInEveryDimensionAndThoseOfLowerOnesLeftOut) {
    const std::string elements = "$Elements\n4\n1 15 2 5 1 2\n2 1 2 6 1 1 2\n3 1 2 -7 1 3 2\n";
    const auto curve =
        read_from("a.msh", old_start + square + elements + "4 15 2 0 1 3\n$EndElements\n");
    EXPECT_EQ(rows(curve.simplices), (Cells{{0, 1}, {2, 1}}));
    EXPECT_EQ(rows(curve.facet_tags.simplices), (Cells{{1}}));
    EXPECT_EQ(curve.facet_tags.tags, (std::vector<Index>{5}));
    const auto surface =
        read_from("a.msh", old_start + square + elements + "4 2 2 0 1 1 2 3\n$EndElements\n");
    EXPECT_EQ(rows(surface.facet_tags.simplices), (Cells{{0, 1}, {2, 1}}));
    EXPECT_EQ(surface.facet_tags.tags, (std::vector<Index>{6, 7}));
    EXPECT_TRUE(surface.tags.empty());
    const auto solid =
        read_from("a.msh", old_start + square + elements + "4 4 2 0 1 1 2 3 4\n$EndElements\n");
    EXPECT_TRUE(solid.facet_tags.tags.empty());
}

TEST(Gmsh, AFacetWithANodeThatIsNotThereIsRefused) {
    EXPECT_UNREADABLE("a.msh",
                      old_start + square +
                          "$Elements\n2\n1 1 2 6 1 1 9\n2 2 2 0 1 1 2 3\n"
                          "$EndElements\n",
                      "a.msh:13", "node 9", "$Nodes");
}

TEST(Gmsh, PartsOfAPartitionedModelHaveTheirGroups) {
    const std::string entities = "$PartitionedEntities\n2\n1\n9 2\n0 0 1 0\n"
                                 "5 2 1 2 1 2 0 0 0 1 1 0 1 77 3 1 2 3\n$EndPartitionedEntities\n";
    const std::string nodes = "$Nodes\n1 4 1 4\n2 5 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                              "$EndNodes\n";
    const auto mesh =
        read_from("a.msh", new_start + entities + nodes +
                               "$Elements\n1 1 1 1\n2 5 2 1\n1 1 2 3\n$EndElements\n");
    EXPECT_EQ(mesh.tags, (std::vector<Index>{77}));
}

TEST(Gmsh, RefusesCellsOfOtherShapes) {
    EXPECT_UNREADABLE("a.msh", old_start + square + "$Elements\n1\n1 34 0 1 2 3 4\n$EndElements\n",
                      "a.msh:13", "type 34", "order");
}

TEST(Gmsh, RefusesWhatDoesNotFit) {
    const std::string triangle = "$Elements\n1\n1 2 0 1 2 3\n$EndElements\n";
    EXPECT_UNREADABLE("a.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n", "a.msh:5", "ends", "$Elements");
    for (const char* version : {"3", "2.25", "4.2", "1"})
        EXPECT_UNREADABLE("a.msh",
                          std::string("$MeshFormat\n") + version + " 0 8\n$EndMeshFormat\n",
                          "a.msh:2", "version", version, "2.2", "4.0", "4.1");
    EXPECT_UNREADABLE("a.msh", "$MeshFormat\n2.2 2 8\n$EndMeshFormat\n", "a.msh:2", "type 2",
                      "size 8", "0", "1", "8");
    EXPECT_UNREADABLE("a.msh", "$MeshFormat\n2.2 1 8\nabcd\n$EndMeshFormat\n", "a.msh:3",
                      "number 1", "order of bytes");
    EXPECT_UNREADABLE("a.msh", square, "a.msh:1", "section", "$MeshFormat");
    EXPECT_UNREADABLE("a.msh", old_start + square, "a.msh:11", "ends", "$Elements");
    EXPECT_UNREADABLE("a.msh", old_start + square + "junk\n", "a.msh:11", "junk", "sections");
    EXPECT_UNREADABLE("a.msh", old_start + "$Views\n1\n" + triangle, "a.msh:4", "$Views",
                      "$EndViews");
    EXPECT_UNREADABLE("a.msh", old_start + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n", "a.msh:7",
                      "node 1", "twice");
    EXPECT_UNREADABLE("a.msh", old_start + "$Nodes\n1\n1 0 nan 0\n$EndNodes\n", "a.msh:6",
                      "vertex 0", "coordinate", "NaN");
    EXPECT_UNREADABLE("a.msh", old_start + square + "$Elements\n1\n1 2 0 1 2 9\n$EndElements\n",
                      "a.msh:13", "node 9", "$Nodes");
    EXPECT_UNREADABLE("a.msh",
                      old_start + square + "$Elements\n1\n1 2 0 1 2 3\n2 2 0 1 3 4\n$EndElements\n",
                      "a.msh:14", "2", "$EndElements");
    EXPECT_UNREADABLE("a.msh", old_start + "$Nodes\n2000000000\n1 0 0 0\n$EndNodes\n", "a.msh:5",
                      "2000000000 nodes", "19 bytes", "8 bytes");
    EXPECT_UNREADABLE("a.msh", new_start + "$Nodes\n1 2 1 2\n2 1 0 1\n1\n0 0 0\n$EndNodes\n",
                      "a.msh:8", "2 nodes", "1");
}

} // namespace polydec::test::in_gmsh
