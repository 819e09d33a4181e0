// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_surface_paths {

/// How far ends of segments are from circles around a corner of a square, on eight triangles.
double defect(Index divisions) {
    const auto square = circumcentric(grid(2, 2));
    const Vector levels{{0.3, 0.6, 0.9}};
    const auto lines = SurfacePaths(square, std::vector<Index>{0}).isolines(levels, divisions);
    const Vector corner = square.points().row(0);
    double worst = 0;
    for (Index s = 0; s < lines.mesh.simplices.rows(); ++s)
        for (const Index end : {0, 1}) {
            const Vector place = lines.mesh.points.row(lines.mesh.simplices(s, end));
            const double radius = (place - corner).norm();
            worst = std::max(worst, std::abs(radius - levels[lines.levels[s]]));
        }
    return worst;
}

// Between values at vertices they would be straight across a triangle, and off by a tenth.
TEST(Isolines, of_a_plane_are_circles_with_order_2) {
    const double coarse = defect(8), fine = defect(16);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.4);
}

TEST(ShortestPaths, across_a_seam_have_their_places_in_the_box) {
    const auto torus = discretize(periodic(grid(6, 6), {Vector{{1, 0}}, Vector{{0, 1}}}));
    const auto path = SurfacePaths(torus, std::vector<Index>{0}).from(4); // at (2/3, 0)
    EXPECT_NEAR(path.length, 1. / 3, 1e-14);
    EXPECT_NEAR(total_volume(path.lines), path.length, 1e-14);
}

// Windows turn around vertices within triangles of which paths have one corner only.
TEST(ShortestPaths, through_vertices_have_no_piece_that_is_a_point) {
    for (const Mesh& mesh : {grid(6, 6), icosphere(4), torus(9, 6)}) {
        const auto surface = circumcentric(mesh);
        const SurfacePaths paths(surface, std::vector<Index>{0});
        for (Index v = 0; v < surface.complex().size(0); ++v) {
            const auto path = paths.from(v);
            double length = 0;
            for (const auto& ends : path.lines.simplices.rowwise()) {
                const double piece =
                    (path.lines.points.row(ends[0]) - path.lines.points.row(ends[1])).norm();
                EXPECT_GT(piece, 1e-9);
                length += piece;
            }
            EXPECT_NEAR(length, path.length, 1e-12);
        }
    }
}

TEST(ShortestPaths, of_any_size_have_all_their_pieces) {
    const Mesh mesh = icosphere(3);
    const auto surface = circumcentric(mesh);
    for (const int exponent : {-600, 600}) {
        Mesh other = mesh;
        other.points *= std::ldexp(1, exponent);
        const auto scaled = circumcentric(other);
        const SurfacePaths paths(surface, std::vector<Index>{0}),
            others(scaled, std::vector<Index>{0});
        for (Index v = 1; v < surface.complex().size(0); ++v) {
            const auto path = others.from(v);
            EXPECT_GT(path.lines.simplices.rows(), 0);
            EXPECT_EQ(DenseMatrix(std::ldexp(1, -exponent) * path.lines.points),
                      DenseMatrix(paths.from(v).lines.points))
                << exponent << ", vertex " << v;
        }
    }
}

} // namespace polydec::test::in_surface_paths
