// SPDX-License-Identifier: MIT
#include "dec/fields/contraction.h"

#include "base/decompositions.h"
#include "base/lists.h"
#include "complex/components.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Of a simplex without volume, which has weight only if it is alone.
constexpr double nothing = std::numeric_limits<double>::min();

Vector top_volumes(const PlacedSimplices& places) {
    Circumsphere sphere;
    Vector volumes(places.corners.rows());
    for (Index t = 0; t < volumes.size(); ++t)
        volumes[t] = sphere.look_at({places.points, vertices(places.corners, t)}) ? sphere.volume()
                                                                                  : nothing;
    return volumes;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance of v from the cone of vectors along which no function falls, given their gradients, one
/// per row. Outside, the nearest vector of the cone lies in one of its facets, across which v
/// falls.
double distance_from_cone(const DenseMatrix& gradients, const Eigen::RowVectorXd& v) {
    double nearest = infinity;
    for (Eigen::Index q = 0; q < gradients.rows(); ++q) {
        if (!(gradients.row(q).dot(v) < 0))
            continue;
        const Eigen::RowVectorXd normal = gradients.row(q).normalized();
        DenseMatrix others(gradients.rows() - 1, gradients.cols());
        others << gradients.topRows(q), gradients.bottomRows(gradients.rows() - 1 - q);
        others -= others * normal.transpose() * normal;
        const double depth = normal.dot(v);
        nearest =
            std::min(nearest, std::hypot(depth, distance_from_cone(others, v - depth * normal)));
    }
    return nearest < infinity ? nearest : 0;
}

} // namespace

Contraction::Contraction(const Pieces& complex, const PlacedSimplices& places, int k)
    : complex_(complex),
      k_(k),
      volumes_(top_volumes(places)),
      on_boundary_(boundary_cells(complex)[k - 1]) {
    const int n = complex.dimension();
    const auto N = places.points.cols();
    SimplexFaces faces(complex, n, k - 1);
    const SimplexFaces cofaces(complex, n, k);
    for (const auto& face : faces.positions())
        extensions_.push_back(extensions_of(face, cofaces.positions()));
    gradients_.resize(Eigen::Index{complex.size(n)} * (n + 1), N);
    normals_.resize(complex.size(n) * N, N - n);
    for (Index t = 0; t < complex.size(n); ++t) {
        const DenseMatrix gradients =
            barycentric_gradients(places.points, vertices(places.corners, t));
        gradients_.middleRows(Eigen::Index{t} * (n + 1), n + 1) = gradients;
        DenseMatrix plane = DenseMatrix::Zero(N, N);
        plane.leftCols(n) = gradients.bottomRows(n).transpose();
        normals_.middleRows(t * N, N) = orthonormal_columns(plane).rightCols(N - n);
    }
    around_ = Vector::Zero(complex.size(k - 1));
    for (Index t = 0; t < complex.size(n); ++t)
        for (const Index s : faces.of(t))
            around_[s] += volumes_[t];
}

std::vector<Contraction::Extension>
Contraction::extensions_of(const std::vector<int>& face,
                           const std::vector<std::vector<int>>& cofaces) const {
    std::vector<Extension> extensions;
    for (const int q : complement(complex_.dimension() + 1, face)) {
        const Index place = place_in(face, q);
        auto extended = face;
        extended.insert(extended.begin() + place, q);
        extensions.push_back({q, static_cast<std::size_t>(place_in(cofaces, extended)),
                              place % 2 == 0 ? 1.0 : -1.0});
    }
    return extensions;
}

Contraction::Nearest Contraction::nearest(const Points& field) const {
    const auto N = field.cols();
    SimplexFaces faces(complex_, complex_.dimension(), k_ - 1);
    Nearest result{DenseMatrix::Constant(volumes_.size(), std::ssize(extensions_), infinity),
                   Vector::Constant(around_.size(), infinity), Vector::Zero(around_.size())};
    for (const bool outside : {false, true})
        visit_faces(
            field,
            [&](Index t, Index, Index s) {
                return result.least[s] > rounding && volumes_[t] > nothing;
            },
            [&](const Place& at) {
                const Eigen::RowVectorXd v = -at.X.stableNormalized();
                const double beside = (v * normals_.middleRows(at.t * N, N)).norm();
                double behind = 0; // facets of the cone
                for (const auto& term : at.terms) {
                    const auto gradient = gradients_.row(term.gradient);
                    behind = std::max(behind, -v.dot(gradient) / gradient.norm());
                }
                double& least = result.least[at.s];
                if ((behind > 0) != outside || std::hypot(beside, behind) > least + rounding)
                    return;

                DenseMatrix gradients(std::ssize(at.terms), N);
                for (std::size_t q = 0; q < at.terms.size(); ++q)
                    gradients.row(static_cast<Index>(q)) = gradients_.row(at.terms[q].gradient);
                double& distance = result.distance(at.t, at.i);
                distance = std::hypot(beside, distance_from_cone(gradients, v));
                least = std::min(least, distance);
            });
    for (Index t = 0; t < volumes_.size(); ++t) {
        const auto& list = faces.of(t);
        for (Index i = 0; i < std::ssize(list); ++i)
            if (result.has(t, i, list[i]))
                result.volume[list[i]] += volumes_[t];
    }
    return result;
}

} // namespace polydec
