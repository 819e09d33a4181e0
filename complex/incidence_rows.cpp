// SPDX-License-Identifier: MIT
#include "complex/incidence_rows.h"

#include <algorithm>
#include <utility>

namespace polydec {

IncidenceRows::IncidenceRows(Index cells, Index faces, std::size_t expected)
    : counts_(static_cast<std::size_t>(faces), 0), cells_(cells) {
    ends_.reserve(static_cast<std::size_t>(cells) + 1);
    columns_.reserve(expected);
    signs_.reserve(expected);
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
            columns_.push_back(sum.face);
            signs_.push_back(static_cast<std::int8_t>(sum.sign));
        } else {
            canceled_.push_back({static_cast<Index>(ends_.size()) - 1, sum.face});
        }
    }
    ends_.push_back(static_cast<Index>(columns_.size()));
    sides_.clear();
}

void IncidenceRows::finish(IncidenceMatrix& coboundary, CofaceCounts& coface_counts,
                           std::vector<Incidence>& canceled) {
    IncidenceMatrix rows(cells_, static_cast<Index>(counts_.size()));
    rows.resizeNonZeros(static_cast<Index>(columns_.size()));
    std::copy(columns_.begin(), columns_.end(), rows.innerIndexPtr());
    std::copy(signs_.begin(), signs_.end(), rows.valuePtr());
    std::copy(ends_.begin(), ends_.end(), rows.outerIndexPtr());
    coboundary.swap(rows);
    coface_counts = counts_;
    canceled = std::move(canceled_);
}

} // namespace polydec
