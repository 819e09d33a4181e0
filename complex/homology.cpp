// SPDX-License-Identifier: MIT
#include "complex/homology.h"

#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Simplifies a complex without changing its homology: starting from one vertex of each component,
/// a cell that is the only remaining face of another is removed together with it. The remaining
/// core is usually a handful of cells. On a closed surface the pairs are a spanning tree of edges
/// and a cotree of faces. Linear time. Source: Mrozek and Batko 2009.
class Coreduction {
public:
    explicit Coreduction(const CellComplex& complex);

    /// A removed pair: a k-cell `face` and a (k+1)-cell `coface` whose only remaining face it was.
    struct Pair {
        Index face, coface;
    };

    /// The pairs of k-cells with (k+1)-cells in the order of removal; none for k = -1, n.
    const std::vector<Pair>& pairs(int k) const { return pairs_.at(k + 1); }

    /// The starting vertices of the components that have a 0-cocycle.
    const std::vector<Index>& base_vertices() const { return base_vertices_; }

    /// Whether each k-cell belongs to the core.
    const std::vector<bool>& core(int k) const { return alive_.at(k); }

private:
    void remove_base_vertices();
    void remove(int k, Index s);
    void pair_with_last_face(int k, Index t);

    const CellComplex& complex_;
    std::vector<Index> base_vertices_;
    std::vector<std::vector<Pair>> pairs_; // at k + 1: of k-cells
    std::vector<std::vector<bool>> alive_;
    std::vector<std::vector<Index>> faces_left_;
    std::vector<IncidenceMatrix> cofaces_;
    std::deque<std::pair<int, Index>> queue_;
};

Coreduction::Coreduction(const CellComplex& complex) : complex_(complex) {
    const int n = complex.dimension();
    pairs_.resize(n + 2);
    cofaces_.resize(n + 1);
    for (int k = 0; k <= n; ++k) {
        alive_.emplace_back(complex.size(k), true);
        complex.boundary(k + 1).swap(cofaces_[k]); // Eigen's matrices cannot be moved
        auto& count = faces_left_.emplace_back(complex.size(k), 0);
        for (Index t = 0; t < complex.size(k); ++t)
            count[t] = complex.incidences(k - 1)[t].size();
    }
    remove_base_vertices();
    for (int k = 1; k <= n; ++k) {
        pairs_[k].reserve(static_cast<std::size_t>(std::min(complex.size(k - 1), complex.size(k))));
        for (Index t = 0; t < complex.size(k); ++t)
            if (faces_left_[k][t] == 1)
                queue_.emplace_back(k, t);
    }
    while (!queue_.empty()) {
        const auto [k, t] = queue_.front();
        queue_.pop_front();
        pair_with_last_face(k, t);
    }
    cofaces_.clear();
}

/// One vertex of each component with a 0-cocycle stands for it. A component has none if an edge
/// has one end only, as in a complex relative to its boundary, or if signs clash around a loop.
void Coreduction::remove_base_vertices() {
    const Incidences& D = complex_.incidences(0);
    DisjointSets parts(complex_.size(0));
    std::vector<Index> without_cocycle;
    for (Index e = 0; e < D.rows(); ++e) {
        const IncidenceRow ends = D[e];
        if (ends.size() != 2 || std::abs(ends[0].sign) != std::abs(ends[1].sign)) {
            for (const SignedFace& v : ends)
                without_cocycle.push_back(v.face);
            continue;
        }
        const int relative_sign = ends[0].sign == ends[1].sign ? -1 : 1;
        if (!parts.join(ends[0].face, ends[1].face, relative_sign))
            without_cocycle.push_back(ends[0].face);
    }

    std::vector<bool> done(complex_.size(0), false); // at roots
    for (const Index v : without_cocycle)
        done[parts.find(v).element] = true;
    for (Index v = 0; v < complex_.size(0); ++v) {
        const auto root = parts.find(v).element;
        if (done[root])
            continue;
        done[root] = true;
        base_vertices_.push_back(v);
        remove(0, v);
    }
}

void Coreduction::remove(int k, Index s) {
    alive_[k][s] = false;
    for (IncidenceMatrix::InnerIterator t(cofaces_[k], s); t; ++t) {
        const auto cell = static_cast<Index>(t.col());
        if (--faces_left_[k + 1][cell] == 1)
            queue_.emplace_back(k + 1, cell);
    }
}

void Coreduction::pair_with_last_face(int k, Index t) {
    if (!alive_[k][t] || faces_left_[k][t] != 1)
        return;
    for (const auto& [face, sign] : complex_.incidences(k - 1)[t]) {
        // only an incidence that is invertible over the integers may cancel
        if (!alive_[k - 1][face] || std::abs(sign) != 1)
            continue;
        pairs_[k].push_back({face, t});
        remove(k - 1, face);
        remove(k, t);
        return;
    }
}

/// Elimination computes modulo this prime, 2^31 - 1: products of residues fit 64 bits.
constexpr std::int64_t prime = 2147483647;

/// A chain with coefficients modulo the prime: ascending cells.
using ModularChain = std::vector<std::pair<Index, std::int64_t>>;

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

/// Sparse elimination of what coreduction leaves of the coboundary matrices. Boundaries of cells
/// are reduced by earlier ones with the same last face. The last face of a reduced boundary one
/// degree above is itself a boundary up to earlier cells, and needs no reduction.
class CoreElimination {
public:
    /// Eliminates in every degree; in degree `cycles_of` it keeps the combinations with zero
    /// boundary.
    CoreElimination(const CellComplex& complex, const Coreduction& reduction, int cycles_of = -1)
        : columns_(complex.dimension() + 2), rows_(complex.dimension() + 2) {
        for (int k = complex.dimension(); k >= 0; --k)
            eliminate(complex, reduction, k, k == cycles_of);
    }

    /// Rank of d_k on the core; 0 for k = -1 and n.
    Index rank(int k) const { return static_cast<Index>(pivot_columns(k).size()); }

    /// k-cells and (k+1)-cells of the core on which d_k attains its rank; ascending rows.
    const std::vector<Index>& pivot_columns(int k) const { return columns_.at(k + 1); }
    const std::vector<Index>& pivot_rows(int k) const { return rows_.at(k + 1); }

    /// Cycles of the core in degree `cycles_of` that span its homology, b_k in number (for k = 0,
    /// minus the base vertices).
    const std::vector<ModularChain>& cycles() const { return cycles_; }

private:
    /// Reduces the boundaries of the k-cells of the core.
    void eliminate(const CellComplex& complex, const Coreduction& reduction, int k,
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

    std::vector<std::vector<Index>> columns_, rows_; // at k + 1: of d_k
    std::vector<ModularChain> cycles_;
};

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
            const auto residue = factor * value % prime;
            const auto integer = residue > prime / 2 ? residue - prime : residue;
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
