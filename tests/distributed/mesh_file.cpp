// SPDX-License-Identifier: MIT
#include "distributed/mesh_file.h"

#include "base/errors.h"
#include "io/meshes/write_mesh.h"
#include "tests/distributed/compare.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace polydec::test {

namespace {

/// A folder that all ranks share; rank 0 makes and removes it.
class SharedFolder {
public:
    explicit SharedFolder(const Ranks& ranks) : ranks_(ranks) {
        std::vector<char> name;
        if (ranks.rank() == 0) {
            std::string path = std::filesystem::temp_directory_path() / "polydec-XXXXXX";
            path = ::mkdtemp(path.data());
            name.assign(path.begin(), path.end());
        }
        name = ranks.of_all(name);
        folder_ = std::string(name.begin(), name.end());
    }
    ~SharedFolder() {
        ranks_.any(false); // all are done
        if (ranks_.rank() == 0)
            std::filesystem::remove_all(folder_);
    }
    SharedFolder(const SharedFolder&) = delete;
    SharedFolder& operator=(const SharedFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return folder_ / name; }

private:
    Ranks ranks_;
    std::filesystem::path folder_;
};

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Work of rank 0 before the others go on.
template <class Work>
void on_rank_0(const Ranks& ranks, Work work) {
    ranks.together("a file", [&] {
        if (ranks.rank() == 0)
            work();
    });
}

bool same(const MeshSlice& a, const MeshSlice& b) {
    return a.vertices == b.vertices && a.cells == b.cells && a.points == b.points &&
           a.simplices == b.simplices;
}

std::string refusal_of(const Ranks& ranks, const std::filesystem::path& path) {
    try {
        read_slice(ranks, path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(MeshFiles, ranks_write_the_bytes_of_one_process_and_read_their_own) {
    const auto ranks = Ranks::all();
    const SharedFolder folder(ranks);
    for (const auto& [name, mesh] : meshes()) {
        const MeshSlice slice = slice_of(ranks, mesh);
        write_slice(ranks, folder / "shared.pdm", slice);
        on_rank_0(ranks, [&, given = mesh] {
            Mesh untagged = given;
            untagged.tags.clear();
            write_mesh(folder / "one.pdm", untagged);
            EXPECT_TRUE(text_of(folder / "one.pdm") == text_of(folder / "shared.pdm"));
        });
        EXPECT_TRUE(same(read_slice(ranks, folder / "shared.pdm"), slice)) << name;
    }
}

TEST(MeshFiles, one_of_several_blocks_goes_to_every_rank_and_a_cut_is_told_by_all) {
    const auto ranks = Ranks::all();
    const SharedFolder folder(ranks);
    Mesh mesh; // of three blocks and a bit
    mesh.points = Points::NullaryExpr(
        90000, 3, [](Eigen::Index i, Eigen::Index j) { return static_cast<double>(3 * i + j); });
    mesh.simplices = Simplices::NullaryExpr(100000, 3, [](Eigen::Index i, Eigen::Index j) {
        return static_cast<Index>((i + j) % 90000);
    });
    const MeshSlice slice = slice_of(ranks, mesh);
    write_slice(ranks, folder / "a.pdm", slice);
    EXPECT_TRUE(same(read_slice(ranks, folder / "a.pdm"), slice));

    const std::string text = text_of(folder / "a.pdm");
    for (const std::size_t place : {std::size_t{5}, std::size_t{2000000}, text.size() - 3}) {
        on_rank_0(ranks, [&] {
            std::ofstream(folder / "b.pdm", std::ios::binary)
                << text.substr(0, place) << '?' << text.substr(place + 1);
        });
        EXPECT_NE(refusal_of(ranks, folder / "b.pdm"), "") << place;
    }
    for (std::size_t edge = 128; edge < text.size(); edge += 1 << 20) {
        on_rank_0(ranks, [&] {
            std::ofstream(folder / "c.pdm", std::ios::binary) << text.substr(0, edge);
        });
        EXPECT_NE(refusal_of(ranks, folder / "c.pdm"), "") << edge;
    }
    EXPECT_NE(refusal_of(ranks, folder / "none.pdm"), "");
}

TEST(MeshFiles, every_other_format_comes_through_rank_0) {
    const auto ranks = Ranks::all();
    const SharedFolder folder(ranks);
    const Mesh& mesh = meshes().front().mesh;
    on_rank_0(ranks, [&] { write_mesh(folder / "a.nsc", mesh); });
    const MeshSlice read = read_slice(ranks, folder / "a.nsc");
    EXPECT_EQ(read.cells, mesh.simplices.rows());
    EXPECT_TRUE(same(read, slice_of(ranks, mesh)));
    on_rank_0(ranks, [&] { std::ofstream(folder / "bad.nsc") << "2 2 3 1\n0 0\n1 0\n0 nan\n"; });
    EXPECT_NE(refusal_of(ranks, folder / "bad.nsc").find("bad.nsc:4"), std::string::npos);
    EXPECT_THROW(write_slice(ranks, folder / "a.obj", read), InvalidInput);
    EXPECT_THROW(write_slice(ranks, folder / "no" / "folder.pdm", read), IoError);
}

} // namespace polydec::test
