// SPDX-License-Identifier: MIT
#include "meshes/point_tree.h"
#include "tests/meshes/propositions.h"
#include "tests/meshes/tetgen_support.h"

namespace polydec::test::in_weld {

std::vector<Mesh> all_meshes() {
    return {kuhn(1, 9), grid(5, 4), torus(7, 5), icosphere(2), moebius(9, 2),
            bcc(2),     kuhn(3, 2), kuhn(4, 1),  kuhn(5, 1)};
}

/// The same cells, each with vertices of its own, and a vertex of no cell at the end.
Mesh exploded(const Mesh& mesh) {
    Mesh result{Points(mesh.simplices.size() + 1, mesh.points.cols()), mesh.simplices, {}};
    for (Index i = 0; i < mesh.simplices.size(); ++i) {
        result.points.row(i) = mesh.points.row(mesh.simplices.data()[i]);
        result.simplices.data()[i] = i;
    }
    result.points.bottomRows(1) = mesh.points.topRows(1);
    return result;
}

/// Corners of the cells by place.
Points corners(const Mesh& mesh) {
    return mesh.points(mesh.simplices.reshaped<Eigen::RowMajor>(), Eigen::indexing::all);
}

double edge_length(const Mesh& mesh, Index cell, Index i, Index j) {
    return (mesh.points.row(mesh.simplices(cell, i)) - mesh.points.row(mesh.simplices(cell, j)))
        .norm();
}

/// No edge vanishes that is longer than the length.
void expect_edges_kept(const Joined& welded, const Mesh& mesh, double length) {
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        for (Index i = 0; i < mesh.simplices.cols(); ++i)
            for (Index j = 0; j < i; ++j)
                if (welded.mesh.simplices(cell, i) == welded.mesh.simplices(cell, j)) {
                    EXPECT_LE(edge_length(mesh, cell, i, j), length);
                }
}

/// The surface of a box, closed.
Mesh plate(double thickness) {
    Mesh mesh = cube();
    mesh.points.col(2) *= thickness;
    return mesh;
}

TEST(Weld, of_an_exploded_mesh_gives_back_the_mesh) {
    for (const Mesh& mesh : all_meshes()) {
        const Mesh pieces = exploded(shuffled(mesh, 5).mesh);
        const Joined welded = weld(pieces);
        const Index isolated = static_cast<Index>(welded.mesh.points.rows()) - 1;
        EXPECT_EQ(isolated, mesh.points.rows());
        EXPECT_EQ(welded.joined, mesh.simplices.size() - mesh.points.rows());
        EXPECT_EQ(welded.apart, 0);
        EXPECT_EQ(welded.vertices.back(), isolated);
        Mesh used = welded.mesh;
        used.points.conservativeResize(isolated, Eigen::NoChange);
        EXPECT_TRUE(same_geometry(used, mesh));
        EXPECT_EQ(corners(used), corners(pieces));
        for (Index v = 0; v < pieces.points.rows(); ++v)
            EXPECT_EQ(welded.mesh.points.row(welded.vertices[v]), pieces.points.row(v));

        const Mesh again = weld(welded.mesh).mesh;
        EXPECT_EQ(again.points, welded.mesh.points);
        EXPECT_EQ(again.simplices, welded.mesh.simplices);
        EXPECT_EACH_SAYS(again.warnings, {"joined", std::to_string(welded.joined)});
    }
}

TEST(Weld, numbers_ascend_by_first_vertices_and_cells_keep_their_tags) {
    Mesh mesh = exploded(grid(1, 1));
    mesh.tags = {7, 8};
    mesh.facet_tags = {Simplices{{4, 3}, {0, 2}}, {1, 2}};
    const Joined welded = weld(mesh);
    EXPECT_EQ(welded.vertices.front(), 0);
    for (std::size_t v = 1; v < welded.vertices.size(); ++v)
        EXPECT_LE(welded.vertices[v],
                  1 + *std::max_element(welded.vertices.begin(),
                                        welded.vertices.begin() + static_cast<std::ptrdiff_t>(v)));
    EXPECT_EQ(welded.mesh.tags, mesh.tags);
    EXPECT_EQ(welded.mesh.facet_tags.tags, mesh.facet_tags.tags);
    for (Index i = 0; i < 4; ++i)
        EXPECT_EQ(welded.mesh.facet_tags.simplices.data()[i],
                  welded.vertices[mesh.facet_tags.simplices.data()[i]]);
}

TEST(Weld, joins_what_is_jittered_by_less_than_the_length) {
    for (const Mesh& mesh : all_meshes())
        for (const double jitter : {1e-16, 1e-12, 2e-10}) {
            const double size = weld_length(mesh.points) / 1e-9;
            const double most = jitter / std::sqrt(mesh.ambient_dimension());
            const Mesh pieces = perturbed(exploded(mesh), size * most, 3);
            const Joined welded = weld(pieces);
            EXPECT_EQ(welded.mesh.points.rows(), mesh.points.rows() + 1);
            Mesh used = welded.mesh;
            used.points.conservativeResize(mesh.points.rows(), Eigen::NoChange);
            EXPECT_EQ(face_counts(used), face_counts(mesh));
            EXPECT_WITHIN(corners(used), corners(mesh), 1.01 * size * most + 1e-15);
            EXPECT_EQ(weld(pieces, 0.0).apart, 0);
        }
}

TEST(Weld, keeps_coordinates_that_most_vertices_have) {
    const Mesh mesh = grid(3, 3);
    Mesh pieces = exploded(mesh);
    std::vector<Index> met(static_cast<std::size_t>(mesh.points.rows()), 0);
    for (Index i = 0; i < mesh.simplices.size(); ++i)
        if (++met[mesh.simplices.data()[i]] == 3) // one of three or more
            pieces.points(i, 0) += (i % 2 == 0 ? 1 : -1) * 1e-13;
    EXPECT_EQ(corners(weld(pieces).mesh), corners(mesh));
}

TEST(Weld, depends_neither_on_the_order_nor_on_units) {
    for (const Mesh& mesh : all_meshes()) {
        const Mesh pieces = perturbed(exploded(mesh), 1e-11, 3);
        const Mesh once = weld(pieces).mesh;
        const Renumbered other = shuffled(pieces, 11);
        const Mesh twice = weld(other.mesh).mesh;
        for (Index cell = 0; cell < once.simplices.rows(); ++cell)
            for (Index i = 0; i < once.simplices.cols(); ++i)
                EXPECT_EQ(twice.points.row(twice.simplices(cell, i)),
                          once.points.row(once.simplices(other.cells[cell], i)));
        for (const int exponent : {-900, -30, 30, 900}) {
            Mesh scaled = pieces;
            scaled.points *= std::ldexp(1.0, exponent);
            const Mesh welded = weld(scaled).mesh;
            EXPECT_EQ(welded.simplices, once.simplices);
            EXPECT_EQ(welded.points, once.points * std::ldexp(1.0, exponent));
        }
    }
}

TEST(Weld, removes_no_edge_that_is_longer_than_the_length) {
    // a path in steps of 0.6, and edges over two of them, whose ends are joined by the steps
    Mesh chain{Points(40, 1), Simplices(38, 2), {}};
    for (Index v = 0; v < 40; ++v)
        chain.points(v, 0) = 0.006 * v;
    for (Index e = 0; e < 38; ++e)
        chain.simplices.row(e) << e, e + 2;
    EXPECT_EQ(weld(chain, 0.01).mesh.simplices, chain.simplices);
    EXPECT_EQ(weld(chain, 0.01).joined, 0);

    for (const Mesh& mesh : all_meshes())
        for (const double length : {0.01, 0.1, 0.31, 1.01}) {
            const Mesh pieces = perturbed(exploded(mesh), 0.02, 9);
            expect_edges_kept(weld(pieces, length), pieces, length);
            expect_edges_kept(weld(mesh, length), mesh, length);
        }
}

TEST(Weld, shorter_edges_vanish_and_tidy_tells) {
    const Mesh sliver{
        Points{{0, 0}, {1, 0}, {1, 1e-12}, {0, 1}}, Simplices{{0, 1, 2}, {0, 2, 3}}, {}};
    const Joined welded = weld(sliver);
    EXPECT_EQ(welded.mesh.simplices, (Simplices{{0, 1, 1}, {0, 1, 2}}));
    EXPECT_EACH_SAYS(tidy(welded.mesh).warnings, {"joined 1 vertex"}, {"1 cell", "0 (0 1 1)"});
}

TEST(Weld, a_thin_plate_keeps_both_sides) {
    for (const double thickness : {1e-10, 1e-11, 3e-13})
        for (const double jitter : {0.0, 1e-16}) {
            const Mesh welded = weld(perturbed(exploded(plate(thickness)), jitter, 2)).mesh;
            EXPECT_EQ(welded.points.rows(), 9) << thickness << " " << jitter;
            EXPECT_EQ(tally_facets(welded).coherent, 18);
        }
    // but facets that are there twice become one
    Mesh twice = plate(1);
    twice.simplices.conservativeResize(13, Eigen::NoChange);
    twice.simplices.row(12) = twice.simplices.row(0);
    const Mesh welded = weld(perturbed(exploded(twice), 1e-13, 2)).mesh;
    EXPECT_EQ(welded.simplices.row(12), welded.simplices.row(0));
}

TEST(Weld, turns_no_cell_over) {
    // the apex of the first triangle, at 2, is within 1 of others that go on below its base
    constexpr double length = 0.01;
    Mesh mesh{Points(2, 2), Simplices(9, 3), {}};
    mesh.points << 0, 0, 1, 0;
    mesh.points.conservativeResize(2 + 9 * 3, Eigen::NoChange);
    for (Index t = 0; t < 9; ++t) {
        mesh.points.row(2 + 3 * t) << 0.5, length * (t == 0 ? 2 : 1.5 - 0.4 * t);
        mesh.points.row(3 + 3 * t) << 0.2, -0.5 - 0.1 * t;
        mesh.points.row(4 + 3 * t) << 0.9, -0.5 - 0.1 * t;
        mesh.simplices.row(t) << 2 + 3 * t, 3 + 3 * t, 4 + 3 * t;
    }
    mesh.simplices.row(0) << 0, 1, 2;
    const Joined welded = weld(mesh, length);
    EXPECT_EQ(welded.joined, 7) << "half the length joins the others";
    EXPECT_GT(least_determinant(welded.mesh), 0);
}

TEST(Weld, refuses_what_makes_no_sense) {
    for (const double wrong :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_REFUSED(weld(grid(1, 1), wrong), "length", "joined", "finite");
    Mesh mesh = grid(1, 1);
    mesh.simplices(1, 2) = 4;
    EXPECT_REFUSED(weld(mesh), "cell 1", "4");
    mesh = grid(1, 1);
    mesh.points(3, 1) = std::numeric_limits<double>::infinity();
    EXPECT_REFUSED(weld(mesh), "vertex 3", "finite");
    EXPECT_EQ(weld({Points(3, 2), Simplices(0, 3), {}}).mesh.simplices.rows(), 0);
}

TEST(JoinNear, is_the_closure_of_all_pairs_that_are_near) {
    constexpr Index clusters = 150, of_cluster = 3;
    for (const Index N : {1, 2, 3, 5, 70})
        for (const double length : {1e-9, 1e-4, 0.03}) {
            Random random(static_cast<std::uint64_t>(N));
            Points points(clusters * of_cluster, N);
            for (Index i = 0; i < points.rows(); ++i)
                points.row(i) =
                    i % of_cluster == 0
                        ? Eigen::RowVectorXd(random.point(N).transpose())
                        : Eigen::RowVectorXd(points.row(i - 1) +
                                             1.2 * random.fraction() * length *
                                                 random.point(N).normalized().transpose());
            points.col(N - 1).head(clusters).setZero(); // on a wall of the box
            points.rowwise() -= points.colwise().minCoeff().eval();
            DisjointSets found(static_cast<Index>(points.rows())), expected = found;
            join_near(points, length, found);
            for (Index i = 0; i < points.rows(); ++i)
                for (Index j = 0; j < i; ++j)
                    if ((points.row(i) - points.row(j)).squaredNorm() <= length * length)
                        expected.join(i, j);
            EXPECT_EQ(found.firsts(), expected.firsts()) << N << " coordinates, " << length;
        }
}

TEST(JoinNear, equal_points_are_near_without_any_length) {
    for (const Index rows : {0, 1, 5}) {
        DisjointSets sets(rows);
        join_near(Points::Zero(rows, 3), 0, sets);
        EXPECT_EQ(sets.firsts(), std::vector<Index>(static_cast<std::size_t>(rows), 0));
    }
}

} // namespace polydec::test::in_weld
