// SPDX-License-Identifier: MIT
#include "dec/fields/whitney_interpolation.h"

#include "base/errors.h"
#include "dec/fields/flat_pieces.h"
#include "dec/fields/transfer.h"
#include "dec/forms/input_units.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/simplex_metric.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace polydec {

namespace {

void check_primal(const CellComplex& complex, const Cochain& form) {
    if (form.side != Side::primal)
        throw InvalidInput(fmt::format(
            "a dual {}-form has no Whitney form: use its star, which is primal", form.degree));
    check(complex, form);
}

void check_place(const Pieces& complex, Index top, const Vector& barycentric) {
    const int n = complex.dimension();
    if (top < 0 || top >= complex.size(n))
        throw InvalidInput(
            fmt::format("{}-simplex {} does not exist: there are {}", n, top, complex.size(n)),
            {.degree = n, .cells = {top}});
    constexpr double rounding = 1e-9;
    if (barycentric.size() != n + 1 ||
        !(std::abs(barycentric.sum() - 1) <= rounding * (1 + barycentric.cwiseAbs().sum())))
        throw InvalidInput(fmt::format("({}) are not barycentric coordinates in {}-simplex {}: "
                                       "expected {} numbers of sum 1",
                                       fmt::join(barycentric, ", "), n, top, n + 1),
                           {.degree = n, .cells = {top}});
}

/// The Whitney form of a cochain in one simplex at a time.
class WhitneyForms {
public:
    WhitneyForms(const Pieces& complex, const PlacedSimplices& places, const Cochain& form)
        : complex_(complex),
          places_(places),
          form_(form),
          faces_(complex, complex.dimension(), form.degree),
          product_(static_cast<int>(places.points.cols()), form.degree) {
        check_primal(complex, form);
        require_points(places.points.cols(), "a Whitney form");
    }

    Vector at(Index top, const Vector& barycentric) {
        const DenseMatrix gradients =
            barycentric_gradients(places_.points, vertices(places_.corners, top));
        const auto& list = faces_.of(top);
        Vector result = Vector::Zero(product_.size());
        for (std::size_t f = 0; f < list.size(); ++f) {
            const double value =
                orientation(complex_, form_.degree, list[f]) * form_.values[list[f]];
            result += value * of_face(gradients, barycentric, faces_.positions()[f]);
        }
        return std::tgamma(form_.degree + 1.0) * result;
    }

    Index size() const { return product_.size(); }

private:
    Vector of_face(const DenseMatrix& gradients, const Vector& barycentric,
                   const std::vector<int>& positions) const {
        Vector sum = Vector::Zero(product_.size());
        for (int p = 0; p <= form_.degree; ++p)
            sum += barycentric[positions[p]] * product_.without(p, positions, gradients);
        return sum;
    }

    const Pieces& complex_;
    PlacedSimplices places_;
    const Cochain& form_;
    SimplexFaces faces_;
    ExteriorProduct product_;
};

DenseMatrix at_centroids(const Pieces& complex, const PlacedSimplices& places,
                         const Cochain& form) {
    const int n = complex.dimension();
    WhitneyForms whitney(complex, places, form);
    const Vector centroid = Vector::Constant(n + 1, 1.0 / (n + 1));
    DenseMatrix result(complex.size(n), whitney.size());
    for (Index t = 0; t < complex.size(n); ++t)
        result.row(t) = whitney.at(t, centroid);
    return result;
}

} // namespace

Vector whitney_form(const Pieces& complex, const Points& points, const Cochain& form, Index top,
                    const Vector& barycentric) {
    WhitneyForms whitney(complex, {points, complex.simplices(complex.dimension())}, form);
    check_place(complex, top, barycentric);
    return whitney.at(top, barycentric);
}

DenseMatrix whitney_at_centroids(const Pieces& complex, const Points& points, const Cochain& form) {
    return at_centroids(complex, {points, complex.simplices(complex.dimension())}, form);
}

Vector whitney_form(const Discretization& mesh, const Cochain& form, Index top,
                    const Vector& barycentric) {
    if (top >= 0 && top < mesh.pieces().size(mesh.dimension()) && mesh.geometry().is_flat(top)) {
        check_place(mesh.input(), top, barycentric);
        return whitney_at_centroids(mesh, form).row(top).transpose();
    }
    const Cochain on_input = lifted(mesh, form);
    WhitneyForms whitney(mesh.input(), mesh.places(), on_input);
    check_place(mesh.input(), top, barycentric);
    return form_in_input_units(whitney.at(top, barycentric), mesh.unit(), -form.degree,
                               "coefficients");
}

DenseMatrix whitney_at_centroids(const Discretization& mesh, const Cochain& form) {
    Points rows = at_centroids(mesh.input(), mesh.places(), lifted(mesh, form));
    if (mesh.passage().is_identity())
        fill_flat_pieces(mesh, rows);
    return in_input_units(DenseMatrix(rows), mesh.unit(), -form.degree, "coefficients");
}

} // namespace polydec
