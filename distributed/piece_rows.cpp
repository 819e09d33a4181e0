// SPDX-License-Identifier: MIT
#include "distributed/piece_rows.h"

#include <algorithm>
#include <numeric>

namespace polydec {

namespace {

/// Writes row s of these.
auto writer(const Points& rows) {
    return [&rows](Index s, double* row) {
        std::copy_n(rows.data() + s * rows.cols(), rows.cols(), row);
    };
}

} // namespace

OwnPieces::OwnPieces(const Ranks& ranks, const LocalComplex& local,
                     const DistributedCells::Degree& cells, int k)
    : ranks_(ranks),
      away_(ranks.empty_parcels<Index>()),
      begins_(static_cast<std::size_t>(cells.own()) + 1, 0) {
    const auto& degree = local.degree(k);
    const auto is_own_piece = [&](Index s) {
        return cells.of_simplex[s] >= 0 && local.owns(ranks, k, s);
    };
    const Stretches rows(ranks, cells.first_row);
    struct Sent {
        GlobalIndex row, number;
    };
    auto sent = ranks.empty_parcels<Sent>();
    for (Index s = 0; s < degree.size(); ++s) {
        const Index cell = cells.of_simplex[s];
        if (!is_own_piece(s))
            continue;
        if (cell < cells.own()) {
            ++begins_[cell + 1];
            continue;
        }
        const GlobalIndex row = cells.cell(cell).row;
        away_[rows.rank_of(row)].push_back(s);
        sent[rows.rank_of(row)].push_back({row, degree.number[s]});
    }
    const auto came = unpacked(ranks.deliver(std::move(sent)));
    const auto cell_of = [&](const Sent& piece) { return piece.row - cells.first_row; };
    for (const Sent& piece : came)
        ++begins_[cell_of(piece) + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());

    // those here ascend; only where others come to a cell are its pieces not yet in order
    pieces_.resize(begins_.back());
    std::vector<Index> next(begins_.begin(), begins_.end() - 1);
    for (Index s = 0; s < degree.size(); ++s)
        if (const Index cell = cells.of_simplex[s]; is_own_piece(s) && cell < cells.own())
            pieces_[next[cell]++] = s;
    for (std::size_t i = 0; i < came.size(); ++i)
        pieces_[next[cell_of(came[i])]++] = -1 - static_cast<Index>(i);
    const auto number = [&](Index piece) {
        return piece >= 0 ? degree.number[piece] : came[-1 - piece].number;
    };
    for (const Sent& piece : came) {
        const auto begin = pieces_.begin() + begins_[cell_of(piece)],
                   end = pieces_.begin() + begins_[cell_of(piece) + 1];
        const auto before = [&](Index a, Index b) { return number(a) < number(b); };
        if (!std::is_sorted(begin, end, before))
            std::sort(begin, end, before);
    }
}

Points gather_pieces(const Ranks& ranks, const LocalComplex& local,
                     const DistributedCells::Degree& cells, int k, const Points& of_simplices) {
    const OwnPieces pieces(ranks, local, cells, k);
    const auto width = of_simplices.cols();
    Points rows(pieces.begins().back(), width);
    double* next = rows.data();
    pieces.visit<double>(width, writer(of_simplices),
                         [&](Index, const double* row) { next = std::copy_n(row, width, next); });
    return rows;
}

Points add_pieces(const Ranks& ranks, const LocalComplex& local,
                  const DistributedCells::Degree& cells, int k, const Points& of_simplices) {
    const auto width = of_simplices.cols();
    Points sums = Points::Zero(cells.own(), width);
    OwnPieces(ranks, local, cells, k)
        .visit<double>(width, writer(of_simplices), [&](Index cell, const double* row) {
            sums.row(cell) += Eigen::Map<const Points>(row, 1, width);
        });
    return sums;
}

Points spread_to_pieces(const Ranks& ranks, const DistributedCells::Degree& cells,
                        const Points& of_cells) {
    const auto width = of_cells.cols();
    const Stretches stretches(ranks, cells.first_row);
    std::vector<int> whom;
    std::vector<GlobalIndex> rows;
    for (const CellNumber& cell : cells.others) {
        whom.push_back(stretches.rank_of(cell.row));
        rows.push_back(cell.row);
    }
    const auto came = ranks.ask_rows<double>(
        "rows of cells", width, whom, rows, [&](GlobalIndex row, double* to) {
            std::copy_n(of_cells.data() + (row - cells.first_row) * width, width, to);
        });
    const Points of_others = Eigen::Map<const Points>(came.data(), std::ssize(rows), width);
    Points result = Points::Zero(std::ssize(cells.of_simplex), width);
    for (Eigen::Index s = 0; s < result.rows(); ++s)
        if (const Index cell = cells.of_simplex[s]; cell >= 0)
            result.row(s) =
                cell < cells.own() ? of_cells.row(cell) : of_others.row(cell - cells.own());
    return result;
}

} // namespace polydec
