// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_advice {

std::vector<std::string> advice(const Mesh& mesh, DiscretizeOptions options = {},
                                StarKind star = StarKind::circumcentric) {
    options.star = star;
    std::vector<std::string> list;
    for (const auto told = diagnose(discretize(mesh, options)); const auto& one : told.advice)
        list.push_back(in_words(one, told.dimension));
    return list;
}

TEST(Advice, names_the_option_for_edges_inside_and_on_the_boundary_and_for_what_cannot_flip) {
    const auto obtuse = kite(0.8, 0.9); // both sides of the edge, and none of the boundary
    EXPECT_EACH_SAYS(advice(obtuse), {"1 negative", "edge", "DiscretizeOptions::delaunay"});
    EXPECT_EQ(advice(obtuse, {.delaunay = Delaunay::flips}), Words{});
    const auto triangle = made_of({{0, 0}, {2, 0}, {1, 0.5}}, {{0, 1, 2}});
    EXPECT_EACH_SAYS(advice(triangle),
                     {"1 negative", "edge", "boundary", "Delaunay::flips_and_splits"});
    EXPECT_EQ(advice(triangle, {.delaunay = Delaunay::flips}), advice(triangle));
    EXPECT_EQ(advice(triangle, {.delaunay = Delaunay::flips_and_splits}), Words{});
    const auto three = made_of({{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}, {1, 0, 0.5}, {1, 0, -0.5}},
                               {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    EXPECT_EACH_SAYS(advice(three), {"1 negative", "edge", "StarKind::automatic"});
    EXPECT_EQ(advice(three, {}, StarKind::automatic), Words{});
    const auto right = made_of({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
    EXPECT_EACH_SAYS(advice(right), {"1 dual edge", "volume", "StarKind::automatic"});
    EXPECT_EQ(advice(right, {}, StarKind::automatic), Words{});
    EXPECT_EACH_SAYS(advice(grid(4, 4), {.criterion = MergeCriterion::none}),
                     {"16 dual edges", "volume", "StarKind::automatic"});
    EXPECT_EQ(advice(three, {.centers = Centers::centroids()}), Words{});
}

TEST(LooserTolerance, is_told_where_coordinates_have_few_digits) {
    for (const Mesh& mesh : {perturbed(grid(16, 16), 1e-3, 1), perturbed(kuhn(3, 4), 1e-3, 1)}) {
        const auto told = diagnose(circumcentric(mesh)).looser;
        ASSERT_TRUE(told.has_value());
        const auto merged = discretize(mesh, {.tolerance = told->tolerance});
        EXPECT_EQ(merged.degenerate().interior - circumcentric(mesh).degenerate().interior,
                  told->pairs);
        EXPECT_GT(merged_pairs(merged.merging()).facets, told->pairs / 2);
    }
    for (const Mesh& mesh :
         {grid(16, 16), kuhn(3, 4), icosphere(4), perturbed(grid(16, 16), 0.2, 1)})
        EXPECT_FALSE(diagnose(circumcentric(mesh)).looser.has_value());
    EXPECT_FALSE(
        diagnose(discretize(perturbed(grid(16, 16), 1e-3, 1), {.criterion = MergeCriterion::none}))
            .looser.has_value());
}

TEST(Advice, is_what_works_where_flips_alone_do_not) {
    // the kite with an obtuse triangle at a side of it, its longest edge on the boundary
    const auto both = made_of({{0, 0}, {2, 0}, {1, 0.8}, {1, -0.9}, {0.26, 1.72}},
                              {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}});
    EXPECT_EACH_SAYS(advice(both), {"2 negative", "edges", "Delaunay::flips_and_splits"});
    // closed surfaces need flips alone
    EXPECT_EACH_SAYS(advice(perturbed(icosphere(4), 0.1, 1)),
                     {"negative", "DiscretizeOptions::delaunay"});
}

TEST(Advice, gives_options_that_discretize_takes) {
    Mesh mesh = kite(0.8, 0.9);
    mesh.tags = {1, 2};
    for (auto options : {DiscretizeOptions{.criterion = MergeCriterion::angle, .tolerance = 1e-3},
                         DiscretizeOptions{.materials = Materials::keep_apart},
                         {}}) {
        const auto hybrid = discretize(mesh, options);
        options.star = StarKind::circumcentric;
        const auto told = diagnose(discretize(mesh, options)).advice;
        ASSERT_EQ(told.size(), 1U);
        EXPECT_EQ(not_positive(discretize(mesh, with(told[0].remedy, options))), 0U);
        const bool flips = told[0].remedy == Remedy::flips;
        EXPECT_EQ(flips, options.criterion == MergeCriterion::dual_length &&
                             options.materials == Materials::join);
        EXPECT_EQ(hybrid.warnings().size(), flips ? 1U : 0U);
        EXPECT_EQ(flip_advice(hybrid).empty(), !flips);
    }
    for (const auto remedy : {Remedy::flips, Remedy::splits, Remedy::stars})
        EXPECT_EQ(not_positive(discretize(mesh, with(remedy, {}))), 0U);
}

} // namespace polydec::test::in_advice
