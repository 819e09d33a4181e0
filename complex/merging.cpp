// SPDX-License-Identifier: MIT
#include "complex/merging.h"

#include "base/checks.h"
#include "base/lists.h"
#include "complex/blocks.h"
#include "complex/incidence_rows.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

namespace polydec {

namespace {

using Carriers = std::vector<std::vector<Merging::Carrier>>;

/// What is known of the cells of one degree once they have numbers.
struct Numbered {
    Index cells = 0, sides = 0;           // sides: of the cells one degree up, at these
    std::vector<std::uint8_t> is_first{}; // 1 for the simplices that are first pieces
};

/// Numbers the blocks of degree k in the order of their first pieces, which stood for them.
Numbered number_blocks(Carriers& carriers, const CofaceCounts& active_cofaces, int k) {
    auto& own = carriers[k];
    const auto size = static_cast<Index>(own.size());
    Index cells = 0, sides = 0;
    std::vector<std::uint8_t> is_first(own.size(), 0);
    for (Index s = 0; s < size; ++s) {
        auto& [dimension, cell] = own[s];
        if (dimension == k && cell == s) {
            cell = cells++;
            sides += active_cofaces[s];
            is_first[s] = 1;
        } else {
            cell = carriers[dimension][cell].cell;
        }
    }
    return {cells, sides, std::move(is_first)};
}

/// dia_k: the pieces of each cell are filled in by counting, so they come out ascending.
IncidenceMatrix make_diamond(const std::vector<Merging::Carrier>& own,
                             const std::vector<std::int8_t>& signs, Index cells, int k) {
    IncidenceMatrix diamond(cells, static_cast<Index>(own.size()));
    Index* const begin = diamond.outerIndexPtr();
    for (const auto& [dimension, cell] : own)
        if (dimension == k)
            ++begin[cell + 1];
    std::partial_sum(begin, begin + cells + 1, begin);
    diamond.resizeNonZeros(begin[cells]);
    Index* const pieces = diamond.innerIndexPtr();
    std::int8_t* const values = diamond.valuePtr();
    std::vector<Index> next(begin, begin + cells);
    for (std::size_t s = 0; s < own.size(); ++s)
        if (own[s].dimension == k) {
            const Index place = next[own[s].cell]++;
            pieces[place] = static_cast<Index>(s);
            values[place] = signs[s];
        }
    return diamond;
}

/// d^P_k. All pieces of a k-cell have the same merged cofaces, so its first piece tells: d^P(E, F)
/// is the sum over the pieces t of E around it of sign(t) [t : piece] sign(piece).
Coboundary merge_degree(const Pieces& complex, const std::vector<Merging::Carrier>& carriers,
                        const Numbered& lower, const IncidenceMatrix& upper, int k) {
    const auto cells = static_cast<Index>(upper.rows());
    IncidenceRows rows(cells, lower.cells, lower.sides);
    const FaceTable faces = complex.faces(k + 1);
    const Index *const begins = upper.outerIndexPtr(), *const pieces = upper.innerIndexPtr();
    const std::int8_t* const signs = upper.valuePtr();
    const std::uint8_t* const is_first = lower.is_first.data();
    for (Index cell = 0; cell < cells; ++cell) {
        for (Index p = begins[cell]; p < begins[cell + 1]; ++p) {
            const Index t = pieces[p];
            int sign = signs[p] * complex.sign(k + 1, t, k + 1);
            for (int i = k + 1; i >= 0; --i, sign = -sign)
                if (const Index s = faces(t, i); is_first[s] != 0)
                    rows.add(carriers[s].cell, sign);
        }
        rows.end_cell();
    }
    return rows.finish();
}

} // namespace

Merging::Merging(Pieces pieces, CellComplex merged, std::vector<std::vector<Carrier>> carriers,
                 std::vector<IncidenceMatrix> diamonds)
    : pieces_(std::move(pieces)),
      is_identity_(false),
      maps_(std::make_shared<Lazy<Maps>>(Maps{std::move(carriers), std::move(diamonds)})),
      merged_(std::move(merged)) {}

Merging::Merging(Pieces pieces, Blocks blocks) : Merging(std::move(pieces)) {
    const int n = pieces_.dimension();
    Carriers carriers = std::move(blocks.carriers);
    std::vector<IncidenceMatrix> diamonds(carriers.size());
    std::vector<Coboundary> coboundaries;
    for (int k = n; k >= 0; --k) {
        const Numbered numbered = number_blocks(carriers, blocks.active_cofaces[k], k);
        IncidenceMatrix diamond = make_diamond(carriers[k], blocks.signs[k], numbered.cells, k);
        diamonds[k].swap(diamond);
        if (k < n)
            coboundaries.insert(coboundaries.begin(),
                                merge_degree(pieces_, carriers[k], numbered, diamonds[k + 1], k));
    }
    *this = Merging(pieces_, CellComplex(CellComplex::Unchecked{}, std::move(coboundaries)),
                    std::move(carriers), std::move(diamonds));
}

std::vector<Index> Merging::vertices(int k, Index cell) const {
    check_number(fmt::format("{}-cell", k), cell, 0, merged_.size(k) - 1);
    std::vector<Index> list;
    const auto pieces = is_identity_ ? std::span(&cell, 1) : pieces_of(k, cell); // without maps
    for (const Index s : pieces) {
        const auto simplex = pieces_.simplices(k).row(s);
        list.insert(list.end(), simplex.begin(), simplex.end());
    }
    sort_unique(list);
    return list;
}

Merging::Merging(Pieces pieces)
    : pieces_(std::move(pieces)),
      is_identity_(true),
      maps_(std::make_shared<Lazy<Maps>>()),
      merged_(pieces_) {}

Merging::Maps Merging::identity() const {
    Maps maps;
    maps.diamonds.resize(pieces_.dimension() + 1);
    for (int k = 0; k <= pieces_.dimension(); ++k) {
        auto& own = maps.carriers.emplace_back(static_cast<std::size_t>(pieces_.size(k)));
        for (Index s = 0; s < pieces_.size(k); ++s)
            own[s] = {k, s};
        maps.diamonds[k].resize(pieces_.size(k), pieces_.size(k));
        maps.diamonds[k].setIdentity();
    }
    return maps;
}

} // namespace polydec
