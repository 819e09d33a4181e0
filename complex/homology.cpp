// SPDX-License-Identifier: MIT
#include "complex/homology.h"

#include "complex/disjoint_sets.h"

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
        remove_base_vertices();
        for (int k = 1; k <= n; ++k)
            for (Index t = 0; t < complex.size(k); ++t)
                if (faces_left_[k][t] == 1)
                    queue_.emplace_back(k, t);
        while (!queue_.empty()) {
            const auto [k, t] = queue_.front();
            queue_.pop_front();
            pair_with_last_face(k, t);
        }
    }

    Index base_vertices() const { return base_vertices_; }
    const std::vector<bool>& alive(int k) const { return alive_[k]; }

private:
    /// One vertex of each component with a 0-cocycle stands for it. A component has none if an edge
    /// has one end only, as in a complex relative to its boundary, or if signs clash around a loop.
    void remove_base_vertices() {
        const IncidenceMatrix& D = complex_.coboundary(0);
        DisjointSets parts(complex_.size(0));
        std::vector<Index> without_cocycle;
        for (Index e = 0; e < D.rows(); ++e) {
            const Row tail(D, e);
            Row head = tail;
            if (!tail || !++head || std::abs(tail.value()) != std::abs(head.value()) ||
                faces_left_[1][e] != 2) {
                for (Row v(D, e); v; ++v)
                    without_cocycle.push_back(static_cast<Index>(v.col()));
                continue;
            }
            const int relative_sign = tail.value() == head.value() ? -1 : 1;
            if (!parts.join(static_cast<Index>(tail.col()), static_cast<Index>(head.col()),
                            relative_sign))
                without_cocycle.push_back(static_cast<Index>(tail.col()));
        }

        std::vector<bool> done(complex_.size(0), false); // at roots
        for (const Index v : without_cocycle)
            done[parts.find(v).element] = true;
        for (Index v = 0; v < complex_.size(0); ++v) {
            const auto root = parts.find(v).element;
            if (done[root])
                continue;
            done[root] = true;
            ++base_vertices_;
            remove(0, v);
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
    Index base_vertices_ = 0;
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
    betti[0] += reduction.base_vertices();
    return betti;
}

} // namespace polydec
