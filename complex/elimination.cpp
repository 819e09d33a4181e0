// SPDX-License-Identifier: MIT
#include "complex/elimination.h"

namespace polydec {

namespace {

constexpr std::int64_t prime = elimination_prime;

std::int64_t inverse_mod_prime(std::int64_t a) {
    std::int64_t result = 1;
    for (std::int64_t power = prime - 2; power > 0; power /= 2, a = a * a % prime)
        if (power % 2 == 1)
            result = result * a % prime;
    return result;
}

/// a - factor * b
ModularChain subtract(const ModularChain& a, std::int64_t factor, const ModularChain& b) {
    ModularChain result;
    auto i = a.begin();
    auto j = b.begin();
    while (i != a.end() || j != b.end()) {
        if (j == b.end() || (i != a.end() && i->first < j->first)) {
            result.push_back(*i++);
            continue;
        }
        const bool both = i != a.end() && i->first == j->first;
        const auto value = ((both ? i->second : 0) + (prime - factor) * j->second) % prime;
        if (value != 0)
            result.emplace_back(j->first, value);
        i += both ? 1 : 0;
        ++j;
    }
    return result;
}

/// A boundary under reduction, and the combination of cells that it is the boundary of.
struct Reduced {
    ModularChain boundary, cells;
};

ModularChain core_boundary(const Incidences& D, Index t, const std::vector<bool>& core) {
    ModularChain boundary;
    for (const auto& [face, sign] : D[t])
        if (core[face])
            boundary.emplace_back(face, (sign + prime) % prime);
    return boundary;
}

void scale_last_to_one(Reduced& row) {
    const auto scale = inverse_mod_prime(row.boundary.back().second);
    for (auto* chain : {&row.boundary, &row.cells})
        for (auto& entry : *chain)
            entry.second = entry.second * scale % prime;
}

} // namespace

CoreElimination::CoreElimination(const CellComplex& complex, const Coreduction& reduction,
                                 int cycles_of)
    : columns_(complex.dimension() + 2), rows_(complex.dimension() + 2) {
    for (int k = complex.dimension(); k >= 0; --k)
        eliminate(complex, reduction, k, k == cycles_of);
}

/// Reduces the boundaries of the k-cells of the core.
void CoreElimination::eliminate(const CellComplex& complex, const Coreduction& reduction, int k,
                                bool keep_cycles) {
    const Incidences& D = complex.incidences(k - 1);
    const std::vector<bool> none;
    const auto& faces = k > 0 ? reduction.core(k - 1) : none;
    std::vector<bool> is_boundary(complex.size(k), false);
    for (const Index t : pivot_columns(k))
        is_boundary[t] = true;

    std::vector<Index> row_of_pivot(D.cols(), -1);
    std::vector<Reduced> reduced;
    for (Index t = 0; t < complex.size(k); ++t) {
        if (!reduction.core(k)[t] || is_boundary[t])
            continue;
        Reduced row{core_boundary(D, t, faces), {}};
        if (keep_cycles)
            row.cells.emplace_back(t, 1);
        while (!row.boundary.empty() && row_of_pivot[row.boundary.back().first] >= 0) {
            const auto& pivot = reduced[row_of_pivot[row.boundary.back().first]];
            const auto factor = row.boundary.back().second;
            row = {subtract(row.boundary, factor, pivot.boundary),
                   subtract(row.cells, factor, pivot.cells)};
        }
        if (row.boundary.empty()) {
            if (keep_cycles)
                cycles_.push_back(std::move(row.cells));
            continue;
        }
        scale_last_to_one(row);
        const Index pivot = row.boundary.back().first;
        row_of_pivot[pivot] = static_cast<Index>(reduced.size());
        reduced.push_back(std::move(row));
        columns_[k].push_back(pivot);
        rows_[k].push_back(t);
    }
}

} // namespace polydec
