// SPDX-License-Identifier: MIT
#include "distributed/piece_rows.h"

#include "distributed/number_places.h"

#include <algorithm>
#include <numeric>

namespace polydec {

namespace {

/// Which rank a row of matrices belongs to.
class RowOwners {
public:
    RowOwners(const Ranks& ranks, const DistributedCells::Degree& cells)
        : begins_(ranks.of_all(std::vector<GlobalIndex>{cells.first_row})) {}

    std::size_t operator()(GlobalIndex row) const {
        return static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end(), row) -
                                        begins_.begin() - 1);
    }

private:
    std::vector<GlobalIndex> begins_;
};

void append_row(std::vector<double>& numbers, const Points& rows, Eigen::Index row) {
    const auto width = rows.cols();
    numbers.insert(numbers.end(), rows.data() + row * width, rows.data() + (row + 1) * width);
}

Points as_rows(const Parcels<double>& parcels, Eigen::Index width) {
    std::size_t count = 0;
    for (const auto& parcel : parcels)
        count += parcel.size();
    Points rows(width > 0 ? static_cast<Eigen::Index>(count) / width : 0, width);
    double* entry = rows.data();
    for (const auto& parcel : parcels)
        entry = std::copy(parcel.begin(), parcel.end(), entry);
    return rows;
}

} // namespace

Points PieceRows::sums() const {
    Points result = Points::Zero(static_cast<Eigen::Index>(begins.size()) - 1, rows.cols());
    for (Eigen::Index cell = 0; cell < result.rows(); ++cell)
        for (Index piece = begins[cell]; piece < begins[cell + 1]; ++piece)
            result.row(cell) += rows.row(piece);
    return result;
}

PieceRows gather_pieces(const Ranks& ranks, const LocalComplex& local,
                        const DistributedCells::Degree& cells, int k, const Points& of_simplices) {
    struct Piece {
        GlobalIndex row, number;
        auto operator<=>(const Piece&) const = default;
    };
    const RowOwners owner(ranks, cells);
    const auto& degree = local.degree(k);
    auto keys = ranks.empty_parcels<Piece>();
    auto numbers = ranks.empty_parcels<double>();
    const auto at_most = static_cast<std::size_t>(degree.size()); // nearly all stay here
    keys[static_cast<std::size_t>(ranks.rank())].reserve(at_most);
    numbers[static_cast<std::size_t>(ranks.rank())].reserve(
        at_most * static_cast<std::size_t>(of_simplices.cols()));
    for (Index s = 0; s < degree.size(); ++s)
        if (const GlobalIndex row = cells.of_simplex[s].row; row >= 0 && local.owns(ranks, k, s)) {
            keys[owner(row)].push_back({row, degree.number[s]});
            append_row(numbers[owner(row)], of_simplices, s);
        }
    Points came = as_rows(ranks.deliver(std::move(numbers)), of_simplices.cols());
    std::vector<Piece> pieces;
    for (const auto& parcel : ranks.deliver(std::move(keys)))
        pieces.insert(pieces.end(), parcel.begin(), parcel.end());

    PieceRows result{std::vector<Index>(cells.first.size() + 1, 0), {}};
    for (const Piece& piece : pieces)
        ++result.begins[static_cast<std::size_t>(piece.row - cells.first_row) + 1];
    std::partial_sum(result.begins.begin(), result.begins.end(), result.begins.begin());
    if (std::is_sorted(pieces.begin(), pieces.end())) {
        result.rows = std::move(came);
        return result;
    }
    std::vector<Index> order(pieces.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index i, Index j) { return pieces[i] < pieces[j]; });
    result.rows = came(order, Eigen::all);
    return result;
}

Points spread_to_pieces(const Ranks& ranks, const DistributedCells::Degree& cells,
                        const Points& of_cells) {
    std::vector<GlobalIndex> rows;
    for (const CellNumber& cell : cells.of_simplex)
        if (cell.row >= 0)
            rows.push_back(cell.row);
    const NumberPlaces place(rows);

    const RowOwners owner(ranks, cells);
    auto questions = ranks.empty_parcels<GlobalIndex>();
    for (const GlobalIndex row : place.numbers())
        questions[owner(row)].push_back(row);
    auto answers = ranks.empty_parcels<double>();
    const auto asked = ranks.deliver(std::move(questions));
    for (std::size_t r = 0; r < asked.size(); ++r)
        for (const GlobalIndex row : asked[r])
            append_row(answers[r], of_cells, row - cells.first_row);
    const Points came = as_rows(ranks.deliver(std::move(answers)), of_cells.cols());

    Points result =
        Points::Zero(static_cast<Eigen::Index>(cells.of_simplex.size()), of_cells.cols());
    for (Eigen::Index s = 0; s < result.rows(); ++s)
        if (const GlobalIndex row = cells.of_simplex[static_cast<std::size_t>(s)].row; row >= 0)
            result.row(s) = came.row(place(row));
    return result;
}

} // namespace polydec
