// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"

namespace polydec::test::in_lie_derivative {

constexpr double rounding = 1e-11;

class LieDerivatives : public OverMeshes {
protected:
    /// Functions have no upwind transport at vertices from splits.
    static int first_degree(const Discretization& mesh, Sampling sampling) {
        const bool is_split = mesh.pieces().size(0) > mesh.input().size(0);
        return is_split && sampling == Sampling::upwind ? 1 : 0;
    }
};

TEST_P(LieDerivatives, without_a_matrix_do_what_the_matrices_do) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const Points field = random_field(mesh, 7), other = random_field(mesh, 8);
        for (const auto sampling : {Sampling::centered, Sampling::upwind})
            for (int k = first_degree(mesh, sampling); k <= mesh.dimension(); ++k) {
                const LieDerivative along(mesh, k, sampling);
                const Cochain a = random_form(mesh.complex(), Side::primal, k, 3);
                const SparseMatrix L = lie_derivative(mesh, field, k, sampling);
                const Vector found = along(field, a).values;
                EXPECT_WITHIN(found, L * a.values, rounding * (1 + largest(L))) << k;
                EXPECT_CLOSE(along.interior_product(field, a).values,
                             interior_product(mesh, field, k, sampling) * a.values, rounding)
                    << k;
                // the field is that of the call, not of one before
                if (found.norm() > 1e-6 * largest(L)) {
                    EXPECT_GT((along(other, a).values - found).norm(), 1e-3 * found.norm()) << k;
                }
            }
    });
}

TEST_P(LieDerivatives, let_in_what_the_matrix_of_inflow_lets_in) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const Points field = random_field(mesh, 7);
        for (int k = first_degree(mesh, Sampling::upwind); k <= mesh.dimension(); ++k) {
            const Cochain g = random_form(mesh.complex(), Side::primal, k, 3);
            const LieDerivative along(mesh, k, Sampling::upwind);
            EXPECT_CLOSE(along.inflow(field, g).values, inflow(mesh, field, k) * g.values, rounding)
                << k;
        }
    });
}

POLYDEC_OVER_MESHES(LieDerivatives);

/// Functions keep their range in an upwind step of the largest size; vertices from splits have no
/// such step.
TEST(LieDerivativesAfterFlips, transport_functions_within_their_range_or_refuse) {
    Mesh sheared = grid(6, 6);
    sheared.points.col(0) += 2 * sheared.points.col(1);
    const auto field_on = [](const Discretization& mesh) {
        return Points(Points::Ones(mesh.points().rows(), 2));
    };
    const auto flipped = discretize(sheared, {.delaunay = Delaunay::flips});
    const SparseMatrix L = lie_derivative(flipped, field_on(flipped), 0, Sampling::upwind);
    const Vector u = random_vector(flipped.complex().size(0), 3).cwiseAbs();
    const Vector after = u - L * u / L.diagonal().maxCoeff();
    EXPECT_GE(after.minCoeff(), -rounding);
    EXPECT_LE(after.maxCoeff(), u.maxCoeff() + rounding);

    const auto split = discretize(sheared, {.delaunay = Delaunay::flips_and_splits});
    ASSERT_GT(split.complex().size(0), flipped.complex().size(0));
    EXPECT_REFUSED(lie_derivative(split, field_on(split), 0, Sampling::upwind), "monotone",
                   "vertices", "Delaunay::flips", "centered");
    EXPECT_REFUSED(LieDerivative(split, 0, Sampling::upwind), "monotone", "Delaunay::flips");
    EXPECT_NO_THROW(lie_derivative(split, field_on(split), 1, Sampling::upwind));
    EXPECT_NO_THROW(lie_derivative(split, field_on(split), 0, Sampling::centered));
}

TEST(LieDerivativeErrors, name_the_kind_of_form_and_the_degree) {
    const auto& mesh = discretized("grid4");
    const Points field = Points::Ones(mesh.points().rows(), 2);
    EXPECT_REFUSED(LieDerivative(mesh, 3, Sampling::centered), "vector field", "3-forms", "0", "2");
    const LieDerivative along(mesh, 1, Sampling::centered);
    const auto form = random_form(mesh.complex(), Side::dual, 1, 1);
    EXPECT_REFUSED(along(field, form), "dual 1-form", "Lie derivative", "primal 1-forms");
    const LieDerivative on_simplices(discretized("grid4", MergeCriterion::none), 2,
                                     Sampling::centered);
    const auto area = random_form(mesh.input(), Side::primal, 2, 1);
    EXPECT_REFUSED(on_simplices(Points::Ones(7, 2), area), "vector field", "7 x 2", "25 x 2",
                   "point");
}

} // namespace polydec::test::in_lie_derivative
