// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/simplex_layout.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace polydec {

/// Unit vectors along the heights of two corners over a face. They are orthogonal to the face.
class Heights {
public:
    /// For faces with at most n-1 corners in R^N.
    Heights(int n, Eigen::Index N) : rows_(n, N) {}

    /// The lengths of the sum and the difference of both vectors: 2 cos(a/2) and 2 sin(a/2) for
    /// facets at an angle a. Not a number if a height or an edge of the face is zero.
    struct Lengths {
        double sum, difference;
    };
    Lengths over(std::span<const Index> face, std::array<Index, 2> corners, const Points& points);

    /// Whether n+1 corners have no volume beyond the rounding error, relative to the product of the
    /// edges from one of them.
    bool is_flat(const Corners& corners);

private:
    // N_fixed is N, or -1 for any N
    template <int N_fixed>
    auto row(int i) {
        using Row = Eigen::Matrix<double, N_fixed, 1>;
        return Eigen::Map<Row>(rows_.data() + i * rows_.cols(), rows_.cols());
    }
    template <int N_fixed>
    double place(const Points& points, Index from, Index to, int i);
    template <int N_fixed>
    double orthogonalize(int i, int before, int passes);
    template <int N_fixed>
    Lengths measure(std::span<const Index> face, std::array<Index, 2> corners,
                    const Points& points);

    Points rows_;
};

/// Calls take(t, i, s, angle) for every n-simplex t and its (n-2)-face s, which is number i in
/// SimplexFaces(complex, n, n-2).of(t): the angle between the facets that have s, n >= 2. Omits
/// simplices that are flat to the last digits. Omits s that `around` does not mark; an empty list
/// marks all. Radians.
void for_each_angle(const Pieces& complex, const SimplexMetric& metric,
                    const std::vector<bool>& around,
                    const std::function<void(Index, Index, Index, double)>& take);

/// Sums of the angles of the n-simplices around each (n-2)-simplex, n >= 2: 2 pi in the interior of
/// a flat complex, pi on a plane boundary. Simplices that are flat to the last digits do not
/// contribute. 0 for (n-2)-simplices that `around` does not mark; an empty list marks all. Size
/// size(n-2); radians.
Vector angle_sums(const Pieces& complex, const SimplexMetric& metric,
                  const std::vector<bool>& around = {});

} // namespace polydec
