// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_passage_fields {

constexpr double rounding = 1e-9;

/// A field where the flat wants it: at the vertices, or where the mesh has its cells.
DenseMatrix sampled(const Discretization& mesh, Flat kind, const SmoothForm& field) {
    return test::sampled(is_at_cells(kind) ? cell_centroids(mesh, 2) : mesh.points(), field);
}

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
    for (const auto& [kind, expected] : {std::pair{Flat::ppp, 1.9},
                                         {Flat::pdp, 1.9},
                                         {Flat::dpp, 1.4},
                                         {Flat::ppd, 1.9},
                                         {Flat::pdd, 1.4},
                                         {Flat::dpd, 1.4}})
        EXPECT_GT(order([kind = kind](const auto& mesh) { return error_of_flat(mesh, kind); }),
                  expected)
            << int(kind);
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
