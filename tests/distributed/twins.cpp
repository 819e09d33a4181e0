// SPDX-License-Identifier: MIT
//
// What would be wrong if one of the rules that results rest on were another, and that this is seen.
#include "dec/merging/facet_links.h"
#include "tests/distributed/compare.h"

namespace polydec::test::in_twins {

TEST(BrokenTwin, owners_by_the_last_vertex_are_seen) {
    const auto ranks = Ranks::all();
    for (const char* name : {"kuhn3", "uv8", "grid4", "torus8x6"}) {
        const Mesh& mesh = mesh_named(name);
        const SimplicialComplex whole(mesh.simplices);
        LocalComplex local = distributed(ranks, mesh, Ownership::random);
        bool is_other = false;
        for (int k = 1; k <= whole.dimension(); ++k)
            for (Index s = 0; s < local.degree(k).size(); ++s) {
                const int last = local.degree(0).owner[local.complex.simplices(k)(s, k)];
                is_other = is_other || last != local.degree(k).owner[s];
                local.degrees[k].owner[s] = last;
            }
        EXPECT_EQ(difference(local, whole).empty(), !is_other) << name;
    }
}

/// The first element of the class of each.
std::vector<Index> joined(Index size, const std::vector<FacetLink>& links, double tolerance) {
    DisjointSets classes(size);
    join_links(links, tolerance, classes);
    return classes.firsts();
}

/// A chain of cells whose links tie: together they gather more than they may, some alone do not.
TEST(BrokenTwin, links_that_tie_and_are_joined_on_each_rank_alone_are_seen) {
    const auto ranks = Ranks::all();
    constexpr double wide = 1e-4;
    constexpr Index cells = 60;
    std::vector<FacetLink> all;
    for (Index t = 0; t + 1 < cells; ++t)
        all.push_back({t, t + 1, 0.5 * wide, 1});
    const auto whole = joined(cells, all, wide);
    DisjointSets twin(cells);
    for (int r = 0; r < ranks.size(); ++r) {
        std::vector<FacetLink> own;
        for (const FacetLink& link : all)
            if (link.a % ranks.size() == r)
                own.push_back(link);
        const auto alone = joined(cells, own, wide);
        for (Index t = 0; t < cells; ++t)
            twin.join(t, alone[static_cast<std::size_t>(t)]);
    }
    EXPECT_EQ(twin.firsts() != whole, ranks.size() > 1);
}

/// Triangles to and fro between points of a circle, which are one cell.
Mesh polygon(Index corners, double radius) {
    Mesh mesh;
    mesh.points.resize(corners, 2);
    for (Index v = 0; v < corners; ++v) {
        const double part = v * (v + corners) / (2.0 * corners * corners); // below 1
        const double angle = 2 * std::numbers::pi * part;
        mesh.points.row(v) << radius * std::cos(angle), radius * std::sin(angle);
    }
    std::vector<Index> order; // 0, last, 1, last but one, ..
    for (Index i = 0; i < corners; ++i)
        order.push_back(i % 2 == 0 ? i / 2 : corners - 1 - i / 2);
    mesh.simplices.resize(corners - 2, 3);
    for (Index t = 0; t < corners - 2; ++t)
        mesh.simplices.row(t) << order[t], order[t + 1], order[t + 2];
    return mesh;
}

/// The volume of a merged n-cell from those of its pieces, each rank's added up for itself.
double by_ranks(const Ranks& ranks, const Merged& whole, const std::vector<int>& owners,
                Index cell) {
    const int n = whole.n();
    std::vector<double> sums(static_cast<std::size_t>(ranks.size()), 0);
    for (IncidenceMatrix::InnerIterator piece(whole.merging().diamond(n), cell); piece; ++piece) {
        const auto t = static_cast<Index>(piece.col());
        const int owner = owners[static_cast<std::size_t>(whole.K().vertex_numbers(n, t)[0])];
        sums[static_cast<std::size_t>(owner)] += whole.result.geometry.volumes().primal(n)[t];
    }
    double sum = 0;
    for (const double of_rank : sums)
        sum += of_rank;
    return sum;
}

TEST(BrokenTwin, volumes_added_in_the_order_of_ranks_are_seen) {
    const auto ranks = Ranks::all();
    bool is_seen = false;
    for (int i = 0; i < 10; ++i) {
        const Mesh mesh = polygon(20 + i, 1 + 0.1 * i);
        const Merged whole = make_merged(mesh);
        ASSERT_EQ(whole.P().size(2), 1);
        const auto owners =
            ranks.of_all(vertex_owners(ranks, slice_of(ranks, mesh), Ownership::random));
        const double sum = by_ranks(ranks, whole, owners, 0);
        const double expected =
            merged_volumes(whole.merging(), whole.result.geometry.volumes()).primal(2)[0];
        EXPECT_NEAR(sum, expected, 1e-14 * sum);
        is_seen = is_seen || sum != expected;
    }
    EXPECT_EQ(is_seen, ranks.size() > 1);
}

} // namespace polydec::test::in_twins
