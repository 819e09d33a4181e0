// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/bunge_virtual_vertex.h"
#include "tests/paper/rival_surfaces.h"

namespace polydec::paper::in_virtual_vertices {

TEST(VirtualVertices, of_regular_polygons_weigh_all_corners_equally) {
    for (const Index n : {3, 4, 5, 6, 11}) {
        Polygon polygon(n, 3);
        for (Index i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            polygon.row(i) << std::cos(angle), std::sin(angle), 1.0;
        }
        const Vector w = virtual_vertex_weights(polygon);
        EXPECT_LE((w.array() - 1.0 / n).abs().maxCoeff(), 1e-14) << n;
    }
}

double squared_areas(const Polygon& polygon, const Eigen::RowVector3d& x) {
    const Polygon from = polygon.rowwise() - x;
    double sum = 0;
    for (Index i = 0; i < from.rows(); ++i)
        sum += from.row(i)
                   .transpose()
                   .cross(from.row((i + 1) % from.rows()).transpose())
                   .squaredNorm();
    return sum;
}

TEST(VirtualVertices, minimize_the_squared_areas_of_their_triangles_with_weights_of_least_norm) {
    for (const auto& name : {"moved_hexagons", "moved_chevrons", "crumpled_goldberg"}) {
        const auto& mesh = surfaces().at(name).mesh;
        for (Index f = 0; f < mesh.size(); ++f) {
            const Polygon polygon = positions(mesh, f);
            const Vector w = virtual_vertex_weights(polygon);
            const Eigen::RowVector3d x = w.transpose() * polygon;
            EXPECT_NEAR(w.sum(), 1, 1e-13);
            for (Index axis = 0; axis < 3; ++axis)
                for (const double step : {-1e-3, 1e-3})
                    EXPECT_GT(squared_areas(polygon, x + step * Eigen::RowVector3d::Unit(axis)),
                              squared_areas(polygon, x));

            // least norm: nothing of w lies in the kernel of "the same point and the same sum"
            DenseMatrix conditions(4, polygon.rows());
            conditions << polygon.transpose(), Eigen::RowVectorXd::Ones(polygon.rows());
            const Vector range = conditions.transpose().completeOrthogonalDecomposition().solve(w);
            EXPECT_LE((conditions.transpose() * range - w).norm(), 1e-12);
        }
    }
}

TEST(VirtualVertices, have_weights_that_jump_where_a_polygon_stops_being_planar) {
    Polygon planar(4, 3), bent(4, 3), rounded(4, 3);
    planar << 0, 0, 0, 3, 0, 0, 2, 2, 0, 0, 1, 0;
    bent = rounded = planar;
    bent(2, 2) = 1e-6;
    rounded(2, 2) = 1e-13;
    const Vector w = virtual_vertex_weights(planar);
    EXPECT_LE((virtual_vertex_weights(rounded) - w).norm(), 1e-11);
    EXPECT_GE((virtual_vertex_weights(bent) - w).norm(), 1e-2);
}

} // namespace polydec::paper::in_virtual_vertices
