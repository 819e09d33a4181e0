// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "complex/merging.h"
#include "dec/metric/geometry.h"

#include <memory>
#include <vector>

namespace polydec {

/// Cells and the simplices that were merged into them: the data for Hodge stars of every kind.
/// A handle: copies cost nothing.
class MergedCells {
public:
    /// `geometry`: of the pieces. `volumes`: of the cells. Throws InvalidInput, naming the degree,
    /// unless their sizes match the merging.
    MergedCells(const Merging& merging, const Geometry& geometry, const CellVolumes& volumes);

    const CellComplex& complex() const { return merging_.merged(); }
    int dimension() const { return complex().dimension(); }
    const CellVolumes& volumes() const { return volumes_; }
    const Merging& merging() const { return merging_; }
    const Geometry& geometry() const { return geometry_; }

    /// The same with other volumes of the cells. Throws like the constructor.
    MergedCells with_volumes(const CellVolumes& volumes) const;

    /// The lift of forms on the cells to the pieces (see commuting_lift); computed on first use,
    /// once for all copies.
    const std::vector<SparseMatrix>& lift() const;

    /// The part of |E||*E| in each n-cell, for all k-cells E: size(n) x size(k). Columns sum to
    /// |E||*E|, with *E between these centers. length^n.
    SparseMatrix parts(int k, const Centers& centers) const;

private:
    Merging merging_;
    Geometry geometry_;
    CellVolumes volumes_;
    std::shared_ptr<const Lazy<std::vector<SparseMatrix>>> lift_;
};

} // namespace polydec
