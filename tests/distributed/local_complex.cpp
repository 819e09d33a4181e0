// SPDX-License-Identifier: MIT
#include "distributed/local_complex.h"

#include "tests/distributed/compare.h"

#include <algorithm>

namespace polydec::test::in_local_complex {

/// Owners and what is held fit together: each simplex has one owner, who has it.
GlobalIndex owned(const Ranks& ranks, const LocalComplex& local, int k) {
    const auto& owners = local.degree(k).owner;
    return ranks.sum(GlobalIndex{std::count(owners.begin(), owners.end(), ranks.rank())});
}

TEST(LocalComplexes, are_restrictions_of_the_whole) {
    const auto ranks = Ranks::all();
    for (const auto& [name, mesh] : swept(ranks)) {
        const SimplicialComplex whole(mesh.simplices);
        for (const Ownership by : some_ownerships(ranks, name)) {
            const LocalComplex local = distributed(ranks, mesh, by);
            EXPECT_EQ(difference(local, whole), "") << name << " by " << static_cast<int>(by);
            for (int k = 0; k <= whole.dimension(); ++k)
                EXPECT_EQ(owned(ranks, local, k), whole.size(k)) << name;
        }
    }
}

// With several threads of PTScotch on each rank, some of so many rounds never end.
TEST(Owners, by_the_graph_are_found_again_and_again) {
    const auto ranks = Ranks::all();
    constexpr int times = 5;
    for (const auto& [name, mesh] : swept(ranks)) {
        const MeshSlice slice = slice_of(ranks, mesh);
        for (int time = 0; time < times; ++time) {
            const auto owners = vertex_owners(ranks, slice, Ownership::graph);
            EXPECT_EQ(std::ssize(owners), slice.points.rows()) << name;
            for (const int owner : owners)
                EXPECT_TRUE(0 <= owner && owner < ranks.size()) << name << ": " << owner;
        }
    }
}

TEST(LocalComplexes, are_oriented_like_the_whole_however_cells_are_given) {
    const auto ranks = Ranks::all();
    for (const auto& [name, mesh] : swept(ranks))
        for (unsigned seed = 1; seed <= (ranks.size() > 4 ? 1 : 3); ++seed) {
            Mesh turned = mesh;
            for (Eigen::Index t = 0; t < turned.simplices.rows(); ++t)
                if ((static_cast<unsigned>(t) * 2654435761u + seed * 40503u) >> 7 & 1)
                    std::swap(turned.simplices(t, 0), turned.simplices(t, 1));
            EXPECT_EQ(difference(distributed(ranks, turned, Ownership::random),
                                 SimplicialComplex(turned.simplices)),
                      "")
                << name;
        }
}

TEST(LocalVolumes, are_those_of_the_whole_bit_by_bit) {
    const auto ranks = Ranks::all();
    for (const auto& [name, mesh] : swept(ranks)) {
        const SimplicialComplex whole(mesh.simplices);
        const Points points = vertex_points(whole, mesh.points);
        const CellVolumes volumes = circumcentric_volumes(whole, points);
        for (const Ownership by : some_ownerships(ranks, name)) {
            const LocalComplex local = distributed(ranks, mesh, by);
            const CellVolumes here = circumcentric_volumes(local.complex, local.points);
            std::string differences;
            for (int k = 0; k <= whole.dimension(); ++k)
                for (Index s = 0; s < local.degree(k).size(); ++s) {
                    const auto number = static_cast<Index>(local.degree(k).number[s]);
                    const auto compare = [&](const char* what, double mine, double expected) {
                        constexpr double least =
                            1e-30; // bounds far below the largest have no digits
                        if (mine != expected && std::max(mine, expected) > least)
                            differences += fmt::format("{} of {}-simplex {}: {} for {}\n", what, k,
                                                       number, mine, expected);
                    };
                    compare("volume", here.primal(k)[s], volumes.primal(k)[number]);
                    if (!local.degree(k).complete[s])
                        continue;
                    compare("dual", here.dual(k)[s], volumes.dual(k)[number]);
                    compare("terms", here.terms(k)[s], volumes.terms(k)[number]);
                    compare("rounding", here.rounding(k)[s], volumes.rounding(k)[number]);
                }
            EXPECT_EQ(differences, "") << name;
        }
    }
}

TEST(BrokenTwin, cells_that_share_no_facet_with_an_own_one_are_missed) {
    const auto ranks = Ranks::all();
    const Mesh mesh = kuhn(3, 3);
    const MeshSlice slice = slice_of(ranks, mesh);
    const auto owners = vertex_owners(ranks, slice, Ownership::morton);
    Stars stars = own_stars(ranks, slice, owners);
    const SimplicialComplex whole(mesh.simplices);
    const auto here = [&](Eigen::Index t) { // cells by facets: two vertices or more are owned
        int count = 0;
        for (const GlobalIndex v : stars.cells.row(t))
            count +=
                stars.owners[std::lower_bound(stars.vertices.begin(), stars.vertices.end(), v) -
                             stars.vertices.begin()] == ranks.rank();
        return count >= 2;
    };
    std::vector<Eigen::Index> kept;
    for (Eigen::Index t = 0; t < stars.cells.rows(); ++t)
        if (here(t))
            kept.push_back(t);
    Stars fewer = stars;
    fewer.cells = stars.cells(kept, Eigen::indexing::all);
    fewer.file_places.clear();
    for (const auto t : kept)
        fewer.file_places.push_back(stars.file_places[t]);
    bool caught = false;
    try {
        const std::string found = difference(local_complex(ranks, fewer, slice.vertices), whole);
        caught = ranks.any(!found.empty());
    } catch (const InvalidInput&) {
        caught = true;
    }
    EXPECT_EQ(caught, ranks.size() > 1);
}

TEST(Scattering, gives_the_slices_of_the_mesh_of_rank_0) {
    const auto ranks = Ranks::all();
    const Mesh mesh = torus(9, 5);
    const auto scattered =
        scatter(ranks, ranks.rank() == 0 ? std::optional<Mesh>(mesh) : std::nullopt);
    const auto cut = slice_of(ranks, mesh);
    EXPECT_EQ(scattered.vertices, cut.vertices);
    EXPECT_EQ(scattered.cells, cut.cells);
    EXPECT_EQ(scattered.points, cut.points);
    EXPECT_EQ(scattered.simplices, cut.simplices);
}

} // namespace polydec::test::in_local_complex
