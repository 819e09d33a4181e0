// SPDX-License-Identifier: MIT
#include "dec/metric/simplex_geometry.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "dec/metric/exterior_product.h"

#include <cmath>

namespace polydec {

Index face_at(const Pieces& complex, int m, Index t, std::span<const int> positions) {
    // leaving out the other vertices, the last one first, leads to the face
    for (int k = m, v = m; v >= 0; --v)
        if (!positions.empty() && positions.back() == v)
            positions = positions.first(positions.size() - 1);
        else
            t = complex.face(k--, t, v);
    return t;
}

DenseMatrix edge_vectors(const Pieces& complex, const Points& points) {
    check_as_many("points of vertices", points.rows(), complex.size(0));
    const auto& edges = complex.simplices(1);
    DenseMatrix vectors(edges.rows(), points.cols());
    for (Index e = 0; e < edges.rows(); ++e)
        vectors.row(e) =
            orientation(complex, 1, e) * (points.row(edges(e, 1)) - points.row(edges(e, 0)));
    return vectors;
}

Eigen::RowVectorXd area_vector(const ExteriorProduct& product, const Points& points,
                               const Pieces& complex, Index facet) {
    const auto n = static_cast<int>(points.cols());
    const auto corners = vertices(complex.simplices(n - 1), facet);
    DenseMatrix edges(n - 1, n);
    for (int i = 1; i < n; ++i)
        edges.row(i - 1) = points.row(corners[i]) - points.row(corners[0]);
    const Vector minors = product(edges);
    Eigen::RowVectorXd normal(n);
    for (int c = 0; c < n; ++c) // minor n-1-c lacks axis c
        normal[c] = ((n - 1 - c) % 2 == 0 ? 1 : -1) * minors[n - 1 - c] / std::tgamma(double(n));
    return normal;
}

DenseMatrix barycentric_gradients(const Points& points, std::span<const Index> vertices) {
    const auto m = static_cast<Index>(vertices.size()) - 1;
    DenseMatrix edges(m, points.cols());
    for (Index i = 0; i < m; ++i)
        edges.row(i) = points.row(vertices[i + 1]) - points.row(vertices[0]);
    // all gradients but the first are dual to the edges, and all sum to zero
    DenseMatrix gradients(m + 1, points.cols());
    gradients.bottomRows(m) = pseudo_inverse(edges).transpose();
    gradients.row(0) = -gradients.bottomRows(m).colwise().sum();
    return gradients;
}

} // namespace polydec
