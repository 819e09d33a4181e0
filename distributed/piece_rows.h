// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/cell_numbers.h"

namespace polydec {

/// The pieces of each own k-cell, on any rank, in ascending order.
class OwnPieces {
public:
    /// Collective.
    OwnPieces(const Ranks& ranks, const LocalComplex& local, const DistributedCells::Degree& cells,
              int k);

    /// The pieces of cell i have the places from begins()[i] on.
    const std::vector<Index>& begins() const { return begins_; }

    /// Collective: calls take(cell, row) for every piece, in the order of places. A row has `width`
    /// items, written by write(simplex, row) on the piece's rank.
    template <class Item, class Write, class Take>
    void visit(Eigen::Index width, Write write, Take take) const {
        std::vector<Item> row(width);
        auto parcels = ranks_.empty_parcels<Item>();
        for (std::size_t r = 0; r < parcels.size(); ++r)
            for (const Index s : away_[r]) {
                write(s, row.data());
                parcels[r].insert(parcels[r].end(), row.begin(), row.end());
            }
        const auto came = unpacked(ranks_.deliver(std::move(parcels)));
        for (Index cell = 0; cell + 1 < std::ssize(begins_); ++cell)
            for (Index place = begins_[cell]; place < begins_[cell + 1]; ++place)
                if (const Index s = pieces_[place]; s >= 0) {
                    write(s, row.data());
                    take(cell, static_cast<const Item*>(row.data()));
                } else {
                    take(cell, came.data() + (-1 - s) * width);
                }
    }

private:
    Ranks ranks_;
    Parcels<Index> away_; // own simplices that are pieces of other ranks' cells
    std::vector<Index> begins_;
    std::vector<Index> pieces_; // simplices here, or -1 - i for received row i
};

/// Collective: the rows of the pieces of every own k-cell, in the order of places. `of_simplices`
/// has a row for every local k-simplex; rows of other ranks' simplices and of simplices that are
/// not pieces are ignored.
Points gather_pieces(const Ranks& ranks, const LocalComplex& local,
                     const DistributedCells::Degree& cells, int k, const Points& of_simplices);

/// Collective: sums the rows of the pieces of every own k-cell, in ascending order of pieces, as in
/// one process.
Points add_pieces(const Ranks& ranks, const LocalComplex& local,
                  const DistributedCells::Degree& cells, int k, const Points& of_simplices);

/// Collective: for every local k-simplex the row of its cell, 0 if it is not a piece; `of_cells`
/// has a row for every own k-cell.
Points spread_to_pieces(const Ranks& ranks, const DistributedCells::Degree& cells,
                        const Points& of_cells);

} // namespace polydec
