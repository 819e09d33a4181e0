// SPDX-License-Identifier: MIT
#include "distributed/cell_numbers.h"

#include "dec/merging/merged_volumes.h"
#include "distributed/in_order.h"
#include "distributed/number_places.h"
#include "distributed/piece_rows.h"

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

class Numbering {
public:
    Numbering(const Ranks& ranks, const LocalComplex& local, const MergedCells& merged, int k)
        : ranks_(ranks), local_(local), merged_(merged), k_(k) {}

    DistributedCells::Degree run() {
        find_own();
        const auto [places, count] =
            places_in_order(ranks_, numbers_of_first(), 1, local_.degree(k_).count);
        cells_.count = count;
        cells_.number = places;
        cells_.first_row = ranks_.sum_before(std::ssize(places));
        tell_pieces();
        return std::move(cells_);
    }

private:
    bool is_piece(Index s) const { return merged_.carriers[k_][s].dimension == k_; }

    void find_own() {
        for (Index s = 0; s < local_.degree(k_).size(); ++s)
            if (local_.owns(ranks_, k_, s) && merged_.is_first_piece(local_, k_, s))
                cells_.first.push_back(s);
    }

    std::vector<GlobalIndex> numbers_of_first() const {
        std::vector<GlobalIndex> numbers;
        for (const Index s : cells_.first)
            numbers.push_back(local_.degree(k_).number[s]);
        return numbers;
    }

    void tell_pieces();

    const Ranks& ranks_;
    const LocalComplex& local_;
    const MergedCells& merged_;
    int k_;
    DistributedCells::Degree cells_;
};

/// Owners of cells tell the ranks of their first pieces' numbers, and these whoever asks.
void Numbering::tell_pieces() {
    const auto& degree = local_.degree(k_);
    const EqualStretches stretches(degree.count, ranks_.size());
    struct Told {
        GlobalIndex first;
        CellNumber cell;
    };
    auto parcels = ranks_.empty_parcels<Told>();
    for (std::size_t i = 0; i < cells_.first.size(); ++i) {
        const GlobalIndex first = degree.number[cells_.first[i]];
        parcels[stretches.rank_of(first)].push_back(
            {first, {cells_.number[i], cells_.first_row + static_cast<GlobalIndex>(i)}});
    }
    const auto arrived = ranks_.deliver(std::move(parcels));
    std::vector<CellNumber> directory(
        static_cast<std::size_t>(stretches.end(ranks_.rank()) - stretches.begin(ranks_.rank())));
    const GlobalIndex begin = stretches.begin(ranks_.rank());
    for (const auto& parcel : arrived)
        for (const auto& [first, cell] : parcel)
            directory[static_cast<std::size_t>(first - begin)] = cell;

    std::vector<GlobalIndex> firsts;
    firsts.reserve(static_cast<std::size_t>(degree.size()));
    for (Index s = 0; s < degree.size(); ++s)
        if (is_piece(s))
            firsts.push_back(merged_.carriers[k_][s].first);
    const NumberPlaces place(firsts);
    std::vector<int> whom;
    for (const GlobalIndex first : place.numbers())
        whom.push_back(stretches.rank_of(first));
    const auto found =
        ranks_.ask<CellNumber>("cell numbers", whom, place.numbers(), [&](GlobalIndex first) {
            return directory[static_cast<std::size_t>(first - begin)];
        });
    cells_.of_simplex.resize(static_cast<std::size_t>(degree.size()));
    for (Index s = 0; s < degree.size(); ++s)
        if (is_piece(s))
            cells_.of_simplex[s] = found[place(merged_.carriers[k_][s].first)];
}

/// Added up in ascending order of pieces, wherever these are.
std::vector<PieceSum> sums_of_volumes(const Ranks& ranks, const LocalComplex& local,
                                      const CellVolumes& of_pieces,
                                      const DistributedCells::Degree& cells, int k) {
    Points volumes(local.degree(k).size(), 4);
    for (Index s = 0; s < volumes.rows(); ++s) {
        PieceSum own;
        own.add(of_pieces, k, s);
        volumes.row(s) << own.primal, own.dual, own.terms, own.rounding;
    }
    std::vector<PieceSum> sums;
    const Points all = gather_pieces(ranks, local, cells, k, volumes).sums();
    for (const auto& row : all.rowwise())
        sums.push_back({row[0], row[1], row[2], row[3]});
    return sums;
}

/// Of simplices that are cells as they are.
CellVolumes own_volumes(const CellVolumes& all,
                        const std::vector<DistributedCells::Degree>& cells) {
    std::vector<Vector> primal, dual, terms, rounding;
    for (int k = 0; k <= all.dimension(); ++k) {
        const std::vector<Index>& own = cells[static_cast<std::size_t>(k)].first;
        primal.emplace_back(all.primal(k)(own));
        dual.emplace_back(all.dual(k)(own));
        terms.emplace_back(all.terms(k).vector()(own));
        rounding.emplace_back(all.rounding(k).vector()(own));
    }
    return {std::move(primal), std::move(dual), std::move(terms), std::move(rounding)};
}

/// By which messages name cells; none if they do not fit.
std::vector<std::vector<Index>> numbers_of(const std::vector<DistributedCells::Degree>& cells) {
    std::vector<std::vector<Index>> numbers;
    for (const auto& degree : cells) {
        if (degree.count > std::numeric_limits<Index>::max())
            return {};
        numbers.emplace_back(degree.number.begin(), degree.number.end());
    }
    return numbers;
}

/// The first piece tells: all pieces of a cell have the same merged cofaces.
void add_cofaces(const LocalComplex& local, const MergedCells& merged,
                 const DistributedCells::Degree& above, int k, DistributedCells::Degree& cells) {
    const Cofaces cofaces(local.complex, k + 1);
    std::vector<std::pair<CellNumber, double>> row;
    cells.begins.reserve(cells.first.size() + 1);
    for (const Index s : cells.first) {
        row.clear();
        for (const auto& [t, omitted] : cofaces.of(s))
            if (const CellNumber& cell = above.of_simplex[t]; cell.row >= 0)
                row.emplace_back(cell, merged.carriers[k + 1][t].sign *
                                           local.complex.sign(k + 1, t, omitted));
        std::sort(row.begin(), row.end(),
                  [](const auto& x, const auto& y) { return x.first.row < y.first.row; });
        for (auto entry = row.begin(); entry != row.end();) {
            const CellNumber cell = entry->first;
            double sign = 0;
            for (; entry != row.end() && entry->first.row == cell.row; ++entry)
                sign += entry->second;
            if (sign != 0) {
                cells.cofaces.push_back(cell);
                cells.signs.push_back(sign);
            }
        }
        cells.begins.push_back(static_cast<Index>(cells.cofaces.size()));
    }
}

} // namespace

DistributedCells distributed_cells(const Ranks& ranks, const LocalComplex& local,
                                   const MergedCells& merged) {
    const int n = local.dimension();
    DistributedCells result;
    std::vector<std::vector<PieceSum>> sums;
    for (int k = 0; k <= n; ++k) {
        result.degrees.push_back(Numbering(ranks, local, merged, k).run());
        if (!merged.is_identity)
            sums.push_back(
                sums_of_volumes(ranks, local, merged.of_pieces, result.degrees.back(), k));
    }
    ranks.together("cells", [&] {
        for (int k = 0; k < n; ++k)
            add_cofaces(local, merged, result.degrees[k + 1], k, result.degrees[k]);
        result.volumes =
            merged.is_identity ? own_volumes(merged.of_pieces, result.degrees) : volumes_of(sums);
        if (const auto numbers = numbers_of(result.degrees); !numbers.empty())
            result.volumes = result.volumes.numbered(numbers);
    });
    return result;
}

} // namespace polydec
