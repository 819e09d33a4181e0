// SPDX-License-Identifier: MIT
#include "solvers/stokes.h"

#include "dec/choose_stars.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/de_rham.h"
#include "dec/operators.h"
#include "meshes/generate.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace polydec::test {
namespace {

/// Without divergence, and - Laplace u = u; the pressure is x_0 x_1.
Vector velocity(const Vector& x) {
    Vector u(x.size());
    for (Index i = 0; i < x.size(); ++i)
        u[i] = std::sin(1.5 * x[(i + 1) % x.size()] + 0.3 + i);
    return u;
}

struct Errors {
    double flux, pressure, divergence;
};

/// `turned` is a factor at the velocity along the walls, 1 for the solution.
Errors errors(const Mesh& input, StarKind kind, double turned = 1) {
    constexpr double nu = 0.7;
    auto mesh = discretize(input);
    if (kind != StarKind::circumcentric)
        mesh = mesh.with_stars(choose_stars(mesh, kind));
    const int n = mesh.dimension();
    const StokesSolver solver(mesh, {.viscosity = nu});
    const auto exact = de_rham(mesh, n - 1, flux_form(velocity));
    const auto force = de_rham(mesh, n - 1, flux_form([&](const Vector& x) -> Vector {
                                   Vector f = 2.25 * nu * velocity(x);
                                   f[0] += x[1];
                                   f[1] += x[0];
                                   return f;
                               }));
    // star of the flux
    const auto along = boundary_de_rham(mesh, 1, circulation_form([&](const Vector& x) -> Vector {
                                            return (n % 2 == 0 ? -1 : 1) * turned * velocity(x);
                                        }));
    const auto flow = solver.solve(force, exact.values, along);
    const Points sites = dual_sites(mesh);
    Vector p = sites.col(0).cwiseProduct(sites.col(1));
    const Vector& volumes = mesh.volumes().primal(n);
    p.array() -= p.dot(volumes) / volumes.sum();
    const SparseMatrix star_of_flux = mesh.stars()[n - 1].matrix();
    const Vector e = flow.flux.values - exact.values;
    return {std::sqrt(e.dot(star_of_flux * e) / exact.values.dot(star_of_flux * exact.values)),
            std::sqrt(volumes.dot((flow.pressure.values - p).cwiseAbs2())),
            d(mesh, flow.flux).values.cwiseAbs().maxCoeff()};
}

struct Family {
    const char* name;
    std::function<Mesh(int)> make;
    int coarse, fine;
    StarKind stars;
    double flux_order, pressure_order; ///< at least
};

void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

class Flows : public testing::TestWithParam<Family> {};

TEST_P(Flows, converge_and_lose_nothing) {
    const auto& [name, make, coarse, fine, stars, flux_order, pressure_order] = GetParam();
    const auto a = errors(make(coarse), stars), b = errors(make(fine), stars);
    const double steps = std::log(static_cast<double>(fine) / coarse);
    EXPECT_GE(std::log(a.flux / b.flux) / steps, flux_order);
    EXPECT_GE(std::log(a.pressure / b.pressure) / steps, pressure_order);
    EXPECT_LE(b.divergence, 1e-14);
    EXPECT_GT(errors(make(fine), stars, 2).flux, 0.1) << "with twice the velocity at the walls";
}

// Vorticity on walls is what tangential velocities tell of it: first order there, which costs the
// pressure half an order or a whole one.
INSTANTIATE_TEST_SUITE_P(
    Stokes, Flows,
    testing::Values(
        Family{"squares", [](int m) { return grid(m, m); }, 8, 16, StarKind::circumcentric, 1.8,
               1.6},
        Family{"squares_galerkin", [](int m) { return grid(m, m); }, 8, 16, StarKind::galerkin, 1.9,
               1.1},
        Family{"hexagons", hexagons, 8, 16, StarKind::circumcentric, 1.9, 1.8},
        Family{"hexagons_galerkin", hexagons, 8, 16, StarKind::galerkin, 1.0, 0.6},
        Family{"triangles", well_centered, 8, 16, StarKind::circumcentric, 1.1, 0.6},
        Family{"triangles_galerkin", well_centered, 8, 16, StarKind::galerkin, 1.4, 0.9},
        Family{"cubes", [](int m) { return kuhn(3, m); }, 4, 8, StarKind::circumcentric, 1.5, 1.3},
        Family{"tetrahedra_galerkin", [](int m) { return bcc(m); }, 2, 4, StarKind::galerkin, 1.3,
               0.9}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(StokesErrors, name_what_does_not_fit) {
    const auto mesh = discretize(grid(2, 2));
    const Cochain still{Side::primal, 1, Vector::Zero(mesh.complex().size(1))};
    const StokesSolver solver(mesh);
    EXPECT_EQ(refusal([&] {
                  solver.solve({Side::primal, 0, Vector::Zero(9)}, still.values);
              }),
              "a primal 0-form is given as a force: expected its flux, a primal 1-form");
    EXPECT_EQ(refusal([&] { solver.solve(still, Vector::Ones(2)); }),
              "2 fluxes through facets are given: expected 12");
    EXPECT_EQ(refusal([&] { StokesSolver(mesh, {.viscosity = 0}); }),
              "a viscosity of 0 is given: expected a finite one above 0");
}

} // namespace
} // namespace polydec::test
