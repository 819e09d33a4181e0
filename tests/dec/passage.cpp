// SPDX-License-Identifier: MIT
#include "dec/discretization.h"
#include "dec/fields/dual_wedge.h"
#include "dec/fields/transfer.h"
#include "dec/fields/wedge.h"
#include "dec/forms/apply.h"
#include "dec/metric/dual_parts.h"
#include "tests/support/families.h"
#include "tests/support/glued.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

namespace polydec::test {
namespace {

constexpr double rounding = 1e-11;

/// What holds of forms on simplices and merged cells holds after flips and splits as well.
class AfterFlips : public testing::TestWithParam<std::tuple<std::string, Delaunay>> {
protected:
    Discretization mesh() const {
        const auto& [name, delaunay] = GetParam();
        return discretize(shaken(mesh_named(name), 0.25, 7), {.delaunay = delaunay});
    }
    Cochain random(const Discretization& mesh, Side side, int degree, unsigned seed) const {
        const int k = cell_degree(mesh.complex(), side, degree);
        return {side, degree, random_vector(mesh.complex().size(k), seed)};
    }
};

TEST_P(AfterFlips, products_of_primal_forms_keep_the_rule_of_Leibniz) {
    const auto mesh = this->mesh();
    const auto& P = mesh.complex();
    for (const auto weights : {WedgeWeights::uniform, WedgeWeights::circumcentric})
        for (int k = 0; k < 2; ++k)
            for (int l = 0; k + l < 2; ++l) {
                const auto a = random(mesh, Side::primal, k, 3),
                           b = random(mesh, Side::primal, l, 4);
                const Vector left = d(P, wedge(mesh, a, b, weights)).values;
                const Vector right =
                    wedge(mesh, d(P, a), b, weights).values +
                    (k % 2 == 0 ? 1 : -1) * wedge(mesh, a, d(P, b), weights).values;
                const bool has_rule = weights == WedgeWeights::uniform;
                if (has_rule) {
                    EXPECT_LT(relative_difference(left, right), rounding) << k << ", " << l;
                }
                const Vector turned = wedge(mesh, b, a, weights).values;
                EXPECT_LT(relative_difference(turned, (k * l % 2 == 0 ? 1 : -1) *
                                                          wedge(mesh, a, b, weights).values),
                          rounding);
            }
}

TEST_P(AfterFlips, a_product_with_forms_of_the_triangles_before_flips_would_break_it) {
    // what was computed before flips were carried: sizes may agree, and the rule does not
    const auto mesh = this->mesh();
    if (mesh.passage.flips().statistics.flips == 0 || mesh.pieces().size(1) != mesh.input().size(1))
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

TEST_P(AfterFlips, dual_forms_go_back_by_maps_that_commute_with_d) {
    const auto mesh = this->mesh();
    const auto w = random(mesh, Side::dual, 1, 5);
    const Vector there = to_input(mesh, d(mesh.complex(), w)).values;
    EXPECT_LT(relative_difference(there, d(mesh.input(), to_input(mesh, w)).values), rounding);
}

TEST_P(AfterFlips, dual_forms_are_paired_with_primal_ones_as_before) {
    const auto mesh = this->mesh();
    for (int degree = 1; degree <= 2; ++degree) {
        const int k = 2 - degree;
        const auto w = random(mesh, Side::dual, degree, 6);
        const Cochain a{Side::primal, k, random_vector(mesh.input().size(k), 7)};
        const double there = w.values.dot(to_merged(mesh, a).values);
        EXPECT_NEAR(to_input(mesh, w).values.dot(a.values), there,
                    rounding * w.values.norm() * a.values.norm());
    }
}

TEST_P(AfterFlips, the_parts_of_the_duals_fill_every_triangle) {
    const auto mesh = this->mesh();
    for (int k = 0; k <= 2; ++k)
        for (int m = k; m <= 2; ++m) {
            const SparseMatrix parts =
                dual_parts(mesh.pieces(), mesh.metric(), mesh.piece_volumes, k, m);
            const Vector filled = parts * mesh.piece_volumes.primal(k);
            const double times = k == 0 || k == m ? 1 : m; // C(m, k) for m up to 2
            EXPECT_LT(relative_difference(filled, times * mesh.piece_volumes.primal(m)), 1e-9);
        }
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
        const Vector pieces = primal_to_input(mesh.merging, mesh.piece_volumes, k + 1) * there;
        EXPECT_LT(relative_difference(on_simplices * a, mesh.passage.back(k + 1, pieces)),
                  rounding);
    }
}

std::string with_delaunay(const testing::TestParamInfo<std::tuple<std::string, Delaunay>>& info) {
    const auto& [name, delaunay] = info.param;
    return name + (delaunay == Delaunay::flips ? "_flips" : "_splits");
}

INSTANTIATE_TEST_SUITE_P(Family, AfterFlips,
                         testing::Combine(testing::ValuesIn(names_of_surfaces()),
                                          testing::Values(Delaunay::flips,
                                                          Delaunay::flips_and_splits)),
                         with_delaunay);

} // namespace
} // namespace polydec::test
