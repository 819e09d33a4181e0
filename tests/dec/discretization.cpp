// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_discretization {

class Discretizations : public OverMeshes {};

TEST_P(Discretizations, are_what_their_steps_make) {
    const auto whole = discretize(mesh_named(GetParam()), {MergeCriterion::dual_length, tolerance});
    EXPECT_EQ(whole.points(), mesh().points);
    EXPECT_EQ(whole.options().tolerance, tolerance);
    EXPECT_EQ(whole.degenerate().interior, mesh().result.degenerate.interior);
    EXPECT_EQ(whole.dimension(), mesh().n());
    for (int k = 0; k <= mesh().n(); ++k) {
        EXPECT_TRUE(
            equal(integers(whole.merging().diamond(k)), integers(mesh().merging().diamond(k))));
        EXPECT_EQ(whole.volumes().primal(k), mesh().volumes.primal(k));
        EXPECT_EQ(whole.volumes().dual(k), mesh().volumes.dual(k));
        EXPECT_EQ(whole.input_geometry().volumes().dual(k), mesh().input_volumes.dual(k));
    }
}

POLYDEC_OVER_MESHES(Discretizations);

TEST(Discretize, tells_its_stages_as_they_begin) {
    Words stages;
    discretize(grid(2, 2), {}, [&](std::string_view stage) { stages.emplace_back(stage); });
    EXPECT_EQ(stages, (Words{"complex", "volumes", "merge"}));
}

TEST(Discretize, warns_of_nothing_where_all_is_well) {
    EXPECT_EQ(discretize(grid(2, 2)).warnings(), Words{});
}

TEST(Discretize, gives_a_merged_cell_the_tag_that_its_simplices_share) {
    Mesh mesh = shuffled(grid(2, 1), 3).mesh;
    for (Eigen::Index t = 0; t < 4; ++t) {
        double sum = 0;
        for (const Index v : mesh.simplices.row(t))
            sum += mesh.points(v, 0);
        mesh.tags.push_back(sum < 1.5 ? 7 : 9);
    }
    const auto two = discretize(mesh);
    EXPECT_EQ(std::multiset<Index>(two.tags().begin(), two.tags().end()),
              (std::multiset<Index>{7, 9}));
    EXPECT_EQ(two.warnings(), Words{});
    EXPECT_TRUE(discretize(grid(2, 1)).tags().empty());

    Mesh mixed = grid(2, 1);
    mixed.tags = {7, 9, 7, 8};
    const auto clash = discretize(mixed);
    EXPECT_EQ(clash.tags(), (std::vector<Index>{7, 0}));
    EXPECT_EACH_SAYS(clash.warnings(), {"1 merged cell", "groups", "tag", "0"});
}

TEST(Discretize, warns_of_cells_that_were_turned) {
    Mesh mesh = grid(2, 2);
    mesh.simplices.row(3).reverseInPlace();
    EXPECT_EACH_SAYS(discretize(mesh).warnings(), {"1 of 8 cells", "orientation"});
    mesh.simplices.row(5).reverseInPlace();
    EXPECT_EACH_SAYS(discretize(mesh).warnings(), {"2 of 8 cells", "orientation"});
}

TEST(Discretize, warns_of_one_sided_and_branching_meshes) {
    EXPECT_EACH_SAYS(discretize(moebius(8, 1)).warnings(), {"non-orientable"});
    EXPECT_EACH_SAYS(discretize(mesh_named("branching")).warnings(),
                     {"manifold", "1 facet", "three"});
}

TEST(Discretize, warns_of_boundaries_that_are_not_joined_with_the_remedy) {
    const Mesh slit =
        made_of({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {3, 4, 5}});
    EXPECT_EACH_SAYS(discretize(slit).warnings(), {"2 vertices", "coincide", "3, 4", "weld"});
    const Mesh hanging = made_of({{0, 0}, {0, 1}, {-1, 0}, {0, 0.5}, {1, 0}, {1, 1}},
                                 {{0, 1, 2}, {0, 4, 3}, {3, 4, 5}, {3, 5, 1}});
    EXPECT_EACH_SAYS(discretize(hanging).warnings(),
                     {"1 vertex", "hangs", "vertex 3", "join_hanging"});
}

TEST(Discretize, is_the_same_for_a_mesh_with_flaws_as_for_the_tidied_one) {
    const Mesh clean = grid(3, 1);
    const Simplices corner{{0, 1, 1}}, twin = clean.simplices.row(0).reverse(), flat{{0, 8, 1}};
    using Flaws = std::vector<Simplices>;
    for (const Flaws& flaws :
         {Flaws{corner}, Flaws{twin}, Flaws{flat}, Flaws{corner, twin, flat}, Flaws{}}) {
        Mesh mesh = clean;
        mesh.points.conservativeResize(10, Eigen::NoChange);
        mesh.points.row(8) << 0, 0.5; // between 0 and 1
        mesh.points.row(9) << 7, 7;
        for (const Simplices& flaw : flaws) {
            mesh.simplices.conservativeResize(mesh.simplices.rows() + 1, Eigen::NoChange);
            mesh.simplices.bottomRows(1) = flaw;
        }
        const auto given = discretize(mesh), tidied = discretize(tidy(mesh));
        EXPECT_EQ(given.warnings(), tidied.warnings());
        EXPECT_EQ(given.warnings().size(), flaws.size() + 1);
        EXPECT_EQ(given.input().simplices(2), tidied.input().simplices(2));
        EXPECT_EQ(given.volumes().dual(1), tidied.volumes().dual(1));
    }
}

TEST(Discretize, refuses_what_has_no_place) {
    EXPECT_THROW(discretize(made_of({{0, 0}, {1, 0}}, {{0, 1, 2}})), InvalidInput);
    EXPECT_THROW(discretize(made_of({{0}, {1}, {2}}, {{0, 1, 2}})), InvalidInput);
}

Discretization::Parts parts_of(const Discretization& mesh) {
    return {.input = mesh.input_geometry(),
            .passage = mesh.passage(),
            .merged = mesh.merged(),
            .input_points = std::make_shared<const Points>(mesh.input_points()),
            .points = std::make_shared<const Points>(mesh.points()),
            .isolated = mesh.isolated()};
}

/// What is said of parts after a change that makes them unfit; they fit before it.
template <class Change>
std::string refusal_after(const Discretization& mesh, Change change) {
    auto parts = parts_of(mesh);
    EXPECT_NO_THROW(Discretization{parts});
    change(parts);
    return refusal([&] { Discretization{parts}; });
}

using Parts = Discretization::Parts;

TEST(DiscretizationOfParts, refuses_points_and_lengths_of_another_mesh) {
    const auto square = discretize(grid(2, 2)),
               flipped = discretize(perturbed(grid(3, 3), 0.1, 1),
                                    {.delaunay = Delaunay::flips_and_splits});
    const auto lengths = discretize(length_mesh(grid(2, 2)));
    const auto isolated = discretize(with_isolated_vertices());
    for (const auto& mesh : {square, flipped, lengths, isolated})
        EXPECT_EQ(refusal_after(mesh, [](Parts&) {}), "accepted");
    const auto of_input = [](Index rows) {
        return [rows](Parts& p) {
            p.input_points = std::make_shared<const Points>(Points::Zero(rows, p.points->cols()));
        };
    };
    EXPECT_SAYS(refusal_after(square, of_input(8)), "8 points", "input's vertices", "9");
    EXPECT_SAYS(refusal_after(lengths, of_input(0)), "0 points", "input's vertices", "9");
    const Geometry& input = square.input_geometry();
    EXPECT_REFUSED(Geometry(input.pieces(), Points(8, 2), input.volumes()), "8 points", "vertices",
                   "9");
    EXPECT_REFUSED(SimplexMetric(input.pieces(), Vector::Ones(3)), "3 lengths", "16 edges");
    const Index pieces = flipped.pieces().size(0);
    const auto of_pieces = [](Index rows, Index N) {
        return [=](Parts& p) { p.points = std::make_shared<const Points>(Points::Zero(rows, N)); };
    };
    EXPECT_SAYS(refusal_after(flipped, of_pieces(2, 2)), "2 points", "pieces",
                std::to_string(pieces));
    EXPECT_SAYS(refusal_after(flipped, of_pieces(pieces, 3)), "3 coordinates", "pieces", "2");
    EXPECT_SAYS(refusal_after(isolated, [](Parts& p) { p.isolated = Points::Zero(1, 3); }),
                "3 coordinates", "no cell", "2");
    const auto other = discretize(grid(3, 2));
    EXPECT_SAYS(refusal_after(square,
                              [&](Parts& p) {
                                  p.passage = other.passage();
                                  p.input_points =
                                      std::make_shared<const Points>(other.input_points());
                              }),
                "9 volumes", "0-cells", "12");
}

} // namespace polydec::test::in_discretization
