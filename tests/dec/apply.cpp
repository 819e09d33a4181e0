// SPDX-License-Identifier: MIT
#include "dec/forms/apply.h"

#include "dec/forms/derivative.h"
#include "dec/forms/laplacian.h"
#include "dec/forms/star.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

#include <functional>

namespace polydec::test {
namespace {

using Apply = std::function<Vector(const Vector&)>;
using Assemble = std::function<SparseMatrix()>;

class Applied : public OverMeshes {
protected:
    /// Both give the same, or both refuse with the same words.
    void expect_same(Index columns, const Assemble& assemble, const Apply& apply) {
        const Vector x = random_vector(columns, 7);
        SparseMatrix A;
        const std::string refused = refusal([&] { A = assemble(); });
        EXPECT_EQ(refusal([&] { apply(x); }), refused);
        if (!refused.empty())
            return;
        const Vector product = A * x, applied = apply(x);
        ASSERT_EQ(applied.size(), product.size());
        if (product.size() == 0)
            return;
        const Vector sizes = A.cwiseAbs() * x.cwiseAbs();
        EXPECT_LE((applied - product).cwiseAbs().maxCoeff(), 1e-13 * sizes.maxCoeff());
        if (product.cwiseAbs().maxCoeff() > 0) {
            EXPECT_GT((apply(2 * x) - product).cwiseAbs().maxCoeff(), 0);
        }
    }
};

TEST_P(Applied, derivatives_are_products_with_their_matrices) {
    for (const CellComplex* complex : {static_cast<const CellComplex*>(&mesh().K()), &mesh().P()})
        for (int k = -1; k <= mesh().n(); ++k) {
            expect_same(
                complex->size(k), [=] { return derivative(*complex, k); },
                [=](const Vector& x) { return apply_derivative(*complex, k, x); });
            expect_same(
                complex->size(k + 1),
                [=] { return SparseMatrix(derivative(*complex, k).transpose()); },
                [=](const Vector& y) { return apply_transposed_derivative(*complex, k, y); });
        }
}

TEST_P(Applied, codifferentials_and_laplacians_are_products_with_their_matrices) {
    const CellComplex& P = mesh().P();
    const CellVolumes& V = mesh().volumes;
    const int n = mesh().n();
    for (int k = 0; k <= n; ++k) {
        expect_same(
            P.size(k), [&] { return codifferential(P, V, k); },
            [&](const Vector& x) { return apply_codifferential(P, V, k, x); });
        expect_same(
            P.size(n - k), [&] { return dual_codifferential(P, V, k); },
            [&](const Vector& x) { return apply_dual_codifferential(P, V, k, x); });
        expect_same(
            P.size(k), [&] { return laplacian(P, V, k); },
            [&](const Vector& x) { return apply_laplacian(P, V, k, x); });
        expect_same(
            P.size(k), [&] { return symmetric_laplacian(P, V, k); },
            [&](const Vector& x) { return apply_symmetric_laplacian(P, V, k, x); });
        expect_same(
            P.size(n - k), [&] { return dual_laplacian(P, V, k); },
            [&](const Vector& x) { return apply_dual_laplacian(P, V, k, x); });
    }
}

TEST_P(Applied, diagonals_of_symmetric_laplacians_are_theirs) {
    for (int k = 0; k <= mesh().n(); ++k) {
        SparseMatrix A;
        Vector diagonal;
        const auto assemble = [&] { A = symmetric_laplacian(mesh().P(), mesh().volumes, k); };
        const std::string refused = refusal(assemble);
        EXPECT_EQ(refusal([&] {
                      diagonal = symmetric_laplacian_diagonal(mesh().P(), mesh().volumes, k);
                  }),
                  refused);
        if (refused.empty()) {
            EXPECT_LE((A.diagonal() - diagonal).cwiseAbs().maxCoeff(),
                      1e-13 * diagonal.cwiseAbs().maxCoeff())
                << k;
        }
    }
}

TEST_P(Applied, operators_refuse_values_of_another_number) {
    const CellComplex& P = mesh().P();
    EXPECT_EQ(refusal([&] { apply_derivative(P, 0, Vector::Zero(P.size(0) + 1)); }),
              std::to_string(P.size(0) + 1) + " values are given for " + std::to_string(P.size(0)) +
                  " 0-cells");
}

POLYDEC_OVER_MESHES(Applied);

} // namespace
} // namespace polydec::test
