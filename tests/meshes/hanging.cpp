// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_hanging {

/// The cube [0, 1]^n in `count` parts along each axis, moved.
Mesh cube(int n, int count, const Eigen::RowVectorXd& by) {
    Mesh mesh = kuhn(std::vector<int>(static_cast<std::size_t>(n), count));
    mesh.points.rowwise() += by;
    return mesh;
}

Mesh side_by_side(int n, int coarse, int fine) {
    return united(cube(n, coarse, Eigen::RowVectorXd::Zero(n)),
                  cube(n, fine, Eigen::RowVectorXd::Unit(n, 0)));
}

/// Mirrored along axis 1 of [0, 1]^n, with the same orientation.
Mesh turned(Mesh mesh) {
    mesh.points.col(1) = (1 - mesh.points.col(1).array()).matrix();
    mesh.simplices.col(0).swap(mesh.simplices.col(1));
    return mesh;
}

/// In the plane x_n+1 = x_1 / 2 of a space of one dimension more.
Mesh lifted(const Mesh& mesh) {
    Mesh result = mesh;
    result.points.conservativeResize(Eigen::NoChange, mesh.points.cols() + 1);
    result.points.rightCols(1) = mesh.points.leftCols(1) / 2;
    return result;
}

void expect_nothing_unjoined(const Mesh& mesh) {
    const auto [coincident, hanging, misfits] = unjoined_boundary(mesh);
    EXPECT_TRUE(coincident.empty());
    EXPECT_TRUE(hanging.empty());
    EXPECT_EQ(misfits, 0);
}

/// Fits, fills the same region, and turns no cell over.
void expect_joined(const Mesh& mesh, const Mesh& given) {
    expect_nothing_unjoined(mesh);
    EXPECT_NEAR(total_volume(mesh), total_volume(given), 1e-9 * total_volume(given));
    const FacetTally tally = tally_facets(mesh);
    EXPECT_EQ(tally.clashing, 0);
    EXPECT_EQ(tally.branching, 0);
    if (mesh.dimension() == mesh.ambient_dimension()) {
        EXPECT_GT(least_determinant(mesh), 0);
    }
}

/// A point in [0, 1]^n, with this value along axis 0.
bool lies_inside(const Eigen::RowVectorXd& point, double x) {
    return point[0] == x;
}

TEST(UnjoinedBoundary, nothing_is_found_in_meshes_that_fit) {
    for (const Mesh& mesh : {kuhn(1, 9), grid(5, 4), torus(7, 5), moebius(9, 2), bcc(2), kuhn(3, 2),
                             kuhn(4, 1), kuhn(5, 1)})
        for (const double scale : {1e-150, 1.0, 1e150}) {
            Mesh scaled = mesh;
            scaled.points *= scale;
            expect_nothing_unjoined(scaled);
        }
}

TEST(UnjoinedBoundary, counts_vertices_that_welding_joins) {
    for (const int n : {1, 2, 3, 4}) {
        const Mesh mesh = side_by_side(n, 2, 2);
        const auto found = unjoined_boundary(mesh);
        EXPECT_EQ(std::ssize(found.coincident), weld(mesh).joined);
        EXPECT_EQ(std::ssize(found.coincident), std::lround(std::pow(3, n - 1)));
        EXPECT_TRUE(found.hanging.empty());
        EXPECT_EQ(found.misfits, 0);
        expect_nothing_unjoined(weld(mesh).mesh);
    }
}

TEST(UnjoinedBoundary, counts_hanging_nodes_of_every_dimension) {
    for (const int n : {2, 3, 4}) {
        const Mesh mesh = side_by_side(n, 1, 2);
        const auto places = std::lround(std::pow(3, n - 1)), at_corners = 1L << (n - 1);
        const auto found = unjoined_boundary(mesh);
        EXPECT_EQ(std::ssize(found.coincident), at_corners);
        EXPECT_EQ(std::ssize(found.hanging), places - at_corners);
        for (const Index v : found.hanging)
            EXPECT_TRUE(lies_inside(mesh.points.row(v), 1));
        EXPECT_GT(found.misfits, 0);

        const Renumbered other = shuffled(mesh, 3);
        const auto again = unjoined_boundary(other.mesh);
        std::vector<Index> numbers;
        for (const Index v : again.hanging)
            numbers.push_back(other.vertices[v]);
        std::sort(numbers.begin(), numbers.end());
        EXPECT_EQ(numbers, found.hanging);
        EXPECT_EQ(again.misfits, found.misfits);
    }
}

TEST(UnjoinedBoundary, counts_facets_that_do_not_fit_though_their_vertices_do) {
    Mesh other = turned(cube(3, 1, Eigen::RowVector3d(0, 0, 0)));
    other.points.col(0).array() += 1;
    const Mesh mesh = weld(united(cube(3, 1, Eigen::RowVector3d(0, 0, 0)), other)).mesh;
    const auto found = unjoined_boundary(mesh);
    EXPECT_TRUE(found.coincident.empty() && found.hanging.empty());
    EXPECT_EQ(found.misfits, 4);
    const Mesh joined = join_hanging(mesh).mesh;
    expect_joined(joined, mesh);
    EXPECT_EQ(joined.points.rows(), mesh.points.rows() + 1) << "where the diagonals cross";
}

TEST(JoinHanging, grids_of_other_fineness_fit_then) {
    for (const auto& [coarse, fine] : {std::pair(1, 2), {4, 8}, {1, 7}, {2, 3}, {3, 5}}) {
        for (const bool in_space : {false, true}) {
            const Mesh plane = side_by_side(2, coarse, fine);
            const Mesh mesh = shuffled(in_space ? lifted(plane) : plane, 5).mesh;
            const Joined joined = join_hanging(mesh);
            expect_joined(joined.mesh, mesh);
            EXPECT_EQ(euler_characteristic(joined.mesh), 1);
            EXPECT_EQ(tally_facets(joined.mesh).boundary, 3 * coarse + 3 * fine);
            for (Index v = 0; v < mesh.points.rows(); ++v)
                EXPECT_EQ(joined.mesh.points.row(joined.vertices[v]), mesh.points.row(v));
        }
    }
}

TEST(JoinHanging, tetrahedra_fit_the_smaller_ones_beside_them) {
    for (const auto& [coarse, fine] : {std::pair(1, 2), {2, 4}, {1, 3}, {3, 1}}) {
        const Mesh mesh = shuffled(side_by_side(3, coarse, fine), 5).mesh;
        const Mesh joined = join_hanging(mesh).mesh;
        expect_joined(joined, mesh);
        EXPECT_EQ(euler_characteristic(joined), 1);
        const int most = std::max(coarse, fine);
        EXPECT_EQ(tally_facets(joined).boundary % 2, 0);
        EXPECT_GT(tally_facets(joined).boundary, 10 * coarse * coarse + 10 * fine * fine - 1);
        EXPECT_GE(joined.simplices.rows(), mesh.simplices.rows() + most);
    }
}

TEST(JoinHanging, cells_with_smaller_ones_on_several_sides_get_a_vertex_inside) {
    Mesh mesh = cube(3, 1, Eigen::RowVector3d(0, 0, 0));
    for (Index axis = 0; axis < 3; ++axis)
        for (const double by : {-1.0, 1.0}) {
            mesh = united(mesh, cube(3, 2, by * Eigen::RowVectorXd::Unit(3, axis)));
            const Joined joined = join_hanging(mesh);
            expect_joined(joined.mesh, mesh);
            EXPECT_EQ(euler_characteristic(joined.mesh), 1);
        }
    const Joined joined = join_hanging(mesh);
    EXPECT_SAYS(joined.mesh.warnings.back(), "split 6 cells", "new vertex inside 6");
    EXPECT_GT(joined.mesh.points.rows(),
              1 + *std::max_element(joined.vertices.begin(), joined.vertices.end()));
}

TEST(JoinHanging, sides_that_were_made_independently_fit_where_they_touch) {
    const Mesh coarse = cube(3, 2, Eigen::RowVector3d(0, 0, 0));
    const auto joins = [](const Mesh& mesh) {
        for (const double unit : {1e-120, 1.0, 1e120}) {
            Mesh given = shuffled(mesh, 4).mesh;
            given.points *= unit;
            Mesh joined = join_hanging(given).mesh;
            joined.points /= unit;
            expect_joined(joined, mesh);
            EXPECT_EQ(euler_characteristic(joined), 1);
        }
    };
    for (const int count : {1, 2, 3, 5}) {
        Mesh other = turned(cube(3, count, Eigen::RowVector3d(0, 0, 0)));
        for (Index v = 0; v < other.points.rows(); ++v)
            other.points(v, 1) +=
                other.points(v, 1) * (1 - other.points(v, 1)) * (0.3 - 0.5 * other.points(v, 2));
        for (const auto& by : {Eigen::RowVector3d(1, 0, 0), {1, 0.3, 0.2}, {1, 0.5, 0}}) {
            Mesh moved = other;
            moved.points.rowwise() += by;
            joins(united(coarse, moved));
            joins(lifted(united(coarse, moved)));
        }
        // in the interior of a facet, of which a ring remains
        Mesh small = other;
        small.points = 0.1 * small.points;
        small.points.rowwise() += Eigen::RowVector3d(1, 0.1, 0.3);
        joins(united(coarse, small));
        Mesh another = small;
        another.points.rowwise() += Eigen::RowVector3d(0, 0.1, 0.08);
        joins(united(united(coarse, small), another));
    }
}

TEST(JoinHanging, tags_of_cells_and_facets_cover_what_they_did) {
    for (const int n : {2, 3}) {
        Mesh mesh = weld(side_by_side(n, 1, 2)).mesh;
        for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
            mesh.tags.push_back(1 + cell % 3);
        // the facet of the coarse side between both halves, and one beside it
        std::vector<Index> corners;
        Simplices facets(0, n);
        for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
            for (Index omitted = 0; omitted <= n; ++omitted) {
                std::vector<Index> facet;
                for (Index i = 0; i <= n; ++i)
                    if (i != omitted)
                        facet.push_back(mesh.simplices(cell, i));
                if (cell < (n == 2 ? 2 : 6)) {
                    facets.conservativeResize(facets.rows() + 1, Eigen::NoChange);
                    facets.bottomRows(1) = Eigen::Map<const Simplices>(facet.data(), 1, n);
                }
            }
        mesh.facet_tags = {facets, std::vector<Index>(static_cast<std::size_t>(facets.rows()), 5)};
        const Mesh joined = join_hanging(mesh).mesh;
        expect_joined(joined, mesh);
        const auto volume_of = [](const Mesh& all, Index tag) {
            const Vector volumes = cell_volumes(all);
            double sum = 0;
            for (Index cell = 0; cell < volumes.size(); ++cell)
                sum += all.tags[cell] == tag ? volumes[cell] : 0;
            return sum;
        };
        for (const Index tag : {1, 2, 3})
            EXPECT_NEAR(volume_of(joined, tag), volume_of(mesh, tag), 1e-12);
        const auto area = [](const Mesh& all) {
            return total_volume({all.points, all.facet_tags.simplices, {}});
        };
        EXPECT_NEAR(area(joined), area(mesh), 1e-12);
        EXPECT_GT(joined.facet_tags.simplices.rows(), facets.rows());
    }
}

TEST(JoinHanging, nodes_a_little_off_the_edge_are_joined_up_to_the_length) {
    Mesh mesh = side_by_side(2, 1, 4);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (mesh.points(v, 0) == 1)
            mesh.points(v, 0) += (v % 2 == 0 ? 1e-4 : -1e-4);
    EXPECT_TRUE(unjoined_boundary(mesh).hanging.empty());
    const Mesh joined = join_hanging(mesh, 1e-3).mesh;
    EXPECT_EQ(euler_characteristic(joined), 1);
    EXPECT_GT(least_determinant(joined), 0);
    EXPECT_EQ(join_hanging(mesh).mesh.simplices.rows(), mesh.simplices.rows());
}

TEST(JoinHanging, refuses_what_it_cannot_split) {
    EXPECT_REFUSED(join_hanging(side_by_side(4, 1, 2)), "hang", "dimension 4");
    EXPECT_EQ(join_hanging(side_by_side(4, 1, 1)).mesh.simplices.rows(), 48);
    const Mesh thin{Points{{0, 0}, {2, 0}, {1, 0.9}, {1, -0.5}, {0, -1}, {2, -1}},
                    Simplices{{0, 1, 2}, {0, 4, 3}, {3, 5, 1}, {3, 4, 5}},
                    {}};
    EXPECT_REFUSED(join_hanging(thin, 0.8), "cell 0", "0 1 2", "thin");
}

} // namespace polydec::test::in_hanging
