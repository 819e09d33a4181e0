// SPDX-License-Identifier: MIT
#include "dec/metric/simplex_faces.h"

#include "dec/metric/subsets.h"

namespace polydec {

SimplexFaces::SimplexFaces(const Pieces& complex, int m, int k)
    : positions_(subsets(m + 1, k + 1)), faces_(positions_.size()) {
    for (int degree = m; degree > k; --degree)
        tables_.push_back(complex.faces(degree));
    for (const auto& kept : positions_)
        omitted_.push_back(complement(m + 1, kept));
}

const std::vector<Index>& SimplexFaces::of(Index s) {
    // last vertices first, so the positions of the others stay valid
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        Index face = s;
        auto table = tables_.begin();
        for (auto v = omitted_[i].rbegin(); v != omitted_[i].rend(); ++v)
            face = (*table++)(face, *v);
        faces_[i] = face;
    }
    return faces_;
}

} // namespace polydec
