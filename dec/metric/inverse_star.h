// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/exterior_product.h"

#include <functional>
#include <vector>

namespace polydec {

/// Inverse Hodge stars of constant j-forms on R^N in the planes of m-simplices.
class InverseStar {
public:
    InverseStar(int N, int m, int j);

    /// Looks at the simplex between m+1 points, one per row, with orientation 1 or -1 relative to
    /// their order.
    void look_at(const DenseMatrix& corners, int orientation);

    double volume() const { return volume_; }

    /// The inverse star at m-j vectors in the plane, one per row: one value per coefficient of the
    /// form, at dx_I with I in lexicographic order.
    Eigen::RowVectorXd at(const DenseMatrix& vectors) const;

    /// Its integrals over the faces of degree m-j, oriented by the order of the points: one row per
    /// face, in the order of subsets(m+1, m-j+1).
    DenseMatrix over_faces() const;

private:
    int m_, j_;
    ExteriorProduct minors_, tangents_;
    std::vector<std::vector<int>> faces_, axes_; // axes of j-forms in the plane
    DenseMatrix corners_, frame_, wedge_;        // an orthonormal frame; e_1 ^ .. ^ form by axes
    double volume_ = 0;
};

/// Integrals over the k-simplices, k = n-j, of the inverse star of a form with coefficients (t, s)
/// on simplex s in the plane of n-simplex t: means over t by volume. Size size(k). `corners`: the
/// rows of points of the corners of each n-simplex.
Vector inverse_star_means(const Pieces& complex, const Points& points, const Simplices& corners,
                          int j,
                          const std::function<Eigen::RowVectorXd(Index t, Index s)>& coefficients);

} // namespace polydec
