// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/metric/circumcentric_volumes.h"
#include "distributed/petsc.h"
#include "meshes/generate.h"
#include "tests/distributed/compare.h"

namespace polydec::test {

namespace {

/// What a way ends with: an error's text, or nothing.
template <class Way>
std::string text_of_error(Way way) {
    try {
        way();
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

/// The whole way, from slices to an operator of merged cells.
void go_the_way(const Ranks& ranks, const Mesh& mesh) {
    const LocalComplex local = distributed(ranks, mesh, Ownership::morton);
    const auto volumes = ranks.together(
        "volumes", [&] { return circumcentric_volumes(local.complex, local.points); });
    const auto cells =
        distributed_cells(ranks, local, merge_cospherical(ranks, local, volumes, {}));
    laplacian(ranks, cells, Side::primal, 1);
}

/// The same text on all ranks, of that of rank 0.
void expect_everywhere(const Ranks& ranks, const std::string& expected, const std::string& found) {
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(ranks.any(found != expected));
}

TEST(Faults, of_any_local_work_of_any_rank_are_the_same_error_everywhere) {
    const auto ranks = Ranks::all();
    const Mesh mesh = kuhn(3, 2);
    int works = 0;
    ranks.listen([&](std::string_view) { ++works; });
    go_the_way(ranks, mesh);
    ASSERT_GT(works, 40);
    for (const int guilty : {0, ranks.size() - 1})
        for (int fatal = 1; fatal <= works; ++fatal) {
            int work = 0;
            ranks.listen([&](std::string_view what) {
                if (++work == fatal && ranks.rank() == guilty)
                    throw InvalidInput(fmt::format("{} of rank {}", what, guilty));
            });
            const auto text = text_of_error([&] { go_the_way(ranks, mesh); });
            EXPECT_NE(text.find(fmt::format("of rank {}", guilty)), std::string::npos) << text;
        }
    ranks.listen({});
}

TEST(Faults, memory_that_does_not_suffice_is_told_everywhere) {
    const auto ranks = Ranks::all();
    expect_everywhere(ranks,
                      "memory does not suffice: take more ranks, or machines with more memory",
                      text_of_error([&] {
                          ranks.together("memory", [&] {
                              if (ranks.rank() == ranks.size() - 1)
                                  throw std::bad_alloc();
                          });
                      }));
}

TEST(Faults, of_the_mesh_are_named_by_the_numbers_of_the_file) {
    const auto ranks = Ranks::all();
    const auto refused = [&](const Mesh& mesh) {
        return text_of_error([&] { distributed(ranks, mesh, Ownership::random); });
    };
    Mesh mesh = grid(4, 4);
    const Simplices cells = mesh.simplices;
    const Index vertices = static_cast<Index>(mesh.points.rows());
    mesh.simplices(17, 1) = 99;
    expect_everywhere(
        ranks, fmt::format("cell 17 has vertex 99: expected a number from 0 to {}", vertices - 1),
        refused(mesh));
    mesh.simplices = cells;
    mesh.simplices.row(30) = cells.row(2).reverse();
    expect_everywhere(
        ranks,
        fmt::format("cells 2 and 30 have the same vertices {}: remove one of them", "2, 7, 8"),
        refused(mesh));
    mesh.simplices = cells;
    mesh.simplices(30, 0) = mesh.simplices(30, 1);
    EXPECT_NE(refused(mesh).find("cell 30 has a repeated corner"), std::string::npos);
    mesh.simplices = cells;
    mesh.points(21, 1) = std::nan("");
    expect_everywhere(ranks, "vertex 21 has a coordinate that is not finite", refused(mesh));
}

} // namespace

} // namespace polydec::test
