// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_sharp_orders {

double f(const Vector& x) {
    return std::sin(3 * x[0] + x[1]) * std::cos(2 * x[1]) + x[0] * x[0] * x[1];
}

Vector gradient(const Vector& x) {
    const double a = 3 * x[0] + x[1], b = 2 * x[1];
    return Vector{{3 * std::cos(a) * std::cos(b) + 2 * x[0] * x[1],
                   std::cos(a) * std::cos(b) - 2 * std::sin(a) * std::sin(b) + x[0] * x[0]}};
}

/// L2 error of sharp_pd(df), attached to given places, over the cells of which counted(cell).
template <class Counted>
double error(const Discretization& mesh, const Points& places, Counted counted) {
    const DenseMatrix X = sharp_pd(mesh, d(mesh.complex(), de_rham(mesh, 0, function_form(f))));
    double sum = 0;
    for (Index cell = 0; cell < X.rows(); ++cell)
        if (counted(cell))
            sum += mesh.volumes().primal(mesh.dimension())[cell] *
                   (X.row(cell).transpose() - gradient(places.row(cell))).squaredNorm();
    return std::sqrt(sum);
}

Points centroids(const Discretization& mesh) {
    return cell_centroids(mesh, mesh.dimension());
}

bool all(Index) {
    return true;
}

double error(const Discretization& mesh) {
    return error(mesh, centroids(mesh), all);
}

Discretization exactly_merged(const Mesh& mesh) {
    return discretize(mesh, {MergeCriterion::dual_length, 1e-8});
}

TEST(SharpsOfSmoothFunctions, are_of_order_2_on_squares) {
    const double coarse = error(exactly_merged(grid(16, 16)));
    const double fine = error(exactly_merged(grid(32, 32)));
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.15);
}

/// L2 error over hexagons without an edge on the boundary.
double error_inside(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::vector<bool> inside(mesh.complex().size(n), true);
    for (Index cell = 0; cell < mesh.complex().size(n); ++cell)
        for (IncidenceMatrix::InnerIterator e(mesh.complex().coboundary(n - 1), cell); e; ++e)
            if (mesh.complex().coface_counts(n - 1)[e.col()] == 1)
                inside[cell] = false;
    return error(mesh, centroids(mesh), [&](Index cell) { return inside[cell]; });
}

TEST(SharpsOfSmoothFunctions, are_of_order_2_on_hexagons_inside) {
    const double coarse = error_inside(exactly_merged(hexagons(16)));
    const double fine = error_inside(exactly_merged(hexagons(32)));
    EXPECT_GE(std::log2(coarse / fine), 1.8);
}

TEST(SharpsOfSmoothFunctions, are_of_order_1_on_irregular_triangles) {
    const double coarse = error(exactly_merged(perturbed(grid(16, 16), 0.2 / 16, 5)));
    const double fine = error(exactly_merged(perturbed(grid(32, 32), 0.2 / 32, 5)));
    EXPECT_GE(std::log2(coarse / fine), 0.9);
}

TEST(SharpsBroken, attached_to_circumcenters_have_larger_errors) {
    for (const auto& mesh :
         {exactly_merged(hexagons(16)), exactly_merged(perturbed(grid(16, 16), 0.2 / 16, 5))}) {
        const Points circum = cell_centers(mesh, 2);
        EXPECT_GT(error(mesh, circum, all), 1.05 * error(mesh));
    }
}

} // namespace polydec::test::in_sharp_orders
