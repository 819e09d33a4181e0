// SPDX-License-Identifier: MIT
#include "dec/surfaces/places.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/lists.h"
#include "dec/metric/centers.h"
#include "dec/metric/simplex_faces.h"
#include "dec/surfaces/intrinsic_delaunay.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace polydec {

Places::Places(const Passage& passage, const Points& points) : passage_(passage) {
    if (passage.is_identity())
        return;
    const Pieces& K = passage.pieces();
    overlay_ = overlay(passage, points);
    cofaces_.emplace(K, K.dimension());
    for (Index t = 0; t <= K.size(K.dimension()); ++t)
        begins_.push_back(place_in(overlay_.triangle, t));
}

Points Places::at(int k, const Points& coordinates, const Points& values) const {
    const Pieces& K = passage_.pieces();
    const int n = K.dimension();
    if (passage_.is_identity())
        return combinations(K, k, coordinates, values);

    check_as_many("rows of coordinates", coordinates.rows(), K.size(k));
    const Points known = overlay_.at_points(values);
    SimplexLayout layout(K, SimplexMetric(K, passage_.flips().lengths));
    SimplexFaces faces(K, n, k);
    Points result = Points::Zero(K.size(k), values.cols());
    std::vector<bool> found(static_cast<std::size_t>(K.size(k)), false);
    for (Index t = 0; t < K.size(n); ++t) {
        const auto& of_piece = faces.of(t);
        for (std::size_t f = 0; f < of_piece.size(); ++f) {
            const Index s = of_piece[f];
            if (found[s])
                continue;
            found[s] = true;
            Place place{t, Vector::Zero(n + 1)};
            place.coordinates(faces.positions()[f]) = coordinates.row(s).transpose();
            go_on(layout, place);
            for (const auto& [point, weight] : combination(std::move(place)))
                result.row(s) += weight * known.row(point);
        }
    }
    return result;
}

/// Crosses facets that the place lies beyond, while there are pieces behind them.
void Places::go_on(SimplexLayout& layout, Place& place) const {
    const Pieces& K = passage_.pieces();
    const int n = K.dimension();
    constexpr double rounding = 1e-12;
    constexpr int many = 100; // around a cone the walk may not terminate
    const auto gradients = [&](Index t) {
        const Corners corners = layout.at(n, t);
        return barycentric_gradients(corners.points, corners.vertices);
    };
    for (int step = 0; step < many; ++step) {
        const Index t = place.piece;
        const Vector& here = place.coordinates;
        int omitted = 0;
        if (!(here.minCoeff(&omitted) < -rounding))
            return;
        const auto around = cofaces_->of(K.face(n, t, omitted));
        const auto other = std::find_if(around.begin(), around.end(), [&](const Coface& c) {
            return c.cell != t || c.omitted != omitted;
        });
        if (other == around.end())
            return;

        // down to the facet, and equally far up on the other side
        const auto along_height = [](const DenseMatrix& slopes, int corner) {
            return Vector(slopes * slopes.row(corner).transpose().normalized());
        };
        const DenseMatrix slopes = gradients(t);
        const double depth = -here[omitted] / slopes.row(omitted).norm();
        const Vector foot = here + depth * along_height(slopes, omitted);
        Vector there = depth * along_height(gradients(other->cell), other->omitted);
        for (int i = 0; i < n; ++i)
            there[i < other->omitted ? i : i + 1] += foot[i < omitted ? i : i + 1];
        place = {other->cell, std::move(there)};
    }
}

std::vector<Places::Term> Places::combination(Place place) const {
    const auto& [t, coordinates] = place;
    Vector inside = coordinates.cwiseMax(0);
    inside /= inside.sum();
    std::vector<Term> result;
    double best = -std::numeric_limits<double>::infinity();
    for (Index part = begins_[t]; part < begins_[t + 1]; ++part)
        for (Index c = overlay_.offsets[part] + 2; c < overlay_.offsets[part + 1]; ++c) {
            const std::array<Index, 3> corners{overlay_.offsets[part], c - 1, c};
            Eigen::Matrix3d of_corners;
            for (int i = 0; i < 3; ++i)
                of_corners.col(i) =
                    Eigen::Map<const Eigen::Vector3d>(overlay_.coordinates[corners[i]].data());
            const Eigen::Vector3d weights = of_corners.fullPivLu().solve(inside);
            if (!(weights.minCoeff() > best))
                continue;
            best = weights.minCoeff();
            result.clear();
            for (int i = 0; i < 3; ++i)
                result.push_back({overlay_.corners[corners[i]], weights[i]});
        }
    if (result.empty()) // rounding has left no part
        inside.setZero();
    const auto corners = vertices(passage_.pieces().simplices(passage_.pieces().dimension()), t);
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (const double beyond = coordinates[i] - inside[i]; beyond != 0)
            result.push_back({corners[i], beyond});
    return result;
}

} // namespace polydec
