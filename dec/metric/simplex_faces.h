// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

#include <vector>

namespace polydec {

/// The k-faces of one m-simplex at a time, in the order of subsets(m+1, k+1): the position of a
/// face in the list determines its vertices among the simplex's ascending vertices. Keeps a
/// reference to the complex, which must outlive it. 0 <= k <= m.
class SimplexFaces {
public:
    SimplexFaces(const Pieces& complex, int m, int k);

    /// The numbers of the k-faces of m-simplex s; valid until the next call. Time
    /// O((m-k) C(m+1, k+1)).
    const std::vector<Index>& of(Index s);

    /// The vertices of the m-simplex that each face has: subsets(m+1, k+1).
    const std::vector<std::vector<int>>& positions() const { return positions_; }

    /// The other vertices, ascending too.
    const std::vector<std::vector<int>>& omitted() const { return omitted_; }

private:
    std::vector<FaceTable> tables_; // of degrees m, m-1, .., k+1
    std::vector<std::vector<int>> positions_, omitted_;
    std::vector<Index> faces_;
};

} // namespace polydec
