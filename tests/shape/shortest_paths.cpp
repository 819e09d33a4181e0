// SPDX-License-Identifier: MIT
#include "tests/shape/shapes.h"
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_shortest_paths {

std::vector<MeasuredSurface> surfaces() {
    std::vector<MeasuredSurface> all{measured(cube_surface(3)),
                                     cone(3 * std::numbers::pi, 12, 4),
                                     cone(1.0, 12, 4),
                                     measured(hills(3, 7)),
                                     measured(perturbed(torus(14, 8), 0.15, 1)),
                                     measured(moebius(9, 2)),
                                     measured(perturbed(grid(9, 9), 0.05, 2)),
                                     measured(walls_of_cubes(2)),
                                     measured(touching_tetrahedra())};
    for (const Closing closing : {Closing::torus, Closing::klein_bottle})
        for (const Index n : {1, 2, 5}) {
            const auto sample = flat(n, closing);
            all.push_back({sample.surface, sample.lengths, {}});
        }
    return all;
}

/// Whether a point of a side is the same as one of a side of the next triangle.
bool are_same(const Triangles& surface, const SidePoint& a, const SidePoint& b) {
    const auto vertex = [&](const SidePoint& p) {
        return p.fraction < 1e-9       ? surface.tail(p.halfedge)
               : p.fraction > 1 - 1e-9 ? surface.head(p.halfedge)
                                       : Index(-1);
    };
    const auto along = [&](const SidePoint& p) {
        return surface.sign(p.halfedge) > 0 ? p.fraction : 1 - p.fraction;
    };
    if (vertex(a) >= 0 && vertex(a) == vertex(b))
        return true;
    return surface.edge(a.halfedge) == surface.edge(b.halfedge) &&
           std::abs(along(a) - along(b)) < 1e-12;
}

TEST(ShortestPaths, are_connected_lead_to_a_source_and_have_the_length_of_the_distance) {
    for (const MeasuredSurface& shape : surfaces())
        for (const Index first : {Index(0), shape.surface.vertices() / 2}) {
            const Triangles& surface = shape.surface;
            std::vector<Index> sources{first};
            for (const Index v : one_of_each_component(surface))
                sources.push_back(v);
            const ShortestPaths paths(surface, shape.lengths, sources);
            EXPECT_EQ(paths.distances(), exact_distance(surface, shape.lengths, sources));
            for (Index v = 0; v < surface.vertices(); ++v) {
                const auto [source, length, pieces] = paths.from(v);
                EXPECT_TRUE(std::find(sources.begin(), sources.end(), source) != sources.end());
                EXPECT_NEAR(length, paths.distances()[v], 1e-13 * (1 + length));
                EXPECT_EQ(pieces.empty(), paths.distances()[v] == 0);
                for (std::size_t i = 0; i < pieces.size(); ++i) {
                    EXPECT_EQ(Triangles::triangle(pieces[i].begin.halfedge),
                              Triangles::triangle(pieces[i].end.halfedge));
                    if (i > 0) {
                        EXPECT_TRUE(are_same(surface, pieces[i - 1].end, pieces[i].begin)) << v;
                    }
                }
                if (pieces.empty())
                    continue;
                EXPECT_EQ(surface.tail(pieces.front().begin.halfedge), v);
                EXPECT_EQ(surface.tail(pieces.back().end.halfedge), source);
                EXPECT_EQ(pieces.back().end.fraction, 0);
            }
        }
}

/// The corners of the triangles of a mesh in space.
std::vector<Eigen::Matrix3d> corners(const Mesh& mesh) {
    std::vector<Eigen::Matrix3d> triangles;
    for (Index t = 0; t < mesh.simplices.rows(); ++t) {
        Eigen::Matrix3d corners = Eigen::Matrix3d::Zero();
        for (int i = 0; i < 3; ++i)
            corners.col(i).head(mesh.points.cols()) = mesh.points.row(mesh.simplices(t, i));
        triangles.push_back(corners);
    }
    return triangles;
}

TEST(ShortestPaths, know_the_distance_of_every_point_as_a_finer_mesh_has_it) {
    constexpr int n = 4;
    double linear_error = 0;
    for (const Mesh& mesh :
         {cube_surface(2), perturbed(torus(9, 6), 0.1, 1), hills(3, 5), moebius(7, 2)}) {
        const Mesh fine_mesh = divided(corners(mesh), n);
        const MeasuredSurface coarse = measured(mesh), fine = measured(fine_mesh);
        const Index source = vertex_at(fine, fine_mesh, place(coarse, mesh, 0));
        const ShortestPaths paths(coarse.surface, coarse.lengths, std::vector<Index>{0});
        const Vector d = exact_distance(fine.surface, fine.lengths, std::vector<Index>{source});
        for (Index t = 0; t < coarse.surface.triangles(); ++t)
            for (int i = 0; i <= n; ++i)
                for (int j = 0; i + j <= n; ++j) {
                    const Eigen::Vector3d at = Eigen::Vector3d(i, j, n - i - j) / n;
                    Eigen::Vector3d point = Eigen::Vector3d::Zero();
                    double linear = 0;
                    for (int k = 0; k < 3; ++k) {
                        const Index v = coarse.surface.tail(3 * t + k);
                        point += at[k] * place(coarse, mesh, v);
                        linear += at[k] * paths.distances()[v];
                    }
                    const Index v = vertex_at(fine, fine_mesh, point);
                    EXPECT_NEAR(paths.at(t, at), d[v], 1e-13);
                    linear_error = std::max(linear_error, std::abs(linear - d[v]));
                }
    }
    EXPECT_GT(linear_error, 0.01); // values at vertices do not tell
}

TEST(ShortestPaths, over_a_cube_cross_an_edge_in_its_middle_and_diagonals_in_thirds) {
    const Mesh mesh = cube_surface(1);
    const MeasuredSurface shape = measured(mesh);
    const Index corner = vertex_at(shape, mesh, Eigen::Vector3d::Zero());
    const ShortestPaths paths(shape.surface, shape.lengths, std::vector<Index>{corner});
    const auto path = paths.from(vertex_at(shape, mesh, Eigen::Vector3d::Ones()));
    EXPECT_NEAR(path.length, std::sqrt(5.0), 1e-15);
    ASSERT_GE(path.pieces.size(), 2U);
    for (std::size_t i = 1; i < path.pieces.size(); ++i) {
        const SidePoint at = path.pieces[i].begin;
        const bool is_edge = std::abs(shape.lengths[shape.surface.edge(at.halfedge)] - 1) < 1e-9;
        const double off = std::abs(at.fraction - 0.5);
        EXPECT_NEAR(off, is_edge ? 0.0 : 1.0 / 6, 1e-15);
    }
}

TEST(ShortestPaths, from_vertices_and_at_places_that_are_none_are_refused) {
    const MeasuredSurface shape = measured(cube_surface(1));
    const ShortestPaths paths(shape.surface, shape.lengths, std::vector<Index>{0});
    EXPECT_THROW(paths.from(8), InvalidInput);
    EXPECT_THROW(paths.from(-1), InvalidInput);
    EXPECT_THROW(paths.at(12, {1, 0, 0}), InvalidInput);
    EXPECT_REFUSED(paths.at(3, {std::nan(""), 1, 0}), "triangle 3", "nan, 1, 0", "sum is 1");
    EXPECT_REFUSED(paths.at(3, {1, 0, std::nan("")}), "1, 0, nan");
    EXPECT_REFUSED(paths.at(3, {-1, 1, 1}), "-1, 1, 1");
    EXPECT_REFUSED(paths.at(3, {0.5, 0.5, 0.5}), "0.5, 0.5, 0.5");
    EXPECT_NO_THROW(paths.at(3, {1 + 1e-15, 0, -1e-15}));
}

} // namespace polydec::test::in_shortest_paths
