// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_peel {

void add(Mesh& mesh, const std::vector<std::array<Index, 4>>& cells) {
    const auto before = mesh.simplices.rows();
    mesh.simplices.conservativeResize(before + std::ssize(cells), Eigen::NoChange);
    for (std::size_t t = 0; t < cells.size(); ++t)
        for (Index i = 0; i < mesh.simplices.cols(); ++i)
            mesh.simplices(before + Index(t), i) = cells[t][i];
}

/// The vertex at the place, or -1.
Index vertex_at(const Mesh& mesh, const Eigen::RowVectorXd& place) {
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if ((mesh.points.row(v) - place).norm() < 1e-9)
            return v;
    return -1;
}

/// m^3 cubes, one vertex of the bottom a little inside, and under it the flat cells of the hull: a
/// fan over the hexagon around it.
Mesh dented_cubes(int m, double depth) {
    Mesh mesh = kuhn(3, m);
    const auto at = [&](int i, int j) { return vertex_at(mesh, Eigen::RowVector3d(i, j, 0) / m); };
    const Index dent = at(1, 1);
    const std::array ring{at(0, 0), at(1, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 1)};
    mesh.points(dent, 2) = depth / m;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        add(mesh, {{dent, ring[0], ring[i], ring[i + 1]}});
    return mesh;
}

TEST(Peeling, takes_flat_cells_off_a_hull) {
    for (const double depth : {1e-12, 1e-8, 1e-5}) {
        const Mesh mesh = peeled(dented_cubes(3, depth));
        EXPECT_EQ(mesh.simplices.rows(), 6 * 27) << depth;
        EXPECT_SAYS(mesh.warnings.back(), "4 flat cells", "boundary");
        EXPECT_EQ(discretize(mesh).complex().size(3), 27) << depth;
    }
}

TEST(Peeling, does_not_depend_on_numbers) {
    const Mesh mesh = dented_cubes(3, 1e-6);
    for (const std::uint64_t seed : {1, 2, 3})
        EXPECT_EQ(peeled(shuffled(mesh, seed).mesh).simplices.rows(), 6 * 27);
}

TEST(Peeling, of_a_plane_takes_triangles_off_an_edge) {
    Mesh mesh = grid(3, 3);
    const double step = mesh.points.col(0).maxCoeff() / 3;
    const auto at = [&](int i) { return vertex_at(mesh, Eigen::RowVector2d(i * step, 0)); };
    const Index a = at(0), b = at(1), c = at(2);
    mesh.points(b, 1) = 1e-7 * step;
    const auto before = mesh.simplices.rows();
    add(mesh, {{a, c, b, 0}});
    EXPECT_EQ(peeled(mesh).simplices.rows(), before);
    EXPECT_EQ(discretize(peeled(mesh)).complex().size(2), 9);
}

TEST(Peeling, leaves_thin_layers_and_meshes_without_flat_cells) {
    Mesh thin = kuhn(3, 3);
    thin.points.col(2) *= 1e-5;
    for (const Mesh& mesh : {thin, kuhn(3, 2), grid(3, 3), fcc(1)}) {
        EXPECT_EQ(peeled(mesh).simplices.rows(), mesh.simplices.rows());
        EXPECT_TRUE(peeled(mesh).warnings.empty());
    }
}

TEST(Peeling, is_of_solids_alone) {
    EXPECT_REFUSED(peeled(uv_sphere(6, 4)), "peel", "dimension 2", "3 coordinates");
}

TEST(PeelingBroken, without_it_hull_cells_would_stay) {
    EXPECT_GT(discretize(dented_cubes(3, 1e-6)).complex().size(3), 27);
}

} // namespace polydec::test::in_peel
