// SPDX-License-Identifier: MIT
#include "complex/homology.h"

#include "base/errors.h"
#include "complex/coreduction.h"
#include "complex/elimination.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace polydec {

namespace {

using IntegerChain = std::map<Index, std::int64_t>;

void check_degree(const CellComplex& complex, int k) {
    if (k < 0 || k > complex.dimension())
        throw InvalidInput(
            fmt::format("homology of degree {} does not exist in dimension {}: expected 0 to {}", k,
                        complex.dimension(), complex.dimension()));
}

/// A chain with coefficients modulo the prime, as the smallest multiple of it whose coefficients
/// are small integers.
IntegerChain integral(const ModularChain& chain) {
    constexpr std::int64_t small = 1000000;
    for (std::int64_t factor = 1; factor < 1000; ++factor) {
        IntegerChain result;
        for (const auto& [cell, value] : chain) {
            const auto residue = factor * value % elimination_prime;
            const auto integer =
                residue > elimination_prime / 2 ? residue - elimination_prime : residue;
            if (std::abs(integer) > small)
                break;
            result[cell] = integer;
        }
        if (result.size() == chain.size())
            return result;
    }
    throw InvalidInput("a generator of the homology has coefficients above a million: check the "
                       "incidences of the complex");
}

/// Carries a cycle of the core back to the whole complex: pairs come back in the reverse order of
/// leaving, and each coface is added as often as makes its face cancel.
class Embedding {
public:
    Embedding(const CellComplex& complex, const Coreduction& reduction, int k)
        : D_(complex.incidences(k - 1)), pairs_(reduction.pairs(k - 1)) {
        order_.assign(D_.cols(), -1);
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            order_[pairs_[i].face] = static_cast<Index>(i);
    }

    IntegerChain operator()(IntegerChain chain) const {
        IntegerChain left; // coefficient of the boundary at the face of each pair, by its number
        for (const auto& [cell, coefficient] : chain)
            add_boundary(cell, coefficient, left);
        while (!left.empty()) {
            const auto [i, coefficient] = *left.rbegin();
            const auto [face, coface] = pairs_[i];
            const std::int64_t factor = -coefficient * D_.sign(coface, face);
            chain[coface] += factor;
            add_boundary(coface, factor, left);
        }
        return chain;
    }

private:
    void add_boundary(Index cell, std::int64_t factor, IntegerChain& left) const {
        for (const auto& [face, sign] : D_[cell]) {
            const Index i = order_[face];
            // faces that did not leave as faces of a pair cancel by themselves
            if (i >= 0 && (left[i] += factor * sign) == 0)
                left.erase(i);
        }
    }

    const Incidences& D_;
    const std::vector<Coreduction::Pair>& pairs_;
    std::vector<Index> order_;
};

} // namespace

std::vector<Index> betti_numbers(const CellComplex& complex) {
    const int n = complex.dimension();
    const Coreduction reduction(complex);
    const CoreElimination core(complex, reduction);
    std::vector<Index> betti(n + 1);
    for (int k = 0; k <= n; ++k) {
        const auto& cells = reduction.core(k);
        const auto left = static_cast<Index>(std::count(cells.begin(), cells.end(), true));
        betti[k] = left - core.rank(k - 1) - core.rank(k);
    }
    betti[0] += static_cast<Index>(reduction.base_vertices().size());
    return betti;
}

SparseMatrix homology_generators(const CellComplex& complex, int k) {
    check_degree(complex, k);
    const Coreduction reduction(complex);
    const CoreElimination core(complex, reduction, k);
    std::vector<Eigen::Triplet<double, Index>> entries;
    Index count = 0;
    for (const Index v : reduction.base_vertices())
        if (k == 0)
            entries.emplace_back(v, count++, 1.0);

    const Embedding embed(complex, reduction, k);
    for (const auto& cycle : core.cycles()) {
        for (const auto& [cell, coefficient] : embed(integral(cycle)))
            if (coefficient != 0)
                entries.emplace_back(cell, count, static_cast<double>(coefficient));
        ++count;
    }
    SparseMatrix generators(complex.size(k), count);
    generators.setFromTriplets(entries.begin(), entries.end());
    return generators;
}

RegularMinor regular_minor(const CellComplex& complex, int k) {
    check_degree(complex, k);
    const Coreduction reduction(complex);
    const CoreElimination core(complex, reduction);
    RegularMinor minor{core.pivot_columns(k), core.pivot_rows(k)};
    for (const auto& [face, coface] : reduction.pairs(k)) {
        minor.columns.push_back(face);
        minor.rows.push_back(coface);
    }
    std::sort(minor.columns.begin(), minor.columns.end());
    std::sort(minor.rows.begin(), minor.rows.end());
    return minor;
}

} // namespace polydec
