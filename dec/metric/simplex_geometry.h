// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

#include <span>

namespace polydec {

class ExteriorProduct;

/// The corners of a simplex, a row of the table.
inline std::span<const Index> vertices(const Simplices& simplices, Index s) {
    return {&simplices(s, 0), static_cast<std::size_t>(simplices.cols())};
}

/// The number of the face of m-simplex t spanned by its vertices at these ascending positions.
Index face_at(const Pieces& complex, int m, Index t, std::span<const int> positions);

/// Orientation of a k-simplex relative to the ascending order of its vertices.
inline double orientation(const Pieces& complex, int k, Index s) {
    return k == complex.dimension() ? complex.orientation(s) : 1;
}

/// The oriented edges as vectors from tail to head: size(1) x N.
DenseMatrix edge_vectors(const Pieces& complex, const Points& points);

/// Normal of an (n-1)-simplex in R^n whose length is the simplex's volume; normal and edges, in
/// this order, are a positively oriented basis. Only for points of dimension n; `product` is of n-1
/// vectors.
Eigen::RowVectorXd area_vector(const ExteriorProduct& product, const Points& points,
                               const Pieces& complex, Index facet);

/// Gradients of the barycentric coordinates of an m-simplex, in its plane: (m+1) x N.
DenseMatrix barycentric_gradients(const Points& points, std::span<const Index> vertices);

} // namespace polydec
