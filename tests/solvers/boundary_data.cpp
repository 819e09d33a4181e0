// SPDX-License-Identifier: MIT
#include "backends/registry.h"
#include "base/decompositions.h"
#include "complex/relative.h"
#include "dec/fields/de_rham.h"
#include "dec/forms/derivative.h"
#include "dec/forms/laplacian.h"
#include "dec/forms/star.h"
#include "meshes/generate.h"
#include "solvers/poisson.h"
#include "tests/support/circumcentric.h"
#include "tests/support/families.h"
#include "tests/support/forms.h"
#include "tests/support/matrices.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polydec::test::in_boundary_data {
namespace {

constexpr Side sides[] = {Side::primal, Side::dual};

/// Outward unit normals of the boundary facets of a full-dimensional mesh, a row for each facet.
DenseMatrix outward_normals(const Discretization& mesh) {
    const auto& K = mesh.input();
    const int n = mesh.dimension();
    const IncidenceMatrix cofaces = K.boundary(n);
    DenseMatrix normals = DenseMatrix::Zero(mesh.complex().size(n - 1), n);
    for (Index f = 0; f < K.size(n - 1); ++f) {
        const auto& carrier = mesh.merging().carriers(n - 1)[f];
        if (K.coface_counts(n - 1)[f] != 1 || carrier.dimension != n - 1)
            continue;
        const auto corners = K.simplices(n - 1).row(f);
        const auto top = static_cast<Index>(IncidenceMatrix::InnerIterator(cofaces, f).col());
        DenseMatrix edges(n, n - 1);
        for (int i = 1; i < n; ++i)
            edges.col(i - 1) = (mesh.points().row(corners[i]) - mesh.points().row(corners[0]));
        const DenseMatrix Q = Eigen::HouseholderQR<DenseMatrix>(edges).householderQ();
        Vector normal = Q.col(n - 1);
        for (const Index v : K.simplices(n).row(top))
            if (std::find(corners.begin(), corners.end(), v) == corners.end() &&
                normal.dot((mesh.points().row(v) - mesh.points().row(corners[0])).transpose()) > 0)
                normal = -normal;
        normals.row(carrier.cell) = normal;
    }
    return normals;
}

class FlatMeshes : public testing::TestWithParam<std::string> {
protected:
    FlatMeshes() : mesh_(circumcentric(mesh_named(GetParam()))) {}
    const Discretization& mesh() const { return mesh_; }

    /// Largest error for a linear function with its values on the facets beyond the middle of the
    /// first coordinate, and `factor` times its normal derivative elsewhere.
    double linear_error(Side side, double factor) const {
        const int n = mesh().dimension();
        const Vector slope = Vector::LinSpaced(n, 1, 2);
        const double middle =
            (mesh().points().col(0).minCoeff() + mesh().points().col(0).maxCoeff()) / 2;
        const Points sites = cell_centers_of_facets();
        PoissonSolver solver(
            mesh(), {.side = side, .boundary = essential_where(sites, [&](const Vector& site) {
                                       return site[0] < middle;
                                   })});
        const Vector u =
            solver
                .solve(Vector::Zero(solver.sites().rows()), solver.boundary_sites() * slope,
                       factor * (outward_normals(mesh()) * slope))
                .values;
        return relative_difference(u, Vector(solver.sites() * slope));
    }

private:
    Points cell_centers_of_facets() const {
        return PoissonSolver(mesh(), {.side = Side::primal}).flux_sites();
    }

    Discretization mesh_;
};

TEST_P(FlatMeshes, have_linear_functions_as_solutions_under_mixed_conditions) {
    for (const Side side : sides) {
        EXPECT_LE(linear_error(side, 1), 1e-10) << name(side);
        EXPECT_GT(linear_error(side, -1), 1e-2) << name(side) << " with the flux reversed";
    }
}

INSTANTIATE_TEST_SUITE_P(Bounded, FlatMeshes,
                         testing::Values("grid4", "hex4", "wellcentred4", "ring6", "kuhn1d",
                                         "kuhn3", "split_cubes", "solid_torus3", "bcc2", "boxes",
                                         "kuhn4", "tesseracts2", "hexagons5", "rectangles"),
                         [](const auto& instance) { return instance.param; });

double wave(const Vector& p) {
    return std::sin(2 * p[0]) * std::cos(p[1]);
}

/// L2 error of the wave on a grid with values on the left half of the boundary.
double wave_error(Side side, int cells) {
    const auto mesh = circumcentric(grid(cells, cells));
    const Points sites = PoissonSolver(mesh).flux_sites();
    PoissonSolver solver(
        mesh, {.side = side,
               .boundary = essential_where(sites, [](const Vector& p) { return p[0] < 0.5; })});
    const DenseMatrix normals = outward_normals(mesh);
    Vector f(solver.sites().rows()), values(solver.boundary_sites().rows()), slopes(sites.rows());
    for (Index i = 0; i < f.size(); ++i)
        f[i] = 5 * wave(solver.sites().row(i));
    for (Index i = 0; i < values.size(); ++i)
        values[i] = wave(solver.boundary_sites().row(i));
    for (Index i = 0; i < slopes.size(); ++i) {
        const double x = sites(i, 0), y = sites(i, 1);
        slopes[i] = normals.row(i).dot(
            Eigen::RowVector2d(2 * std::cos(2 * x) * std::cos(y), -std::sin(2 * x) * std::sin(y)));
    }
    const Vector u = solver.solve(f, values, slopes).values;
    const Vector& volume =
        side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(mesh.dimension());
    double square = 0;
    for (Index i = 0; i < u.size(); ++i)
        square += volume[i] * std::pow(u[i] - wave(solver.sites().row(i)), 2);
    return std::sqrt(square);
}

TEST(MixedConditions, converge_with_order_2) {
    for (const Side side : sides)
        EXPECT_NEAR(std::log2(wave_error(side, 16) / wave_error(side, 32)), 2.0, 0.15)
            << name(side);
}

TEST(NaturalConditions, say_how_far_fluxes_are_from_balanced) {
    const auto mesh = circumcentric(grid(4, 4));
    for (const Side side : sides) {
        PoissonSolver solver(mesh, {.side = side, .boundary = {BoundaryCondition::natural}});
        const Vector zero = Vector::Zero(solver.sites().rows());
        const Vector none = Vector::Zero(solver.boundary_sites().rows());
        // what is made inside, 4 per area, leaves through the boundary of length 4
        const Vector out = Vector::Constant(solver.flux_sites().rows(), -1);
        EXPECT_LE(solver.solve(zero.array() + 4, none, out).compatibility.worst, 1e-12);
        EXPECT_GT(solver.solve(zero.array() + 5, none, out).compatibility.worst, 0.1);
    }
}

/// Solves Delta u = 0 for primal k-forms whose values on the boundary are those of w, and nothing
/// is known of w inside. Forms that vanish on the boundary are those of the relative complex.
Vector harmonic_extension(const Discretization& mesh, int k, const Vector& w) {
    const auto& P = mesh.complex();
    const auto relative = relative_to_boundary(P);
    const auto volumes = relative_volumes(relative, mesh.volumes());
    Vector boundary_part = w;
    boundary_part(relative.cells[k]).setZero();

    const SparseMatrix d = derivative(P, k);
    const Vector flux =
        d.transpose() * star(mesh.volumes(), k + 1).diagonal().cwiseProduct(d * boundary_part);
    const auto solver = make_linear_solver("auto");
    solver->factorize(symmetric_laplacian(relative.complex, volumes, k),
                      {.symmetry = Symmetry::symmetric, .definiteness = Definiteness::positive});
    const Vector inside = solver->solve(Vector(-relative.restrict(k, flux)));
    return boundary_part + relative.extend(k, inside);
}

TEST(EssentialConditions, of_every_degree_determine_constant_forms) {
    for (const char* name :
         {"grid4", "wellcentred4", "rectangles", "kuhn3", "boxes", "tesseracts2"}) {
        const auto mesh = circumcentric(mesh_named(name));
        const int n = mesh.dimension();
        for (int k = 0; k < n; ++k) {
            const Vector coefficients = random_vector(test::coefficients(n, k), 1);
            const auto w = de_rham(mesh, k, [&](const Vector&) { return coefficients; });
            EXPECT_LE(relative_difference(harmonic_extension(mesh, k, w.values), w.values), 1e-11)
                << name << ", k = " << k;
        }
    }
    // what is not harmonic is not returned
    const auto mesh = circumcentric(grid(4, 4));
    const Vector bump = random_vector(mesh.complex().size(1), 2);
    EXPECT_GT(relative_difference(harmonic_extension(mesh, 1, bump), bump), 0.1);
}

TEST(BoundaryDataErrors, name_what_does_not_fit) {
    const auto mesh = circumcentric(grid(2, 2));
    PoissonSolver solver(mesh);
    EXPECT_TRUE(
        says(refusal([&] { solver.solve(Vector::Zero(9), Vector::Zero(9), Vector::Zero(9)); }),
             {"normal derivatives", "9 values", "12 places"}));
    EXPECT_TRUE(
        says(refusal([&] {
                 PoissonSolver(mesh, {.boundary = {.facets = {2, BoundaryCondition::natural}}});
             }),
             {"2 boundary conditions", "12 1-cells"}));
}

} // namespace
} // namespace polydec::test::in_boundary_data
