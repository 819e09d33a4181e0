// SPDX-License-Identifier: MIT
#include "tests/paper/rival_surfaces.h"

#include "examples/paper/rivals/alexa_wardetzky.h"
#include "examples/paper/rivals/bunge_diamond.h"
#include "examples/paper/rivals/bunge_virtual_vertex.h"
#include "examples/paper/rivals/de_goes.h"

namespace polydec::paper {

using test::random_vector;

const std::map<std::string, Laplacian>& rivals() {
    static const std::map<std::string, Laplacian> all = {
        {"alexa_wardetzky", [](const PolygonMesh& mesh) { return alexa_wardetzky(mesh); }},
        {"de_goes", [](const PolygonMesh& mesh) { return de_goes(mesh); }},
        {"bunge_virtual_vertex", bunge_virtual_vertex},
        {"bunge_diamond", bunge_diamond}};
    return all;
}

PolygonLaplacian of_graph(const PolygonMesh& mesh) {
    const auto local = [](const Polygon& polygon) -> DenseMatrix {
        const DenseMatrix D = differences(static_cast<Index>(polygon.rows()));
        return D.transpose() * D / 2;
    };
    SparseMatrix identity(mesh.points.rows(), mesh.points.rows());
    identity.setIdentity();
    return {assemble(mesh, local), identity};
}

PolygonMesh polygons(const Mesh& mesh) {
    const auto made = discretize(mesh);
    auto result = polygon_mesh(made.merging(), made.points());
    const auto axes = result.points.cols();
    result.points.conservativeResize(Eigen::NoChange, 3);
    result.points.rightCols(3 - axes).setZero();
    return result;
}

namespace {

PolygonMesh moved(PolygonMesh mesh, double amplitude, Index axes) {
    for (Index axis = 0; axis < axes; ++axis)
        mesh.points.col(axis) += amplitude * random_vector(static_cast<Index>(mesh.points.rows()),
                                                           static_cast<unsigned>(7 + axis));
    return mesh;
}

/// A plane of arrow-shaped hexagons, `across` times `up`, not convex at one corner each.
PolygonMesh chevrons(Index across, Index up) {
    PolygonMesh mesh;
    const Index columns = 2 * across + 1;
    mesh.points.resize(columns * (up + 1), 3);
    for (Index j = 0; j <= up; ++j)
        for (Index i = 0; i < columns; ++i)
            mesh.points.row(j * columns + i) << i, j + (i % 2) * 0.3, 0.0;
    for (Index j = 0; j < up; ++j)
        for (Index i = 0; i + 2 < columns; i += 2) {
            const Index low = j * columns + i, high = low + columns;
            for (const Index v : {low, low + 1, low + 2, high + 2, high + 1, high})
                mesh.corners.push_back(v);
            mesh.offsets.push_back(static_cast<Index>(mesh.corners.size()));
        }
    return mesh;
}

} // namespace

const std::map<std::string, Surface>& surfaces() {
    static const std::map<std::string, Surface> all = {
        {"squares", {polygons(grid(6, 5, 6.0, 5.0)), true, true}},
        {"quads", {moved(polygons(grid(6, 5, 6.0, 5.0)), 0.25, 2), true, true}},
        {"hexagons", {polygons(hexagons(4)), true, true}},
        {"moved_hexagons", {moved(polygons(hexagons(4)), 0.03, 2), true, true}},
        {"chevrons", {chevrons(3, 4), true, true}},
        {"moved_chevrons", {moved(chevrons(3, 4), 0.1, 2), true, true}},
        {"triangles", {moved(polygons(well_centered(3)), 0.05, 2), true, true}},
        {"uv_sphere", {polygons(uv_sphere(9, 7)), false, true}},
        {"goldberg", {polygons(goldberg(2)), false, true}},
        {"icosphere", {polygons(icosphere(2)), false, true}},
        {"moebius", {polygons(moebius(12, 3)), false, true}},
        {"crumpled_torus", {moved(polygons(torus(9, 6)), 0.05, 3), false, false}},
        {"crumpled_goldberg", {moved(polygons(goldberg(2)), 0.05, 3), false, false}}};
    return all;
}

} // namespace polydec::paper
