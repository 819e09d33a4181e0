// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_intrinsic {

Discretization flipped(const Mesh& mesh) {
    return circumcentric(mesh, {.delaunay = Delaunay::flips_and_splits});
}

class OnFlippedSurfaces : public testing::TestWithParam<std::string> {};

TEST_P(OnFlippedSurfaces, spectra_of_all_degrees_and_sides_are_certified_and_not_negative) {
    const auto mesh = flipped(shaken(mesh_named(GetParam()), 0.25, 7));
    for (const Side side : {Side::primal, Side::dual})
        for (int degree = 0; degree <= 2; ++degree) {
            const FormSpace space(mesh, side, degree);
            const auto found = spectrum(space, {.count = std::min<Index>(6, space.size())});
            EXPECT_TRUE(found.certificate.complete);
            EXPECT_GT(found.eigenvalues[0], -1e-9 * found.eigenvalues.maxCoeff())
                << "degree " << degree;
        }
}

INSTANTIATE_TEST_SUITE_P(Family, OnFlippedSurfaces, testing::ValuesIn(names_of_surfaces()),
                         parameter_name);

TEST(OnSurfacesAsTheyAre, forms_have_no_mass_where_duals_are_negative) {
    const auto mesh = circumcentric(shaken(icosphere(5), 0.25, 7));
    EXPECT_THROW(spectrum({mesh, Side::primal, 1}, {.count = 4}), InvalidInput);
}

/// Greatest error of a function of the plane that is given on the boundary, and whose Laplacian is
/// given, on a square of bad triangles after flips.
double error_in_the_plane(Side side, const std::function<double(double, double)>& u, double f) {
    const auto mesh = flipped(perturbed(grid(9, 9), 0.04, 3));
    EXPECT_GT(mesh.passage().flips().statistics.flips, 0);
    const auto given = [&](const Vector& p) { return u(p[0], p[1]); };
    const Vector exact = at(sites(mesh, side), given);
    const auto found =
        solved(PoissonSolver(functions(mesh, side)), Vector::Constant(exact.size(), f),
               at(boundary_sites(mesh, side), given));
    return (found.form.values - exact).cwiseAbs().maxCoeff();
}

TEST(PoissonOnFlippedSquare, takes_a_conductivity_for_each_polygon) {
    const auto mesh = flipped(perturbed(grid(9, 9), 0.04, 3));
    const auto solve = [](Side side, const Discretization& medium) {
        return solved(PoissonSolver(functions(medium, side)),
                      Vector::Zero(sites(medium, side).rows()), boundary_sites(medium, side).col(0))
            .form.values;
    };
    const auto solve_with = [&](Side side, const Vector& conductivity) {
        return solve(side, with_conductivity(mesh, side, CellData::on_cells(conductivity)));
    };
    const Vector ones = Vector::Ones(mesh.complex().size(2));
    const Vector any = ones + 0.9 * random_vector(mesh.complex().size(2), 4);
    for (const Side side : {Side::primal, Side::dual}) {
        const Vector linear = solve(side, mesh);
        EXPECT_LT(relative_difference(solve_with(side, 3 * ones), linear), 1e-11);
        EXPECT_GT(relative_difference(solve_with(side, any), linear), 1e-3);
    }
}

TEST(PoissonOnFlippedSquare, gives_others_back_but_for_the_size_of_triangles) {
    const auto saddle = [](double x, double y) { return x * y; };
    for (const Side side : {Side::primal, Side::dual}) {
        EXPECT_LT(error_in_the_plane(side, saddle, 0), 0.01);
        EXPECT_GT(error_in_the_plane(side, saddle, 0), 1e-5);
    }
}

TEST(GeodesicDistance, of_a_bundle_is_that_of_its_triangles_before_or_after_flips) {
    const Mesh mesh = perturbed(grid(24, 24), 0.02, 3);
    const Index from[] = {0};
    const auto error = [&](const Discretization& surface) {
        const Vector d = heat_distance(surface, from);
        const Points points = surface.points();
        const Vector exact = (points.rowwise() - points.row(0)).rowwise().norm();
        return (d - exact).cwiseAbs().mean();
    };
    EXPECT_LT(error(circumcentric(mesh)), 0.02);
    EXPECT_LT(error(flipped(mesh)), 0.02);
}

} // namespace polydec::test::in_intrinsic
