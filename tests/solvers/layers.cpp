// SPDX-License-Identifier: MIT
#include "dec/discretization.h"
#include "meshes/generate.h"
#include "solvers/poisson.h"
#include "solvers/spectrum.h"
#include "tests/support/hand_made.h"
#include "tests/support/scales.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test {
namespace {

double error_of_linear_solution(const Mesh& input, Side side, const MergeOptions& options = {}) {
    const auto mesh = discretize(input, options);
    PoissonSolver solver(mesh, {.side = side});
    const auto linear = [&](const Points& sites) {
        const Vector slopes = Vector::LinSpaced(sites.cols(), 1.0, -2.0);
        return Vector((sites * slopes).array() + 0.3);
    };
    const Vector u =
        solver.solve(Vector::Zero(solver.sites().rows()), linear(solver.boundary_sites()));
    return (u - linear(solver.sites())).cwiseAbs().maxCoeff();
}

TEST(ThinLayers, keep_linear_functions_on_both_sides) {
    for (const Side side : {Side::primal, Side::dual})
        for (const double thickness : {1e-3, 1e-4, 1e-5, 1e-6}) {
            EXPECT_LE(error_of_linear_solution(layers(2, 10, thickness), side), 1e-9) << thickness;
            EXPECT_LE(error_of_linear_solution(layers(3, 5, thickness), side), 1e-9) << thickness;
        }
}

TEST(ThinLayers, keep_linear_functions_after_flips_as_far_as_lengths_know_their_angles) {
    for (const Side side : {Side::primal, Side::dual})
        for (const double thickness : {1e-3, 1e-4})
            EXPECT_LE(error_of_linear_solution(layers(2, 10, thickness), side,
                                               {.delaunay = Delaunay::flips}),
                      1e-9)
                << thickness;
}

TEST(ThinLayers, keep_linear_functions_where_boxes_grow) {
    for (const Side side : {Side::primal, Side::dual}) {
        EXPECT_LE(error_of_linear_solution(graded(2, 10, 1e5), side), 1e-9);
        EXPECT_LE(error_of_linear_solution(graded(3, 6, 3e4), side), 1e-9);
    }
}

/// Largest error of sin(pi x) y with y across the layers, so that -Laplace is pi^2 of itself.
double error_of_wave(int cells, double thickness, Side side) {
    const Mesh input = layers(2, cells, thickness / cells);
    const auto mesh = discretize(input);
    PoissonSolver solver(mesh, {.side = side});
    const auto wave = [&](const Points& sites) {
        return Vector((M_PI * sites.col(0)).array().sin() * (1 + sites.col(1).array() / thickness));
    };
    const Vector u =
        solver.solve(M_PI * M_PI * wave(solver.sites()), wave(solver.boundary_sites()));
    return (u - wave(solver.sites())).cwiseAbs().maxCoeff() /
           wave(solver.sites()).cwiseAbs().maxCoeff();
}

TEST(ThinLayers, have_the_errors_of_interpolation_at_their_boundary) {
    // in a thin strip the boundary values decide: what is left falls with order 2 at least
    for (const Side side : {Side::primal, Side::dual})
        EXPECT_LE(error_of_wave(32, 1e-3, side), error_of_wave(16, 1e-3, side) / 3);
}

TEST(TwoSpheres, of_radii_1_and_1e_6_have_their_spectra_in_every_degree) {
    Mesh small = icosphere(2);
    small.points *= 1e-6;
    const auto one = discretize(icosphere(2)), both = discretize(united(icosphere(2), small));
    for (int k = 0; k <= 2; ++k) {
        const Vector alone = spectrum(one, {.degree = k, .count = 6}).eigenvalues;
        const Vector found = spectrum(both, {.degree = k, .count = 7}).eigenvalues;
        const Index zeros = k == 1 ? 0 : 1; // harmonic ones of the small sphere
        for (Index i = zeros; i < 6; ++i)
            EXPECT_NEAR(found[i + zeros], alone[i], 1e-4) << "k = " << k; // 1e-18 of the largest
    }
}

TEST(GradedBoxes, have_spectra_in_every_degree) {
    const auto mesh = discretize(graded(3, 4, 3e4));
    for (int k = 0; k <= 3; ++k)
        EXPECT_EQ(spectrum(mesh, {.degree = k, .count = 3}).eigenvalues.size(), 3) << k;
}

} // namespace
} // namespace polydec::test
