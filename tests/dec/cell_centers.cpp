// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_cell_centers {

class CellCenters : public OverMeshes {
protected:
    Points centers(int k) const { return cell_centers(discretized(GetParam()), k); }
    bool flat() const { return mesh().points.cols() == mesh().n(); }
};

/// Largest minus least distance from the center to the cell's vertices, over the largest.
double unevenness(const Merged& mesh, int k, Index F, const Vector& center) {
    double least = INFINITY, most = 0;
    for (const Index v : mesh.merging().vertices(k, F)) {
        const double distance = (mesh.points.row(v).transpose() - center).norm();
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    return k == 0 ? most : (most - least) / most;
}

TEST_P(CellCenters, have_the_same_distance_from_all_corners_of_flat_cells) {
    for (int k = 0; k <= mesh().n() && flat(); ++k) {
        const Points c = centers(k);
        for (Index F = 0; F < mesh().P().size(k); ++F)
            EXPECT_LE(unevenness(mesh(), k, F, c.row(F)), 1e-6) << "k = " << k << ", cell " << F;
    }
}

TEST_P(CellCenters, of_degree_0_are_the_vertices) {
    const Points c = centers(0);
    for (Index v = 0; v < mesh().K().size(0); ++v)
        EXPECT_LE((c.row(v) - mesh().points.row(v)).norm(), 1e-15);
}

TEST_P(CellCenters, of_degree_1_are_the_middles) {
    const Points c = centers(1);
    for (Index e = 0; e < mesh().P().size(1); ++e) {
        const auto ends = mesh().merging().vertices(1, e);
        ASSERT_EQ(ends.size(), 2U);
        const auto middle = (mesh().points.row(ends[0]) + mesh().points.row(ends[1])) / 2;
        EXPECT_LE((c.row(e) - middle).norm(), 1e-13);
    }
}

POLYDEC_OVER_MESHES(CellCenters);

TEST(CellCentersOf, cubes_are_their_middles) {
    const Points c = cell_centers(discretized("kuhn3"), 3);
    for (Index F = 0; F < 8; ++F)
        for (Index axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(std::abs(c(F, axis) - 0.5), 0.25, 1e-14);
}

TEST(CellCentersOf, a_folded_rectangle_is_the_middle_of_the_fold) {
    const auto& mesh = merged("folded_rect");
    const Points c = cell_centers(discretized("folded_rect"), 2);
    ASSERT_EQ(c.rows(), 1);
    for (Index e = 0; e < mesh.K().size(1); ++e)
        if (mesh.merging().carriers(1)[e].dimension == 2) {
            const auto ends = mesh.K().simplices(1).row(e);
            const auto middle = (mesh.points.row(ends[0]) + mesh.points.row(ends[1])) / 2;
            EXPECT_LE((c.row(0) - middle).norm(), 1e-13);
        }
}

TEST(CellCentersBroken, means_of_vertices_are_no_circumcenters) {
    const auto& mesh = merged("hex4");
    double most = 0;
    for (Index F = 0; F < mesh.P().size(2); ++F) {
        Vector mean = Vector::Zero(2);
        const auto vertices = mesh.merging().vertices(2, F);
        for (const Index v : vertices)
            mean += mesh.points.row(v).transpose() / static_cast<double>(vertices.size());
        most = std::max(most, unevenness(mesh, 2, F, mean));
    }
    EXPECT_GT(most, 0.1);
}

} // namespace polydec::test::in_cell_centers
