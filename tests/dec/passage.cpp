// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"

namespace polydec::test::in_passage {

constexpr double rounding = 1e-11;

class AfterFlips : public testing::TestWithParam<std::tuple<std::string, Delaunay>> {
protected:
    Discretization mesh() const {
        const auto& [name, delaunay] = GetParam();
        return discretize(shaken(mesh_named(name), 0.25, 7), {.delaunay = delaunay});
    }
};

TEST_P(AfterFlips, a_product_with_forms_of_the_triangles_before_flips_would_break_it) {
    // what was computed before flips were carried: sizes may agree, and the rule does not
    const auto mesh = this->mesh();
    if (mesh.passage().flips().statistics.flips == 0 ||
        mesh.pieces().size(1) != mesh.input().size(1))
        return;
    const auto& P = mesh.pieces();
    const Cochain a{Side::primal, 0, random_vector(P.size(0), 3)};
    const Cochain b{Side::primal, 0, random_vector(P.size(0), 4)};
    const Vector left = d(P, wedge(P, a, b)).values;
    const auto product = [&](const Pieces& pieces) {
        return Vector(wedge(pieces, d(P, a), b).values + wedge(pieces, a, d(P, b)).values);
    };
    EXPECT_LT(relative_difference(left, product(P)), rounding);
    EXPECT_GT(relative_difference(left, product(mesh.input())), 1e-3);
}

TEST_P(AfterFlips, forms_do_not_depend_on_numbers) {
    const auto& [name, delaunay] = GetParam();
    Mesh given = shaken(mesh_named(name), 0.25, 7);
    given.points.col(0) *= 0.1; // which takes several flips of an edge
    const auto norm_on = [how = delaunay](const Mesh& mesh) {
        const auto N = mesh.points.cols();
        const auto made = discretize(mesh, {.delaunay = how});
        const auto form = de_rham(made, 1, [N](const Vector& x) {
            return Vector::NullaryExpr(
                N, [&](Index i) { return std::sin(3 * x.sum() + 2 * x[i] + double(i)); });
        });
        return norm(made, form);
    };
    const double expected = norm_on(given);
    for (const std::uint64_t seed : {1, 2, 3})
        EXPECT_NEAR(norm_on(shuffled(given, seed).mesh) / expected, 1, 1e-9);
}

TEST_P(AfterFlips, dual_forms_go_back_by_maps_that_commute_with_d) {
    const auto mesh = this->mesh();
    const auto w = random_form(mesh.complex(), Side::dual, 1, 5);
    const Vector there = to_input(mesh, d(mesh.complex(), w)).values;
    EXPECT_LT(relative_difference(there, d(mesh.input(), to_input(mesh, w)).values), rounding);
}

TEST_P(AfterFlips, dual_forms_are_paired_with_primal_ones_as_before) {
    const auto mesh = this->mesh();
    for (int degree = 1; degree <= 2; ++degree) {
        const int k = 2 - degree;
        const auto w = random_form(mesh.complex(), Side::dual, degree, 6);
        const Cochain a{Side::primal, k, random_vector(mesh.input().size(k), 7)};
        const double there = w.values.dot(to_merged(mesh, a).values);
        EXPECT_NEAR(to_input(mesh, w).values.dot(a.values), there,
                    rounding * w.values.norm() * a.values.norm());
    }
}

/// Dual forms are merged by cochain maps: the transposes of those that split up primal ones.
void expect_transposed(const Discretization& mesh) {
    for (int degree = 0; degree <= 2; ++degree) {
        const int k = 2 - degree;
        const Cochain w{Side::primal, k, random_vector(mesh.complex().size(k), 6)};
        const Cochain z{Side::dual, degree, random_vector(mesh.input().size(k), 7)};
        const Cochain here = to_merged(mesh, z);
        EXPECT_NEAR(w.values.dot(here.values), to_input(mesh, w).values.dot(z.values),
                    rounding * w.values.norm() * z.values.norm())
            << degree;
        if (degree < 2) {
            const Vector later = to_merged(mesh, d(mesh.input(), z)).values;
            EXPECT_LT(relative_difference(d(mesh.complex(), here).values, later), rounding)
                << degree;
        }
    }
}

TEST_P(AfterFlips, dual_forms_are_merged_by_transposed_maps) {
    expect_transposed(mesh());
}

TEST(OnASquashedTorus, dual_forms_are_merged_by_transposed_maps) {
    Mesh squashed = torus(7, 5); // whose triangles flip, and merge
    squashed.points.col(2) *= 0.1;
    const auto mesh = discretize(squashed, {.delaunay = Delaunay::flips});
    ASSERT_GT(mesh.passage().flips().statistics.flips, 0);
    ASSERT_LT(mesh.complex().size(1), mesh.pieces().size(1));
    expect_transposed(mesh);
}

TEST_P(AfterFlips, the_parts_of_the_duals_fill_every_triangle) {
    const auto mesh = this->mesh();
    for (int k = 0; k <= 2; ++k)
        for (int m = k; m <= 2; ++m) {
            const SparseMatrix parts = dual_parts(mesh.geometry(), {}, k, m);
            const Vector filled = parts * mesh.geometry().volumes().primal(k);
            const double times = k == 0 || k == m ? 1 : m; // C(m, k) for m up to 2
            EXPECT_LT(relative_difference(filled, times * mesh.geometry().volumes().primal(m)),
                      1e-9);
        }
}

TEST_P(AfterFlips, products_of_dual_forms_keep_their_sign_in_either_order) {
    const auto mesh = this->mesh();
    if (!star(mesh.volumes(), 0).zeros().empty() || !star(mesh.volumes(), 1).zeros().empty())
        return;
    const auto a = random_form(mesh.complex(), Side::dual, 1, 10),
               b = random_form(mesh.complex(), Side::dual, 1, 11);
    EXPECT_LT(relative_difference(dual_wedge(mesh, a, b).values, -dual_wedge(mesh, b, a).values),
              1e-9);
}

TEST_P(AfterFlips, operators_are_carried_to_the_input_and_back) {
    const auto mesh = this->mesh();
    for (int k = 0; k <= 1; ++k) {
        const SparseMatrix d = mesh.complex().coboundary(k).cast<double>();
        const SparseMatrix on_simplices =
            on_input(mesh, d, {Side::primal, k}, {Side::primal, k + 1});
        EXPECT_EQ(on_simplices.rows(), mesh.input().size(k + 1));
        EXPECT_EQ(on_simplices.cols(), mesh.input().size(k));
        const Vector a = random_vector(mesh.input().size(k), 8);
        const Vector there = d * to_merged(mesh, {Side::primal, k, a}).values;
        const Vector pieces =
            primal_to_input(mesh.merging(), mesh.geometry().volumes(), k + 1) * there;
        EXPECT_LT(relative_difference(on_simplices * a, mesh.passage().back(k + 1, pieces)),
                  rounding);
    }
}

TEST_P(AfterFlips, pieces_are_not_taken_for_straight_ones) {
    const auto mesh = this->mesh();
    if (!mesh.passage().is_identity())
        EXPECT_REFUSED(circumcentric_volumes(mesh.pieces(), mesh.points()), "glued", "lengths");
}

/// On a flat surface constant forms have constant products, whatever was flipped.
TEST(OnAFlippedSquare, products_of_constant_dual_forms_are_exact) {
    const auto mesh = discretize(perturbed(grid(9, 9), 0.04, 3),
                                 {.delaunay = Delaunay::flips, .star = StarKind::circumcentric});
    ASSERT_GT(mesh.passage().flips().statistics.flips, 0);
    const auto constant = [&](double x, double y) {
        const auto form = circulation_form([=](const Vector&) { return Vector{{x, y}}; });
        const Vector a = de_rham(mesh, 1, form, 1).values;
        return Cochain{Side::dual, 1, star(mesh.volumes(), 1).diagonal().cwiseProduct(a)};
    };
    const Vector product = dual_wedge(mesh, constant(2, 1), constant(-1, 3)).values;
    EXPECT_LT(relative_difference(product, 7 * mesh.volumes().dual(0)), 1e-10);
    EXPECT_GT(relative_difference(product, 7 * mesh.input_geometry().volumes().dual(0)), 1e-2);
}

TEST(WithoutFlips, the_passage_takes_cochains_of_the_simplices_alone) {
    const auto mesh = discretize(grid(2, 2));
    const auto& passage = mesh.passage();
    const Vector values = Vector::Ones(mesh.input().size(1));
    EXPECT_EQ(passage.forth(1, values), values);
    const Words other{"16 values", "0-cells", "9"};
    EXPECT_REFUSED(passage.forth(0, values), other);
    EXPECT_REFUSED(passage.back(0, values), other);
    EXPECT_THROW(passage.matrix(3), InvalidInput);
    EXPECT_THROW(passage.matrix_back(-1), InvalidInput);
}

INSTANTIATE_TEST_SUITE_P(Family, AfterFlips,
                         testing::Combine(testing::ValuesIn(names_of_surfaces()),
                                          testing::Values(Delaunay::flips,
                                                          Delaunay::flips_and_splits)),
                         [](const auto& instance) {
                             const bool is_split =
                                 std::get<1>(instance.param) == Delaunay::flips_and_splits;
                             return std::get<0>(instance.param) + (is_split ? "_splits" : "_flips");
                         });

TEST(NoFlips, leave_tags_points_and_boxes_as_they_are) {
    Mesh mesh = well_centered(4);
    for (Index t = 0; t < mesh.simplices.rows(); ++t)
        mesh.tags.push_back(t % 2 + 1);
    const auto plain = discretize(mesh), flipped = discretize(mesh, {.delaunay = Delaunay::flips});
    EXPECT_EQ(flipped.passage().flips().statistics.flips, 0);
    EXPECT_EQ(diagnose(flipped).flips->statistics.flips, 0);
    EXPECT_TRUE(flipped.passage().is_identity());
    EXPECT_EQ(flipped.tags(), plain.tags());
    EXPECT_EQ(flipped.warnings(), plain.warnings());
    for (int k = 0; k <= 2; ++k)
        EXPECT_EQ(flipped.stars()[k].diagonal(), plain.stars()[k].diagonal()) << k;
    EXPECT_THROW(overlay(flipped.passage(), flipped.points()), InvalidInput);

    const PeriodicMesh box = periodic(grid(4, 4), {Vector{{1, 0}}, Vector{{0, 1}}});
    const auto glued = discretize(box, {.delaunay = Delaunay::flips});
    EXPECT_TRUE(glued.warnings().empty());
    EXPECT_EQ(glued.points(), discretize(box).points());
}

} // namespace polydec::test::in_passage
