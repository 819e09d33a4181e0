// SPDX-License-Identifier: MIT
//
// Hodge decompositions and harmonic forms by stars that are no diagonal.
#include "dec/forms/boundary_conditions.h"
#include "dec/operators.h"
#include "meshes/generate.h"
#include "solvers/hodge.h"
#include "tests/solvers/hodge_laws.h"
#include "tests/solvers/star_samples.h"
#include "tests/support/circumcentric.h"
#include "tests/support/glued.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test::in_hodge_by_stars {
namespace {

constexpr double rounding = 1e-10;

class HodgeByStars : public OverMeshes {
protected:
    /// Calls law(complex, stars, k) for cells and simplices, relative to the boundary too, with
    /// stars of every kind and every degree.
    template <class Law>
    void for_all(Law law) const {
        for (const auto& [title, mesh, chosen] : with_star_kinds(mesh_named(GetParam()))) {
            const auto relative = relative_to_boundary(mesh.complex());
            const HodgeStars restricted = relative_stars(relative, mesh.stars());
            for (int k = 0; k <= mesh.dimension(); ++k) {
                SCOPED_TRACE(title + ", k = " + std::to_string(k));
                law(mesh.complex(), mesh.stars(), k);
                if (relative.complex.size(k) > 0 &&
                    relative.complex.size(k) < mesh.complex().size(k)) {
                    SCOPED_TRACE("relative to the boundary");
                    law(relative.complex, restricted, k);
                }
            }
        }
    }
};

TEST_P(HodgeByStars, parts_are_orthogonal_and_have_their_potentials) {
    for_all(expect_orthogonal_parts);
}

TEST_P(HodgeByStars, harmonic_forms_are_as_many_as_betti_numbers_say) {
    for_all(expect_harmonic_forms);
}

TEST_P(HodgeByStars, exact_and_coexact_forms_have_no_other_part) {
    for_all(expect_parts_stay);
}

POLYDEC_OVER_MESHES(HodgeByStars);

TEST(HodgeByOtherStars, parts_are_orthogonal_in_their_own_inner_product_alone) {
    const auto mesh = circumcentric(shaken(grid(6, 6), 0.42, 3));
    const auto stars = mesh.with_stars(StarKind::automatic).stars();
    const auto other = mesh.with_stars(StarKind::barycentric).stars();
    ASSERT_FALSE(stars[1].is_diagonal());
    const Cochain w{Side::primal, 1, random_vector(mesh.complex().size(1), 1)};
    const auto parts = hodge_decomposition(mesh.complex(), stars, w);
    EXPECT_GT(std::abs(inner_product(mesh.complex(), other, parts.exact, parts.coexact)),
              1e-3 * inner_product(mesh.complex(), other, w, w));
}

/// Stars of the same cells measured in another unit.
TEST(HodgeByOtherStars, parts_of_cells_of_every_size_are_the_same) {
    const auto mesh = circumcentric(shaken(kuhn(3, 2), 0.3, 3));
    const auto& complex = mesh.complex();
    const auto chosen = mesh.with_stars(StarKind::galerkin).stars();
    const Cochain w{Side::primal, 1, random_vector(complex.size(1), 1)};
    const auto here = hodge_decomposition(complex, chosen, w);
    for (const double factor : {0x1p-300, 0x1p300}) {
        const auto stars = chosen.with(1, factor * chosen[1].matrix());
        const auto there = hodge_decomposition(complex, stars, w);
        EXPECT_LE(relative_difference(there.exact.values, here.exact.values), rounding);
        EXPECT_LE(relative_difference(there.coexact.values, here.coexact.values), rounding);
        EXPECT_LE(relative_difference(there.copotential.values / factor, here.copotential.values),
                  1e-6); // but for what d takes to 0
        EXPECT_EQ(harmonic_forms(complex, stars, Side::primal, 1).cols(), 0);
    }
}

TEST(HodgeByOtherStars, refuse_a_matrix_that_is_not_definite) {
    const auto mesh = circumcentric(grid(2, 2));
    SparseMatrix M(mesh.complex().size(1), mesh.complex().size(1));
    M.setIdentity();
    M.coeffRef(0, 1) = M.coeffRef(1, 0) = 2;
    const auto stars = mesh.stars().with(1, M);
    EXPECT_TRUE(says(refusal([&] { HodgeSolver(mesh.complex(), stars, Side::primal, 1); }),
                     {"negative eigenvalue"}));
}

} // namespace
} // namespace polydec::test::in_hodge_by_stars
