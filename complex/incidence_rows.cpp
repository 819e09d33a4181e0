// SPDX-License-Identifier: MIT
#include "complex/incidence_rows.h"

#include <algorithm>
#include <utility>

namespace polydec {

IncidenceRows::IncidenceRows(Index cells, Index faces, Index sides)
    : rows_(cells, faces), counts_(static_cast<std::size_t>(faces), 0) {
    rows_.resizeNonZeros(sides);
}

void IncidenceRows::end_cell() {
    // those of a single simplex are sorted already, those of a few nearly so
    const auto comes_before = [](const SignedFace& a, const SignedFace& b) {
        return a.face < b.face;
    };
    if (!std::is_sorted(sides_.begin(), sides_.end(), comes_before))
        std::sort(sides_.begin(), sides_.end(), comes_before);
    for (std::size_t i = 0, j = 0; i < sides_.size(); i = j) {
        SignedFace sum{sides_[i].face, 0};
        for (; j < sides_.size() && sides_[j].face == sum.face; ++j)
            sum.sign += sides_[j].sign;
        if (sum.sign != 0) {
            rows_.innerIndexPtr()[end_] = sum.face;
            rows_.valuePtr()[end_++] = static_cast<std::int8_t>(sum.sign);
        } else {
            canceled_.push_back({cell_, sum.face});
        }
    }
    rows_.outerIndexPtr()[++cell_] = end_;
    sides_.clear();
}

void IncidenceRows::finish(IncidenceMatrix& coboundary, CofaceCounts& coface_counts,
                           std::vector<Incidence>& canceled) {
    rows_.resizeNonZeros(end_);
    coboundary.swap(rows_);
    coface_counts = counts_;
    canceled = std::move(canceled_);
}

} // namespace polydec
