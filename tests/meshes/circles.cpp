// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_circles {

/// The polygons of a mesh whose triangles come as fans, one polygon after the other, each triangle
/// (a, b, c) of a fan being followed by (a, c, d).
std::vector<std::vector<Index>> fanned_polygons(const Mesh& mesh) {
    std::vector<std::vector<Index>> result;
    for (Index t = 0; t < mesh.simplices.rows(); ++t) {
        const auto triangle = mesh.simplices.row(t);
        if (result.empty() || result.back().front() != triangle[0] ||
            result.back().back() != triangle[1])
            result.push_back({triangle[0], triangle[1]});
        result.back().push_back(triangle[2]);
    }
    return result;
}

struct Distances {
    double plane = 0.0;  ///< root mean square distance of corners from the nearest plane
    double circle = 0.0; ///< largest distance from the circle of least squares, within that plane
};

/// On a circle with the center c, |x|^2 - 2 c . x is constant.
Distances distances(const Points& points, const std::vector<Index>& polygon) {
    const auto p = static_cast<Eigen::Index>(polygon.size());
    DenseMatrix X(p, points.cols());
    for (Eigen::Index i = 0; i < p; ++i)
        X.row(i) = points.row(polygon[i]);
    X.rowwise() -= X.colwise().mean().eval();
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> axes(
        DenseMatrix(X.transpose() * X)); // ascending
    const DenseMatrix in_plane = X * axes.eigenvectors().rightCols(2);

    DenseMatrix A(p, 3);
    A << 2.0 * in_plane, Vector::Ones(p);
    const Vector squares = in_plane.rowwise().squaredNorm();
    const Vector circle = least_squares(A, squares).shortest;
    return {points.cols() == 2 ? 0.0 : (X * axes.eigenvectors().col(0)).norm() / std::sqrt(p),
            (A * circle - squares).cwiseAbs().maxCoeff() / (2.0 * std::sqrt(squares.mean()))};
}

/// Largest over all polygons of a mesh.
Distances largest_distances(const Mesh& mesh) {
    Distances largest;
    for (const auto& polygon : fanned_polygons(mesh)) {
        const auto [plane, circle] = distances(mesh.points, polygon);
        largest.plane = std::max(largest.plane, plane);
        largest.circle = std::max(largest.circle, circle);
    }
    return largest;
}

std::map<std::size_t, Index> polygon_sizes(const Mesh& mesh) {
    std::map<std::size_t, Index> sizes;
    for (const auto& polygon : fanned_polygons(mesh))
        ++sizes[polygon.size()];
    return sizes;
}

class Goldberg : public testing::TestWithParam<int> {};

TEST_P(Goldberg, has_planar_concyclic_pentagons_and_hexagons) {
    const int f = GetParam();
    const Mesh mesh = goldberg(f);
    std::map<std::size_t, Index> sizes{{5, 12}};
    if (f > 1)
        sizes[6] = 10 * f * f - 10;
    EXPECT_EQ(polygon_sizes(mesh), sizes);
    const auto [plane, circle] = largest_distances(mesh);
    EXPECT_LT(plane, 1e-15);
    // A corner off the sphere by rounding is off the circle by the ratio of the radii more.
    EXPECT_LT(circle, 1e-15 * f);
}

TEST_P(Goldberg, has_its_corners_on_the_unit_sphere) {
    EXPECT_LT((goldberg(GetParam()).points.rowwise().norm().array() - 1.0).abs().maxCoeff(), 4e-16);
}

TEST_P(Goldberg, keeps_the_symmetry_of_the_icosahedron) {
    const Mesh mesh = goldberg(GetParam());
    Mesh image = mesh;
    image.points.col(0) = mesh.points.col(1);
    image.points.col(1) = mesh.points.col(2);
    image.points.col(2) = -mesh.points.col(0);
    const auto matching = matching_vertices(image, mesh, 1e-12);
    EXPECT_EQ(std::count(matching.begin(), matching.end(), -1), 0);
}

TEST_P(Goldberg, has_faces_of_similar_size) {
    const Mesh mesh = goldberg(GetParam());
    double shortest = 2.0, longest = 0.0;
    for (const auto& polygon : fanned_polygons(mesh))
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Index a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double length = (mesh.points.row(a) - mesh.points.row(b)).norm();
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
        }
    EXPECT_LT(longest, 2.0 * shortest);
}

INSTANTIATE_TEST_SUITE_P(Frequencies, Goldberg, testing::Values(1, 2, 3, 4, 5, 8, 16));

TEST(Hexagons, have_their_corners_on_circles) {
    for (const int columns : {2, 3, 4, 7, 16, 33})
        EXPECT_LT(largest_distances(hexagons(columns)).circle, 1e-15) << columns;
}

TEST(Hexagons, come_as_full_ones_inside_and_cut_ones_at_the_boundary) {
    const std::map<std::size_t, Index> sizes{{4, 4}, {5, 8}, {6, 10}};
    EXPECT_EQ(polygon_sizes(hexagons(4)), sizes);
}

TEST(Surfaces, of_revolution_have_planar_concyclic_quads) {
    for (const Mesh& mesh : {torus(8, 6), torus(31, 17, 5.0, 2.0), flange(7), flange(40)}) {
        EXPECT_EQ(polygon_sizes(mesh).size(), 1U);
        EXPECT_EQ(polygon_sizes(mesh).begin()->first, 4U);
        EXPECT_LT(largest_distances(mesh).plane, 1e-14);
        EXPECT_LT(largest_distances(mesh).circle, 1e-14);
    }
}

TEST(UvSphere, has_triangles_at_the_poles_and_planar_concyclic_quads) {
    const Mesh mesh = uv_sphere(9, 7);
    const std::map<std::size_t, Index> sizes{{3, 18}, {4, 45}};
    EXPECT_EQ(polygon_sizes(mesh), sizes);
    EXPECT_LT(largest_distances(mesh).plane, 1e-15);
    EXPECT_LT(largest_distances(mesh).circle, 1e-15);
}

TEST(Spheres, have_their_vertices_on_the_unit_sphere) {
    for (const Mesh& mesh : {uv_sphere(9, 7), uv_sphere(64, 64), icosphere(1), icosphere(13)})
        EXPECT_LT((mesh.points.rowwise().norm().array() - 1.0).abs().maxCoeff(), 4e-16);
}

/// Whether a map of the points exchanges them to the last bit.
template <typename Map>
bool is_exact_symmetry(const Points& points, Map map) {
    std::vector<std::vector<double>> before, after;
    for (const auto& row : points.rowwise()) {
        const Eigen::RowVectorXd image = map(Eigen::RowVectorXd(row));
        before.emplace_back(row.begin(), row.end());
        after.emplace_back(image.begin(), image.end());
    }
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    return before == after;
}

TEST(Symmetries, are_exact) {
    using Row = Eigen::RowVectorXd;
    const auto cyclic = [](const Row& x) { return Row{{x[1], x[2], x[0]}}; };
    const auto reflected = [](const Row& x) { return Row{{-x[0], x[1], x[2]}}; };
    const auto exchanged = [](const Row& x) { return Row{{x[1], x[0], x[2]}}; };
    const auto upside_down = [](const Row& x) { return Row{{x[0], x[1], -x[2]}}; };
    for (const int frequency : {1, 2, 5, 12}) {
        EXPECT_TRUE(is_exact_symmetry(icosphere(frequency).points, cyclic));
        EXPECT_TRUE(is_exact_symmetry(icosphere(frequency).points, reflected));
        EXPECT_FALSE(is_exact_symmetry(icosphere(frequency).points, exchanged));
    }
    for (const Mesh& mesh : {uv_sphere(12, 7), torus(16, 10), flange(20)}) {
        EXPECT_TRUE(is_exact_symmetry(mesh.points, reflected));
        EXPECT_TRUE(is_exact_symmetry(mesh.points, exchanged));
    }
    EXPECT_TRUE(is_exact_symmetry(uv_sphere(12, 7).points, upside_down));
    EXPECT_TRUE(is_exact_symmetry(torus(16, 10).points, upside_down));
    EXPECT_TRUE(is_exact_symmetry(bcc(3).points, cyclic));
    EXPECT_TRUE(is_exact_symmetry(fcc(3).points, cyclic));
}

TEST(WellCentered, has_acute_triangles_only) {
    for (const int rows : {2, 3, 4, 5, 10, 31, 32}) {
        const Mesh mesh = well_centered(rows);
        double least_cosine = 1.0;
        for (Index t = 0; t < mesh.simplices.rows(); ++t)
            for (int c = 0; c < 3; ++c) {
                const auto corner = [&](int i) {
                    return mesh.points.row(mesh.simplices(t, (c + i) % 3));
                };
                const Eigen::RowVectorXd a = corner(1) - corner(0), b = corner(2) - corner(0);
                least_cosine = std::min(least_cosine, a.dot(b) / (a.norm() * b.norm()));
            }
        EXPECT_GT(least_cosine, 0.04) << rows;
    }
}

} // namespace polydec::test::in_circles
