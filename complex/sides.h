// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

#include <array>
#include <cstdlib>
#include <vector>

namespace polydec {

/// The two n-simplices at each facet that has exactly two cofaces.
class Sides {
public:
    explicit Sides(const Pieces& pieces)
        : sides_(static_cast<std::size_t>(pieces.size(pieces.dimension() - 1)), {0, 0}) {
        const int n = pieces.dimension();
        const CofaceCounts& counts = pieces.coface_counts(n - 1);
        const FaceTable faces = pieces.faces(n);
        const Index size = pieces.size(n);
        for (Index t = 0; t < size; ++t) {
            Index side = pieces.sign(n, t, 0) * (t + 1);
            for (int i = 0; i <= n; ++i, side = -side) {
                const Index f = faces(t, i);
                if (auto& [first, second] = sides_[f]; first == 0)
                    first = side;
                else if (counts[f] == 2)
                    second = side;
            }
        }
    }

    /// Whether the facet has two cofaces.
    bool exist(Index facet) const { return sides_[facet][1] != 0; }

    Index first(Index facet) const { return std::abs(sides_[facet][0]) - 1; }
    Index second(Index facet) const { return std::abs(sides_[facet][1]) - 1; }

    /// 1 if both are oriented alike, so that they induce opposite orientations of the facet.
    int relative_sign(Index facet) const {
        return (sides_[facet][0] ^ sides_[facet][1]) < 0 ? 1 : -1;
    }

private:
    std::vector<std::array<Index, 2>>
        sides_; // number + 1, with the sign of the facet in it; or 0: none, or more
};

} // namespace polydec
