// SPDX-License-Identifier: MIT
#include "meshes/point_tree.h"

#include "tests/support/test.h"

namespace polydec::test::in_point_tree {

/// Points of which some lie in the simplex, and some about a length away from it.
Points points_around(const Points& simplex, double length, std::mt19937& random) {
    std::uniform_real_distribution<double> part(0, 1), any(-1, 1);
    Points points(300, simplex.cols());
    for (Index i = 0; i < points.rows(); ++i) {
        Eigen::VectorXd shares = Eigen::VectorXd::NullaryExpr(simplex.rows(), [&](Eigen::Index) {
            return -std::log(part(random)); // uniform among those of sum 1
        });
        points.row(i) = (shares / shares.sum()).transpose() * simplex;
        if (i % 3 > 0)
            for (Index axis = 0; axis < points.cols(); ++axis)
                points(i, axis) += (i % 3 == 1 ? length : 0.3) * any(random);
    }
    return points;
}

// Large and thin simplices among many points, compared with a test of every point.
TEST(PointTree, finds_the_points_near_a_simplex) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    constexpr double length = 0.01;
    Index found = 0, others = 0;
    for (int round = 0; round < 200; ++round) {
        const int N = 2 + round % 2, k = 1 + round % N;
        Points simplex =
            Points::NullaryExpr(k + 1, N, [&](Eigen::Index, Eigen::Index) { return any(random); });
        if (round % 5 == 0)
            simplex.row(1) = simplex.row(0).array() + 1e-3;
        const Points points = points_around(simplex, length, random);
        std::vector<Index> expected;
        for (Index i = 0; i < points.rows(); ++i)
            if (i != 7 &&
                squared_distance(points.row(i), simplex, length * length) <= length * length)
                expected.push_back(i);
        EXPECT_EQ(PointTree(points).near(simplex, length, {7}), expected) << round;
        found += std::ssize(expected);
        others += points.rows() - std::ssize(expected);
    }
    EXPECT_GT(found, 10'000);
    EXPECT_GT(others, 10'000);
}

} // namespace polydec::test::in_point_tree
