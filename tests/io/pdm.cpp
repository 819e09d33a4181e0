// SPDX-License-Identifier: MIT
#include "io/meshes/pdm.h"

#include "tests/io/support.h"

#include <rapidcheck.h>

namespace polydec::test::in_pdm {

Mesh any_tagged_mesh() {
    const int ambient = *rc::gen::inRange(1, 6), dimension = *rc::gen::inRange(1, ambient + 1);
    const int vertices = *rc::gen::inRange(dimension + 1, 40), cells = *rc::gen::inRange(1, 40);
    Mesh mesh;
    mesh.points = Points::NullaryExpr(
        vertices, ambient, [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 7; });
    mesh.simplices = Simplices::NullaryExpr(cells, dimension + 1,
                                            [vertices] { return *rc::gen::inRange(0, vertices); });
    for (int cell = 0; cell < cells && *rc::gen::inRange(0, 1) == 0; ++cell)
        mesh.tags.push_back(*rc::gen::inRange(0, 5));
    return mesh;
}

/// Large enough for several blocks of bytes.
Mesh large_mesh() {
    constexpr Index vertices = 50000, cells = 90000;
    Mesh mesh;
    mesh.points = Points::NullaryExpr(vertices, 3, [](Eigen::Index i, Eigen::Index j) {
        return 0.5 * static_cast<double>(i) + 0.25 * static_cast<double>(j);
    });
    mesh.simplices = Simplices::NullaryExpr(cells, 4, [](Eigen::Index i, Eigen::Index j) {
        return static_cast<Index>((i * 7 + j) % vertices);
    });
    return mesh;
}

TEST(Pdm, EveryMeshReadsBackExactlyWithItsTags) {
    EXPECT_TRUE(rc::check([] {
        const Mesh mesh = any_tagged_mesh();
        const TemporaryFolder folder;
        write_mesh(folder.path("a.pdm"), mesh);
        const Mesh read = read_mesh(folder.path("a.pdm"));
        RC_ASSERT(same(read, mesh));
        RC_ASSERT(read.tags == mesh.tags);
    }));
}

TEST(Pdm, AnyPartIsThatOfTheWhole) {
    const TemporaryFolder folder;
    const Mesh mesh = large_mesh();
    write_mesh(folder.path("a.pdm"), mesh);
    const std::string text = read_text(folder.path("a.pdm"));
    const PdmReader reader({"a.pdm", std::ssize(text), [&](std::int64_t begin, std::int64_t end) {
                                return text.substr(static_cast<std::size_t>(begin),
                                                   static_cast<std::size_t>(end - begin));
                            }});
    EXPECT_GT(reader.layout().blocks(), 2);
    for (const auto& [begin, end] : {std::pair{0, 1}, {43680, 43700}, {49999, 50000}, {7, 7}})
        EXPECT_EQ(reader.points(begin, end), mesh.points.middleRows(begin, end - begin));
    for (const auto& [begin, end] : {std::pair{0, 2}, {40000, 90000}, {89999, 90000}}) {
        const auto corners = reader.cells(begin, end);
        for (Index i = begin; i < end; ++i)
            for (int j = 0; j < 4; ++j)
                ASSERT_EQ(corners[4 * (i - begin) + j], mesh.simplices(i, j));
    }
}

TEST(Pdm, CutAnywhereItIsRefused) {
    const TemporaryFolder folder;
    write_mesh(folder.path("a.pdm"), large_mesh());
    const std::string text = read_text(folder.path("a.pdm"));
    std::vector<std::size_t> lengths{0, 1, 7, 8, 64, 127, 128, text.size() - 1};
    for (std::size_t edge = 128; edge < text.size(); edge += PdmLayout::block_bytes)
        lengths.insert(lengths.end(), {edge - 1, edge, edge + 1});
    for (const std::size_t length : lengths) {
        const auto path = folder.write("b.pdm", text.substr(0, length));
        EXPECT_NE(error_of([&] { read_mesh(path); }), "") << length;
    }
    const auto path = folder.write("b.pdm", text + "x");
    EXPECT_SAYS(error_of([&] { read_mesh(path); }), "cut off");
}

TEST(Pdm, NoByteThatCountsCanChangeUnseen) {
    const TemporaryFolder folder;
    write_mesh(folder.path("a.pdm"),
               {Points{{0, 0}, {1, 0}, {0, 1}}, Simplices{{0, 1, 2}}, {}, {4}});
    const std::string text = read_text(folder.path("a.pdm"));
    constexpr std::size_t padding_begin = 68, padding_end = 128;
    for (std::size_t place = 0; place < text.size(); ++place) {
        std::string damaged = text;
        damaged[place] = static_cast<char>(damaged[place] ^ 16);
        const auto path = folder.write("b.pdm", damaged);
        const bool is_padding = place >= padding_begin && place < padding_end;
        EXPECT_EQ(error_of([&] { read_mesh(path); }).empty(), is_padding) << place;
    }
}

} // namespace polydec::test::in_pdm
