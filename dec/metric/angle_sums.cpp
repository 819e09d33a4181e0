// SPDX-License-Identifier: MIT
#include "dec/metric/angle_sums.h"

#include "base/decompositions.h"
#include "dec/metric/simplex_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Inward normals of the facets of a simplex, one per row; no rows if it is flat.
DenseMatrix normals(const Corners& corners) {
    const auto n = static_cast<Eigen::Index>(corners.vertices.size()) - 1;
    DenseMatrix edges(n, corners.points.cols());
    for (Eigen::Index j = 0; j < n; ++j)
        edges.row(j) =
            corners.points.row(corners.vertices[j + 1]) - corners.points.row(corners.vertices[0]);
    const Vector lengths = edges.rowwise().norm();
    edges = lengths.cwiseInverse().asDiagonal() * edges; // independent of scale
    const double rounding = 64 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
    if (std::abs(triangular_factor(edges.transpose()).diagonal().prod()) <= rounding)
        return {};
    DenseMatrix result(n + 1, edges.cols());
    result.bottomRows(n) = (lengths.minCoeff() * lengths.cwiseInverse()).asDiagonal() *
                           pseudo_inverse(edges).transpose();
    result.row(0) = -result.bottomRows(n).colwise().sum();
    result.rowwise().normalize();
    return result;
}

} // namespace

Vector angle_sums(const Pieces& complex, const SimplexMetric& metric) {
    const int n = complex.dimension();
    SimplexFaces faces(complex, n, n - 2);
    std::vector<std::pair<int, int>> omitted; // for each face
    for (const auto& kept : faces.positions()) {
        std::vector<int> corners;
        for (int i = 0; i <= n; ++i)
            if (!std::binary_search(kept.begin(), kept.end(), i))
                corners.push_back(i);
        omitted.emplace_back(corners[0], corners[1]);
    }
    SimplexLayout layout(complex, metric);
    Vector sums = Vector::Zero(complex.size(n - 2));
    for (Index t = 0; t < complex.size(n); ++t) {
        const DenseMatrix inwards = normals(layout.at(n, t));
        if (inwards.rows() == 0)
            continue;
        const auto& list = faces.of(t);
        for (std::size_t s = 0; s < list.size(); ++s) {
            const auto a = inwards.row(omitted[s].first), b = inwards.row(omitted[s].second);
            sums[list[s]] += 2 * std::atan2((a + b).norm(), (a - b).norm());
        }
    }
    return sums;
}

} // namespace polydec
