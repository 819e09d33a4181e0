// SPDX-License-Identifier: MIT
#include "distributed/mesh_file.h"

#include "tests/distributed/common_folder.h"
#include "tests/distributed/compare.h"
#include "tests/io/support.h"

namespace polydec::test::in_mesh_file {

bool same(const MeshSlice& a, const MeshSlice& b) {
    return a.vertices == b.vertices && a.cells == b.cells && a.points == b.points &&
           a.simplices == b.simplices && a.tags == b.tags;
}

TEST(MeshFiles, ranks_write_the_bytes_of_one_process_and_read_their_own) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    for (auto [name, mesh] : meshes()) {
        for (Index t = 0; t < mesh.simplices.rows() && name.size() % 2 == 0; ++t)
            mesh.tags.push_back(t % 5 - 2);
        const MeshSlice slice = slice_of(ranks, mesh);
        write_slice(ranks, folder / "shared.pdm", slice);
        on_rank_0(ranks, [&, given = mesh] {
            write_mesh(folder / "one.pdm", given);
            EXPECT_TRUE(read_text(folder / "one.pdm") == read_text(folder / "shared.pdm"));
        });
        EXPECT_TRUE(same(read_slice(ranks, folder / "shared.pdm"), slice)) << name;
    }
}

TEST(MeshFiles, one_of_several_blocks_goes_to_every_rank_and_a_cut_is_told_by_all) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    Mesh mesh; // of three blocks and a bit
    mesh.points = Points::NullaryExpr(90000, 3, [](Eigen::Index i, Eigen::Index j) {
        return static_cast<double>(j == 0 ? i : i * i % (7 + 4 * j));
    });
    mesh.simplices = Simplices::NullaryExpr(100000, 3, [](Eigen::Index i, Eigen::Index j) {
        return static_cast<Index>((i + j + (i >= 90000 && j == 2 ? 1 : 0)) % 90000);
    });
    const MeshSlice slice = slice_of(ranks, mesh);
    write_slice(ranks, folder / "a.pdm", slice);
    EXPECT_TRUE(same(read_slice(ranks, folder / "a.pdm"), slice));

    const std::string text = read_text(folder / "a.pdm");
    for (const std::size_t place : {std::size_t{5}, std::size_t{2000000}, text.size() - 3}) {
        on_rank_0(ranks, [&] {
            std::ofstream(folder / "b.pdm", std::ios::binary)
                << text.substr(0, place) << '?' << text.substr(place + 1);
        });
        EXPECT_THROW(read_slice(ranks, folder / "b.pdm"), Error) << place;
    }
    for (std::size_t edge = 128; edge < text.size(); edge += 1 << 20) {
        on_rank_0(ranks, [&] {
            std::ofstream(folder / "c.pdm", std::ios::binary) << text.substr(0, edge);
        });
        EXPECT_THROW(read_slice(ranks, folder / "c.pdm"), Error) << edge;
    }
    EXPECT_THROW(read_slice(ranks, folder / "none.pdm"), Error);
}

TEST(MeshFiles, every_other_format_comes_through_rank_0) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const Mesh& mesh = meshes().front().mesh;
    on_rank_0(ranks, [&] { write_mesh(folder / "a.nsc", mesh); });
    const MeshSlice read = read_slice(ranks, folder / "a.nsc");
    EXPECT_EQ(read.cells, mesh.simplices.rows());
    EXPECT_TRUE(same(read, slice_of(ranks, mesh)));
    on_rank_0(ranks, [&] { std::ofstream(folder / "bad.nsc") << "2 2 3 1\n0 0\n1 0\n0 nan\n"; });
    EXPECT_REFUSED(read_slice(ranks, folder / "bad.nsc"), "bad.nsc:4");
    EXPECT_THROW(write_slice(ranks, folder / "a.obj", read), InvalidInput);
    EXPECT_THROW(write_slice(ranks, folder / "no" / "folder.pdm", read), IoError);
}

} // namespace polydec::test::in_mesh_file
