// SPDX-License-Identifier: MIT
#include "complex/incidence_rows.h"

#include <algorithm>
#include <utility>

namespace polydec {

IncidenceRows::IncidenceRows(Index cells, Index faces, Index sides)
    : rows_(cells, faces), counts_(static_cast<std::size_t>(faces), 0) {
    rows_.resizeNonZeros(sides);
    faces_ = rows_.innerIndexPtr();
    signs_ = rows_.valuePtr();
}

void IncidenceRows::add_up() {
    std::vector<SignedFace> sides;
    for (Index i = begin_; i < end_; ++i)
        sides.push_back({faces_[i], signs_[i]});
    std::sort(sides.begin(), sides.end(),
              [](const SignedFace& a, const SignedFace& b) { return a.face < b.face; });
    end_ = begin_;
    for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
        SignedFace sum{sides[i].face, 0};
        for (; j < sides.size() && sides[j].face == sum.face; ++j)
            sum.sign += sides[j].sign;
        if (sum.sign != 0) {
            faces_[end_] = sum.face;
            signs_[end_++] = static_cast<std::int8_t>(sum.sign);
        } else {
            canceled_.push_back({cell_, sum.face});
        }
    }
    are_ascending_ = true;
}

Coboundary IncidenceRows::finish() {
    rows_.resizeNonZeros(end_);
    return {Incidences(std::move(rows_)), counts_, std::move(canceled_)};
}

} // namespace polydec
