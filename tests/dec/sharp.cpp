// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"
#include "dec/metric/overlaps.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_sharp {

constexpr double rounding = 1e-12;

class Sharps : public OverMeshes {
protected:
    bool flat_mesh() const { return is_flat(mesh_named(GetParam())); }
};

/// The flat of a constant field: the differential of a linear function.
Cochain constant_circulation(const Discretization& mesh, const Vector& X) {
    return flat(mesh, Flat::ppp, X.transpose().replicate(mesh.points().rows(), 1));
}

Cochain random_differential(const Discretization& mesh) {
    return d(mesh.complex(), {Side::primal, 0, random_vector(mesh.complex().size(0), 4)});
}

/// Largest difference of a row from X.
double difference(const DenseMatrix& rows, const Vector& X) {
    return (rows.rowwise() - X.transpose()).cwiseAbs().maxCoeff();
}

double difference(const DenseMatrix& a, const DenseMatrix& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Means by volume, over merged cells, of the rows of n-simplices.
DenseMatrix mean_over_cells(const Discretization& mesh, const DenseMatrix& rows) {
    const int n = mesh.dimension();
    const SparseMatrix pieces = mesh.merging().diamond(n).cast<double>().cwiseAbs();
    const DenseMatrix sums =
        pieces * (mesh.input_geometry().volumes().primal(n).asDiagonal() * rows);
    return mesh.volumes().primal(n).cwiseInverse().asDiagonal() * sums;
}

/// Whether the cell lies in one n-plane.
bool is_unbent(const Discretization& mesh, Index cell) {
    const int n = mesh.dimension();
    const auto corners = mesh.merging().vertices(n, cell);
    DenseMatrix edges = mesh.points()(corners, Eigen::indexing::all);
    edges.rowwise() -= edges.row(0).eval();
    Eigen::ColPivHouseholderQR<DenseMatrix> factors(edges);
    factors.setThreshold(1e-9);
    return factors.rank() <= n;
}

bool is_unbent(const Discretization& mesh) {
    for (Index cell = 0; cell < mesh.complex().size(mesh.dimension()); ++cell)
        if (!is_unbent(mesh, cell))
            return false;
    return true;
}

/// Whether shaking has not folded the mesh.
bool is_unfolded(const Discretization& mesh) {
    return find_overlaps(mesh.input(), mesh.input_points()).folded.empty();
}

/// What sharps after flips may miss.
double flat_rounding(const Discretization& mesh) {
    return mesh.passage().is_identity() ? rounding : 1e-7;
}

TEST_P(Sharps, return_constant_fields_on_flat_meshes) {
    if (!flat_mesh())
        return;
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const Vector X = random_vector(space(mesh), 3);
        const Cochain form = constant_circulation(mesh, X);
        if (is_unfolded(mesh)) {
            EXPECT_LE(difference(sharp_pd(mesh, form), X), flat_rounding(mesh));
        }
        if (star(mesh.input_geometry().volumes(), 0).zeros().empty()) {
            EXPECT_LE(difference(sharp_pp(mesh, form), X), flat_rounding(mesh));
        }
    });
}

TEST_P(Sharps, at_cells_return_the_tangential_part_of_constant_fields_on_unbent_cells) {
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        const Vector X = random_vector(space(mesh), 5);
        const DenseMatrix result = sharp_pd(mesh, constant_circulation(mesh, X));
        const DenseMatrix covectors = whitney_at_centroids(mesh, constant_circulation(mesh, X));
        const DenseMatrix expected = mean_over_cells(mesh, covectors);
        for (Index cell = 0; cell < result.rows(); ++cell)
            if (is_unbent(mesh, cell)) {
                EXPECT_LE(difference(result.row(cell), Vector(expected.row(cell))), rounding)
                    << "cell " << cell;
            }
    });
}

TEST_P(Sharps, at_simplices_of_the_differential_of_a_function_are_its_gradients) {
    const auto& mesh = discretized(GetParam(), MergeCriterion::none);
    const Cochain df = random_differential(mesh);
    EXPECT_LE(difference(sharp_pd(mesh, df), whitney_at_centroids(mesh.input(), mesh.points(), df)),
              rounding);
}

/// The differential on the simplices; vertices have the same numbers there.
Cochain on_simplices(const Discretization& mesh) {
    return d(mesh.input(), {Side::primal, 0, random_vector(mesh.complex().size(0), 4)});
}

/// Mean by area of the gradients of the above on the pieces of each cell.
DenseMatrix mean_gradients(const Discretization& mesh) {
    return mean_over_cells(mesh,
                           whitney_at_centroids(mesh.input(), mesh.points(), on_simplices(mesh)));
}

/// In curves and surfaces the weights of a cell's edges make the unit matrix, times its volume.
bool has_isotropic_weights(const Discretization& mesh) {
    return mesh.dimension() <= 2 && is_unbent(mesh);
}

TEST_P(Sharps, at_polygons_of_the_differential_of_a_function_are_means_of_its_gradients) {
    const auto& mesh = discretized(GetParam());
    if (has_isotropic_weights(mesh)) {
        EXPECT_LE(difference(sharp_pd(mesh, random_differential(mesh)), mean_gradients(mesh)),
                  rounding);
    }
}

/// Vectors at cells: the sharp is adjoint to the dpp flat.
TEST_P(Sharps, at_polygons_are_adjoint_to_the_dpp_flat) {
    for_flipped_and_not(GetParam(), [&](const Discretization& mesh) {
        const bool is_flipped = !mesh.passage().is_identity();
        if (!(is_flipped ? flat_mesh() && is_unfolded(mesh) : has_isotropic_weights(mesh)) ||
            !star(mesh.volumes(), 1).zeros().empty())
            return;
        const Index cells = mesh.complex().size(mesh.dimension()), N = space(mesh);
        const Cochain a{Side::primal, 1, random_vector(mesh.complex().size(1), 7)};
        const DenseMatrix X = random_matrix(cells, N, 8);
        const Vector products = sharp_pd(mesh, a).cwiseProduct(X).rowwise().sum();
        const Vector by_cell = products.cwiseProduct(mesh.volumes().primal(mesh.dimension()));
        EXPECT_NEAR(inner_product({mesh.complex(), mesh.volumes()}, a, flat(mesh, Flat::dpp, X)),
                    by_cell.sum(), flat_rounding(mesh) * by_cell.cwiseAbs().sum());
    });
}

/// Of a function that is linear in space, whatever the surface, loops and spikes included.
TEST_P(Sharps, at_flipped_triangles_have_the_circulations_that_they_are_made_of) {
    for_flipped(GetParam(), [](const Discretization& mesh) {
        const auto& K = mesh.pieces();
        if (mesh.complex().size(2) < K.size(2))
            return;
        const Cochain du = constant_circulation(mesh, random_vector(space(mesh), 6));
        const DenseMatrix X = sharp_pd(mesh, du);
        for (Index t = 0; t < K.size(2); ++t)
            for (int i = 0; i < 3; ++i) {
                const Index e = K.face(2, t, i);
                const auto ends = K.simplices(1).row(e);
                const auto edge = mesh.points().row(ends[1]) - mesh.points().row(ends[0]);
                EXPECT_NEAR(X.row(t).dot(edge), du.values[e], 1e-7) << "triangle " << t;
            }
    });
}

/// How far sum |*v| X_v is from the integral of the gradients of the above, relative to their size.
double integral_defect(const Discretization& mesh, const DenseMatrix& X) {
    const int n = mesh.dimension();
    const DenseMatrix gradients =
        whitney_at_centroids(mesh.input(), mesh.points(), on_simplices(mesh));
    const Vector& volumes = mesh.input_geometry().volumes().primal(n);
    Vector defect = -(gradients.transpose() * volumes);
    for (Index v = 0; v < mesh.input().size(0); ++v)
        defect += mesh.volumes().dual(0)[v] * X.row(v).transpose();
    return defect.cwiseAbs().maxCoeff() / (gradients.cwiseAbs().transpose() * volumes).maxCoeff();
}

TEST_P(Sharps, at_vertices_have_the_same_integral_as_the_gradients) {
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        const DenseMatrix X = sharp_pp(mesh, random_differential(mesh));
        EXPECT_LE(integral_defect(mesh, X), rounding);
    });
}

TEST_P(Sharps, of_fluxes_return_constant_fields_on_flat_meshes) {
    if (!flat_mesh())
        return;
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        if (!is_unfolded(mesh))
            return;
        const int n = mesh.dimension();
        const Vector X = random_vector(n, 6);
        const Cochain flux = de_rham(mesh, n - 1, flux_form(constant_form(X)), 1);
        // fluxes are meant as the cells are oriented
        const Vector volumes = de_rham(mesh, n, constant_form(Vector::Ones(1)), 1).values;
        EXPECT_LE(difference(volumes.cwiseSign().asDiagonal() * flux_sharp(mesh, flux), X),
                  flat_rounding(mesh));
    });
}

/// How far the integrals of linear densities are from their values at these places, times volume.
double moment_defect(const Discretization& mesh, const Points& places) {
    const int n = mesh.dimension();
    const Vector slope = random_vector(n, 2);
    const auto linear = [&](const Vector& x) { return slope.dot(x); };
    const Vector moments = de_rham(mesh, n, function_form(linear), 1).values.cwiseAbs();
    const Vector values = (places * slope).cwiseAbs();
    return relative_difference(values.cwiseProduct(mesh.volumes().primal(n)), moments);
}

TEST_P(Sharps, belong_to_centroids_where_linear_functions_have_their_means) {
    if (!flat_mesh())
        return;
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        EXPECT_LE(moment_defect(mesh, cell_centroids(mesh, mesh.dimension())), rounding);
    });
}

POLYDEC_OVER_MESHES(Sharps);

TEST(SharpsOfCurves, at_vertices_weight_the_slopes_by_length) {
    const auto mesh = discretize(made_of({{0}, {1}, {1.5}, {4.5}}, {{0, 1}, {1, 2}, {2, 3}}));
    const Cochain df = d(mesh.complex(), {Side::primal, 0, Vector{{0, 3, 4, 16}}});
    const DenseMatrix X = sharp_pp(mesh, df);
    const Vector expected{{3, 4 / 1.5, 13 / 3.5, 4}};
    EXPECT_CLOSE(Vector(X.col(0)), expected, rounding);
}

TEST(SharpsBroken, without_weights_are_not_the_means_of_the_gradients) {
    for (const auto& name : {"hex4", "torus8x6", "rectangles"}) {
        const auto& mesh = discretized(name);
        const Cochain df = random_differential(mesh);
        const auto N = space(mesh);
        DenseMatrix result(mesh.complex().size(2), N);
        const IncidenceMatrix& sides = mesh.complex().coboundary(1);
        for (Index cell = 0; cell < result.rows(); ++cell) {
            DenseMatrix M = DenseMatrix::Zero(N, N);
            Vector sum = Vector::Zero(N);
            for (IncidenceMatrix::InnerIterator e(sides, cell); e; ++e) {
                const auto ends = mesh.merging().vertices(1, static_cast<Index>(e.col()));
                const Vector edge = mesh.points().row(ends[1]) - mesh.points().row(ends[0]);
                M += edge * edge.transpose();
                sum += df.values[e.col()] * edge;
            }
            result.row(cell) = least_squares(M, sum).shortest.transpose();
        }
        if (std::string(name) == "rectangles") {
            EXPECT_LE(difference(result, mean_gradients(mesh)), rounding) << "by symmetry";
            continue;
        }
        EXPECT_GT(difference(result, mean_gradients(mesh)), 1e-2) << name;
    }
}

TEST(SharpsBroken, circumcenters_are_no_centroids) {
    for (const auto& name : {"hex4", "well_centered3", "obtuse_solid"}) {
        const auto& mesh = discretized(name);
        EXPECT_GT(moment_defect(mesh, cell_centers(mesh, mesh.dimension())), 1e-3) << name;
    }
}

TEST(SharpsBroken, at_vertices_by_plain_means_of_the_gradients_have_another_integral) {
    for (const auto& name : {"uv8", "wellcentred4", "obtuse_solid"}) {
        const auto& mesh = discretized(name);
        const auto& tops = mesh.input().simplices(mesh.dimension());
        const DenseMatrix gradients =
            whitney_at_centroids(mesh.input(), mesh.points(), on_simplices(mesh));
        DenseMatrix X = DenseMatrix::Zero(mesh.points().rows(), space(mesh));
        Vector counts = Vector::Zero(mesh.points().rows());
        for (Index t = 0; t < tops.rows(); ++t)
            for (const Index v : tops.row(t)) {
                X.row(v) += gradients.row(t);
                counts[v] += 1;
            }
        X = counts.cwiseMax(1).cwiseInverse().asDiagonal() * X;
        EXPECT_GT(integral_defect(mesh, X), 1e-3) << name;
    }
}

TEST(SharpsBroken, at_vertices_without_the_lift_miss_constant_fields) {
    for (const auto& name : {"grid4", "hex4", "kuhn3"}) {
        const auto& mesh = discretized(name);
        const Vector X = random_vector(space(mesh), 3);
        const auto simplices = discretized(name, MergeCriterion::none);
        const Cochain fine{Side::primal, 1,
                           mesh.merging().diamond(1).cast<double>().transpose() *
                               constant_circulation(mesh, X).values};
        EXPECT_GT(difference(sharp_pp(simplices, fine), X), 0.1) << name;
    }
}

TEST(SharpsBroken, of_fluxes_about_circumcenters_of_facets_are_wrong_in_space) {
    const auto& mesh = discretized("split_cubes", MergeCriterion::none);
    const Vector X = random_vector(3, 6);
    const Cochain flux = de_rham(mesh, 2, flux_form(constant_form(X)), 1);
    const Points facets = cell_centers(mesh, 2);
    const Points cells = cell_centers(mesh, 3);
    DenseMatrix result = DenseMatrix::Zero(cells.rows(), 3);
    for (Index P = 0; P < result.rows(); ++P)
        for (IncidenceMatrix::InnerIterator e(mesh.complex().coboundary(2), P); e; ++e)
            result.row(P) += e.value() * flux.values[e.col()] *
                             (facets.row(e.col()) - cells.row(P)) / mesh.volumes().primal(3)[P];
    EXPECT_GT(difference(result, X), 0.1);
}

TEST(SharpsRefuse, vertices_without_dual_cell) {
    const auto mesh = discretize(fan_without_dual(), {MergeCriterion::none, 0});
    EXPECT_REFUSED(sharp_pp(mesh, constant_circulation(mesh, Vector::Ones(2))), "sharp", "zero",
                   "1 vertices", "vertices 0");
}

/// Obtuse for large x.
Discretization tetrahedron(double x) {
    return discretize(made_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {x, x, 1}}, {{0, 1, 2, 3}}));
}

/// Determinant of the sum of w e e^T over the edges of the only tetrahedron.
double determinant(const Discretization& mesh) {
    const SparseMatrix parts = dual_parts(mesh.input_geometry(), {}, 1, 3);
    DenseMatrix M = DenseMatrix::Zero(3, 3);
    for (SparseMatrix::InnerIterator e(parts, 0); e; ++e) {
        const auto ends = mesh.input().simplices(1).row(e.col());
        const Vector edge = mesh.points().row(ends[1]) - mesh.points().row(ends[0]);
        M += e.value() / mesh.input_geometry().volumes().primal(1)[e.col()] * edge *
             edge.transpose();
    }
    return M.determinant();
}

TEST(SharpsRefuse, cells_whose_edges_leave_the_vector_undetermined) {
    double low = 1, high = 2;
    ASSERT_GT(determinant(tetrahedron(low)), 0);
    ASSERT_LT(determinant(tetrahedron(high)), 0);
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (determinant(tetrahedron(middle)) > 0 ? low : high) = middle;
    }
    const auto mesh = tetrahedron(low);
    EXPECT_REFUSED(sharp_pd(mesh, constant_circulation(mesh, Vector::Ones(3))), "vector",
                   "merged cell 0", "vertices 0, 1, 2, 3", "edges");
}

TEST(SharpsRefuse, other_forms) {
    const auto& mesh = discretized("grid4");
    const Cochain dual{Side::dual, 1, Vector::Ones(mesh.complex().size(1))};
    EXPECT_REFUSED(sharp_pd(mesh, dual), "primal 1-form", "dual 1-form");
    EXPECT_REFUSED(sharp_pp(mesh, dual), "primal 1-form", "dual 1-form");
    EXPECT_THROW(flux_sharp(mesh, {Side::primal, 1, Vector::Ones(3)}), InvalidInput);
}

} // namespace polydec::test::in_sharp
