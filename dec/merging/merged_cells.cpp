// SPDX-License-Identifier: MIT
#include "dec/merging/merged_cells.h"

#include "dec/merging/lift.h"
#include "dec/metric/dual_parts.h"

#include <utility>

namespace polydec {

MergedCells::MergedCells(const Merging& merging, const Geometry& geometry,
                         const CellVolumes& volumes)
    : merging_(merging),
      geometry_(geometry),
      volumes_(volumes),
      lift_(std::make_shared<Lazy<std::vector<SparseMatrix>>>()) {
    check_fit(merging.pieces(), geometry.volumes());
    check_fit(merging.merged(), volumes);
}

const std::vector<SparseMatrix>& MergedCells::lift() const& {
    return lift_->get([this] { return commuting_lift(merging_, geometry_); });
}

SparseMatrix MergedCells::parts(int k, const Centers& centers) const {
    const int n = dimension();
    const SparseMatrix of_pieces = dual_parts(geometry_, centers, k, n);
    const SparseMatrix cells = merging_.diamond(n).cast<double>().cwiseAbs();
    const SparseMatrix faces = merging_.diamond(k).cast<double>().cwiseAbs();
    return cells * of_pieces * geometry_.volumes().primal(k).asDiagonal() *
           SparseMatrix(faces.transpose());
}

namespace {

/// sum_of(cell): of its pieces.
template <class SumOf>
CellVolumes::Degree volumes_from(Index cells, SumOf sum_of) {
    Vector primal(cells), dual(cells), terms(cells), rounding(cells);
    for (Index cell = 0; cell < cells; ++cell) {
        const PieceSum sum = sum_of(cell);
        primal[cell] = sum.primal;
        dual[cell] = sum.dual / sum.primal;
        terms[cell] = sum.terms / sum.primal;
        rounding[cell] = sum.rounding / sum.primal;
    }
    return {std::move(primal), std::move(dual), terms, rounding};
}

} // namespace

CellVolumes volumes_of(const std::vector<std::vector<PieceSum>>& sums) {
    std::vector<CellVolumes::Degree> degrees;
    for (const auto& cells : sums)
        degrees.push_back(volumes_from(static_cast<Index>(cells.size()),
                                       [&](Index cell) { return cells[cell]; }));
    return CellVolumes(std::move(degrees));
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    if (merging.is_identity())
        return input;
    std::vector<CellVolumes::Degree> degrees;
    for (int k = 0; k <= merging.merged().dimension(); ++k) {
        const IncidenceMatrix& diamond = merging.diamond(k);
        const CellVolumes::Degree& of_pieces = input.degree(k);
        degrees.push_back(volumes_from(static_cast<Index>(diamond.rows()), [&](Index cell) {
            PieceSum sum;
            for (IncidenceMatrix::InnerIterator piece(diamond, cell); piece; ++piece)
                sum.add(of_pieces, static_cast<Index>(piece.col()));
            return sum;
        }));
    }
    return CellVolumes(std::move(degrees));
}

} // namespace polydec
