// SPDX-License-Identifier: MIT
#include "complex/homology.h"

#include "complex/components.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

constexpr std::int64_t prime = 2147483647;

std::int64_t inverse_mod_prime(std::int64_t a) {
    std::int64_t result = 1;
    for (std::int64_t power = prime - 2; power > 0; power /= 2, a = a * a % prime)
        if (power % 2 == 1)
            result = result * a % prime;
    return result;
}

/// Coreduction: which cells are left when no cell has exactly one remaining face.
class Reduction {
public:
    explicit Reduction(const CellComplex& complex) : complex_(complex) {
        const int n = complex.dimension();
        for (int k = 0; k <= n; ++k) {
            alive_.emplace_back(complex.size(k), true);
            cofaces_.push_back(k < n ? complex.boundary(k + 1) : IncidenceMatrix());
            auto& count = faces_left_.emplace_back(complex.size(k), 0);
            for (Index t = 0; k > 0 && t < complex.size(k); ++t)
                count[t] = complex.coboundary(k - 1).outerIndexPtr()[t + 1] -
                           complex.coboundary(k - 1).outerIndexPtr()[t];
        }
        remove_one_vertex_per_component();
        while (!queue_.empty()) {
            const auto [k, t] = queue_.front();
            queue_.pop_front();
            pair_with_last_face(k, t);
        }
    }

    Index components() const { return components_; }
    const std::vector<bool>& alive(int k) const { return alive_[k]; }

private:
    void remove_one_vertex_per_component() {
        const auto parts = polydec::components(complex_);
        components_ = parts.count;
        std::vector<bool> seen(parts.count, false);
        for (Index v = 0; v < complex_.size(0); ++v) {
            const auto part = parts.of_vertex[v];
            if (!seen[part])
                remove(0, v);
            seen[part] = true;
        }
    }

    void remove(int k, Index s) {
        alive_[k][s] = false;
        if (k == complex_.dimension())
            return;
        for (Row t(cofaces_[k], s); t; ++t) {
            const auto cell = static_cast<Index>(t.col());
            if (--faces_left_[k + 1][cell] == 1)
                queue_.emplace_back(k + 1, cell);
        }
    }

    void pair_with_last_face(int k, Index t) {
        if (!alive_[k][t] || faces_left_[k][t] != 1)
            return;
        for (Row s(complex_.coboundary(k - 1), t); s; ++s) {
            // only an incidence that is invertible over the integers may cancel
            if (!alive_[k - 1][s.col()] || std::abs(s.value()) != 1)
                continue;
            remove(k - 1, static_cast<Index>(s.col()));
            remove(k, t);
            return;
        }
    }

    const CellComplex& complex_;
    Index components_ = 0;
    std::vector<std::vector<bool>> alive_;
    std::vector<std::vector<Index>> faces_left_;
    std::vector<IncidenceMatrix> cofaces_;
    std::deque<std::pair<int, Index>> queue_;
};

using Column = std::vector<std::pair<Index, std::int64_t>>; // ascending rows, values mod prime

/// column - factor * pivot
Column subtract(const Column& column, std::int64_t factor, const Column& pivot) {
    Column result;
    auto a = column.begin(), b = pivot.begin();
    while (a != column.end() || b != pivot.end()) {
        if (b == pivot.end() || (a != column.end() && a->first < b->first)) {
            result.push_back(*a++);
            continue;
        }
        const bool both = a != column.end() && a->first == b->first;
        const auto value = ((both ? a->second : 0) + (prime - factor) * b->second) % prime;
        if (value != 0)
            result.emplace_back(b->first, value);
        a += both ? 1 : 0;
        ++b;
    }
    return result;
}

/// Rank of the rows and columns of D that are alive, modulo the prime. Rows are reduced by earlier
/// rows with the same last entry; a row that already was a pivot one degree below is a boundary
/// and needs no reduction (`skip`). Marks the pivot columns in `pivots`.
Index rank(const IncidenceMatrix& D, const std::vector<bool>& rows,
           const std::vector<bool>& columns, const std::vector<bool>& skip,
           std::vector<bool>& pivots) {
    std::vector<Index> row_of_pivot(D.cols(), -1);
    std::vector<Column> reduced;
    for (Index t = 0; t < D.rows(); ++t) {
        if (!rows[t] || skip[t])
            continue;
        Column row;
        for (Row s(D, t); s; ++s)
            if (columns[s.col()])
                row.emplace_back(static_cast<Index>(s.col()), (s.value() + prime) % prime);
        while (!row.empty() && row_of_pivot[row.back().first] >= 0) {
            const auto& pivot = reduced[row_of_pivot[row.back().first]];
            row = subtract(row, row.back().second, pivot);
        }
        if (row.empty())
            continue;
        const auto scale = inverse_mod_prime(row.back().second);
        for (auto& entry : row)
            entry.second = entry.second * scale % prime;
        pivots[row.back().first] = true;
        row_of_pivot[row.back().first] = static_cast<Index>(reduced.size());
        reduced.push_back(std::move(row));
    }
    return static_cast<Index>(reduced.size());
}

} // namespace

std::vector<Index> betti_numbers(const CellComplex& complex) {
    const int n = complex.dimension();
    const Reduction reduction(complex);

    std::vector<Index> betti(n + 1), ranks(n + 2, 0); // ranks[k]: of the boundary of k-cells
    std::vector<bool> is_pivot(complex.size(n), false);
    for (int k = n; k > 0; --k) {
        std::vector<bool> pivots(complex.size(k - 1), false);
        ranks[k] = rank(complex.coboundary(k - 1), reduction.alive(k), reduction.alive(k - 1),
                        is_pivot, pivots);
        is_pivot = std::move(pivots);
    }
    for (int k = 0; k <= n; ++k) {
        const auto& alive = reduction.alive(k);
        const auto left = static_cast<Index>(std::count(alive.begin(), alive.end(), true));
        betti[k] = left - ranks[k] - ranks[k + 1];
    }
    betti[0] += reduction.components();
    return betti;
}

} // namespace polydec
