// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"
#include "tests/meshes/tetgen_support.h"

namespace polydec::test::in_tetrahedralize {

struct Case {
    const char* name;
    Mesh (*surface)();
    Index euler;    ///< of what it encloses
    double stretch; ///< makes it bad by itself, but not sharp
};

const Case cases[] = {
    {"cube", [] { return cube(); }, 1, 7.0},
    {"icosphere", [] { return icosphere(5); }, 1, 1.0},
    {"torus", [] { return torus(24, 12); }, 0, 1.0},
};

/// Largest circumradius over shortest edge.
double worst_quality(const Mesh& mesh) {
    double worst = 0.0;
    for (Eigen::Index i = 0; i < mesh.simplices.rows(); ++i) {
        Eigen::Matrix<double, 4, 3> corners;
        for (int j = 0; j < 4; ++j)
            corners.row(j) = mesh.points.row(mesh.simplices(i, j));
        const Eigen::Matrix3d edges = corners.bottomRows<3>().rowwise() - corners.row(0);
        const Eigen::Vector3d squares = 0.5 * edges.rowwise().squaredNorm();
        const Eigen::Vector3d center = edges.inverse() * squares;
        double shortest = edges.rowwise().norm().minCoeff();
        for (int j = 1; j < 4; ++j)
            shortest = std::min(shortest, (corners.row(j) - corners.row(j % 3 + 1)).norm());
        worst = std::max(worst, center.norm() / shortest);
    }
    return worst;
}

class Tetrahedralize : public TetgenTest, public testing::WithParamInterface<Case> {
protected:
    template <typename F>
    void with_tetgen(F proposition) {
        TetgenTest::with_tetgen([&] { proposition(GetParam().surface()); });
    }
};

TEST_P(Tetrahedralize, the_volume_is_the_enclosed_one) {
    with_tetgen([](const Mesh& surface) {
        const double enclosed = enclosed_volume(surface);
        EXPECT_NEAR(total_volume(tetrahedralize(surface)), enclosed, 1e-12 * enclosed);
        EXPECT_NEAR(total_volume(tetrahedralize(surface, {.quality = 1.5})), enclosed,
                    1e-12 * enclosed);

        auto smaller = surface; // not the volume of another surface
        smaller.points *= 0.999;
        EXPECT_GT(std::abs(total_volume(tetrahedralize(smaller)) - enclosed), 1e-3 * enclosed);
    });
}

TEST_P(Tetrahedralize, cells_are_positive_and_meet_in_whole_facets) {
    with_tetgen([](const Mesh& surface) {
        auto mesh = tetrahedralize(surface, {.quality = 1.5});
        EXPECT_GT(least_determinant(mesh), 0.0);
        EXPECT_EQ(euler_characteristic(mesh), GetParam().euler);
        const auto tally = tally_facets(mesh);
        EXPECT_EQ(tally.clashing + tally.branching, 0);
        EXPECT_GT(tally.coherent, 0);

        std::swap(mesh.simplices(0, 0), mesh.simplices(0, 1)); // one turned over is seen
        EXPECT_LT(least_determinant(mesh), 0.0);
        EXPECT_GT(tally_facets(mesh).clashing, 0);
    });
}

TEST_P(Tetrahedralize, the_orientation_of_the_surface_does_not_matter) {
    with_tetgen([](Mesh surface) {
        const auto mesh = tetrahedralize(surface);
        surface.simplices.col(0).swap(surface.simplices.col(1));
        EXPECT_GT(least_determinant(tetrahedralize(surface)), 0.0);
        EXPECT_NEAR(total_volume(tetrahedralize(surface)), total_volume(mesh), 1e-12);
    });
}

TEST_P(Tetrahedralize, a_boundary_that_may_not_be_split_is_the_surface) {
    with_tetgen([](const Mesh& surface) {
        const double volume = enclosed_volume(surface) / 2000;
        const auto kept = tetrahedralize(
            surface, {.largest_volume = volume, .boundary = BoundarySplitting::forbidden});
        EXPECT_EQ(sorted_rows(boundary_of(kept).simplices), sorted_rows(surface.simplices));
        EXPECT_EQ(kept.points.topRows(surface.points.rows()), surface.points);

        const auto split = tetrahedralize(surface, {.largest_volume = volume});
        EXPECT_NE(sorted_rows(boundary_of(split).simplices), sorted_rows(surface.simplices));
        EXPECT_EQ(split.points.topRows(surface.points.rows()), surface.points);
    });
}

TEST_P(Tetrahedralize, quality_is_bounded_if_asked_for) {
    with_tetgen([](const Mesh& surface) {
        Mesh tall = surface;
        tall.points.col(2) *= GetParam().stretch;
        const auto mesh = tetrahedralize(tall, {.quality = 1.5});
        EXPECT_LE(worst_quality(mesh), 1.5 * (1 + 1e-9));
        EXPECT_TRUE(mesh.warnings.empty());
        EXPECT_GT(worst_quality(tetrahedralize(tall)), 1.5);
    });
}

TEST_P(Tetrahedralize, quality_that_is_missed_is_told_with_the_worst) {
    with_tetgen([](const Mesh& surface) {
        Mesh tall = surface;
        tall.points.col(2) *= 7.0;
        const auto mesh =
            tetrahedralize(tall, {.quality = 1.2, .boundary = BoundarySplitting::forbidden});
        ASSERT_EQ(mesh.warnings.size(), 1U);
        const auto worst = std::to_string(worst_quality(mesh)).substr(0, 4);
        EXPECT_SAYS(mesh.warnings[0], "quality", "1.2", "worst");
        EXPECT_NE(mesh.warnings[0].find(worst), std::string::npos) << mesh.warnings[0];
    });
}

TEST_P(Tetrahedralize, a_surface_that_crosses_another_is_named_by_triangles) {
    with_tetgen([](const Mesh& surface) {
        Mesh moved = surface;
        moved.points.rowwise() += Eigen::RowVector3d(0.31, 0.23, 0.17);
        EXPECT_SAYS(refusal_of(united(surface, moved)), "facets", "overlap");
    });
}

TEST_P(Tetrahedralize, vertices_of_no_triangle_are_left_out_with_a_warning) {
    with_tetgen([](const Mesh& surface) {
        Mesh single;
        single.points = Points::Constant(1, 3, 0.123);
        single.simplices.resize(0, 3);
        const auto more = united(single, united(surface, single));
        const auto mesh = tetrahedralize(more), plain = tetrahedralize(surface);
        EXPECT_EQ(mesh.points, plain.points);
        EXPECT_EACH_SAYS(mesh.warnings, {"2 vertices", "without a triangle"});
        EXPECT_TRUE(plain.warnings.empty());
    });
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Tetrahedralize, testing::ValuesIn(cases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(TetrahedralizeErrors, what_is_no_closed_surface_is_refused) {
    EXPECT_REFUSED(tetrahedralize(kuhn(3, 1)), "surface of triangles", "6 cells", "dimension 3",
                   "3");
    EXPECT_REFUSED(tetrahedralize(grid(2, 2)), "surface of triangles", "8 cells", "dimension 2",
                   "2");
    Mesh open = cube();
    open.simplices.conservativeResize(11, 3);
    EXPECT_REFUSED(tetrahedralize(open), "mesher", "closed", "3", "edge 1 5", "facet 4", "edge 1 7",
                   "facet 10", "edge 5 7", "facet 2");
}

} // namespace polydec::test::in_tetrahedralize
