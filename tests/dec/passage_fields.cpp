// SPDX-License-Identifier: MIT
#include "dec/metric/overlaps.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_passage_fields {

constexpr double rounding = 1e-9;
constexpr std::array primal_kinds{Flat::ppp, Flat::pdp, Flat::dpp};
constexpr std::array dual_kinds{Flat::ppd, Flat::pdd, Flat::dpd};

/// A field where the flat wants it: at the vertices, or where the mesh has its cells.
DenseMatrix sampled(const Discretization& mesh, Flat kind, const SmoothForm& field) {
    return test::sampled(is_at_cells(kind) ? cell_centroids(mesh, 2) : mesh.points(), field);
}

/// Vector fields on surfaces whose edges were flipped.
class FieldsAfterFlips : public OverFlippedSurfaces {
protected:
    Discretization mesh(MergeCriterion criterion = MergeCriterion::dual_length) const {
        const auto& [name, delaunay] = GetParam();
        return circumcentric(shaken(mesh_named(name), 0.25, 7),
                             {.criterion = criterion, .delaunay = delaunay});
    }
};

TEST_P(FieldsAfterFlips, that_are_constant_have_their_circulations_as_flats) {
    const auto mesh = this->mesh();
    const SmoothForm X = random_constant(mesh);
    const Vector primal = de_rham(mesh, 1, circulation_form(X)).values;
    const Vector dual = dual_de_rham(mesh, 1, circulation_form(X)).values;
    for (const Flat kind : primal_kinds)
        if (kind != Flat::dpp || star(mesh.volumes(), 1).zeros().empty()) {
            EXPECT_CLOSE(flat(mesh, kind, sampled(mesh, kind, X)).values, primal, rounding)
                << int(kind);
        }
    for (const Flat kind : dual_kinds)
        EXPECT_CLOSE(flat(mesh, kind, sampled(mesh, kind, X)).values, dual, rounding) << int(kind);
}

TEST_P(FieldsAfterFlips, that_are_linear_have_their_circulations_as_flats_from_vertices) {
    const auto mesh = this->mesh();
    const SmoothForm X = linear_field(space(mesh), 3);
    EXPECT_CLOSE(flat(mesh, Flat::ppp, sampled(mesh, Flat::ppp, X)).values,
                 de_rham(mesh, 1, circulation_form(X)).values, rounding);
    EXPECT_CLOSE(flat(mesh, Flat::ppd, sampled(mesh, Flat::ppd, X)).values,
                 dual_de_rham(mesh, 1, circulation_form(X)).values, rounding);
}

/// Facets of pieces, and their vertices, that have pieces on both sides all around.
std::array<std::vector<bool>, 2> interior(const Discretization& mesh) {
    const auto& K = mesh.pieces();
    std::array<std::vector<bool>, 2> inside{std::vector<bool>(K.size(0), true),
                                            std::vector<bool>(K.size(1), true)};
    const Cofaces cofaces(K, 2);
    for (Index e = 0; e < K.size(1); ++e)
        if (cofaces.of(e).size() != 2) {
            inside[1][e] = false;
            for (int i = 0; i < 2; ++i)
                inside[0][K.face(1, e, i)] = false;
        }
    return inside;
}

/// How far d R(w), times a sign, is from R(dw) on dual cells off the boundary: of a function for
/// j = 0, of a linear field's circulation for j = 1.
double stokes_defect(const Discretization& mesh, int j, double sign) {
    const auto N = space(mesh);
    const DenseMatrix A = random_vector(N * N, 3).reshaped(N, N);
    const SmoothForm function = function_form([&](const Vector& x) { return x.dot(A * x); });
    const SmoothForm gradient = [&](const Vector& x) { return Vector((A + A.transpose()) * x); };
    const SmoothForm field = [&](const Vector& x) { return Vector(A * x); };
    const SmoothForm rotation = [&](const Vector&) {
        std::vector<double> rows;
        for (Index a = 0; a < N; ++a)
            for (Index b = a + 1; b < N; ++b)
                rows.push_back(A(b, a) - A(a, b));
        return Vector(Eigen::Map<const Vector>(rows.data(), Eigen::Index(rows.size())));
    };
    const Cochain w = dual_de_rham(mesh, j, j == 0 ? function : field);
    const Cochain dw = dual_de_rham(mesh, j + 1, j == 0 ? gradient : rotation);
    Vector left = sign * d(mesh.complex(), w).values, right = dw.values;
    const double scale = right.cwiseAbs().maxCoeff();
    const auto inside = interior(mesh);
    const auto& carriers = mesh.merging().carriers(1 - j);
    for (std::size_t s = 0; s < carriers.size(); ++s)
        if (!inside[1 - j][s] && carriers[s].dimension == 1 - j)
            left[carriers[s].cell] = right[carriers[s].cell] = 0;
    return (left - right).cwiseAbs().maxCoeff() / scale;
}

TEST_P(FieldsAfterFlips, have_dual_integrals_that_keep_the_theorem_of_Stokes) {
    for (const auto criterion : {MergeCriterion::none, MergeCriterion::dual_length}) {
        const auto mesh = this->mesh(criterion);
        if (!mesh.input().orientable())
            return;
        for (int j = 0; j < 2; ++j)
            EXPECT_LE(stokes_defect(mesh, j, 1), rounding) << j << " " << int(criterion);
    }
}

/// Whether the surface is flat with its points in a plane: not where shaking has folded it.
bool is_flat_surface(const Discretization& mesh) {
    return mesh.points().cols() == 2 &&
           find_overlaps(mesh.input(), mesh.input_points()).folded.empty();
}

TEST_P(FieldsAfterFlips, that_are_constant_come_back_from_sharps_where_the_surface_is_flat) {
    const auto mesh = this->mesh();
    if (!is_flat_surface(mesh))
        return;
    const Vector X = random_constant(mesh)(Vector::Zero(2));
    const auto difference = [&](const DenseMatrix& rows) {
        return (rows.rowwise() - X.transpose()).cwiseAbs().maxCoeff();
    };
    EXPECT_LE(difference(sharp_pd(mesh, de_rham(mesh, 1, constant_form(X)))), 1e-7);
    // fluxes are meant as the cells are oriented
    const Vector turned{{-X[1], X[0]}};
    DenseMatrix of_fluxes = flux_sharp(mesh, de_rham(mesh, 1, constant_form(turned)));
    const Vector areas = de_rham(mesh, 2, constant_form(Vector::Ones(1))).values;
    of_fluxes = areas.cwiseSign().asDiagonal() * of_fluxes;
    EXPECT_LE(difference(of_fluxes), 1e-7);
}

TEST_P(FieldsAfterFlips, at_cells_are_adjoint_to_the_dpp_flat_where_the_surface_is_flat) {
    const auto mesh = this->mesh();
    if (!is_flat_surface(mesh) || !star(mesh.volumes(), 1).zeros().empty())
        return;
    expect_adjoint_to_the_dpp_flat(mesh, 1e-7);
}

TEST_P(FieldsAfterFlips, at_triangles_have_the_circulations_that_they_are_made_of) {
    // of a function that is linear in space, whatever the surface, loops and spikes included
    const auto mesh = this->mesh(MergeCriterion::none);
    const Vector gradient = random_constant(mesh)(Vector::Zero(mesh.points().cols()));
    const Cochain du = d(mesh.complex(), {Side::primal, 0, mesh.points() * gradient});
    const DenseMatrix X = sharp_pd(mesh, du);
    const auto& K = mesh.pieces();
    for (Index t = 0; t < K.size(2); ++t)
        for (int i = 0; i < 3; ++i) {
            const Index e = K.face(2, t, i);
            const Vector edge = mesh.points().row(K.simplices(1)(e, 1)).transpose() -
                                mesh.points().row(K.simplices(1)(e, 0)).transpose();
            EXPECT_NEAR(X.row(t).dot(edge), du.values[e], 1e-7) << "triangle " << t;
        }
}

POLYDEC_OVER_FLIPPED_SURFACES(FieldsAfterFlips);

constexpr double slope = 2.3;

/// A square sheared along its columns: the edges of its rows are long, and flip.
Mesh slanted(Index cells) {
    Mesh mesh = grid(cells, cells);
    mesh.points.col(1) += slope * mesh.points.col(0);
    return mesh;
}

/// The same folded along the row in the middle, which edges cross after flips: it is isometric.
Mesh folded(Mesh sheet, double angle) {
    const Eigen::Vector3d normal = Eigen::Vector3d(-slope, 1, 0).normalized();
    const Eigen::Vector3d bent =
        std::cos(angle) * normal + std::sin(angle) * Eigen::Vector3d::UnitZ();
    Points points(sheet.points.rows(), 3);
    for (Index v = 0; v < points.rows(); ++v) {
        const Eigen::Vector3d point(sheet.points(v, 0), sheet.points(v, 1), 0);
        const double beyond = (point - Eigen::Vector3d(0, 0.5, 0)).dot(normal);
        points.row(v) = point + std::max(beyond, 0.0) * (bent - normal);
    }
    sheet.points = points;
    return sheet;
}

/// How far places on the folded sheet are from those on the flat one, folded.
double off_the_fold(const Points& on_flat, const Points& on_folded) {
    const Mesh places{on_flat, {}, {}};
    return (folded(places, 1.2).points - on_folded).rowwise().norm().maxCoeff();
}

TEST(OnAFoldedSheet, centers_and_centroids_are_those_of_the_flat_one_folded) {
    const auto sheet = circumcentric(slanted(8), {.delaunay = Delaunay::flips_and_splits});
    const auto bent =
        circumcentric(folded(slanted(8), 1.2), {.delaunay = Delaunay::flips_and_splits});
    ASSERT_GT(bent.passage().flips().statistics.flips, 0);
    for (int k = 0; k <= 2; ++k) {
        EXPECT_LE(off_the_fold(cell_centroids(sheet, k), cell_centroids(bent, k)), rounding) << k;
        EXPECT_LE(off_the_fold(cell_centers(sheet, k), cell_centers(bent, k)), rounding) << k;
    }
}

TEST(OnAFoldedSheetBroken, combinations_of_the_corners_lie_beside_the_surface) {
    const DiscretizeOptions options{.criterion = MergeCriterion::none, .delaunay = Delaunay::flips};
    const auto sheet = circumcentric(slanted(8), options);
    const auto bent = circumcentric(folded(slanted(8), 1.2), options);
    for (int k = 1; k <= 2; ++k) {
        const auto& K = bent.pieces();
        const Points middles = Points::Constant(K.size(k), k + 1, 1.0 / (k + 1));
        EXPECT_GT(
            off_the_fold(cell_centroids(sheet, k), combinations(K, k, middles, bent.points())),
            0.01);
    }
}

TEST(StokesAfterFlipsBroken, with_the_other_sign_fails) {
    for (const auto& name : {"uv_sphere7x5", "torus9x5", "hex4"})
        for (int j = 0; j < 2; ++j)
            EXPECT_GT(stokes_defect(circumcentric(shaken(mesh_named(name), 0.25, 7),
                                                  {.criterion = MergeCriterion::none,
                                                   .delaunay = Delaunay::flips}),
                                    j, -1),
                      1e-3)
                << name << j;
}

/// A round sphere in slanted triangles.
Discretization twisted_sphere(Index parts) {
    Mesh mesh = icosphere(parts);
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        const double angle = 2 * mesh.points(v, 2), x = mesh.points(v, 0), y = mesh.points(v, 1);
        mesh.points(v, 0) = std::cos(angle) * x - std::sin(angle) * y;
        mesh.points(v, 1) = std::sin(angle) * x + std::cos(angle) * y;
    }
    return circumcentric(mesh, {.delaunay = Delaunay::flips});
}

/// A field tangential to spheres around the origin, and the same turned by a right angle.
Vector tangential(const Vector& x) {
    const Vector X{{std::sin(x[1]) + x[2], x[0] * x[2] + 1, std::cos(2 * x[0])}};
    return X - X.dot(x) / x.squaredNorm() * x;
}

Vector turned(const Vector& x) {
    const Eigen::Vector3d X = tangential(x), axis = x;
    return axis.cross(X);
}

double error_of_flat(const Discretization& mesh, Flat kind) {
    const auto circulation = circulation_form(tangential);
    const Cochain form = flat(mesh, kind, sampled(mesh, kind, tangential));
    return norm(mesh, form - (form.side == Side::primal ? de_rham(mesh, 1, circulation)
                                                        : dual_de_rham(mesh, 1, circulation)));
}

double error_of_sharp(const Discretization& mesh, bool of_fluxes) {
    const DenseMatrix X = of_fluxes
                              ? flux_sharp(mesh, de_rham(mesh, 1, circulation_form(turned)))
                              : sharp_pd(mesh, de_rham(mesh, 1, circulation_form(tangential)));
    const Points places = cell_centroids(mesh, 2);
    double sum = 0;
    for (Index cell = 0; cell < X.rows(); ++cell)
        sum += mesh.volumes().primal(2)[cell] *
               (X.row(cell).transpose() - tangential(places.row(cell))).squaredNorm();
    return std::sqrt(sum);
}

/// How far dual integrals are from the star of primal ones.
double error_of_star(const Discretization& mesh, double sign) {
    const Cochain dual = dual_de_rham(mesh, 1, circulation_form(tangential));
    const Cochain primal = de_rham(mesh, 1, circulation_form(turned));
    return norm(mesh, sign * dual - star({mesh.complex(), mesh.volumes()}, primal));
}

/// The order at which an error falls from one sphere to one twice as fine.
template <class Error>
double order(Error error) {
    static const auto coarse = twisted_sphere(16), fine = twisted_sphere(32);
    return std::log2(error(coarse) / error(fine));
}

TEST(OnATwistedSphere, flats_converge) {
    for (const Flat kind : primal_kinds) {
        const double expected = kind == Flat::dpp ? 1.4 : 1.9;
        EXPECT_GT(order([&](const auto& mesh) { return error_of_flat(mesh, kind); }), expected)
            << int(kind);
    }
    for (const Flat kind : dual_kinds) {
        const double expected = kind == Flat::ppd ? 1.9 : 1.4;
        EXPECT_GT(order([&](const auto& mesh) { return error_of_flat(mesh, kind); }), expected)
            << int(kind);
    }
}

TEST(OnATwistedSphere, sharps_and_dual_integrals_converge) {
    for (const bool of_fluxes : {false, true})
        EXPECT_GT(order([&](const auto& mesh) { return error_of_sharp(mesh, of_fluxes); }), 0.95)
            << of_fluxes;
    EXPECT_GT(order([](const auto& mesh) { return error_of_star(mesh, -1); }), 1.5);
}

TEST(OnATwistedSphereBroken, with_the_other_sign_nothing_converges) {
    EXPECT_LT(order([](const auto& mesh) { return error_of_star(mesh, 1); }), 0.1);
}

} // namespace polydec::test::in_passage_fields
