// SPDX-License-Identifier: MIT
#include "dec/metric/simplex_geometry.h"
#include "tests/dec/discretized.h"
#include "tests/support/diamond.h"

namespace polydec::test::in_glued_box {

using std::numbers::pi;

struct Sample {
    PeriodicMesh glued;
    bool closed;
    Discretization mesh = circumcentric(glued);
};

const std::vector<Sample>& samples() {
    static const auto all = [] {
        std::vector<Sample> result;
        for (int n = 1; n <= 3; ++n)
            for (int axes = 1; axes <= n; ++axes)
                result.push_back(
                    {periodic(kuhn(n, n == 3 ? 3 : 5), unit_translations(n, axes)), axes == n});
        result.push_back({periodic(bcc(3), unit_translations(3, 3)), true});
        result.push_back({unit_diamond(3), true});
        return result;
    }();
    return all;
}

/// Functions and forms with the periods of all samples.
SmoothForm waves(Index coefficients) {
    return [=](const Vector& x) -> Vector {
        Vector result(coefficients);
        for (Index i = 0; i < coefficients; ++i)
            result[i] = std::sin(2 * pi * x[0] + 0.7 * i) + 0.3 * std::cos(2 * pi * x.sum());
        return result;
    };
}

Vector direction(Index n) {
    return Vector{{0.6, -1.1, 0.8}}.head(n);
}

double off_lattice(const Eigen::RowVectorXd& x) {
    return (x.array() - x.array().round()).abs().maxCoeff();
}

TEST(GluedBox, has_the_box_and_the_first_places) {
    for (const auto& [glued, closed, mesh] : samples()) {
        ASSERT_NE(mesh.box(), nullptr);
        EXPECT_EQ(mesh.ambient_dimension(), glued.box.ambient_dimension());
        EXPECT_EQ(mesh.points().cols(), 0);
        EXPECT_EQ(cell_centers(mesh, 0), glued.points);
        EXPECT_EQ(placed(mesh).input_points(), glued.box.points);
        EXPECT_NEAR(placed(mesh).volumes().primal(mesh.dimension()).sum(),
                    mesh.volumes().primal(mesh.dimension()).sum(), 1e-12);
        EXPECT_EQ(circumcentric(glued.quotient).box(), nullptr);
    }
}

/// Simplices between their corners in the box have the lengths that are known, the diagonals of
/// the box none.
TEST(GluedBox, has_straight_simplices_across_the_seams) {
    for (const auto& [glued, closed, mesh] : samples()) {
        const int n = mesh.dimension();
        const auto [points, corners] = mesh.places();
        const auto& K = mesh.input();
        for (Index t = 0; t < K.size(n); ++t)
            for (int i = 0; i <= n; ++i)
                for (int j = i + 1; j <= n; ++j)
                    EXPECT_NEAR((points.row(corners(t, i)) - points.row(corners(t, j))).norm(),
                                mesh.input_geometry().volumes().primal(
                                    1)[face_at(K, n, t, std::array{i, j})],
                                1e-12);
    }
}

TEST(GluedBox, pulls_forms_back_as_d_does) {
    for (const auto& [glued, closed, mesh] : samples()) {
        for (int k = 0; k < mesh.dimension(); ++k) {
            const Vector a = random_vector(mesh.input().size(k), 3);
            const Vector da = derivative(mesh.input(), k) * a;
            const Vector there = to_places(mesh, k, a);
            EXPECT_CLOSE(Vector(derivative(placed(mesh).input(), k) * there),
                         Vector(to_places(mesh, k + 1, da)), 1e-15);
            EXPECT_EQ(Vector(from_places(mesh, k, there)), a);
            EXPECT_NEAR(sums_from_places(mesh, k, there).col(0).dot(a), there.squaredNorm(),
                        1e-12 * a.size());
            // and on merged cells, by the lift
            const Cochain u{Side::primal, k, random_vector(mesh.complex().size(k), 4)};
            EXPECT_CLOSE(d(placed(mesh).complex(), form_at_places(mesh, u)).values,
                         form_at_places(mesh, d(mesh.complex(), u)).values, 1e-12);
        }
    }
}

/// The straight way between the centers of cells side by side, modulo the periods, is as long as
/// the dual edge, also where the seams cut cells.
TEST(GluedBox, has_centers_a_dual_edge_apart) {
    for (const auto& [glued, closed, mesh] : samples()) {
        const int n = mesh.dimension();
        const double side = glued.box.points.col(0).maxCoeff() - glued.box.points.col(0).minCoeff();
        const Points centers = cell_centers(mesh, n), facets = cell_centers(mesh, n - 1);
        const auto apart = [&](Eigen::RowVectorXd way) {
            for (Index axis = 0; side < 1.5 && axis < way.size(); ++axis)
                way[axis] -= std::round(way[axis]);
            if (side > 1.5) { // the diamond: along both diagonals
                const double u = std::round((way[0] + way[1]) / 2),
                             v = std::round((way[0] - way[1]) / 2);
                way[0] -= u + v;
                way[1] -= u - v;
            }
            return way.norm();
        };
        const IncidenceMatrix boundary = mesh.complex().boundary(n);
        for (Index f = 0; f < boundary.rows(); ++f) {
            std::vector<Index> cells;
            for (IncidenceMatrix::InnerIterator cell(boundary, f); cell; ++cell)
                cells.push_back(static_cast<Index>(cell.col()));
            if (cells.size() != 2)
                continue;
            const double dual = mesh.volumes().dual(n - 1)[f];
            EXPECT_NEAR(apart(centers.row(cells[0]) - centers.row(cells[1])), std::abs(dual),
                        1e-12);
            if (dual > 0) {
                EXPECT_NEAR(apart(centers.row(cells[0]) - facets.row(f)) +
                                apart(centers.row(cells[1]) - facets.row(f)),
                            dual, 1e-12);
            }
        }
    }
}

TEST(GluedBox, has_cut_squares_in_one_place) {
    const int m = 4;
    const auto mesh = circumcentric(diamond(m));
    ASSERT_EQ(mesh.complex().size(2), 2 * m * m) << "squares are merged across the seams";
    for (const Points& places : {cell_centers(mesh, 2), cell_centroids(mesh, 2), dual_sites(mesh)})
        for (Index cell = 0; cell < places.rows(); ++cell)
            EXPECT_LE(off_lattice(places.row(cell).array() - 0.5), 1e-12);
    EXPECT_EQ(placed(mesh).complex().size(2), 2 * m * m + 2 * m) << "cut in the box: 4 m halves";
    EXPECT_EQ(std::ssize(cells_of_places(mesh, 2)), 2 * m * m + 2 * m);
}

TEST(GluedBox, has_functions_with_its_periods) {
    for (const auto& [glued, closed, mesh] : samples()) {
        const int n = mesh.dimension();
        const auto values = [&](const Points& places) {
            Vector result(places.rows());
            for (Index i = 0; i < result.size(); ++i)
                result[i] = waves(1)(places.row(i).transpose())[0];
            return result;
        };
        EXPECT_EQ(de_rham(mesh, 0, waves(1)).values, values(cell_centers(mesh, 0)));
        EXPECT_WITHIN(dual_de_rham(mesh, 0, waves(1)).values, values(dual_sites(mesh)), 1e-12);
        // all places of a vertex have one value
        const Vector at_box = values(glued.box.points);
        EXPECT_WITHIN(form_at_places(mesh, de_rham(mesh, 0, waves(1))).values, at_box, 1e-12);
        const auto ones = function_form([](const Vector&) { return 1.0; });
        EXPECT_NEAR(de_rham(mesh, n, ones).values.cwiseAbs().sum(), mesh.volumes().primal(n).sum(),
                    1e-12);
    }
}

SmoothForm derivative_of_waves(int n) {
    return [n](const Vector& x) -> Vector {
        Vector result = Vector::Constant(n, -0.6 * pi * std::sin(2 * pi * x.sum()));
        result[0] += 2 * pi * std::cos(2 * pi * x[0]);
        return result;
    };
}

TEST(GluedBox, has_the_theorem_of_stokes) {
    for (const auto& [glued, closed, made] : samples())
        for (const StarKind star : {StarKind::circumcentric, StarKind::galerkin}) {
            const auto mesh = discretize(glued, {.star = star});
            const int n = mesh.dimension();
            const Vector df = de_rham(mesh, 1, derivative_of_waves(n), 15).values;
            EXPECT_CLOSE(d(mesh.complex(), de_rham(mesh, 0, waves(1))).values, df, 1e-5);
            if (n > 1) {
                EXPECT_EQ(boundary_de_rham(mesh, 1, derivative_of_waves(n)).isZero(0), closed);
            }
            if (star != StarKind::circumcentric)
                continue;
            const Vector inside =
                dual_derivative(mesh.complex(), 0) * dual_de_rham(mesh, 0, waves(1), 15).values;
            const Vector data = boundary_de_rham(mesh, 0, waves(1), 15);
            const SparseMatrix B = dual_boundary_derivative(mesh.complex(), 0);
            const Vector whole = dual_de_rham(mesh, 1, derivative_of_waves(n), 15).values;
            EXPECT_CLOSE(Vector(inside + B * data), whole, 1e-5) << n;
            EXPECT_EQ(data.isZero(0), closed) << "seams are no boundary";
        }
}

/// Forms of every degree whose dual is over cells: the dual of a constant form is the star of the
/// constant form that is its dual, and closed.
TEST(GluedBox, has_constant_dual_forms) {
    for (const auto& [glued, closed, mesh] : samples()) {
        const int n = mesh.dimension();
        const Vector X = direction(n);
        const auto fluxes = de_rham(mesh, n - 1, flux_form([&](const Vector&) { return X; }));
        const auto along = dual_de_rham(mesh, 1, constant_form(X));
        const double sign = n % 2 == 0 ? -1 : 1;
        EXPECT_CLOSE(Vector(sign * star(mesh, fluxes).values), along.values, 1e-12) << n;
        const auto by_matrices = discretize(glued, {.star = StarKind::galerkin});
        EXPECT_CLOSE(
            Vector(sign * star(by_matrices, de_rham(by_matrices, n - 1,
                                                    flux_form([&](const Vector&) { return X; })))
                              .values),
            dual_de_rham(by_matrices, 1, constant_form(X)).values, 1e-12)
            << n;
    }
}

TEST(GluedBox, has_flats_and_sharps_of_constants) {
    for (const auto& [glued, closed, mesh] : samples()) {
        const int n = mesh.dimension();
        const Vector X = direction(n);
        const auto field = [&](Index rows) -> DenseMatrix {
            return X.transpose().replicate(rows, 1);
        };
        const DenseMatrix at_vertices = field(mesh.complex().size(0)),
                          at_cells = field(mesh.complex().size(n));
        const Cochain primal = de_rham(mesh, 1, constant_form(X)),
                      dual = dual_de_rham(mesh, 1, constant_form(X));
        for (const auto kind : {Flat::ppp, Flat::pdp})
            EXPECT_CLOSE(flat(mesh, kind, at_vertices).values, primal.values, 1e-12);
        if (star(mesh.volumes(), 1).zeros().empty()) {
            EXPECT_CLOSE(flat(mesh, Flat::dpp, at_cells).values, primal.values, 1e-12);
        }
        for (const auto kind : {Flat::ppd, Flat::pdd, Flat::dpd})
            EXPECT_CLOSE(flat(mesh, kind, kind == Flat::dpd ? at_cells : at_vertices).values,
                         dual.values, 1e-12);
        EXPECT_WITHIN(sharp_pp(mesh, primal), at_vertices, 1e-12);
        EXPECT_WITHIN(sharp_pd(mesh, primal), at_cells, 1e-12);
        const Cochain fluxes = de_rham(mesh, n - 1, flux_form([&](const Vector&) { return X; }));
        EXPECT_WITHIN(flux_sharp(mesh, fluxes), at_cells, 1e-12);
        const DenseMatrix found = whitney_at_centroids(mesh, primal);
        EXPECT_WITHIN(found, field(mesh.input().size(n)), 1e-12);
        EXPECT_CLOSE(Vector(interior_product(mesh, at_vertices, n, Sampling::centered) *
                            de_rham(mesh, n, constant_form(Vector::Ones(1))).values),
                     fluxes.values, 1e-12);
        if (closed) { // what is constant stays
            for (const auto sampling : {Sampling::centered, Sampling::upwind})
                EXPECT_LE((lie_derivative(mesh, at_vertices, 1, sampling) * primal.values)
                              .cwiseAbs()
                              .maxCoeff(),
                          1e-11);
        }
    }
}

TEST(GluedBox, is_measured_in_the_unit_of_the_mesh) {
    PeriodicMesh tiny = unit_diamond(3);
    constexpr double size = 0x1p-340;
    tiny.box.points *= size;
    tiny.points *= size;
    tiny.quotient.lengths *= size;
    const auto mesh = circumcentric(tiny), usual = circumcentric(unit_diamond(3));
    ASSERT_NE(mesh.unit(), 1);
    EXPECT_TRUE(cell_centers(mesh, 0).isApprox(size * cell_centers(usual, 0), 1e-12));
    EXPECT_TRUE(cell_centroids(mesh, 2).isApprox(size * cell_centroids(usual, 2), 1e-12));
}

TEST(GluedBox, keeps_the_groups_of_the_box) {
    Mesh box = grid(6, 6);
    for (Index t = 0; t < box.simplices.rows(); ++t)
        box.tags.push_back(t < box.simplices.rows() / 2 ? 1 : 2);
    box.facet_tags.simplices = box.simplices.topRows(1).leftCols(2);
    box.facet_tags.tags = {7};
    box.warnings.emplace_back("as it was read");
    const auto mesh = circumcentric(periodic(box, unit_translations(2, 2)));
    const auto open = circumcentric(box);
    for (const Index tag : {1, 2})
        EXPECT_EQ(std::count(mesh.tags().begin(), mesh.tags().end(), tag),
                  std::count(open.tags().begin(), open.tags().end(), tag));
    EXPECT_EQ(mesh.facet_tags().size(), static_cast<std::size_t>(mesh.complex().size(1)));
    EXPECT_SAYS(mesh.warnings().front(), "as it was read");
}

TEST(GluedBox, is_not_known_after_flips) {
    Mesh box = grid(4, 4);
    for (auto place : box.points.rowwise())
        if ((place.array() == 0.5).all())
            place *= 1.2;
    const auto mesh =
        discretize(periodic(box, unit_translations(2, 2)), {.delaunay = Delaunay::flips});
    EXPECT_EQ(mesh.box(), nullptr);
    EXPECT_EQ(mesh.ambient_dimension(), 0);
    EXPECT_SAYS(mesh.warnings().front(), "glued", "flipped", "no positions");
}

} // namespace polydec::test::in_glued_box
