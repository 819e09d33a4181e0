// SPDX-License-Identifier: MIT
#include "complex/surfaces/ordered_surface.h"
#include "dec/metric/side_lengths.h"
#include "tests/support/test.h"

namespace polydec::test::in_intrinsic {

constexpr double rounding = 1e-12;

Discretization flipped(const Mesh& mesh, Delaunay delaunay) {
    return discretize(mesh, {.delaunay = delaunay});
}

/// A primal form of the input on the polygons, and back.
Vector carry(const Discretization& mesh, int k, const Vector& values) {
    return to_merged(mesh, {Side::primal, k, values}).values;
}
Vector carry_back(const Discretization& mesh, int k, const Vector& values) {
    return to_input(mesh, {Side::primal, k, values}).values;
}

/// Entries of star_1, by the number of polygons at the edge.
std::vector<double> stars_of_edges(const Discretization& mesh, Index cofaces) {
    const Vector all = star(mesh.volumes(), 1).diagonal();
    std::vector<double> result;
    for (Index e = 0; e < all.size(); ++e)
        if (mesh.complex().coface_counts(1)[e] == cofaces)
            result.push_back(all[e]);
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<double> sorted(const Vector& values) {
    std::vector<double> result(values.begin(), values.end());
    std::sort(result.begin(), result.end());
    return result;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_NEAR(a[i], b[i], tolerance * (1 + std::abs(b[i]))) << "entry " << i;
}

/// Two shakings of every surface, of which the second makes most meshes far from Delaunay.
class Flipped : public testing::TestWithParam<std::tuple<std::string, double>> {
protected:
    Mesh mesh() const {
        const auto& [name, amplitude] = GetParam();
        return amplitude == 0 ? mesh_named(name) : shaken(mesh_named(name), amplitude, 7);
    }
};

TEST_P(Flipped, have_positive_stars_inside_and_vertices_off_negative_boundary) {
    const auto mesh = flipped(this->mesh(), Delaunay::flips);
    EXPECT_EQ(mesh.passage().flips().statistics.negative_interior, 0);
    const Vector star_1 = star(mesh.volumes(), 1).diagonal();
    std::vector<bool> beside(static_cast<std::size_t>(mesh.complex().size(0)), false);
    for (Index e = 0; e < star_1.size(); ++e) {
        if (mesh.complex().coface_counts(1)[e] == 2) {
            EXPECT_GT(star_1[e], mesh.options().tolerance) << "edge " << e;
        } else if (star_1[e] < mesh.options().tolerance)
            for (const Index v : {0, 1})
                beside[mesh.complex().coboundary(0).innerIndexPtr()[2 * e + v]] = true;
    }
    const Vector star_0 = star(mesh.volumes(), 0).diagonal();
    for (Index v = 0; v < star_0.size(); ++v)
        EXPECT_TRUE(star_0[v] > 0 || beside[v]) << "vertex " << v;
}

TEST_P(Flipped, keep_topology_area_and_points) {
    const auto mesh = flipped(this->mesh(), Delaunay::flips);
    EXPECT_EQ(betti_numbers(mesh.complex()), betti_numbers(mesh.input()));
    EXPECT_EQ(mesh.complex().size(0), mesh.input().size(0));
    const double area = mesh.input_geometry().volumes().primal(2).sum();
    EXPECT_NEAR(mesh.volumes().primal(2).sum(), area, rounding * area);
    EXPECT_NEAR(mesh.volumes().dual(0).sum(), area, 1e-9 * area);
}

TEST_P(Flipped, make_the_laplacian_an_m_matrix_inside) {
    const auto mesh = flipped(this->mesh(), Delaunay::flips_and_splits);
    const SparseMatrix L = symmetric_laplacian({mesh.complex(), mesh.volumes()}, 0);
    for (Index row = 0; row < L.rows(); ++row)
        for (SparseMatrix::InnerIterator entry(L, row); entry; ++entry)
            if (entry.col() != row) {
                EXPECT_LE(entry.value(), 0) << row << ", " << entry.col();
            }
}

TEST_P(Flipped, have_positive_stars_everywhere_after_splits) {
    const auto mesh = flipped(this->mesh(), Delaunay::flips_and_splits);
    for (int k = 0; k <= 2; ++k)
        EXPECT_GT(star(mesh.volumes(), k).diagonal().minCoeff(), 0) << "degree " << k;
    EXPECT_EQ(betti_numbers(mesh.complex()), betti_numbers(mesh.input()));
    const auto& done = mesh.passage().flips().statistics;
    EXPECT_EQ(mesh.complex().size(0), mesh.input().size(0) + done.splits);
    EXPECT_EQ(done.negative_boundary, 0);
}

TEST_P(Flipped, carry_forms_there_and_back_by_maps_that_commute_with_d) {
    for (const auto delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
        const auto mesh = flipped(this->mesh(), delaunay);
        if (mesh.passage().is_identity())
            continue;
        const auto& lift = mesh.merged().lift();
        for (int k = 0; k < 2; ++k) {
            const SparseMatrix d = mesh.input().coboundary(k).cast<double>();
            const SparseMatrix d_P = mesh.complex().coboundary(k).cast<double>();
            const Vector w = random_vector(mesh.input().size(k), 3);
            EXPECT_LT(relative_difference(carry(mesh, k + 1, d * w), d_P * carry(mesh, k, w)),
                      rounding);
            const Vector x = random_vector(mesh.complex().size(k), 4);
            EXPECT_LT(
                relative_difference(carry_back(mesh, k + 1, d_P * x), d * carry_back(mesh, k, x)),
                rounding);
            const SparseMatrix d_T = mesh.pieces().coboundary(k).cast<double>();
            EXPECT_LT(relative_difference(SparseMatrix(d_T * lift[k]), lift[k + 1] * d_P),
                      rounding);
        }
        for (int k = 0; k <= 2; ++k) {
            const SparseMatrix pieces = mesh.merging().diamond(k).cast<double>();
            EXPECT_LT(relative_difference(product(pieces, lift[k]),
                                          identity(static_cast<Index>(pieces.rows()))),
                      rounding);
            const Vector w = random_vector(mesh.input().size(k), 5);
            EXPECT_LT(relative_difference(mesh.passage().matrix(k) * w, mesh.passage().forth(k, w)),
                      rounding);
            const Vector x = random_vector(mesh.pieces().size(k), 6);
            EXPECT_LT(
                relative_difference(mesh.passage().matrix_back(k) * x, mesh.passage().back(k, x)),
                rounding);
        }
    }
}

TEST_P(Flipped, give_functions_and_their_derivatives_back_unchanged) {
    const auto mesh = flipped(this->mesh(), Delaunay::flips_and_splits);
    const Vector u = random_vector(mesh.input().size(0), 8);
    EXPECT_LT(relative_difference(carry_back(mesh, 0, carry(mesh, 0, u)), u), rounding);
    const Vector du = mesh.input().coboundary(0).cast<double>() * u;
    if (!mesh.passage().is_identity()) { // without flips, values inside merged cells are means
        EXPECT_LT(relative_difference(carry_back(mesh, 1, carry(mesh, 1, du)), du), rounding);
    }
    const Vector areas = random_vector(mesh.input().size(2), 9).cwiseAbs();
    if (mesh.input().orientable()) { // else values of turned neighbors cancel
        EXPECT_NEAR(mesh.passage().forth(2, areas).sum(), areas.sum(), rounding * areas.sum());
    }
}

TEST_P(Flipped, do_not_depend_on_the_order_of_vertices_and_triangles) {
    const Mesh input = mesh();
    const Mesh other = shuffled(input, 11).mesh;
    for (const auto delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
        const auto a = flipped(input, delaunay), b = flipped(other, delaunay);
        for (int k = 0; k <= 2; ++k)
            expect_near(sorted(b.volumes().primal(k)), sorted(a.volumes().primal(k)), 1e-9);
        for (const Index cofaces : {1, 2})
            expect_near(stars_of_edges(b, cofaces), stars_of_edges(a, cofaces), 1e-9);
    }
}

TEST_P(Flipped, do_not_depend_on_scale) {
    const Mesh input = mesh();
    for (const double scale : {1e-8, 1e8}) {
        Mesh other = input;
        other.points *= scale;
        for (const auto delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
            const auto a = flipped(input, delaunay), b = flipped(other, delaunay);
            EXPECT_EQ(b.passage().flips().statistics.splits, a.passage().flips().statistics.splits);
            for (const Index cofaces : {1, 2})
                expect_near(stars_of_edges(b, cofaces), stars_of_edges(a, cofaces), 1e-9);
        }
    }
}

TEST_P(Flipped, have_volumes_of_their_simplices_before_any_flip) {
    const Mesh input = mesh();
    const SimplicialComplex K(input.simplices);
    const Points points = vertex_points(K, input.points);
    const auto expected = circumcentric_volumes(K, points);
    const GluedSurface surface(K);
    std::vector<Index> names(static_cast<std::size_t>(K.size(0)));
    std::iota(names.begin(), names.end(), 0);
    const Pieces pieces = in_order(surface, names).pieces;
    const auto found = circumcentric_volumes(pieces, {pieces, expected.primal(1)});
    // an error of the lengths in the last digit is multiplied by the square of the sum of
    // cotangents
    double shape = 0;
    for (Index t = 0; t < K.size(2); ++t) {
        const auto [a, b, c] = side_lengths(surface, expected.primal(1), t);
        shape = std::max(shape, (a * a + b * b + c * c) / (4 * expected.primal(2)[t]));
    }
    const double bound = 16 * std::numeric_limits<double>::epsilon() * shape * shape;
    for (int k = 0; k <= 2; ++k) {
        EXPECT_CLOSE(found.primal(k), expected.primal(k), bound);
        EXPECT_CLOSE(found.dual(k), expected.dual(k), bound);
    }
}

INSTANTIATE_TEST_SUITE_P(Family, Flipped,
                         testing::Combine(testing::ValuesIn(names_of_surfaces()),
                                          testing::Values(0.0, 0.1, 0.25)),
                         [](const auto& instance) {
                             const int percent = int(100 * std::get<1>(instance.param));
                             return std::get<0>(instance.param) + "_" + std::to_string(percent);
                         });

TEST(IntrinsicDelaunay, without_flips_shaken_meshes_have_negative_stars) {
    const Mesh mesh = shaken(icosphere(5), 0.25, 7);
    EXPECT_LT(star(discretize(mesh).volumes(), 1).diagonal().minCoeff(), 0);
    EXPECT_GT(star(flipped(mesh, Delaunay::flips).volumes(), 1).diagonal().minCoeff(), 0);
}

TEST(IntrinsicDelaunay, without_splits_obtuse_corners_keep_negative_stars_on_the_boundary) {
    const Mesh mesh = mesh_named("obtuse_planar");
    EXPECT_LT(stars_of_edges(flipped(mesh, Delaunay::flips), 1).front(), 0);
    EXPECT_GT(stars_of_edges(flipped(mesh, Delaunay::flips_and_splits), 1).front(), 0);
}

TEST(IntrinsicDelaunay, a_wrong_share_does_not_commute_with_d) {
    const SimplicialComplex K(icosphere(3).simplices);
    GluedSurface surface(K);
    FlipHistory right(surface), wrong(surface);
    right.flip(surface, 5, 0.5, 0.4);
    wrong.flip(surface, 5, 0.5, 0.4);
    surface.flip(5);
    wrong.reverse(GluedSurface::triangle(surface.halfedges(5)[0]));
    const SparseMatrix d = K.coboundary(1).cast<double>();
    const SparseMatrix d_T = cell_complex(surface).coboundary(1).cast<double>();
    const Vector w = random_vector(K.size(1), 1);
    EXPECT_LT(relative_difference(right.carry(2, d * w), d_T * right.carry(1, w)), rounding);
    EXPECT_GT(relative_difference(wrong.carry(2, d * w), d_T * wrong.carry(1, w)), 1e-2);
}

TEST(IntrinsicDelaunay, flips_glued_triangles_too) {
    // a torus of one vertex whose lattice is long and slanted: flips find its shortest basis
    const GluedSurface torus = square_torus();
    const Vector lengths{{1, std::hypot(7.3, 1), std::hypot(8.3, 1)}};
    const auto result = intrinsic_delaunay(torus, lengths);
    expect_near(sorted(result.lengths), {1, std::hypot(0.3, 1), std::hypot(0.7, 1)}, rounding);
    EXPECT_EQ(betti_numbers(cell_complex(result.surface)), (std::vector<Index>{1, 2, 1}));
}

TEST(IntrinsicDelaunay, gives_needles_and_coinciding_points_some_area) {
    Mesh mesh = icosphere(4);
    const auto row = mesh.simplices.row(10).eval();
    mesh.points.row(row[0]) = mesh.points.row(row[1]); // an edge
    mesh.points.row(mesh.simplices(100, 0)) =          // a needle
        (mesh.points.row(mesh.simplices(100, 1)) + mesh.points.row(mesh.simplices(100, 2))) / 2;
    const auto result = flipped(mesh, Delaunay::flips);
    EXPECT_GT(result.passage().flips().statistics.added_length, 0);
    EXPECT_GT(star(result.volumes(), 1).diagonal().minCoeff(), 0);
    ASSERT_EQ(result.warnings().size(), 1u);
    EXPECT_SAYS(result.warnings()[0], "triangle", "area");
    EXPECT_LT(result.passage().flips().statistics.added_area, 1e-4);
    EXPECT_REFUSED(discretize(mesh), "cell", "area");
}

TEST(IntrinsicDelaunay, refuses_by_number_what_are_no_lengths) {
    const GluedSurface torus = square_torus();
    EXPECT_REFUSED(intrinsic_delaunay(torus, Vector{{1, 1, 3}}), "triangle 0", "vertices 0, 0, 0",
                   "lengths", "1", "1", "3");
    EXPECT_REFUSED(intrinsic_delaunay(torus, Vector{{1, -1, 1}}), "edge 1", "vertex 0", "0",
                   "length", "-1");
    EXPECT_REFUSED(intrinsic_delaunay(torus, Vector{{1, NAN, 1}}), "edge 1", "vertex 0", "0",
                   "length", "nan");
    EXPECT_REFUSED(intrinsic_delaunay(torus, Vector{{1, 1}}), "2 lengths", "3 edges");
}

TEST(IntrinsicDelaunay, is_refused_where_it_makes_no_sense) {
    EXPECT_REFUSED(flipped(mesh_named("kuhn3"), Delaunay::flips), "dimension 3", "surface");
    EXPECT_REFUSED(discretize(mesh_named("uv8"),
                              {.criterion = MergeCriterion::angle, .delaunay = Delaunay::flips}),
                   "flips", "angle");
}

TEST(IntrinsicDelaunay, forms_of_another_size_or_degree_are_refused) {
    const auto mesh = flipped(mesh_named("icosphere3"), Delaunay::flips);
    EXPECT_REFUSED(mesh.passage().back(1, Vector::Zero(3)), "3 values", "1-cells", "270");
    EXPECT_REFUSED(mesh.passage().forth(0, Vector::Zero(3)), "3 values", "0-cells", "92");
    EXPECT_REFUSED(mesh.passage().matrix(3), "passage", "degree 3", "0", "2");
    const auto& history = mesh.passage().flips().history;
    EXPECT_REFUSED(history.carry(0, Vector::Zero(3)), "3 values", "0-form", "92 vertices",
                   "270 edges", "180 triangles");
    EXPECT_REFUSED(history.matrix(3), "0 values", "3-form", "92 vertices", "270 edges",
                   "180 triangles");
    EXPECT_REFUSED(discretize(mesh_named("icosphere3")).passage().flips(), "edges", "flipped",
                   "delaunay");
}

} // namespace polydec::test::in_intrinsic
