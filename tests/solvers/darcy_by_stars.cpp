// SPDX-License-Identifier: MIT
//
// Dual Poisson problems and Darcy's by stars that are no diagonal.
#include "base/decompositions.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/de_rham.h"
#include "dec/material_stars.h"
#include "dec/operators.h"
#include "meshes/generate.h"
#include "solvers/darcy.h"
#include "tests/solvers/star_samples.h"
#include "tests/support/circumcentric.h"
#include "tests/support/glued.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test::in_darcy_by_stars {
namespace {

/// 1 or -1 as all simplices of a flat mesh are oriented against its coordinates; 0 if it is folded.
int turn(const Discretization& mesh) {
    const int n = mesh.dimension();
    const Pieces& K = mesh.pieces();
    Index sum = 0;
    for (Index t = 0; t < K.size(n); ++t) {
        DenseMatrix edges(n, n);
        for (int i = 0; i < n; ++i)
            edges.row(i) = mesh.points().row(K.simplices(n)(t, i + 1)) -
                           mesh.points().row(K.simplices(n)(t, 0));
        sum += (edges.determinant() > 0 ? 1 : -1) * K.orientation(t);
    }
    return std::abs(sum) == K.size(n) ? static_cast<int>(sum / K.size(n)) : 0;
}

/// Values are given where the first coordinate is small, what flows out elsewhere.
BoundaryConditions mixed(const Discretization& mesh) {
    const auto x = mesh.points().col(0);
    const double middle = (x.minCoeff() + x.maxCoeff()) / 2;
    return essential_where(facet_sites(mesh), [=](const Vector& site) { return site[0] < middle; });
}

/// Fluxes through facets as they leave the domain, per area.
Vector outflow(const Discretization& mesh, const Vector& flux) {
    const int n = mesh.dimension();
    const SparseMatrix cofaces = derivative(mesh, n - 1).transpose();
    Vector result = Vector::Zero(flux.size());
    for (Index f = 0; f < result.size(); ++f)
        if (mesh.complex().coface_counts(n - 1)[f] == 1)
            result[f] = SparseMatrix::InnerIterator(cofaces, f).value() * flux[f] /
                        mesh.volumes().primal(n - 1)[f];
    return result;
}

/// Through the cells' facets, of a constant field.
Vector flux_of(const Discretization& mesh, const Vector& field) {
    return turn(mesh) *
           de_rham(mesh, mesh.dimension() - 1, flux_form([&](const Vector&) { return field; }))
               .values;
}

struct Defects {
    double pressure, flux;
};

/// How far a linear pressure, taken at these sites, and its flux are from what comes out.
Defects patch_defects(const Discretization& mesh, const Vector& slope, const Vector& field,
                      const Points& sites) {
    const Vector exact = flux_of(mesh, field);
    const auto by = [&](const BoundaryConditions& conditions) {
        const DarcySolver solver(mesh, {.boundary = conditions});
        return solver.solve(Vector::Zero(sites.rows()), solver.facet_sites() * slope,
                            outflow(mesh, exact));
    };
    auto flow = by(mixed(mesh));
    if (flow.compatibility.free_components > 0)
        flow = by({}); // parts that hang together at a vertex need a pressure each
    return {relative_difference(flow.pressure.values, Vector(sites * slope)),
            relative_difference(flow.flux.values, exact)};
}

Defects patch_defects(const Discretization& mesh) {
    const Vector slope = Vector::LinSpaced(mesh.dimension(), 1, 2);
    return patch_defects(mesh, slope, -slope, dual_sites(mesh));
}

class DarcyByStars : public OverMeshes {
protected:
    /// Calls law(mesh) for cells and simplices with stars of every kind that are matrices for
    /// fluxes; of flat meshes whose vertices are moved, too.
    template <class Law>
    void for_all(Law law) const {
        const Mesh& input = mesh_named(GetParam());
        std::vector<Mesh> inputs{input};
        if (is_flat(input) && input.simplices.cols() > 2)
            inputs.push_back(shaken(input, 0.08, 3));
        for (const Mesh& moved : inputs)
            for (const auto& [title, mesh, chosen] : with_star_kinds(moved))
                if (!mesh.stars()[mesh.dimension() - 1].is_diagonal() && is_two_sided(mesh)) {
                    SCOPED_TRACE(title);
                    law(mesh, chosen);
                }
    }

    static bool is_two_sided(const Discretization& mesh) {
        const int n = mesh.dimension();
        const auto& counts = mesh.complex().coface_counts(n - 1);
        const Vector sums =
            derivative(mesh, n - 1).transpose() * Vector::Ones(mesh.complex().size(n));
        for (Index f = 0; f < sums.size(); ++f)
            if (counts[f] > 2 || (counts[f] == 2 && sums[f] != 0))
                return false;
        return true;
    }
};

TEST_P(DarcyByStars, linear_pressures_and_their_fluxes_come_out) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for_all([](const Discretization& mesh, const ChosenStars&) {
        if (turn(mesh) == 0)
            return;
        const auto defects = patch_defects(mesh);
        EXPECT_LE(defects.pressure, 1e-11);
        EXPECT_LE(defects.flux, 1e-10);
    });
}

TEST_P(DarcyByStars, both_equations_hold_for_all_data) {
    for_all([](const Discretization& mesh, const ChosenStars&) {
        const int n = mesh.dimension();
        const auto& complex = mesh.complex();
        const bool bounded =
            std::any_of(complex.coface_counts(n - 1).begin(), complex.coface_counts(n - 1).end(),
                        [](Index count) { return count == 1; });
        const auto conditions = bounded ? mixed(mesh) : BoundaryConditions{};
        const DarcySolver solver(mesh, {.boundary = conditions});
        const Index facets = complex.size(n - 1);
        const Vector source = random_vector(complex.size(n), 1);
        const Vector pressures = random_vector(facets, 2), out = random_vector(facets, 3);
        const auto flow = solver.solve(source, pressures, out);
        const SparseMatrix D = derivative(mesh, n - 1);
        const Vector& volumes = mesh.volumes().primal(n);

        Vector balance = volumes.cwiseProduct(source) - D * flow.flux.values;
        if (flow.compatibility.free_components == 1 && !bounded) {
            balance -= volumes * (balance.sum() / volumes.sum());
            EXPECT_LE(std::abs(volumes.dot(flow.pressure.values)),
                      1e-12 * volumes.sum() * flow.pressure.values.cwiseAbs().maxCoeff());
        }
        if (flow.compatibility.free_components <= (bounded ? 0 : 1)) {
            EXPECT_LE(balance.norm(), 1e-11 * (flow.flux.values.norm() + source.norm()));
        }

        const auto essential = essential_cells(complex, conditions)[n - 1];
        Vector drops = D.transpose() * flow.pressure.values;
        for (Index f = 0; f < facets; ++f)
            if (essential[f])
                drops[f] -= SparseMatrix::InnerIterator(SparseMatrix(D.transpose()), f).value() *
                            pressures[f];
        Vector left = mesh.stars()[n - 1] * flow.flux.values - drops;
        const Vector given = outflow(mesh, flow.flux.values) - out;
        for (Index f = 0; f < facets; ++f)
            if (complex.coface_counts(n - 1)[f] == 1 && !essential[f]) {
                left[f] = 0; // there what flows out is given
                EXPECT_NEAR(given[f], 0, 1e-12);
            }
        EXPECT_LE(left.norm(), 1e-11 * (drops.norm() + pressures.norm()));
        const auto poisson = PoissonSolver(mesh, {.side = Side::dual, .boundary = conditions});
        EXPECT_LE(relative_difference(poisson.solve(source, pressures, -out).values,
                                      flow.pressure.values),
                  1e-12);
    });
}

/// The star itself tells which cells have Galerkin's.
TEST_P(DarcyByStars, sites_are_centroids_where_stars_are_those_of_galerkin) {
    for_all([](const Discretization& mesh, const ChosenStars& chosen) {
        const int n = mesh.dimension();
        const Points sites = dual_sites(mesh), centers = cell_centers(mesh, n),
                     centroids = cell_centroids(mesh, n);
        for (Index cell = 0; cell < sites.rows(); ++cell)
            if (IncidenceMatrix::InnerIterator(mesh.complex().coboundary(n - 1), cell)) {
                EXPECT_EQ(sites.row(cell), (chosen.galerkin[cell] ? centroids : centers).row(cell));
            }
    });
}

POLYDEC_OVER_MESHES(DarcyByStars);

TEST(DarcyByOtherStars, linear_pressures_do_not_come_out) {
    const auto mesh = circumcentric(shaken(grid(6, 6), 0.3, 3));
    const auto hybrid = mesh.with_stars(StarKind::hybrid).chosen_stars();
    ASSERT_GT(hybrid.galerkin_share(), 0);
    ASSERT_LT(hybrid.galerkin_share(), 1);
    const Discretization by_hybrid = mesh.with_stars(hybrid.stars);
    const Eigen::Vector2d slope(1, 2);
    EXPECT_LE(patch_defects(by_hybrid).pressure, 1e-12);
    EXPECT_GT(patch_defects(by_hybrid, slope, -slope, cell_centers(mesh, 2)).pressure, 1e-3);
    EXPECT_GT(patch_defects(by_hybrid, slope, slope, dual_sites(by_hybrid)).flux, 1e-1);

    const auto tets = circumcentric(shaken(kuhn(3, 3), 0.15, 3));
    const auto by = [&](StarKind kind) {
        const auto chosen = tets.with_stars(kind).stars();
        return patch_defects(tets.with_stars(chosen));
    };
    EXPECT_LE(by(StarKind::galerkin).flux, 1e-11);
    EXPECT_GT(by(StarKind::barycentric).flux, 1e-2);
}

double wave(const Vector& p) {
    double product = 1;
    for (const double x : p)
        product *= std::cos(M_PI * x / 2 + 0.3);
    return product;
}

/// Errors of a manufactured pressure in L2, and of its flux in the norm of the star.
Defects errors(const Mesh& input, StarKind kind) {
    const auto bare = circumcentric(input);
    const auto mesh = bare.with_stars(bare.with_stars(kind).stars());
    const int n = mesh.dimension();
    const DarcySolver solver(mesh);
    const auto at = [](const Points& places) {
        Vector values(places.rows());
        for (Index i = 0; i < values.size(); ++i)
            values[i] = wave(places.row(i));
        return values;
    };
    const Vector p = at(solver.sites()), boundary = at(solver.facet_sites());
    const auto flow = solver.solve(n * M_PI * M_PI / 4 * p, boundary, 0 * boundary);
    const auto exact = de_rham(mesh, n - 1, flux_form([&](const Vector& x) {
                                   Vector X(n);
                                   for (int i = 0; i < n; ++i)
                                       X[i] = wave(x) * M_PI / 2 * std::tan(M_PI * x[i] / 2 + 0.3);
                                   return X;
                               }));
    const Vector difference = flow.flux.values - turn(mesh) * exact.values;
    return {std::sqrt(mesh.volumes().primal(n).dot((flow.pressure.values - p).cwiseAbs2())),
            std::sqrt(difference.dot(mesh.stars()[n - 1] * difference))};
}

/// The fine mesh has been halved so many times.
void expect_orders(const Mesh& coarse, const Mesh& fine, int halvings, StarKind kind) {
    const auto a = errors(coarse, kind), b = errors(fine, kind);
    EXPECT_GE(std::log2(a.pressure / b.pressure) / halvings, 1.8) << name(kind);
    EXPECT_GE(std::log2(a.flux / b.flux) / halvings, 0.9) << name(kind);
}

TEST(DarcyByStarsOrders, are_2_for_pressures_and_1_for_fluxes) {
    for (const StarKind kind : {StarKind::galerkin, StarKind::hybrid})
        expect_orders(shaken(grid(16, 16), 0.2, 1), shaken(grid(64, 64), 0.2, 1), 2, kind);
    expect_orders(shaken(kuhn(3, 4), 0.1, 1), shaken(kuhn(3, 8), 0.1, 1), 1, StarKind::galerkin);
    const auto a = errors(shaken(grid(16, 16), 0.2, 1), StarKind::barycentric),
               b = errors(shaken(grid(32, 32), 0.2, 1), StarKind::barycentric);
    EXPECT_LT(std::log2(a.flux / b.flux), 0.5); // inconsistent
}

DenseMatrix tensor(int n) {
    DenseMatrix root = DenseMatrix::Identity(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            root(i, j) += 0.3 * std::sin(1 + 3 * i + 7 * j);
    return root * root.transpose();
}

TEST(MaterialStars, of_1_are_those_of_galerkin) {
    for (const char* title : {"obtuse_planar", "hex4", "kuhn3", "split_cubes", "segments4"}) {
        const auto mesh = circumcentric(mesh_named(title));
        const int n = mesh.dimension();
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        const Vector ones = Vector::Ones(mesh.complex().size(n));
        for (int k = 0; k < n; ++k)
            EXPECT_LE(relative_difference(material_star(mesh, k, CellData::on_cells(ones)),
                                          stars[k].matrix()),
                      1e-13)
                << title;
        const std::vector<DenseMatrix> tensors(mesh.input().size(n),
                                               2 * DenseMatrix::Identity(n, n));
        EXPECT_LE(relative_difference(material_star(mesh, tensors),
                                      SparseMatrix(stars[n - 1].matrix() / 2)),
                  1e-12)
            << title;
    }
}

TEST(MaterialStars, carry_linear_pressures_through_anisotropic_media) {
    for (const Mesh& input : {shaken(grid(5, 5), 0.3, 2), shaken(kuhn(3, 3), 0.12, 2)}) {
        const auto mesh = circumcentric(input);
        const int n = mesh.dimension();
        const DenseMatrix K = tensor(n);
        const std::vector<DenseMatrix> tensors(mesh.input().size(n), K);
        const auto stars =
            mesh.with_stars(StarKind::galerkin).stars().with(n - 1, material_star(mesh, tensors));
        const auto medium = mesh.with_stars(stars);
        const Vector slope = Vector::LinSpaced(n, 1, 2);
        const auto right = patch_defects(medium, slope, -K * slope, dual_sites(medium));
        EXPECT_LE(right.pressure, 1e-11);
        EXPECT_LE(right.flux, 1e-11);
        EXPECT_GT(patch_defects(medium, slope, -slope, dual_sites(medium)).flux, 1e-2);
    }
}

/// Two layers of a box: flux 1 needs pressure drops 1/2 and 1/8, also where cells are skewed within
/// the layers.
TEST(MaterialStars, are_exact_for_resistances_in_series) {
    for (const int n : {1, 2, 3}) {
        Mesh input = kuhn(n, 4);
        for (Index v = 0; v < input.points.rows() && n > 1; ++v)
            if (const double y = input.points(v, 1); y > 0 && y < 1)
                input.points(v, 1) += 0.1 * std::sin(10 * input.points(v, 0));
        const auto mesh = circumcentric(input);
        const Points centroids = cell_centroids(mesh, n);
        Vector kappa(centroids.rows()), exact(centroids.rows());
        for (Index i = 0; i < kappa.size(); ++i) {
            const double x = centroids(i, 0);
            kappa[i] = x < 0.5 ? 1 : 4;
            exact[i] = x < 0.5 ? -x : -0.5 - (x - 0.5) / 4;
        }
        const Vector resistivity = kappa.cwiseInverse();
        const auto medium = mesh.with_stars(
            mesh.stars().with(n - 1, material_star(mesh, n - 1, CellData::on_cells(resistivity))));
        const auto ends = essential_where(
            facet_sites(medium), [](const Vector& p) { return p[0] < 1e-9 || p[0] > 1 - 1e-9; });
        const DarcySolver solver(medium, {.boundary = ends});
        const Vector drop = -0.625 * solver.facet_sites().col(0);
        const auto flow = solver.solve(0 * kappa, drop, 0 * drop);
        EXPECT_LE(relative_difference(flow.pressure.values, exact), 1e-12) << "n = " << n;
        EXPECT_LE(relative_difference(flow.flux.values, flux_of(mesh, Vector::Unit(n, 0))), 1e-12);
    }
}

TEST(MaterialStars, refuse_what_is_no_conductivity) {
    const auto mesh = circumcentric(grid(2, 2));
    std::vector<DenseMatrix> tensors(8, DenseMatrix::Identity(2, 2));
    tensors[2](0, 1) = 1;
    EXPECT_TRUE(says(refusal([&] { material_star(mesh, tensors); }),
                     {"conductivity", "2-cell 2", "2 x 2", "symmetric"}));
    EXPECT_TRUE(says(
        refusal([&] { material_star(mesh, 1, CellData::on_cells(Eigen::Vector4d(1, 0, 1, 1))); }),
        {"weight", "2-cell 1", "0"}));
    const auto sphere = circumcentric(icosphere(1));
    EXPECT_TRUE(says(refusal([&] {
                         material_star(sphere,
                                       std::vector<DenseMatrix>(sphere.complex().size(2),
                                                                DenseMatrix::Identity(2, 2)));
                     }),
                     {"number", "cell"}));
}

TEST(DarcyByStarsErrors, name_what_does_not_fit) {
    const auto branching = circumcentric(mesh_named("branching"));
    const auto stars = branching.with_stars(StarKind::galerkin).stars();
    EXPECT_TRUE(says(refusal([&] { DarcySolver(branching.with_stars(stars)); }),
                     {"cells", "facet", "flux"}));
    const auto mesh = circumcentric(grid(2, 2));
    const auto by_galerkin = mesh.with_stars(mesh.with_stars(StarKind::galerkin).stars());
    EXPECT_TRUE(says(refusal([&] { DarcySolver(by_galerkin, {.conductivity = Vector::Ones(8)}); }),
                     {"material_star"}));
    EXPECT_TRUE(says(refusal([&] { DarcySolver(by_galerkin, {.linear_solver = "eigen.cg"}); }),
                     {"positive", "definite"}));
}

} // namespace
} // namespace polydec::test::in_darcy_by_stars
