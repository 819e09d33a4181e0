// SPDX-License-Identifier: MIT
//
// Flats, sharps and interior products on surfaces as they are found, against what they mean for
// gradients: those of a function on each triangle of the input, by elementary geometry.
#include "dec/metric/dual_parts.h"
#include "tests/real/surfaces.h"

namespace polydec::test::in_vectors {

constexpr double rounding = 1e-12;
// of heights of circumcenters, and of least squares in thin cells, which are ill-conditioned
constexpr double of_geometry = 1e-10;

using Vector3 = Eigen::Vector3d;

/// Of a function at vertices: on each triangle the gradient, the sum of the sizes of the three
/// terms in it, and the unit normal of its orientation.
struct Gradients {
    Points gradient, normal;
    Vector size, area;
};

Gradients gradients(const Pieces& K, const Points& points, const Vector& u) {
    const auto& triangles = K.simplices(2);
    const auto count = triangles.rows();
    Gradients all{Points::Zero(count, 3), Points(count, 3), Vector::Zero(count), Vector(count)};
    for (Index t = 0; t < count; ++t) {
        const auto corner = [&](int i) { return Vector3(points.row(triangles(t, i % 3))); };
        const Vector3 twice = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        all.area[t] = twice.norm() / 2;
        all.normal.row(t) = K.orientation(t) * twice.normalized();
        for (int i = 0; i < 3; ++i) {
            const Vector3 slope = twice.cross(corner(i + 2) - corner(i + 1)) / twice.squaredNorm();
            all.gradient.row(t) += u[triangles(t, i)] * slope;
            all.size[t] += std::abs(u[triangles(t, i)]) * slope.norm();
        }
    }
    return all;
}

class RealVectors : public OnRealSurfaces {
protected:
    bool flipped() const { return !mesh().passage().is_identity(); }
    const SimplicialComplex& K() const { return mesh().input(); }
    Vector u() const { return random(Side::primal, 0, 6).values; }
    Cochain du() const { return d(P(), Cochain{Side::primal, 0, u()}); }

    /// Means over triangles, weights(c, t) for row c, and of what sizes.
    static double worst_row(const DenseMatrix& found, const SparseMatrix& weights,
                            const Points& vectors, const Vector& sizes) {
        const Vector defects = (found - weights * vectors).rowwise().norm();
        return worst_share(defects, SparseMatrix(weights.cwiseAbs()) * sizes);
    }

    /// The means by area over the pieces of cells.
    SparseMatrix means_over_cells() const {
        const SparseMatrix pieces = mesh().merging().diamond(2).cast<double>();
        const Vector inverse = mesh().volumes().primal(2).cwiseInverse();
        return inverse.asDiagonal() * SparseMatrix(pieces.cwiseAbs()) *
               mesh().geometry().volumes().primal(2).asDiagonal();
    }

    /// How far each cell is from being flat and cospherical, relative: by how much the normals of
    /// its pieces differ, and how far their circumcenters may lie apart.
    Vector flaws(const Points& normals) const {
        const IncidenceMatrix& pieces = mesh().merging().diamond(2);
        Vector result = Vector::Zero(pieces.rows());
        for (Index c = 0; c < pieces.rows(); ++c) {
            const IncidenceMatrix::InnerIterator first(pieces, c);
            for (IncidenceMatrix::InnerIterator t(pieces, c); t; ++t) {
                const Vector3 bend =
                    t.value() * normals.row(t.col()) - first.value() * normals.row(first.col());
                if (t.col() != first.col())
                    result[c] = std::max(result[c], 10 * mesh().options().tolerance + bend.norm());
            }
        }
        return result;
    }
};

TEST_P(RealVectors, at_vertices_contract_a_differential_to_the_slope) {
    const Points field = mesh().points().array().cos();
    const auto slopes = gradients(K(), mesh().input_points(), u());
    const Vector found = interior_product(mesh(), field, 1, Sampling::centered) * du().values;
    Vector mean = Vector::Zero(K().size(0)), area = mean, size = mean;
    for (Index t = 0; t < K().size(2); ++t)
        for (const Index v : K().simplices(2).row(t)) {
            mean[v] += slopes.area[t] * field.row(v).dot(slopes.gradient.row(t));
            size[v] += slopes.area[t] * field.row(v).norm() * slopes.size[t];
            area[v] += slopes.area[t];
        }
    const Vector here = found.head(mean.size()).cwiseProduct(area);
    EXPECT_LE(worst_share(here - mean, size), of_geometry);
    EXPECT_GT(worst_share(here + mean, size), 1e-2) << "against the field";
}

TEST_P(RealVectors, that_are_constant_have_flats_that_are_differentials) {
    const Vector3 c(0.3, -0.8, 0.5);
    const Vector x = mesh().points() * c;
    const Vector expected = d(P(), Cochain{Side::primal, 0, x}).values;
    const Vector size = c.norm() * Sizes(mesh()).d(0, mesh().points().rowwise().norm());
    const auto constant = [&](Index rows) { return DenseMatrix(c.transpose().replicate(rows, 1)); };
    for (const Flat kind : {Flat::ppp, Flat::pdp}) {
        const Vector found = flat(mesh(), kind, constant(P().size(0))).values;
        EXPECT_LE(worst_share(found - expected, size), rounding);
        EXPECT_GT(worst_share(found + expected, size), 1e-3) << "with the sign flipped";
    }
    if (flipped())
        return;
    if (star(mesh().volumes(), 1).zeros().empty()) {
        const Vector found = flat(mesh(), Flat::dpp, constant(P().size(2))).values;
        EXPECT_LE(worst_share(found - expected, size), of_geometry);
    }
    const Vector ppd = flat(mesh(), Flat::ppd, constant(P().size(0))).values;
    const Vector lengths = ppd.cwiseAbs() + mesh().volumes().terms(1).vector();
    EXPECT_LE(worst_share(flat(mesh(), Flat::pdd, constant(P().size(0))).values - ppd, lengths),
              of_geometry);
    EXPECT_LE(worst_share(flat(mesh(), Flat::dpd, constant(P().size(2))).values - ppd, lengths),
              of_geometry);
}

TEST_P(RealVectors, at_vertices_are_means_of_the_gradients_by_the_parts_of_the_dual) {
    if (flipped() || !star(mesh().volumes(), 0).zeros().empty())
        return;
    const auto slopes = gradients(K(), mesh().points(), u());
    const auto& V = mesh().input_geometry().volumes();
    const SparseMatrix parts =
        dual_parts({K(), mesh().input_geometry().metric(), V}, {}, 0, 2).transpose();
    const Vector inverse = V.dual(0).cwiseInverse();
    const SparseMatrix weights = inverse.asDiagonal() * parts;
    const DenseMatrix found = sharp_pp(mesh(), du());
    EXPECT_LE(worst_row(found, weights, slopes.gradient, slopes.size), of_geometry);
    EXPECT_GT(worst_row(-found, weights, slopes.gradient, slopes.size), 1e-2) << "turned around";
}

TEST_P(RealVectors, of_cells_are_means_of_the_gradients_and_of_these_turned) {
    if (flipped())
        return;
    const auto slopes = gradients(K(), mesh().points(), u());
    const SparseMatrix weights = means_over_cells();
    Points turned(slopes.gradient.rows(), 3);
    for (Index t = 0; t < turned.rows(); ++t)
        turned.row(t) = Vector3(slopes.gradient.row(t)).cross(Vector3(slopes.normal.row(t)));
    const DenseMatrix along = sharp_pd(mesh(), du()), across = flux_sharp(mesh(), du());
    // one vector for all pieces of a cell fits best where these have one plane and one center
    const Vector bent = (along - weights * slopes.gradient).rowwise().norm();
    const Vector size = weights * slopes.size;
    EXPECT_LE(worst_share(bent, size.array() * (of_geometry + flaws(slopes.normal).array())), 1);
    EXPECT_LE(worst_row(across, weights, turned, slopes.size), of_geometry);
    EXPECT_GT(worst_row(along, weights, turned, slopes.size), 1e-2) << "turned";
    EXPECT_GT(worst_row(across, weights, slopes.gradient, slopes.size), 1e-2) << "not turned";
}

/// What vectors and forms there are after flips is either refused or of the right shape.
TEST_P(RealVectors, are_as_many_as_the_cells_or_refused) {
    const auto expect_rows = [&](Index rows, const std::function<DenseMatrix()>& made) {
        std::optional<DenseMatrix> result;
        if (refusal([&] { result = made(); }) != "accepted")
            return;
        EXPECT_EQ(result->rows(), rows);
        EXPECT_TRUE(result->allFinite());
    };
    expect_rows(P().size(0), [&] { return sharp_pp(mesh(), du()); });
    expect_rows(P().size(2), [&] { return sharp_pd(mesh(), du()); });
    expect_rows(P().size(2), [&] { return flux_sharp(mesh(), du()); });
    for (const Flat kind : {Flat::ppp, Flat::pdp, Flat::ppd, Flat::pdd})
        expect_rows(P().size(1),
                    [&] { return DenseMatrix(flat(mesh(), kind, mesh().points()).values); });
    for (const Flat kind : {Flat::dpp, Flat::dpd})
        expect_rows(P().size(1), [&] {
            return DenseMatrix(flat(mesh(), kind, DenseMatrix::Ones(P().size(2), 3)).values);
        });
}

POLYDEC_ON_REAL_SURFACES(RealVectors);

} // namespace polydec::test::in_vectors
