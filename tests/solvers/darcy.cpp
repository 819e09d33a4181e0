// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/solvers/cases.h"
#include "tests/solvers/star_samples.h"

namespace polydec::test::in_darcy {

/// Values are given where the first coordinate is small, what flows out elsewhere.
BoundaryConditions mixed(const Discretization& mesh) {
    const auto x = mesh.points().col(0);
    const double middle = (x.minCoeff() + x.maxCoeff()) / 2;
    return essential_where(facet_sites(mesh), [=](const Vector& site) { return site[0] < middle; });
}

/// Fluxes through facets as they leave the domain, per area.
Vector outflow(const Discretization& mesh, const Vector& flux) {
    const Vector& areas = mesh.volumes().primal(mesh.dimension() - 1);
    Vector result = Vector::Zero(flux.size());
    for (const auto& [facet, cell, outward] : boundary_facets(mesh.complex()))
        result[facet] = outward * flux[facet] / areas[facet];
    return result;
}

/// Through the cells' facets, of a field.
Vector flux_of(const Discretization& mesh, const std::function<Vector(const Vector&)>& field) {
    return turn(mesh) * de_rham(mesh, mesh.dimension() - 1, flux_form(field)).values;
}

Vector flux_of(const Discretization& mesh, const Vector& field) {
    return flux_of(mesh, [&](const Vector&) { return field; });
}

struct Defects {
    double pressure, flux;
};

/// How far a linear pressure, taken at these sites, and its flux are from what comes out.
Defects patch_defects(const Discretization& mesh, const Vector& slope, const Vector& field,
                      const Points& sites) {
    const Vector exact = flux_of(mesh, field);
    const auto by = [&](const BoundaryConditions& conditions) {
        return solved(PoissonSolver(functions(mesh, Side::dual, conditions)),
                      Vector::Zero(sites.rows()), facet_sites(mesh) * slope, -outflow(mesh, exact));
    };
    auto flow = by(mixed(mesh));
    if (flow.compatibility.free_components > 0)
        flow = by({}); // parts that hang together at a vertex need a pressure each
    return {relative_difference(flow.form.values, Vector(sites * slope)),
            relative_difference(flow.flux.values, exact)};
}

Defects patch_defects(const Discretization& mesh) {
    const Vector slope = Vector::LinSpaced(mesh.dimension(), 1, 2);
    return patch_defects(mesh, slope, -slope, dual_sites(mesh));
}

/// What flows out of cells with random data less the source in them, relative.
double imbalance(const Discretization& mesh, const BoundaryConditions& conditions) {
    const int n = mesh.dimension();
    const PoissonSolver solver(functions(mesh, Side::dual, conditions));
    const Index facets = mesh.complex().size(n - 1);
    const Vector source = random_vector(mesh.complex().size(n), 1);
    const Vector flux =
        solved(solver, source, random_vector(facets, 2), -random_vector(facets, 3)).flux.values;
    const Vector balance =
        derivative(mesh.complex(), n - 1) * flux - mesh.volumes().primal(n).cwiseProduct(source);
    return balance.cwiseAbs().maxCoeff() / flux.cwiseAbs().maxCoeff();
}

// Pressures at the corners of an FCC box are given thrice, and fluxes there by their sum alone.
TEST(DarcyCorners, cells_with_several_facets_without_dual_balance_as_a_whole) {
    const auto mesh = circumcentric(mesh_named("fcc1"));
    const Vector slope = Vector::LinSpaced(3, 1, 2);
    const Vector exact = dual_sites(mesh) * slope;
    const auto linear =
        solved(PoissonSolver(functions(mesh, Side::dual)), 0 * exact, facet_sites(mesh) * slope);
    EXPECT_CLOSE(linear.form.values, exact, 1e-10);
    EXPECT_LE(imbalance(mesh, {}), 1e-12);
}

class DarcyByStars : public OverMeshes {
protected:
    /// Calls law(mesh, chosen) for cells and simplices with stars of every kind that are matrices
    /// for fluxes or positive there; of flat meshes whose vertices are moved, too.
    template <class Law>
    void for_all(Law law) const {
        const Mesh& input = mesh_named(GetParam());
        std::vector<Mesh> inputs{input};
        if (is_flat(input) && input.simplices.cols() > 2)
            inputs.push_back(shaken(input, 0.08, 3));
        for (const Mesh& moved : inputs) {
            auto samples = with_star_kinds(moved);
            std::erase_if(samples, [](const StarSample& sample) {
                return sample.mesh.stars()[sample.mesh.dimension() - 1].is_diagonal();
            });
            const auto by_duals = circumcentric(moved, {.tolerance = 1e-12}); // merged exactly
            const HodgeStar star = by_duals.stars()[by_duals.dimension() - 1];
            if (star.zeros().empty() && star.negatives().empty())
                samples.push_back({"circumcentric", by_duals, by_duals.chosen_stars()});
            for (const auto& [title, mesh, chosen] : samples)
                if (is_two_sided(mesh)) {
                    SCOPED_TRACE(title);
                    law(mesh, chosen);
                }
        }
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
        const auto boundary = boundary_facets(complex);
        const bool bounded = !boundary.empty();
        const auto conditions = bounded ? mixed(mesh) : BoundaryConditions{};
        const Index facets = complex.size(n - 1);
        const Vector source = random_vector(complex.size(n), 1);
        const Vector pressures = random_vector(facets, 2), out = random_vector(facets, 3);
        const auto flow =
            solved(PoissonSolver(functions(mesh, Side::dual, conditions)), source, pressures, -out);
        const SparseMatrix D = derivative(mesh.complex(), n - 1);
        const Vector& volumes = mesh.volumes().primal(n);

        Vector balance = volumes.cwiseProduct(source) - D * flow.flux.values;
        const Index free = flow.compatibility.free_components;
        if (free == 1 && !bounded) {
            balance -= volumes * (balance.sum() / volumes.sum());
            EXPECT_LE(std::abs(volumes.dot(flow.form.values)),
                      1e-12 * volumes.sum() * flow.form.values.cwiseAbs().maxCoeff());
        }
        if (free <= (bounded ? 0 : 1)) {
            EXPECT_LE(balance.norm(), 1e-11 * (flow.flux.values.norm() + source.norm()));
        }

        const auto essential = essential_cells(complex, conditions)[n - 1];
        Vector drops = D.transpose() * flow.form.values;
        for (const auto& [facet, cell, outward] : boundary)
            if (essential[facet])
                drops[facet] -= outward * pressures[facet];
        Vector left = mesh.stars()[n - 1] * flow.flux.values - drops;
        const Vector given = outflow(mesh, flow.flux.values) - out;
        for (const auto& [facet, cell, outward] : boundary)
            if (!essential[facet]) {
                left[facet] = 0; // there what flows out is given
                EXPECT_NEAR(given[facet], 0, 1e-12);
            }
        EXPECT_LE(left.norm(), 1e-11 * (drops.norm() + pressures.norm()));
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
    EXPECT_TRUE(hybrid.galerkin_share() > 0 && hybrid.galerkin_share() < 1);
    const Discretization by_hybrid = mesh.with_stars(hybrid.stars);
    const Eigen::Vector2d slope(1, 2);
    EXPECT_LE(patch_defects(by_hybrid).pressure, 1e-12);
    EXPECT_GT(patch_defects(by_hybrid, slope, -slope, cell_centers(mesh, 2)).pressure, 1e-3);
    EXPECT_GT(patch_defects(by_hybrid, slope, slope, dual_sites(by_hybrid)).flux, 1e-1);

    const auto by = [&](StarKind kind) {
        return patch_defects(with_stars(shaken(kuhn(3, 3), 0.15, 3), kind));
    };
    EXPECT_LE(by(StarKind::galerkin).flux, 1e-11);
    EXPECT_GT(by(StarKind::barycentric).flux, 1e-2);
}

/// Errors of a manufactured pressure in L2, and of its flux in the norm of the star.
Vector errors(const Discretization& mesh) {
    const int n = mesh.dimension();
    const auto wave = [](const Vector& p) { return (M_PI / 2 * p.array() + 0.3).cos().prod(); };
    const Vector p = at(dual_sites(mesh), wave);
    const auto flow = solved(PoissonSolver(functions(mesh, Side::dual)), n * M_PI * M_PI / 4 * p,
                             at(facet_sites(mesh), wave));
    const Vector exact = flux_of(mesh, [&](const Vector& x) -> Vector {
        return wave(x) * M_PI / 2 * (M_PI / 2 * x.array() + 0.3).tan();
    });
    const Vector difference = flow.flux.values - exact;
    return Vector{{l2_norm(mesh, Side::dual, flow.form.values - p),
                   size_of(mesh, {Side::primal, n - 1, difference})}};
}

struct Row : Case {
    double tolerance;   ///< of the order 2 of pressures
    double least, most; ///< of the order of fluxes
};

class DarcyOrders : public testing::TestWithParam<Row> {};

TEST_P(DarcyOrders, are_those_of_an_independent_program) {
    const Row& row = GetParam();
    const Vector found = orders(row, errors);
    EXPECT_NEAR(found[0], 2, row.tolerance);
    EXPECT_TRUE(row.least <= found[1] && found[1] <= row.most) << found[1];
}

// Pressures on fcc have their order from above: 2.45, 2.18, 2.06.
INSTANTIATE_TEST_SUITE_P(Diagonal, DarcyOrders,
                         testing::Values(Row{{"squares", 16, 32}, 0.1, 1.85, 2.15},
                                         Row{{"hexagons", 16, 32}, 0.1, 1.4, 2},
                                         Row{{"cubes", 4, 8}, 0.15, 1.7, 2},
                                         Row{{"bcc", 4, 8}, 0.15, 1.4, 2},
                                         Row{{"fcc", 4, 8}, 0.2, 0.9, 2}),
                         name_of<Row>);

/// The fine mesh has been halved so many times.
void expect_orders(const Mesh& coarse, const Mesh& fine, int halvings, StarKind kind) {
    const Vector ratios =
        errors(with_stars(coarse, kind)).cwiseQuotient(errors(with_stars(fine, kind)));
    EXPECT_GE(std::log2(ratios[0]) / halvings, 1.8) << name(kind);
    EXPECT_GE(std::log2(ratios[1]) / halvings, 0.9) << name(kind);
}

TEST(DarcyByStarsOrders, are_2_for_pressures_and_1_for_fluxes) {
    const auto squares = [](int cells) { return shaken(grid(cells, cells), 0.2, 1); };
    for (const StarKind kind : {StarKind::galerkin, StarKind::hybrid})
        expect_orders(squares(16), squares(64), 2, kind);
    expect_orders(shaken(kuhn(3, 4), 0.1, 1), shaken(kuhn(3, 8), 0.1, 1), 1, StarKind::galerkin);
    const auto flux_error = [&](int cells) {
        return errors(with_stars(squares(cells), StarKind::barycentric))[1];
    };
    EXPECT_LT(std::log2(flux_error(16) / flux_error(32)), 0.5); // inconsistent
}

DenseMatrix tensor(int n) {
    DenseMatrix root = DenseMatrix::Identity(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            root(i, j) += 0.3 * std::sin(1 + 3 * i + 7 * j);
    return root * root.transpose();
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
        const Vector kappa = at(centroids, [](const Vector& p) { return p[0] < 0.5 ? 1 : 4; });
        const Vector exact = at(centroids, [](const Vector& p) {
            return p[0] < 0.5 ? -p[0] : -0.5 - (p[0] - 0.5) / 4;
        });
        const Vector resistivity = kappa.cwiseInverse();
        const auto medium = mesh.with_stars(
            mesh.stars().with(n - 1, material_star(mesh, n - 1, CellData::on_cells(resistivity))));
        const auto ends = essential_where(
            facet_sites(medium), [](const Vector& p) { return p[0] < 1e-9 || p[0] > 1 - 1e-9; });
        const auto flow = solved(PoissonSolver(functions(medium, Side::dual, ends)), 0 * kappa,
                                 -0.625 * facet_sites(medium).col(0));
        EXPECT_CLOSE(flow.form.values, exact, 1e-12) << "n = " << n;
        EXPECT_CLOSE(flow.flux.values, flux_of(mesh, Vector(Vector::Unit(n, 0))), 1e-12);
    }
}

TEST(DarcyErrors, name_what_does_not_fit) {
    const auto mesh = circumcentric(grid(2, 2));
    EXPECT_REFUSED(with_conductivity(mesh, Side::dual, Vector::Ones(3)), "3 values", "conductivity",
                   "8");
    Vector kappa = Vector::Ones(8);
    kappa[2] = 0;
    EXPECT_REFUSED(with_conductivity(mesh, Side::dual, kappa), "conductivity", "2-cell 2", "0");
}

TEST(DarcyByStarsErrors, name_what_does_not_fit) {
    const auto branching = circumcentric(mesh_named("branching"));
    const auto stars = branching.with_stars(StarKind::galerkin).stars();
    EXPECT_REFUSED(functions(branching.with_stars(stars), Side::dual), "cells", "facet", "flux");
    const auto mesh = circumcentric(grid(2, 2));
    const auto by_galerkin = mesh.with_stars(mesh.with_stars(StarKind::galerkin).stars());
    for (const Side side : sides)
        EXPECT_REFUSED(with_conductivity(by_galerkin, side, Vector::Ones(8)), "material_star");
    EXPECT_REFUSED(PoissonSolver(functions(by_galerkin, Side::dual), "eigen.cg"), "positive",
                   "definite");
}

} // namespace polydec::test::in_darcy
