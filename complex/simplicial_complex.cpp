// SPDX-License-Identifier: MIT
#include "complex/simplicial_complex.h"

#include "base/errors.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "complex/disjoint_sets.h"
#include "complex/faces.h"
#include "complex/size_estimate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace polydec {

namespace {

/// So many simplices are one piece of work.
constexpr Index part_size = 1 << 14;

std::span<const Index> row(const Simplices& table, Index i) {
    return {table.data() + i * table.cols(), static_cast<std::size_t>(table.cols())};
}

/// As std::ranges::equal, which is slow for a handful of numbers.
bool same(std::span<const Index> a, std::span<const Index> b) {
    std::size_t i = 0;
    while (i < a.size() && a[i] == b[i])
        ++i;
    return i == a.size();
}

/// Sorts the list; 1 or -1 is the sign of the permutation that did it.
std::int8_t sort_with_sign(std::span<Index> list) {
    std::int8_t sign = 1;
    for (std::size_t i = 1; i < list.size(); ++i) {
        for (std::size_t j = i; j > 0 && list[j] < list[j - 1]; --j) {
            std::swap(list[j], list[j - 1]);
            sign = static_cast<std::int8_t>(-sign);
        }
    }
    return sign;
}

struct SortedTops {
    Simplices simplices;
    std::vector<Index> input_rows;
    std::vector<std::int8_t> signs; // of the input's order against the ascending one
};

void check_tops(const SortedTops& tops, Index begin, Index end) {
    const auto n = static_cast<int>(tops.simplices.cols()) - 1;
    for (Index s = begin; s < end; ++s) {
        const auto list = row(tops.simplices, s);
        if (std::adjacent_find(list.begin(), list.end()) != list.end())
            throw InvalidInput(fmt::format("cell {} has a repeated corner: its vertices are {}",
                                           tops.input_rows[s], fmt::join(list, ", ")),
                               {.degree = n,
                                .cells = {tops.input_rows[s]},
                                .vertices = {list.begin(), list.end()}});
        if (s > 0 && same(row(tops.simplices, s - 1), list))
            throw InvalidInput(
                fmt::format("cells {} and {} have the same vertices {}: remove one of them",
                            tops.input_rows[s - 1], tops.input_rows[s], fmt::join(list, ", ")),
                {.degree = n,
                 .cells = {tops.input_rows[s - 1], tops.input_rows[s]},
                 .vertices = {list.begin(), list.end()}});
    }
}

SortedTops sort_tops(Simplices tops) {
    if (tops.rows() == 0 || tops.cols() < 2)
        throw InvalidInput(
            "a simplicial complex needs at least one simplex of dimension 1 or more");
    if (tops.minCoeff() < 0)
        throw InvalidInput(fmt::format("vertex number {}: expected 0 or more", tops.minCoeff()),
                           {.vertices = {tops.minCoeff()}});
    if (tops.maxCoeff() == std::numeric_limits<Index>::max())
        throw InvalidInput(
            fmt::format("vertex number {}: expected less than that", tops.maxCoeff()),
            {.vertices = {tops.maxCoeff()}});

    std::vector<std::int8_t> signs(tops.rows());
    for_each_part(static_cast<Index>(tops.rows()), part_size, [&](Index begin, Index end) {
        for (Index s = begin; s < end; ++s)
            signs[s] = sort_with_sign({&tops(s, 0), static_cast<std::size_t>(tops.cols())});
    });

    auto [rows, order] = sorted_rows(tops);
    SortedTops sorted{std::move(rows), std::move(order), std::vector<std::int8_t>(signs.size())};
    for_each_part(static_cast<Index>(signs.size()), part_size, [&](Index begin, Index end) {
        for (Index s = begin; s < end; ++s)
            sorted.signs[s] = signs[sorted.input_rows[s]];
        check_tops(sorted, begin, end);
    });
    return sorted;
}

Index count_vertices(const Simplices& tops) {
    std::vector<bool> used(static_cast<std::size_t>(tops.maxCoeff()) + 1, false);
    for (const Index vertex : tops.reshaped())
        used[vertex] = true;
    return static_cast<Index>(std::count(used.begin(), used.end(), true));
}

/// A simplex has 2^(n+1) faces: a short file can ask for more than any machine has.
void check_cost(const Simplices& tops) {
    const auto n = static_cast<int>(tops.cols()) - 1;
    const auto simplices = static_cast<Index>(tops.rows());
    const auto size = estimate_size(n, simplices, count_vertices(tops));
    check_memory(size.bytes(),
                 fmt::format("a complex of {} simpl{} of dimension {}, of about "
                             "{:.2g} cells of all degrees,",
                             simplices, simplices == 1 ? "ex" : "ices", n, size.cells));
}

struct Orientation {
    std::vector<std::int8_t> signs;
    bool coherent = true;
    Index turned = 0;
};

/// Whether neighbors across facets with two cofaces have opposite signs there already.
bool is_coherent(const IncidenceMatrix& D, const std::vector<Index>& coface_counts,
                 const std::vector<std::int8_t>& signs) {
    std::vector<std::int8_t> sum(coface_counts.size(), 0);
    for (Index t = 0; t < D.rows(); ++t)
        for (IncidenceMatrix::InnerIterator f(D, t); f; ++f)
            sum[f.col()] = static_cast<std::int8_t>(sum[f.col()] + f.value() * signs[t]);
    for (std::size_t f = 0; f < sum.size(); ++f)
        if (coface_counts[f] == 2 && sum[f] != 0)
            return false;
    return true;
}

/// Signs of the tops, coherent across facets with exactly two cofaces wherever that is possible:
/// in each part connected by such facets the given signs or their opposites, whichever turns
/// fewer. A part that cannot be oriented keeps what was given.
Orientation orient(const IncidenceMatrix& D, const std::vector<Index>& coface_counts,
                   const std::vector<std::int8_t>& given) {
    if (is_coherent(D, coface_counts, given))
        return {given};
    const auto tops = static_cast<Index>(given.size());
    DisjointSets parts(tops);
    std::vector<Index> first(coface_counts.size(), -1), conflicts;
    for (Index t = 0; t < tops; ++t) {
        for (IncidenceMatrix::InnerIterator f(D, t); f; ++f) {
            if (coface_counts[f.col()] != 2)
                continue;
            if (const Index other = first[f.col()]; other < 0)
                first[f.col()] = t;
            else if (!parts.join(t, other, -f.value() * D.coeff(other, f.col())))
                conflicts.push_back(t);
        }
    }

    std::vector<Index> balance(tops, 0); // at roots: agreeing minus disagreeing, 0 if one-sided
    for (Index t = 0; t < tops; ++t) {
        const auto root = parts.find(t);
        balance[root.element] += root.sign * given[t];
    }
    std::vector<bool> one_sided(tops, false);
    for (const Index t : conflicts)
        one_sided[parts.find(t).element] = true;

    Orientation result{given, conflicts.empty(), 0};
    for (Index t = 0; t < tops; ++t) {
        const auto root = parts.find(t);
        if (one_sided[root.element])
            continue;
        // a tie is decided by the part's first cell, so that it does not depend on the root
        if (balance[root.element] == 0)
            balance[root.element] = root.sign * given[t];
        const int sign = balance[root.element] > 0 ? root.sign : -root.sign;
        result.turned += sign != given[t];
        result.signs[t] = static_cast<std::int8_t>(sign);
    }
    return result;
}

} // namespace

SimplicialComplex::Sorted SimplicialComplex::sorted(const Simplices& tops) {
    auto sorted = sort_tops(tops);
    check_cost(sorted.simplices);
    const auto n = static_cast<int>(tops.cols()) - 1;
    std::vector<Simplices> simplices(n + 1);
    simplices[n] = std::move(sorted.simplices);

    std::vector<IncidenceMatrix> coboundaries(n);
    std::vector<std::vector<Index>> counts(n);
    for (int k = n - 1; k >= 0; --k) {
        auto faces = faces_of(simplices[k + 1]);
        coboundaries[k].swap(faces.coboundary);
        simplices[k] = std::move(faces.simplices);
        counts[k] = std::move(faces.counts);
    }

    auto orientation = orient(coboundaries[n - 1], counts[n - 1], sorted.signs);
    std::int8_t* sign = coboundaries[n - 1].valuePtr();
    for (const std::int8_t turn : orientation.signs)
        for (int i = 0; i <= n; ++i, ++sign)
            *sign = static_cast<std::int8_t>(*sign * turn);
    CellComplex cells(Unchecked{}, std::move(coboundaries), std::move(counts));
    return {Pieces(Unchecked{}, std::move(cells), std::move(simplices),
                   std::move(orientation.signs), orientation.coherent),
            std::move(sorted.input_rows), orientation.turned};
}

SimplicialComplex::SimplicialComplex(const Simplices& tops) : SimplicialComplex(sorted(tops)) {}

SimplicialComplex::SimplicialComplex(Sorted sorted)
    : Pieces(std::move(sorted.pieces)),
      input_rows_(std::make_shared<const std::vector<Index>>(std::move(sorted.input_rows))),
      turned_(sorted.turned) {}

} // namespace polydec
