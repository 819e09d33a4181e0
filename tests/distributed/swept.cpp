// SPDX-License-Identifier: MIT
#include "tests/distributed/swept.h"

#include "tests/io/support.h"

namespace polydec::test {

namespace {

/// What cannot be read or tidied, or is refused by one process too, is another test's.
std::optional<Mesh> tidied(const std::filesystem::path& path) {
    try {
        Mesh mesh = tidy(read_mesh(path));
        discretize(mesh);
        return mesh;
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::vector<NamedMesh> found(const Ranks& ranks) {
    constexpr std::uintmax_t small = 20000; // bytes
    constexpr int turns = 5;                // as many as numbers of ranks are tested
    std::vector<NamedMesh> list;
    int turn = 0;
    for (const auto& path : test::test_data("")) {
        const bool is_due = is_full_sweep() || (std::filesystem::file_size(path) < small &&
                                                ++turn % turns == ranks.size() % turns);
        if (auto mesh = is_due ? tidied(path) : std::nullopt)
            list.push_back({path.filename().string(), *std::move(mesh)});
    }
    return list;
}

} // namespace

bool is_full_sweep() {
    return std::getenv("POLYDEC_TEST_SWEEP") != nullptr;
}

std::vector<NamedMesh> swept(const Ranks& ranks, Index most_cells) {
    static const std::vector<NamedMesh> all = found(ranks);
    std::vector<NamedMesh> list = meshes();
    for (const NamedMesh& mesh : all)
        if (mesh.mesh.simplices.rows() <= most_cells)
            list.push_back(mesh);
    return list;
}

} // namespace polydec::test
