// SPDX-License-Identifier: MIT
#include "complex/blocks.h"

#include "tests/complex/labels.h"

#include <rapidcheck.h>

namespace polydec::test::in_blocks {

const Straightness always = [](int, Index, Index, Index) { return true; };

std::vector<Index> one_label(const SimplicialComplex& complex) {
    return std::vector<Index>(complex.size(complex.dimension()), 5);
}

std::vector<InadmissibleBlock> inadmissible(const SimplicialComplex& complex,
                                            const std::vector<Index>& labels) {
    return inadmissible_blocks(complex,
                               join_blocks(complex, facets_within_labels(complex, labels), always));
}

std::vector<Index> random_labels(const SimplicialComplex& complex, int different) {
    return *rc::gen::container<std::vector<Index>>(
        static_cast<std::size_t>(complex.size(complex.dimension())),
        rc::gen::inRange<Index>(0, different));
}

TEST(Labels, remove_the_facets_whose_two_cofaces_have_the_same) {
    for (const char* name : {"grid4", "branching", "spike", "kuhn3", "kuhn4", "moebius12x2"}) {
        const SimplicialComplex K(mesh_named(name).simplices);
        const int n = K.dimension();
        EXPECT_TRUE(rc::check(std::string("removed facets of ") + name, [&] {
            const auto labels = random_labels(K, 3);
            std::vector<std::vector<Index>> around(K.size(n - 1));
            for (Index t = 0; t < K.size(n); ++t)
                for (int omitted = 0; omitted <= n; ++omitted)
                    around[K.face(n, t, omitted)].push_back(labels[t]);
            const auto removed = facets_within_labels(K, labels);
            for (Index f = 0; f < K.size(n - 1); ++f)
                RC_ASSERT(removed[f] == (around[f].size() == 2 && around[f][0] == around[f][1]));
        }));
    }
}

/// What holds for any merging by labels and any idea of straightness that makes balls of all
/// blocks.
void expect_laws_for_random_labels(const std::string& name, int different) {
    const SimplicialComplex K(mesh_named(name).simplices);
    const int n = K.dimension();
    int admissible = 0;
    EXPECT_TRUE(rc::check("merging " + name + " by random labels", [&] {
        const auto labels = random_labels(K, different);
        const auto straight_ones = *rc::gen::inRange(2, 12);
        const auto straight = [&](int k, Index s, Index, Index) {
            return (7 * s + k) % straight_ones == 1;
        };
        const auto blocks = join_blocks(K, facets_within_labels(K, labels), straight);
        if (!inadmissible_blocks(K, blocks).empty())
            return;
        ++admissible;
        const Merging merging(K, blocks);
        const auto& P = merging.merged();
        for (int k = 0; k < n; ++k)
            RC_ASSERT(equal(integers(merging.diamond(k + 1)) * integers(K.coboundary(k)),
                            integers(P.coboundary(k)) * integers(merging.diamond(k))));
        for (int k = 0; k + 1 < n; ++k)
            RC_ASSERT(is_zero(integers(P.coboundary(k + 1)) * integers(P.coboundary(k))));
        RC_ASSERT(euler_characteristic(P) == euler_characteristic(K));
        RC_ASSERT(betti_numbers(P) == betti_numbers(K));
    }));
    EXPECT_GE(admissible, 10) << name;
}

TEST(Labels, merge_to_complexes_that_keep_every_law_if_all_blocks_are_admissible) {
    expect_laws_for_random_labels("grid4", 6);
    expect_laws_for_random_labels("branching", 2);
    expect_laws_for_random_labels("spike", 3);
    expect_laws_for_random_labels("moebius12x2", 9);
    expect_laws_for_random_labels("projective_plane", 4);
    expect_laws_for_random_labels("torus8x6", 20);
    expect_laws_for_random_labels("kuhn3", 12);
    expect_laws_for_random_labels("tilted_tetrahedra", 2);
    expect_laws_for_random_labels("boundary_of_tesseract", 12);
    expect_laws_for_random_labels("kuhn4", 6);
}

TEST(Labels, merge_a_disc_to_one_cell) {
    const SimplicialComplex K(grid(1, 5).simplices);
    ASSERT_TRUE(inadmissible(K, one_label(K)).empty());
    const auto blocks = join_blocks(K, facets_within_labels(K, one_label(K)), always);
    const Merging merging(K, blocks);
    EXPECT_EQ(merging.merged().size(2), 1);
    EXPECT_EQ(merging.merged().size(1), 12);
    EXPECT_EQ(merging.merged().size(0), 12);
}

TEST(InadmissibleBlocks, are_found_where_a_ring_closes_and_none_if_it_is_open) {
    const SimplicialComplex K(annulus(9).simplices);
    auto labels = one_label(K);
    const auto found = inadmissible(K, labels);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].dimension, 2);
    EXPECT_EQ(found[0].piece, 0);
    EXPECT_EQ(found[0].interfaces.size(), 18U);
    for (Index t = 0; t < K.size(2); ++t)
        if (K.simplices(2)(t, 0) == 0)
            labels[t] = t;
    EXPECT_TRUE(inadmissible(K, labels).empty());
}

TEST(InadmissibleBlocks, are_found_where_a_vertex_is_swallowed) {
    const SimplicialComplex fan(
        made_of({{0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}}).simplices);
    const auto found = inadmissible(fan, one_label(fan));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].interfaces.size(), 5U);
}

TEST(InadmissibleBlocks, are_found_where_a_vertex_inside_a_solid_is_swallowed) {
    // the six tetrahedra of a cube around a vertex in the middle of each of two cubes
    const SimplicialComplex K(bcc(1).simplices);
    const auto found = inadmissible(K, one_label(K));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.back().dimension, 3);
}

TEST(InadmissibleBlocks, are_found_where_a_handle_and_a_cavity_have_the_euler_number_of_a_ball) {
    const SimplicialComplex K(handle_and_cavity().simplices);
    const Straightness never = [](int, Index, Index, Index) { return false; };
    const auto blocks = join_blocks(K, facets_within_labels(K, one_label(K)), never);
    const auto found = inadmissible_blocks(K, blocks);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].dimension, 5);
    // the only thing wrong: all else holds of the merged complex
    const CellComplex P = Merging(K, blocks).merged();
    EXPECT_EQ(euler_characteristic(P), euler_characteristic(K));
    EXPECT_EQ(std::count(P.coface_counts(0).begin(), P.coface_counts(0).end(), 0), 0);
    EXPECT_EQ(betti_numbers(K), (std::vector<Index>{1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(betti_numbers(P), (std::vector<Index>{1, 0, 1, 1, 0, 0}));
}

TEST(InadmissibleBlocks, are_found_where_orientations_clash) {
    const SimplicialComplex strip(moebius(9, 1).simplices);
    const auto blocks = join_blocks(strip, facets_within_labels(strip, one_label(strip)), always);
    EXPECT_EQ(blocks.twisted[2], std::vector<Index>{0});
    EXPECT_EQ(inadmissible_blocks(strip, blocks).size(), 1U);
}

TEST(InadmissibleBlocks, are_found_where_a_closed_surface_becomes_one_cell) {
    for (const char* name : {"icosphere3", "torus8x6", "genus_two", "projective_plane"}) {
        const SimplicialComplex K(mesh_named(name).simplices);
        EXPECT_EQ(inadmissible(K, one_label(K)).size(), 1U) << name;
    }
}

TEST(DisjointSets, have_their_least_members_and_signs_for_roots) {
    constexpr Index size = 300;
    DisjointSets sets(size);
    std::vector<Index> label(size);
    std::vector<int> sign(size);
    std::mt19937 random(1);
    for (Index a = 0; a < size; ++a) {
        label[a] = a;
        sign[a] = random() % 2 == 0 ? 1 : -1;
    }
    for (int i = 0; i < 280; ++i) {
        const auto a = static_cast<Index>(random() % size), b = static_cast<Index>(random() % size);
        EXPECT_TRUE(sets.join(a, b, sign[a] * sign[b]));
        EXPECT_FALSE(sets.join(b, a, -sign[a] * sign[b]));
        const auto [least, other] = std::minmax({label[a], label[b]});
        std::replace(label.begin(), label.end(), Index{other}, Index{least});
        const auto root = sets.find(std::max(a, b));
        EXPECT_EQ(root.element, label[a]);
        EXPECT_EQ(root.sign, sign[std::max(a, b)] * sign[root.element]);
    }
    EXPECT_EQ(sets.firsts(), label);
}

TEST(Blocks, never_join_across_branching_facets) {
    for (const char* name : {"branching", "tilted_tetrahedra", "theta_graph"}) {
        const SimplicialComplex K(mesh_named(name).simplices);
        const int n = K.dimension();
        const auto blocks = join_blocks(K, facets_within_labels(K, one_label(K)), always);
        for (Index f = 0; f < K.size(n - 1); ++f)
            if (K.coface_counts(n - 1)[f] > 2) {
                EXPECT_EQ(blocks.carriers[n - 1][f].dimension, n - 1) << name;
            }
    }
}

TEST(Blocks, ignore_marks_of_facets_without_two_cofaces) {
    for (const char* name : {"grid4", "branching", "kuhn3"}) {
        const SimplicialComplex K(mesh_named(name).simplices);
        const std::vector<bool> all(K.size(K.dimension() - 1), true);
        EXPECT_EQ(join_blocks(K, all, always).signs,
                  join_blocks(K, facets_within_labels(K, one_label(K)), always).signs)
            << name;
    }
}

TEST(Blocks, need_straightness_below_the_top) {
    const SimplicialComplex K(kuhn(3, 1).simplices);
    const auto removed = facets_within_labels(K, one_label(K));
    const Straightness never = [](int, Index, Index, Index) { return false; };
    EXPECT_EQ(Merging(K, join_blocks(K, removed, never)).merged().size(2), 12);
    // if all is straight, the whole boundary but one edge path becomes too few faces
    EXPECT_FALSE(inadmissible_blocks(K, join_blocks(K, removed, always)).empty());
}

TEST(Unmerged, leaves_every_simplex_a_cell) {
    for (const auto& [name, mesh] : meshes()) {
        const SimplicialComplex K(mesh.simplices);
        const Merging merging(K);
        for (int k = 0; k <= K.dimension(); ++k) {
            EXPECT_TRUE(equal(integers(merging.merged().coboundary(k)), integers(K.coboundary(k))))
                << name;
            EXPECT_EQ(merging.merged().coface_counts(k), K.coface_counts(k)) << name;
        }
    }
}

} // namespace polydec::test::in_blocks
