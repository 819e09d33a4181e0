// SPDX-License-Identifier: MIT
#include "dec/merging/merged_cells.h"

#include "dec/merging/lift.h"
#include "dec/metric/dual_parts.h"

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

MergedCells MergedCells::with_volumes(const CellVolumes& volumes) const {
    MergedCells result(merging_, geometry_, volumes);
    result.lift_ = lift_;
    return result;
}

const std::vector<SparseMatrix>& MergedCells::lift() const {
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

} // namespace polydec
