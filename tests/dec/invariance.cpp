// SPDX-License-Identifier: MIT
#include "dec/metric/plane.h"
#include "tests/dec/discretized.h"
#include "tests/support/slivers.h"

namespace polydec::test::in_invariance {

/// The cells of each degree by their vertices, sorted.
std::vector<std::vector<std::vector<Index>>> shape(const Discretization& mesh) {
    std::vector<std::vector<std::vector<Index>>> result;
    for (int k = 0; k <= mesh.dimension(); ++k) {
        auto& cells = result.emplace_back();
        for (Index c = 0; c < mesh.complex().size(k); ++c)
            cells.push_back(mesh.merging().vertices(k, c));
        std::sort(cells.begin(), cells.end());
    }
    return result;
}

std::vector<Mesh> moved(const Mesh& mesh) {
    std::vector<Mesh> result;
    const auto n = mesh.points.cols();
    for (Eigen::Index axis = 0; axis < n; ++axis) {
        result.push_back(mesh); // reflected
        result.back().points.col(axis) *= -1;
        result.push_back(mesh); // axes exchanged
        result.back().points.col(axis).swap(result.back().points.col((axis + 1) % n));
    }
    result.push_back(mesh);
    result.back().points *= 1024;
    result.push_back(mesh); // in more coordinates, in the middle and behind
    result.back().points.resize(mesh.points.rows(), n + 2);
    result.back().points << mesh.points.leftCols(1), Points::Constant(mesh.points.rows(), 1, 7),
        mesh.points.rightCols(n - 1), Points::Zero(mesh.points.rows(), 1);
    return result;
}

class Shapes : public testing::TestWithParam<int> {};

TEST_P(Shapes, do_not_depend_on_axes_reflection_scale_or_more_coordinates) {
    const int seed = GetParam();
    Index merged = 0;
    for (const double jitter : {0.0, 1e-8, 1e-6, 3e-5, 1e-4, 3e-4})
        for (const Mesh& mesh :
             {delaunay_grid(3, jitter, seed == 3 ? 33 : seed), perturbed(kuhn(3, 2), jitter, seed),
              perturbed(kuhn(4, 1), jitter, seed), perturbed(grid(4, 4), jitter, seed)}) {
            const auto exact = discretize(mesh);
            const auto expected = shape(exact);
            merged +=
                exact.pieces().size(exact.dimension()) - exact.complex().size(exact.dimension());
            for (const Mesh& other : moved(mesh)) {
                const auto found = discretize(other);
                EXPECT_EQ(shape(found), expected) << mesh.dimension() << ' ' << jitter;
                const double scale = other.points.norm() > 100 * mesh.points.norm() ? 1024 : 1;
                const Vector lengths = exact.volumes().dual(exact.dimension() - 1) * scale;
                EXPECT_LE((found.volumes().dual(found.dimension() - 1) - lengths).norm(),
                          1e-9 * lengths.norm())
                    << mesh.dimension() << ' ' << jitter;
            }
        }
    EXPECT_GT(merged, 100);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Shapes, testing::Range(1, 9));

TEST(Shapes, of_tilted_planes_are_those_of_the_plane) {
    const Mesh flat = delaunay_grid(3, 3e-5);
    Mesh tilted = flat;
    DenseMatrix basis(3, 4); // orthonormal rows in R^4
    basis << 0.5, 0.5, 0.5, 0.5, 0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, -0.5;
    tilted.points = flat.points * basis;
    EXPECT_EQ(plane_points(tilted.points, 3).points.cols(), 3);
    EXPECT_EQ(shape(discretize(tilted)), shape(discretize(flat)));
    EXPECT_EQ(plane_points(perturbed(tilted, 1e-9, 1).points, 3).points.cols(), 0);
    EXPECT_EQ(plane_points(flat.points, 3).points.cols(), 0);
}

TEST(Shapes, of_details_far_smaller_than_their_distance_are_not_flattened) {
    // a pyramid of 48 units in the last place of its coordinates
    Mesh near = grid(8, 8);
    near.points.conservativeResize(Eigen::NoChange, 3);
    for (Eigen::Index v = 0; v < near.points.rows(); ++v) {
        const double x = near.points(v, 0), y = near.points(v, 1);
        near.points.row(v) << 160 * x, 160 * y,
            48 * (1 - 2 * std::max(std::abs(x - 0.5), std::abs(y - 0.5)));
    }
    near.points *= std::ldexp(1, -33);
    Mesh far = near;
    far.points.array() += std::ldexp(1, 20);
    ASSERT_EQ(DenseMatrix(far.points.array() - std::ldexp(1, 20)), DenseMatrix(near.points));
    const auto area = [](const Mesh& mesh) { return discretize(mesh).volumes().primal(2).sum(); };
    EXPECT_NEAR(area(far) / area(near), 1, 1e-12);
}

/// Orthonormal rows in R^N.
DenseMatrix random_axes(int n, int N, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> number;
    const DenseMatrix any = DenseMatrix::NullaryExpr(N, n, [&] { return number(random); });
    const DenseMatrix Q = any.householderQr().householderQ();
    return Q.leftCols(n).transpose();
}

TEST(Planes, of_points_have_volumes_within_rounding_of_those_between_the_points) {
    const Mesh flat = made_of({{0, 0}, {1, 0}, {0.5, 1e-8}, {0.5, -1}}, {{0, 1, 2}, {0, 3, 1}});
    for (const Mesh& mesh : {kuhn({5}), grid(5, 4), flat, perturbed(grid(20, 20), 1e-2, 1),
                             perturbed(kuhn(3, 2), 1e-2, 1)})
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const int n = mesh.dimension(), N = n + 1 + static_cast<int>(seed % 2);
            Mesh tilted = mesh;
            tilted.points *= random_axes(n, N, seed);
            tilted.points.array() += seed % 5;
            const auto found = discretize(tilted, {.criterion = MergeCriterion::none,
                                                   .star = StarKind::circumcentric})
                                   .input_geometry();
            EXPECT_EQ(found.metric().ambient_dimension(), n) << seed;
            const auto exact = circumcentric_volumes(found.pieces(), tilted.points);
            for (int k = 0; k <= n; ++k) {
                const Vector bound =
                    found.volumes().rounding(k).vector() + exact.rounding(k).vector();
                const Vector error = (found.volumes().ratios(k) - exact.ratios(k))
                                         .cwiseAbs()
                                         .cwiseProduct(exact.primal(k));
                EXPECT_TRUE((error.array() <= bound.array()).all())
                    << "n = " << n << ", k = " << k << ", seed " << seed << ": "
                    << error.cwiseQuotient(bound).maxCoeff();
            }
        }
}

TEST(Planes, are_none_where_details_are_small_beside_zero_coordinates) {
    Mesh mesh =
        made_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-11, 5e-15}, {0.5, -1, 0}}, {{0, 1, 2}, {0, 3, 1}});
    const auto volumes =
        discretize(mesh, {.criterion = MergeCriterion::none, .star = StarKind::circumcentric})
            .volumes();
    EXPECT_NEAR(volumes.primal(2)[0] / (std::hypot(1e-11, 5e-15) / 2), 1, 1e-12);
}

TEST(Kinds, of_pairs_do_not_depend_on_numbers_where_a_center_is_on_the_facet) {
    // octahedra that are too flat to merge, whose pieces have one center
    Mesh mesh = fcc(1);
    mesh.points.col(2) *= 0.01;
    const auto kinds_of = [](const Mesh& numbered) {
        return counts(facet_kinds(discretize(numbered).input_geometry()));
    };
    const auto expected = kinds_of(mesh);
    EXPECT_EQ(expected[3], 2);
    for (unsigned seed = 1; seed <= 8; ++seed)
        EXPECT_EQ(kinds_of(shuffled(mesh, seed).mesh), expected) << seed;
}

TEST(HybridStars, do_not_depend_on_the_side_to_which_a_right_angle_is_rounded) {
    // squares with a diagonal, of which one corner is pulled out
    Mesh mesh = grid(6, 6);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (mesh.points(v, 0) > 0.99 && mesh.points(v, 1) > 0.99)
            mesh.points.row(v) << 0.9, 0.85;
    const auto stars_of = [](const Mesh& turned) {
        const auto cells = discretize(turned, {.criterion = MergeCriterion::none});
        return cells.with_stars(StarKind::hybrid).chosen_stars();
    };
    const auto expected = stars_of(mesh);
    EXPECT_GT(expected.galerkin_share(), 0);
    EXPECT_LT(expected.galerkin_share(), 1);
    for (int k = 0; k < 40; ++k) {
        Mesh turned = mesh;
        turned.points =
            mesh.points * Eigen::Rotation2Dd(0.1 + 0.37 * k).toRotationMatrix().transpose();
        EXPECT_EQ(stars_of(turned).galerkin, expected.galerkin) << k;
    }
}

} // namespace polydec::test::in_invariance
