// SPDX-License-Identifier: MIT
//
// Exact distances against the exact paths of CGAL, where its headers are.
#include "tests/shape/shapes.h"

#ifdef POLYDEC_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#endif

namespace polydec::test::in_exact_paths_of_cgal {

#ifdef POLYDEC_HAS_CGAL

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>>;

/// From one vertex of a surface to all, which are those of a mesh.
Vector distances_of_cgal(const MeasuredSurface& shape, const Mesh& mesh, Index source) {
    SurfaceMesh surface;
    std::vector<SurfaceMesh::Vertex_index> vertices;
    for (const Index v : shape.vertices) {
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        point.head(mesh.points.cols()) = mesh.points.row(v);
        vertices.push_back(surface.add_vertex({point[0], point[1], point[2]}));
    }
    const auto corner = [&](Index halfedge) { return vertices[shape.surface.tail(halfedge)]; };
    for (Index h = 0; h < 3 * shape.surface.triangles(); h += 3)
        if (!surface.add_face(corner(h), corner(h + 1), corner(h + 2)).is_valid())
            throw std::logic_error("the mesh is not oriented");
    Paths paths(surface);
    paths.add_source_point(vertices[source]);
    Vector result(shape.surface.vertices());
    for (Index v = 0; v < result.size(); ++v)
        result[v] = paths.shortest_distance_to_source_points(vertices[v]).first;
    return result;
}

TEST(ExactDistance, is_that_of_cgal) {
    const std::vector<Mesh> meshes{
        icosphere(3),    perturbed(icosphere(3), 0.05, 1), perturbed(torus(24, 12), 0.1, 2),
        cube_surface(6), perturbed(grid(15, 15), 0.02, 3), perturbed(uv_sphere(12, 17), 0.03, 4)};
    for (const Mesh& mesh : meshes) {
        const MeasuredSurface shape = measured(mesh);
        for (const Index source : {Index(0), shape.surface.vertices() / 3}) {
            const Vector d =
                exact_distance(shape.surface, shape.lengths, std::vector<Index>{source});
            const Vector cgal = distances_of_cgal(shape, mesh, source);
            for (Index v = 0; v < d.size(); ++v)
                EXPECT_NEAR(d[v], cgal[v], 1e-12) << mesh.simplices.rows() << " triangles";
        }
    }
}

#else

TEST(ExactDistance, is_that_of_cgal) {
    GTEST_SKIP() << "libcgal-dev is not there";
}

#endif

} // namespace polydec::test::in_exact_paths_of_cgal
