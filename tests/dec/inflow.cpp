// SPDX-License-Identifier: MIT
#include "complex/components.h"
#include "dec/fields/lie_derivative.h"
#include "dec/forms/cochain.h"
#include "tests/dec/discretized.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polydec::test::in_inflow {
namespace {

/// Of functions, by a field that flows in and out wherever it likes.
class Inflow : public OverMeshes {
protected:
    Points field() const {
        const auto rows = mesh().points.rows(), columns = mesh().points.cols();
        return random_vector(static_cast<Index>(rows * columns), 7).reshaped(rows, columns);
    }
    const Discretization& simplices() const {
        return discretized(GetParam(), MergeCriterion::none);
    }
    SparseMatrix L() const { return lie_derivative(simplices(), field(), 0, Sampling::upwind); }
    SparseMatrix rates() const { return inflow(simplices(), field(), 0); }
};

/// The largest size of values that begin with sizes up to 1, carried for many steps at the limit,
/// with the same values outside all the time.
double largest_ever(const SparseMatrix& L, const SparseMatrix& rates, const Vector& outside) {
    const double time = 1 / std::max(Vector(L.diagonal()).maxCoeff(), 1e-300);
    Vector u = random_vector(static_cast<Index>(L.rows()), 3);
    double result = 0;
    for (int step = 0; step < 300; ++step) {
        u -= time * (L * u - rates * outside);
        result = std::max(result, u.cwiseAbs().maxCoeff());
    }
    return result;
}

TEST_P(Inflow, brings_nothing_where_nothing_is_given_and_else_what_is_given) {
    const Vector zero = Vector::Zero(L().rows());
    for (const double g : {0.0, 0.5, 1.0})
        EXPECT_LE(largest_ever(L(), rates(), zero.array() + g), 1 + 1e-12) << g;
    if (largest(rates()) > 0) {
        EXPECT_GT(largest_ever(L(), rates(), zero.array() + 3), 1.1);
        EXPECT_LE(largest_ever(L(), rates(), zero.array() + 3), 3 + 1e-12);
    }
}

TEST_P(Inflow, keeps_what_is_the_same_inside_and_outside) {
    const Vector ones = Vector::Ones(L().rows());
    EXPECT_LE((L() * ones - rates() * ones).cwiseAbs().maxCoeff(), 1e-12 * largest(L()));
}

TEST_P(Inflow, is_on_the_boundary_alone) {
    const auto boundary = boundary_cells(mesh().K());
    for (int k = 0; k <= mesh().n(); ++k) {
        const Vector rate = inflow(simplices(), field(), k).diagonal();
        for (Index s = 0; s < rate.size(); ++s)
            EXPECT_TRUE(rate[s] == 0 || (rate[s] > 0 && boundary[k][s]));
    }
}

/// Of n-forms that are nowhere negative, on coherently oriented cells.
TEST_P(Inflow, never_makes_more_of_a_density) {
    const int n = mesh().n();
    const SparseMatrix L = lie_derivative(simplices(), field(), n, Sampling::upwind);
    const Vector gain = -(Eigen::RowVectorXd::Ones(L.rows()) * L).transpose();
    if (mesh().K().orientable() && is_flat(mesh_named(GetParam()))) {
        EXPECT_LE(gain.maxCoeff(), 1e-12 * largest(L));
    }
}

POLYDEC_OVER_MESHES(Inflow);

/// Taken from the nearest simplex instead of from outside, values grow without bound.
TEST(InflowBroken, by_the_nearest_simplex_grows) {
    for (const char* name : {"segments4", "grid4", "wellcentred4", "kuhn3"}) {
        const auto& mesh = merged(name);
        Points wind = -mesh.points; // inwards from everywhere, and the faster the farther out
        wind.rowwise() += mesh.points.colwise().mean();
        const SparseMatrix L =
            interior_product(discretized(name, MergeCriterion::none), wind, 1, Sampling::upwind) *
            derivative(mesh.K(), 0);
        const SparseMatrix none(L.rows(), L.cols());
        EXPECT_GT(largest_ever(L, none, Vector::Zero(L.rows())), 1e9) << name;
    }
}

} // namespace
} // namespace polydec::test::in_inflow
