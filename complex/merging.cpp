// SPDX-License-Identifier: MIT
#include "complex/merging.h"

#include "base/checks.h"
#include "complex/blocks.h"
#include "complex/incidence_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;
using Carriers = std::vector<std::vector<Merging::Carrier>>;

bool is_first_piece(const Blocks& blocks, int k, Index s) {
    const auto& [dimension, piece] = blocks.carriers[k][s];
    return dimension == k && piece == s;
}

/// Numbers the blocks of each degree in the order of their first pieces.
Carriers number_blocks(const Pieces& complex, const Blocks& blocks) {
    const int n = complex.dimension();
    Carriers carriers(n + 1);
    for (int k = n; k >= 0; --k) {
        carriers[k].resize(complex.size(k));
        Index next = 0;
        for (Index s = 0; s < complex.size(k); ++s) {
            const auto [dimension, piece] = blocks.carriers[k][s];
            carriers[k][s] = {
                dimension, is_first_piece(blocks, k, s) ? next++ : carriers[dimension][piece].cell};
        }
    }
    return carriers;
}

/// dia_k: the pieces of each cell are filled in by counting, so they come out ascending.
IncidenceMatrix make_diamond(const Carriers& carriers, const Blocks& blocks, int k) {
    const auto& own = carriers[k];
    Index cells = 0, pieces = 0;
    for (const auto& carrier : own)
        if (carrier.dimension == k) {
            cells = std::max(cells, carrier.cell + 1);
            ++pieces;
        }
    IncidenceMatrix diamond(cells, static_cast<Index>(own.size()));
    diamond.resizeNonZeros(pieces);
    Index* const begin = diamond.outerIndexPtr();
    for (const auto& carrier : own)
        if (carrier.dimension == k)
            ++begin[carrier.cell + 1];
    std::partial_sum(begin, begin + cells + 1, begin);
    std::vector<Index> next(begin, begin + cells);
    for (std::size_t s = 0; s < own.size(); ++s)
        if (own[s].dimension == k) {
            const Index place = next[own[s].cell]++;
            diamond.innerIndexPtr()[place] = static_cast<Index>(s);
            diamond.valuePtr()[place] = blocks.signs[k][s];
        }
    return diamond;
}

/// d^P_k. All pieces of a k-cell have the same merged cofaces, so its first piece tells: d^P(E, F)
/// is the sum over the pieces t of E around it of sign(t) [t : piece] sign(piece).
IncidenceRows merge_degree(const Pieces& complex, const Blocks& blocks, const Carriers& carriers,
                           const std::vector<IncidenceMatrix>& diamonds, int k) {
    const IncidenceMatrix& upper = diamonds[k + 1];
    const auto cells = static_cast<Index>(upper.rows());
    Index sides = 0;
    for (Index s = 0; s < complex.size(k); ++s)
        if (is_first_piece(blocks, k, s))
            sides += blocks.active_cofaces[k][s];
    IncidenceRows rows(cells, static_cast<Index>(diamonds[k].rows()), sides);
    const FaceTable faces = complex.faces(k + 1);
    for (Index cell = 0; cell < cells; ++cell) {
        for (Row piece(upper, cell); piece; ++piece) {
            const auto t = static_cast<Index>(piece.col());
            for (int i = k + 1; i >= 0; --i)
                if (const Index s = faces(t, i); is_first_piece(blocks, k, s))
                    rows.add(carriers[k][s].cell, piece.value() * complex.sign(k + 1, t, i));
        }
        rows.end_cell();
    }
    return rows;
}

CellComplex make_merged(const Pieces& complex, const Blocks& blocks, const Carriers& carriers,
                        const std::vector<IncidenceMatrix>& diamonds) {
    std::vector<IncidenceMatrix> coboundaries(complex.dimension());
    std::vector<CofaceCounts> counts;
    std::vector<std::vector<Incidence>> canceled;
    for (int k = 0; k < complex.dimension(); ++k) {
        auto rows = merge_degree(complex, blocks, carriers, diamonds, k);
        rows.finish(coboundaries[k], counts.emplace_back(), canceled.emplace_back());
    }
    return {CellComplex::Unchecked{}, std::move(coboundaries), std::move(counts),
            std::move(canceled)};
}

std::vector<IncidenceMatrix> make_diamonds(const Carriers& carriers, const Blocks& blocks) {
    std::vector<IncidenceMatrix> diamonds(carriers.size());
    for (std::size_t k = 0; k < carriers.size(); ++k) {
        IncidenceMatrix diamond = make_diamond(carriers, blocks, static_cast<int>(k));
        diamonds[k].swap(diamond);
    }
    return diamonds;
}

} // namespace

Merging::Merging(Pieces pieces, const Blocks& blocks)
    : pieces_(std::move(pieces)),
      is_identity_(false),
      maps_(std::make_shared<Lazy<Maps>>(maps_of(pieces_, blocks))),
      merged_(make_merged(pieces_, blocks, maps().carriers, maps().diamonds)) {}

Merging::Merging(Pieces pieces, CellComplex merged, std::vector<std::vector<Carrier>> carriers,
                 std::vector<IncidenceMatrix> diamonds)
    : pieces_(std::move(pieces)),
      is_identity_(false),
      maps_(std::make_shared<Lazy<Maps>>(Maps{std::move(carriers), std::move(diamonds)})),
      merged_(std::move(merged)) {}

Merging::Maps Merging::maps_of(const Pieces& pieces, const Blocks& blocks) {
    Carriers carriers = number_blocks(pieces, blocks);
    auto diamonds = make_diamonds(carriers, blocks);
    return {std::move(carriers), std::move(diamonds)};
}

std::vector<Index> Merging::vertices(int k, Index cell) const {
    const IncidenceMatrix& pieces = diamond(k);
    check_number(fmt::format("{}-cell", k), cell, 0, pieces.rows() - 1);
    std::vector<Index> list;
    for (Row s(pieces, cell); s; ++s) {
        const auto simplex = pieces_.simplices(k).row(s.col());
        list.insert(list.end(), simplex.begin(), simplex.end());
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

Merging::Merging(Pieces pieces)
    : pieces_(std::move(pieces)),
      is_identity_(true),
      maps_(std::make_shared<Lazy<Maps>>()),
      merged_(pieces_) {}

Merging::Maps Merging::identity() const {
    Maps maps;
    for (int k = 0; k <= pieces_.dimension(); ++k) {
        auto& own = maps.carriers.emplace_back(static_cast<std::size_t>(pieces_.size(k)));
        for (Index s = 0; s < pieces_.size(k); ++s)
            own[s] = {k, s};
        IncidenceMatrix identity(pieces_.size(k), pieces_.size(k));
        identity.setIdentity();
        maps.diamonds.emplace_back().swap(identity);
    }
    return maps;
}

Merging unmerged(Pieces complex) {
    return Merging(std::move(complex));
}

} // namespace polydec
