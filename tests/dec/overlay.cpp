// SPDX-License-Identifier: MIT
#include "dec/surfaces/strand_places.h"
#include "tests/support/test.h"

namespace polydec::test::in_overlay {

class Overlays : public testing::TestWithParam<std::string> {
protected:
    Discretization mesh(Delaunay delaunay = Delaunay::flips_and_splits) const {
        return discretize(shaken(mesh_named(GetParam()), 0.25, 7), {.delaunay = delaunay});
    }
};

Vector sums(const std::vector<Index>& groups, const Vector& values, Eigen::Index size) {
    Vector result = Vector::Zero(size);
    for (std::size_t i = 0; i < groups.size(); ++i)
        result[groups[i]] += values[static_cast<Eigen::Index>(i)];
    return result;
}

TEST_P(Overlays, cut_both_triangulations_into_the_same_pieces) {
    for (const auto delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
        const auto mesh = this->mesh(delaunay);
        if (mesh.passage().is_identity())
            continue;
        const Overlay pieces = overlay(mesh.passage(), mesh.points());
        const Vector& input = mesh.input_geometry().volumes().primal(2);
        const Vector& flipped = mesh.geometry().volumes().primal(2);
        EXPECT_LT(relative_difference(sums(pieces.input, pieces.areas, input.size()), input), 1e-9);
        EXPECT_LT(relative_difference(sums(pieces.triangle, pieces.areas, flipped.size()), flipped),
                  1e-9);
    }
}

TEST_P(Overlays, have_strands_whose_crossings_ascend) {
    const auto mesh = this->mesh();
    const auto& T = mesh.passage().flips();
    const Strands strands = trace(T.surface, T.crossings);
    const auto places = strand_places(T.surface, T.lengths, strands);
    for (std::size_t s = 0; s < strands.ends.size(); ++s)
        for (std::size_t c = strands.offsets[s]; c < strands.offsets[s + 1]; ++c) {
            EXPECT_GT(places[c], c == strands.offsets[s] ? 0 : places[c - 1]);
            EXPECT_LT(places[c], 1);
        }
}

TEST_P(Overlays, bring_functions_of_cells_back_as_means) {
    const auto mesh = this->mesh();
    const Vector u = random_vector(mesh.complex().size(2), 2);
    const Vector means = to_input(mesh, {Side::dual, 0, u}).values;
    EXPECT_LE(means.cwiseAbs().maxCoeff(), u.cwiseAbs().maxCoeff() + 1e-12);
    if (mesh.input().orientable()) {
        EXPECT_NEAR(means.dot(mesh.input_geometry().volumes().primal(2)),
                    u.dot(mesh.volumes().primal(2)), 1e-9 * mesh.volumes().primal(2).sum());
    }
}

TEST_P(Overlays, bring_functions_of_cells_back_with_the_signs_that_flips_give) {
    // triangles oriented at random: where the surface is one-sided they stay so
    Mesh input = shaken(mesh_named(GetParam()), 0.25, 7);
    std::mt19937 random(5);
    for (Index t = 0; t < input.simplices.rows(); ++t)
        if (random() % 2 == 0)
            std::swap(input.simplices(t, 0), input.simplices(t, 1));
    const auto mesh =
        discretize(input, {.criterion = MergeCriterion::none, .delaunay = Delaunay::flips});
    for (Index t = 0; t < mesh.complex().size(2); ++t) {
        const Vector one = Vector::Unit(mesh.complex().size(2), t);
        const Vector by_flips =
            mesh.passage().back(2, mesh.merging().diamond(2).cast<double>().transpose() * one);
        EXPECT_GT(by_flips.dot(to_input(mesh, {Side::dual, 0, one}).values), 0) << "triangle " << t;
    }
}

TEST_P(Overlays, know_what_crosses_by_integers_that_one_missed_flip_spoils) {
    const auto mesh = this->mesh(Delaunay::flips);
    const auto& T = mesh.passage().flips();
    if (T.statistics.flips == 0)
        return;
    const NormalCoordinates ignorant(T.surface);
    EXPECT_LT(trace(T.surface, ignorant).ends.size(), trace(T.surface, T.crossings).ends.size());
}

INSTANTIATE_TEST_SUITE_P(Family, Overlays, testing::ValuesIn(names_of_surfaces()), parameter_name);

TEST(Overlay, refuses_values_at_other_vertices) {
    const auto mesh = discretize(shaken(grid(4, 4), 0.25, 7), {.delaunay = Delaunay::flips});
    const auto both = overlay(mesh.passage(), mesh.points());
    ASSERT_FALSE(both.crossings.empty());
    EXPECT_EQ(both.at_points(mesh.points()), both.points);
    for (const auto& values : {Points(mesh.points().topRows(24)), both.points})
        EXPECT_REFUSED(both.at_points(values), std::to_string(values.rows()), "vertices", "25");
}

TEST(Overlay, is_refused_without_flips) {
    const auto mesh = discretize(grid(2, 2));
    EXPECT_REFUSED(overlay(mesh.passage(), mesh.points()), "overlay", "flipped", "delaunay");
}

} // namespace polydec::test::in_overlay
