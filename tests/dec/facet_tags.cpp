// SPDX-License-Identifier: MIT
#include "dec/merging/merged_tags.h"
#include "tests/support/test.h"

namespace polydec::test::in_facet_tags {

const DiscretizeOptions apart{.tolerance = tolerance, .materials = Materials::keep_apart};
const DiscretizeOptions unmerged_cells{.criterion = MergeCriterion::none};

/// The mesh with one of some tags on about every `share`-th facet, at random, whose corners stand
/// in reverse order.
Mesh with_facet_tags(Mesh mesh, Index tags, unsigned share) {
    std::mt19937 random(9);
    const SimplicialComplex complex(mesh.simplices);
    const Simplices& facets = complex.simplices(complex.dimension() - 1);
    std::vector<Index> chosen;
    for (Index f = 0; f < facets.rows(); ++f)
        if (random() % share == 0)
            chosen.push_back(f);
    mesh.facet_tags.simplices = facets(chosen, Eigen::indexing::all).rowwise().reverse();
    for (Index& vertex : mesh.facet_tags.simplices.reshaped())
        vertex = complex.vertex_number(vertex);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        mesh.facet_tags.tags.push_back(1 +
                                       static_cast<Index>(random() % static_cast<unsigned>(tags)));
    return mesh;
}

std::vector<Index> sorted_tags(const Mesh& mesh) {
    auto tags = discretize(mesh, unmerged_cells).facet_tags();
    std::sort(tags.begin(), tags.end());
    return tags;
}

/// Of each facet of the simplices its tag, found one by one.
std::vector<Index> expected_tags(const SimplicialComplex& complex, const TaggedSimplices& given) {
    const int k = complex.dimension() - 1;
    std::vector<Index> result(static_cast<std::size_t>(complex.size(k)), 0);
    for (Index f = 0; f < complex.size(k); ++f) {
        const auto corners = complex.vertex_numbers(k, f);
        for (Index i = 0; i < given.simplices.rows(); ++i)
            if (std::is_permutation(corners.begin(), corners.end(), given.simplices.row(i).begin()))
                result[f] = given.tags[i];
    }
    return result;
}

/// Facets with tags that are not there any more.
Index removed(const Discretization& mesh, const std::vector<Index>& tags) {
    Index count = 0;
    const auto& carriers = mesh.merging().carriers(mesh.dimension() - 1);
    for (std::size_t f = 0; f < tags.size(); ++f)
        count += tags[f] != 0 && carriers[f].dimension == mesh.dimension() ? 1 : 0;
    return count;
}

class FacetTagsOf : public OverMeshes {
protected:
    Mesh input(Index tags, unsigned share) const {
        return with_facet_tags(mesh_named(GetParam()), tags, share);
    }
};

TEST_P(FacetTagsOf, cells_that_are_not_merged_are_those_of_the_input) {
    const Mesh given = input(3, 3);
    const auto mesh = discretize(given, unmerged_cells);
    if (given.facet_tags.tags.empty()) {
        EXPECT_TRUE(mesh.facet_tags().empty());
        return;
    }
    EXPECT_EQ(mesh.facet_tags(), expected_tags(mesh.input(), given.facet_tags));
    EXPECT_EQ(mesh.warnings(), discretize(mesh_named(GetParam()), unmerged_cells).warnings());
}

TEST_P(FacetTagsOf, merged_cells_are_what_their_pieces_share) {
    const Mesh given = input(2, 1);
    const auto mesh = discretize(given, {.tolerance = tolerance});
    const int n = mesh.dimension();
    const auto of_pieces = expected_tags(mesh.input(), given.facet_tags);
    ASSERT_EQ(mesh.facet_tags().size(), static_cast<std::size_t>(mesh.complex().size(n - 1)));
    for (Index cell = 0; cell < mesh.complex().size(n - 1); ++cell) {
        std::vector<Index> tags;
        for (std::size_t f = 0; f < of_pieces.size(); ++f) {
            const auto carrier = mesh.merging().carriers(n - 1)[f];
            if (carrier.dimension == n - 1 && carrier.cell == cell)
                tags.push_back(of_pieces[f]);
        }
        const bool is_one = std::count(tags.begin(), tags.end(), tags.front()) ==
                            static_cast<std::ptrdiff_t>(tags.size());
        EXPECT_EQ(mesh.facet_tags()[cell], is_one ? tags.front() : 0);
    }
}

/// Facets that are pieces of a cell with another tag.
Index mixed(const Discretization& mesh, const std::vector<Index>& tags) {
    Index count = 0;
    const auto& carriers = mesh.merging().carriers(mesh.dimension() - 1);
    for (std::size_t f = 0; f < tags.size(); ++f)
        if (carriers[f].dimension < mesh.dimension() &&
            mesh.facet_tags()[carriers[f].cell] != tags[f])
            ++count;
    return count;
}

TEST_P(FacetTagsOf, facets_with_tags_stay_with_them_if_groups_are_kept_apart) {
    const Mesh given = input(3, 2);
    const auto mesh = discretize(given, apart);
    if (given.facet_tags.tags.empty())
        return;
    const auto tags = expected_tags(mesh.input(), given.facet_tags);
    EXPECT_EQ(removed(mesh, tags), 0);
    EXPECT_EQ(mixed(mesh, tags), 0);
}

TEST_P(FacetTagsOf, numbers_of_vertices_and_cells_do_not_matter) {
    const Mesh given = input(4, 2);
    EXPECT_EQ(sorted_tags(given), sorted_tags(shuffled(given, 3).mesh));
}

POLYDEC_OVER_MESHES(FacetTagsOf);

TEST(FacetTags, without_being_kept_apart_some_facets_are_removed) {
    const Mesh given = with_facet_tags(mesh_named("kuhn3"), 3, 2);
    const auto mesh = discretize(given);
    EXPECT_GT(removed(mesh, expected_tags(mesh.input(), given.facet_tags)), 0);
}

TEST(FacetTags, of_half_a_wall_between_cubes_stay_its_own_if_groups_are_kept_apart) {
    Mesh given = kuhn({2, 1, 1}, {2, 1, 1});
    const SimplicialComplex K(given.simplices);
    std::vector<Index> wall;
    for (Index f = 0; f < K.size(2); ++f)
        if ((given.points(K.simplices(2).row(f), 0).array() == 1).all())
            wall.push_back(f);
    ASSERT_EQ(wall.size(), 2U);
    given.facet_tags = {K.simplices(2)(std::vector{wall[0]}, Eigen::indexing::all), {7}};
    const auto joined = discretize(given), kept = discretize(given, apart);
    EXPECT_EQ(mixed(joined, expected_tags(K, given.facet_tags)), 1);
    EXPECT_EACH_SAYS(joined.warnings(), {"1 merged facet joins", "groups", "keep_apart"});
    EXPECT_EQ(mixed(kept, expected_tags(K, given.facet_tags)), 0);
    EXPECT_EQ(kept.complex().size(2), joined.complex().size(2) + 1);
    EXPECT_TRUE(kept.warnings().empty());
}

TEST(FacetTags, by_the_old_numbers_of_vertices_are_others) {
    const Mesh given = with_facet_tags(mesh_named("kuhn3"), 4, 2);
    Mesh renumbered = shuffled(given, 3).mesh;
    renumbered.facet_tags = given.facet_tags;
    EXPECT_NE(sorted_tags(given), sorted_tags(renumbered));
}

/// A square of two triangles, and its diagonal.
Mesh square() {
    return {Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, Simplices{{0, 1, 2}, {0, 2, 3}}, {}};
}

TEST(FacetTags, an_interface_divides_what_would_merge) {
    Mesh mesh = square();
    mesh.facet_tags = {Simplices{{2, 0}, {0, 1}}, {7, 8}};
    const auto joined = discretize(mesh), divided = discretize(mesh, apart);
    EXPECT_EQ(joined.complex().size(2), 1);
    EXPECT_EQ(joined.facet_tags(), (std::vector<Index>{8, 0, 0, 0}));
    EXPECT_EQ(divided.complex().size(2), 2);
    EXPECT_EQ(divided.facet_tags(), (std::vector<Index>{8, 7, 0, 0, 0}));
    EXPECT_TRUE(joined.warnings().empty());

    mesh.facet_tags = {Simplices{{0, 1}}, {8}};
    EXPECT_EQ(discretize(mesh, apart).complex().size(2), 1); // at the boundary nothing divides
}

TEST(FacetTags, what_no_cell_has_is_left_out_with_a_warning) {
    Mesh mesh = square();
    mesh.facet_tags = {Simplices{{1, 3}, {0, 1}, {2, 2}}, {7, 8, 9}};
    const auto result = discretize(mesh);
    EXPECT_EQ(result.facet_tags(), (std::vector<Index>{8, 0, 0, 0}));
    EXPECT_EACH_SAYS(result.warnings(), {"2 facets", "group", "without a cell", "(1 3)", "(2 2)"});
}

TEST(FacetTags, of_several_groups_of_a_facet_all_count) {
    Mesh mesh = square();
    mesh.facet_tags = {Simplices{{1, 0}, {0, 1}, {1, 0}, {1, 2}, {2, 0}}, {8, 9, 8, 9, 5}};
    mesh.groups = {{1, 8, "wall"}, {-1, 9, "lid"}, {2, 9, "plate"}};
    const auto result = discretize(mesh, apart);
    EXPECT_EQ(result.facet_tags(), (std::vector<Index>{10, 5, 0, 9, 0}));
    ASSERT_EQ(result.tagged_facets().joint.size(), 1U);
    EXPECT_EQ(result.tagged_facets().joint[0].tag, 10);
    EXPECT_EQ(result.tagged_facets().joint[0].groups, (std::vector<Index>{8, 9}));
    EXPECT_EACH_SAYS(result.warnings(), {"1 facet", "groups 8, 9", "10"});
    using Marks = std::vector<bool>;
    EXPECT_EQ(facets_in(result, {"wall"}), (Marks{true, false, false, false, false}));
    EXPECT_EQ(facets_in(result, {"9"}), (Marks{true, false, false, true, false}));
    EXPECT_EQ(facets_in(result, {"lid"}), facets_in(result, {"9"}));
    EXPECT_EQ(facets_in(result, {"8", "5"}), (Marks{true, true, false, false, false}));
    EXPECT_EQ(essential_on(result, {"lid"}).at(3), BoundaryCondition::essential);
    EXPECT_EQ(essential_on(result, {"lid"}).at(1), BoundaryCondition::natural);
    EXPECT_REFUSED(facets_in(result, {"4"}), "no facet", "group 4", "5 (1 facets)",
                   "wall (1 facets)", "lid (2 facets)");
    EXPECT_REFUSED(facets_in(result, {"plate"}), "1-cells", "plate", "wall");
    EXPECT_REFUSED(essential_on(result, {"lid", "5"}), "group 5", "wall", "none",
                   "4 boundary facets");
    mesh.facet_tags = {};
    EXPECT_REFUSED(facets_in(discretize(mesh), {"4"}), "no facet", "group 4");
    mesh.facet_tags = {Simplices{{1, 0}, {0, 1}}, {1, std::numeric_limits<Index>::max()}};
    EXPECT_EQ(discretize(mesh).tagged_facets().joint[0].tag, 2);
}

TEST(FacetTags, of_cells_that_tidying_leaves_out_go_with_them) {
    Mesh mesh = square();
    mesh.points.conservativeResize(5, Eigen::NoChange);
    mesh.points.row(4) << 0.5, 0;
    mesh.simplices = Simplices{{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
    mesh.facet_tags = {Simplices{{0, 4}, {0, 1}}, {7, 8}};
    const auto result = discretize(mesh);
    EXPECT_EQ(result.facet_tags(), (std::vector<Index>{8, 0, 0, 0}));
    EXPECT_SAYS(result.warnings().back(), "1 facet", "group", "without a cell", "(0 4)");
}

TEST(FacetTags, pieces_of_different_groups_have_none_together) {
    Mesh mesh = mesh_named("kuhn3"); // the boundary of its cubes merges to squares
    const SimplicialComplex complex(mesh.simplices);
    mesh.facet_tags.simplices = complex.simplices(2);
    for (Index f = 0; f < complex.size(2); ++f)
        mesh.facet_tags.tags.push_back(1 + f);
    const auto result = discretize(mesh);
    const auto zeros = std::count(result.facet_tags().begin(), result.facet_tags().end(), 0);
    EXPECT_EQ(zeros, result.complex().size(2));
    EXPECT_EACH_SAYS(result.warnings(),
                     {std::to_string(zeros), "merged facets", "groups", "tag", "0"});
    EXPECT_EQ(std::ssize(result.tagged_facets().groups), complex.size(2));
    EXPECT_REFUSED(facets_in(result, {"5"}), "group 5", "merging", "Materials::keep_apart",
                   "MergeCriterion::none");
    EXPECT_REFUSED(facets_in(result, {"1000"}), "group 1000", "no merged facet");
    mesh.facet_tags.tags.assign(mesh.facet_tags.tags.size(), 4);
    const auto one = discretize(mesh);
    EXPECT_EQ(one.facet_tags(), std::vector<Index>(result.facet_tags().size(), 4));
    EXPECT_TRUE(one.warnings().empty());
}

TEST(FacetTags, and_tags_of_cells_are_one_for_each) {
    const SimplicialComplex K(grid(1, 1).simplices);
    std::vector<std::string> warnings;
    EXPECT_REFUSED(tags_of_cells(K, {1}), "1 tags", "cells", "2");
    EXPECT_REFUSED(tags_of_facets(K, {K.simplices(1), {1, 2}}, warnings), "2 tags", "facets", "5");
    EXPECT_REFUSED(merged_tags(Merging(K), 1, {1, 2}, warnings), "2 tags", "5");
}

TEST(FacetTags, flips_leave_none) {
    const Mesh mesh = with_facet_tags(shaken(mesh_named("grid4"), 0.25, 7), 2, 2);
    const auto flipped = discretize(mesh, {.delaunay = Delaunay::flips});
    EXPECT_TRUE(flipped.facet_tags().empty());
    EXPECT_REFUSED(facets_in(flipped, {"1"}), "group 1", "flipped", "DiscretizeOptions::delaunay");
    auto options = apart;
    options.delaunay = Delaunay::flips;
    EXPECT_REFUSED(discretize(mesh, options), "flips", "groups");
}

} // namespace polydec::test::in_facet_tags
