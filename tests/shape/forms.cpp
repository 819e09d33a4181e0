// SPDX-License-Identifier: MIT
#include "tests/shape/known_shapes.h"

namespace polydec::test::in_forms_of_shapes {

void expect_narrow(const ShapeSpectrum& found, const std::vector<double>& truth, Index zeros) {
    EXPECT_EQ(found.zeros, zeros);
    expect_enclosed(found, truth, 1e-12);
    for (Index j = 0; j < found.upper.size(); ++j)
        EXPECT_LE(found.upper[j] - found.lower[j], 2e-2 * truth[j]) << j;
    EXPECT_GE(found.count.at_least, found.upper.size());
    EXPECT_GE(found.count.at_most.value_or(1000), found.count.at_least);
}

/// Tangential part 0 or not: functions with Dirichlet's condition and free ones, in turn.
TEST(OneForms, of_a_square_have_the_spectra_of_functions_and_densities) {
    const double one = pi * pi;
    const std::vector<double> both{one, one, 2 * one, 2 * one, 4 * one, 4 * one};
    for (const auto condition : {BoundaryCondition::natural, BoundaryCondition::essential}) {
        const Shape square = unmerged(kuhn(2, 6), {condition});
        expect_narrow(shape_spectrum(square, {.degree = 1, .count = 6}), both, 0);
    }
}

TEST(OneForms, of_a_torus_have_everything_twice) {
    const Mesh box = kuhn(2, 6);
    const Shape torus = unmerged(periodic(box, {Vector{{1, 0}}, Vector{{0, 1}}}));
    const double first = 4 * pi * pi;
    std::vector<double> truth{0, 0};
    truth.insert(truth.end(), 8, first);
    expect_narrow(shape_spectrum(torus, {.degree = 1, .count = 10}), truth, 2);
}

/// Functions 0, 4 pi^2 .. and twisted densities pi^2 .., of Betti number 1.
TEST(OneForms, of_a_klein_bottle_have_the_densities_first) {
    const Shape shape = glued_bottle(kuhn(2, 8), 1, 1);
    const double one = pi * pi;
    expect_narrow(shape_spectrum(shape, {.degree = 1, .count = 8}),
                  {0, one, one, 4 * one, 4 * one, 4 * one, 4 * one, 5 * one}, 1);
    EXPECT_EQ(zero_eigenvalues(shape), 1);
    EXPECT_EQ(zero_eigenvalues(top_forms(shape)), 0);
}

TEST(OneForms, are_refused_where_they_are_not_known) {
    const auto refused = [](const Shape& shape) {
        return refusal([&] { shape_spectrum(shape, {.degree = 1, .count = 2}); });
    };
    EXPECT_SAYS(refused(unmerged(kuhn(3, 1))), "1-forms", "dimension 3", "0", "3");
    Shape shape = unmerged(grid(2, 2), {BoundaryCondition::robin, {}, {1}});
    EXPECT_SAYS(refused(shape), "facet 0", "Robin", "1-forms");
    shape = unmerged(grid(2, 2));
    shape.density = Vector::Ones(8);
    EXPECT_SAYS(refused(shape), "1-forms", "weights");
}

/// On a cube densities that are 0 on the boundary, which all are by natural conditions.
TEST(Densities, of_a_solid_are_functions_under_exchanged_conditions) {
    const auto found = shape_spectrum(unmerged(kuhn(3, 4)), {.degree = 3, .count = 1});
    expect_enclosed(found, {3 * pi * pi});
    EXPECT_EQ(found.zeros, 0);
    EXPECT_EQ(count_below(unmerged(kuhn(3, 4)), 25, {.degree = 3}).at_most, 0);
    EXPECT_EQ(count_below(unmerged(kuhn(3, 4)), 31, {.degree = 3}).at_least, 1);
}

/// A sheared torus, whose triangles have angles up to 160 degrees, is the grid again.
TEST(Flips, change_the_mesh_and_not_the_shape) {
    Mesh box = kuhn(2, 8);
    box.points.col(0) += 2 * box.points.col(1);
    const Shape sheared = unmerged(periodic(box, {Vector{{1, 0}}, Vector{{2, 1}}}));
    const FlippedShape grid = flipped(sheared);
    EXPECT_GT(grid.flips, 64);
    const double first = 4 * pi * pi;
    const auto before = shape_spectrum(sheared, {.count = 5});
    const auto after = shape_spectrum(grid.shape, {.count = 5});
    for (const auto& found : {before, after})
        expect_enclosed(found, {0, first, first, first, first});
    for (Index j = 1; j < 5; ++j) {
        EXPECT_LT(widths(after)[j], widths(before)[j] / 4);
        EXPECT_LT(widths(after)[j], 2e-3);
    }
}

TEST(Flips, keep_conditions_and_leave_what_cannot_flip) {
    Mesh mesh = kuhn({6, 3}, {3, 1});
    mesh.points.col(0) += 2 * mesh.points.col(1); // a sheared strip
    const auto left = conditions_of(mesh, {{[](const Eigen::RowVectorXd& p) { return p[1] < 1e-9; },
                                            BoundaryCondition::essential}});
    const Shape strip = unmerged(mesh, left);
    const auto other = flipped(strip);
    EXPECT_GT(other.flips, 0);
    const auto before = shape_spectrum(strip, {.count = 3});
    const auto after = shape_spectrum(other.shape, {.count = 3});
    for (Index j = 0; j < 3; ++j) {
        EXPECT_LE(before.lower[j], after.upper[j]);
        EXPECT_LE(after.lower[j], before.upper[j]);
        EXPECT_GT(after.lower[j], 0);
    }
    std::mt19937 random(3);
    EXPECT_EQ(flipped(book(random, 3, 2).shape).flips, 0);
    EXPECT_EQ(flipped(unmerged(kuhn(3, 1))).flips, 0);
    Shape weighted = strip;
    weighted.density = Vector::LinSpaced(strip.pieces.size(2), 1, 2);
    EXPECT_EQ(flipped(weighted).flips, 0);
}

} // namespace polydec::test::in_forms_of_shapes
