// SPDX-License-Identifier: MIT
#include "dec/discretization.h"
#include "meshes/generate.h"
#include "solvers/poisson.h"
#include "solvers/spectrum.h"
#include "tests/support/circumcentric.h"
#include "tests/support/hand_made.h"
#include "tests/support/scales.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test::in_layers {
namespace {

double error_of_linear_solution(const Mesh& input, Side side,
                                const DiscretizeOptions& options = {}) {
    const auto mesh = circumcentric(input, options);
    PoissonSolver solver(mesh, {.side = side});
    const auto linear = [&](const Points& sites) {
        const Vector slopes = Vector::LinSpaced(sites.cols(), 1.0, -2.0);
        return Vector((sites * slopes).array() + 0.3);
    };
    const Vector u =
        solver.solve(Vector::Zero(solver.sites().rows()), linear(solver.boundary_sites())).values;
    return (u - linear(solver.sites())).cwiseAbs().maxCoeff();
}

TEST(ThinLayers, keep_linear_functions_on_both_sides) {
    for (const Side side : {Side::primal, Side::dual})
        for (const double thickness : {1e-3, 1e-4, 1e-5, 1e-6}) {
            EXPECT_LE(error_of_linear_solution(layers(2, 10, thickness), side), 1e-12) << thickness;
            EXPECT_LE(error_of_linear_solution(layers(3, 5, thickness), side), 1e-12) << thickness;
        }
}

TEST(ThinLayers, keep_linear_functions_after_flips_as_far_as_lengths_know_their_angles) {
    for (const Side side : {Side::primal, Side::dual})
        for (const double thickness : {1e-3, 1e-4})
            EXPECT_LE(error_of_linear_solution(layers(2, 10, thickness), side,
                                               {.delaunay = Delaunay::flips}),
                      1e-12)
                << thickness;
}

TEST(ThinLayers, keep_linear_functions_where_boxes_grow) {
    for (const Side side : {Side::primal, Side::dual}) {
        EXPECT_LE(error_of_linear_solution(graded(2, 10, 1e5), side), 1e-12);
        EXPECT_LE(error_of_linear_solution(graded(3, 6, 3e4), side), 1e-12);
    }
}

/// Cubes of which the lowest quarter is pressed together to thin layers.
Mesh partly_thin(int n, int cells, double aspect) {
    Mesh mesh = kuhn(n, cells);
    const double part = 0.25, whole = part / aspect;
    for (double& y : mesh.points.col(n - 1))
        y = y <= part ? y / aspect : whole + (y - part) / (1 - part) * (1 - whole);
    return mesh;
}

/// L2 error of the product of cos(pi x_i + 1/4) / (n pi^2), all its values on the boundary given.
double error_of_wave(const Mesh& input, Side side) {
    const auto mesh = circumcentric(input);
    const int n = mesh.dimension();
    PoissonSolver solver(mesh, {.side = side, .boundary = {BoundaryCondition::essential}});
    const auto wave = [](const Points& sites) {
        return Vector((M_PI * sites.array() + 0.25).cos().rowwise().prod());
    };
    const Vector exact = wave(solver.sites());
    const Vector u = solver.solve(n * M_PI * M_PI * exact, wave(solver.boundary_sites())).values;
    const Vector& weights =
        side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(n);
    return std::sqrt(weights.dot((u - exact).cwiseAbs2()));
}

TEST(ThinLayers, have_the_orders_of_ordinary_grids) {
    for (const int n : {2, 3})
        for (const Side side : {Side::primal, Side::dual})
            for (const double aspect : {1.0, 1e5}) {
                const int cells = n == 2 ? 32 : 8;
                const double ratio = error_of_wave(partly_thin(n, cells, aspect), side) /
                                     error_of_wave(partly_thin(n, 2 * cells, aspect), side);
                EXPECT_NEAR(std::log2(ratio), 2, 0.15)
                    << n << "D, " << name(side) << ", aspect " << aspect;
            }
}

TEST(TwoSpheres, of_radii_1_and_1e_6_have_their_spectra_in_every_degree) {
    Mesh small = icosphere(2);
    small.points *= 1e-6;
    const auto one = circumcentric(icosphere(2)), both = circumcentric(united(icosphere(2), small));
    for (int k = 0; k <= 2; ++k) {
        const Vector alone = spectrum(one, {.degree = k, .count = 6}).eigenvalues;
        const Vector found = spectrum(both, {.degree = k, .count = 7}).eigenvalues;
        const Index zeros = k == 1 ? 0 : 1; // harmonic ones of the small sphere
        for (Index i = zeros; i < 6; ++i)
            EXPECT_NEAR(found[i + zeros], alone[i], 1e-4) << "k = " << k; // 1e-18 of the largest
    }
}

TEST(GradedBoxes, have_spectra_in_every_degree) {
    const auto mesh = circumcentric(graded(3, 4, 3e4));
    for (int k = 0; k <= 3; ++k)
        EXPECT_EQ(spectrum(mesh, {.degree = k, .count = 3}).eigenvalues.size(), 3) << k;
}

} // namespace
} // namespace polydec::test::in_layers
