// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"
#include "tests/support/test.h"

namespace polydec::test::in_centers {

/// The circumcenters' coordinates, as one's own.
Centers given_circumcenters(const Pieces& K, const Points& points) {
    std::vector<Points> coordinates;
    for (int k = 0; k <= K.dimension(); ++k)
        coordinates.push_back(center_coordinates(K, points, {}, k));
    return Centers(std::move(coordinates));
}

class CentersOf : public OverMeshes {};

TEST_P(CentersOf, spheres_are_the_same_if_given_by_their_coordinates) {
    const auto& K = mesh().K();
    const auto volumes = dual_volumes(K, mesh().points, given_circumcenters(K, mesh().points));
    for (int k = 0; k <= K.dimension(); ++k)
        EXPECT_EQ(volumes.dual(k), mesh().input_volumes.dual(k)) << "degree " << k;
}

TEST_P(CentersOf, mass_divide_simplices_into_equal_parts_and_make_every_dual_positive) {
    const auto& K = mesh().K();
    const auto centers = Centers::centroids();
    const auto volumes = dual_volumes(K, mesh().points, centers);
    const int n = K.dimension();
    for (int k = 0; k <= n; ++k) {
        EXPECT_GT(volumes.dual(k).minCoeff(), 0) << "degree " << k;
        EXPECT_TRUE(star(volumes, k).zeros().empty());
        const SparseMatrix parts = dual_parts({K, mesh().points, volumes}, centers, k, n);
        const Vector filled = parts * volumes.primal(k);
        EXPECT_LT(relative_difference(filled, binomial(n, k) * volumes.primal(n)), 1e-12);
        const Vector sums = parts.transpose() * Vector::Ones(K.size(n));
        EXPECT_LT(relative_difference(sums, volumes.dual(k)), 1e-12);
        for (Index t = 0; t < K.size(n); ++t)
            for (SparseMatrix::InnerIterator part(parts, t); part; ++part) {
                const double share = volumes.primal(n)[t] / volumes.primal(k)[part.col()];
                const double equal = binomial(n, k) * share / binomial(n + 1, k + 1);
                EXPECT_NEAR(part.value(), equal, 1e-12 * equal);
            }
    }
}

TEST_P(CentersOf, mass_give_laplacians_of_every_degree_on_the_mesh_as_it_is) {
    const auto whole = discretize(mesh_named(GetParam()), {.centers = Centers::centroids()});
    EXPECT_EQ(whole.complex().size(whole.dimension()), whole.input().size(whole.dimension()));
    for (int k = 0; k <= whole.dimension(); ++k) {
        const SparseMatrix L = symmetric_laplacian({whole.complex(), whole.volumes()}, k);
        EXPECT_EQ(L.rows(), whole.complex().size(k));
        const Vector x = random_vector(whole.complex().size(k), 4);
        EXPECT_GE(x.dot(L * x), 0) << "degree " << k;
    }
}

POLYDEC_OVER_MESHES(CentersOf);

TEST(Centroids, are_circumcenters_of_regular_simplices_and_of_no_others) {
    Mesh regular = grid(3, 3); // sheared until its triangles are equilateral
    regular.points.col(0) -= regular.points.col(1) / 2;
    regular.points.col(1) *= std::sqrt(0.75);
    const SimplicialComplex K(regular.simplices);
    const auto around = circumcentric_volumes(K, regular.points);
    const auto mean = dual_volumes(K, regular.points, Centers::centroids());
    for (int k = 0; k <= 2; ++k)
        EXPECT_LT(relative_difference(mean.dual(k), around.dual(k)), 1e-12);
    const Mesh right = grid(3, 3);
    const SimplicialComplex squares(right.simplices);
    EXPECT_GT(relative_difference(dual_volumes(squares, right.points, Centers::centroids()).dual(1),
                                  circumcentric_volumes(squares, right.points).dual(1)),
              0.1);
}

TEST(Combinations, are_refused_for_tables_of_other_simplices) {
    const Mesh square = grid(1, 1);
    const SimplicialComplex K(square.simplices);
    const Points edges = Points::Constant(5, 2, 0.5);
    const auto refused = [&](int k, const Points& coordinates, const Points& of_vertices) {
        return refusal([&] { combinations(K, k, coordinates, of_vertices); });
    };
    EXPECT_EQ(refused(1, edges, square.points), "accepted");
    EXPECT_SAYS(refused(1, edges.topRows(4), square.points), "4 rows", "coordinates", "5");
    EXPECT_SAYS(refused(1, edges.leftCols(1), square.points), "1 coordinates", "2");
    EXPECT_SAYS(refused(1, edges, square.points.topRows(3)), "3 rows", "vertices", "4");
    for (const int k : {-1, 3})
        EXPECT_NE(refused(k, edges, square.points), "accepted");
}

TEST(CentersOfOnesOwn, and_centroids_do_not_go_with_flips) {
    EXPECT_REFUSED(
        discretize(grid(2, 2), {.delaunay = Delaunay::flips, .centers = Centers::centroids()}),
        "flips", "centers");
}

TEST(CentersOfOnesOwn, are_refused_by_name_where_they_are_none) {
    const Mesh square = grid(1, 1);
    const SimplicialComplex K(square.simplices);
    const auto refused = [](std::vector<Points> rows) {
        return refusal([&] { Centers(std::move(rows)); });
    };
    const Points vertices = Points::Ones(4, 1), edges = Points::Constant(5, 2, 0.5);
    Points triangles = Points::Constant(2, 3, 1.0 / 3);
    EXPECT_EQ(refused({vertices, edges, triangles}), "accepted");
    const Centers fewer({vertices, edges.topRows(4), triangles});
    EXPECT_REFUSED(dual_volumes(K, square.points, fewer), "4 centers", "1-simplices", "5");
    triangles(1, 2) = 1;
    EXPECT_SAYS(refused({vertices, edges, triangles}), "coordinates", "center", "2-simplex 1");
    triangles(1, 2) = NAN;
    EXPECT_NE(refused({vertices, edges, triangles}), "accepted");
    EXPECT_SAYS(refused({vertices, triangles}), "3 coordinates", "center", "1-simplex", "2");
}

} // namespace polydec::test::in_centers
