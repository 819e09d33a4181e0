// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "complex/merging.h"
#include "dec/metric/geometry.h"

#include <memory>
#include <vector>

namespace polydec {

/// Cells and the simplices that were merged into them: what Hodge stars of every kind are made of.
/// A handle: copies cost nothing.
class MergedCells {
public:
    /// The geometry is that of the pieces, the volumes those of the cells. Throws InvalidInput,
    /// naming the degree, unless there are as many of both.
    MergedCells(const Merging& merging, const Geometry& geometry, const CellVolumes& volumes);

    const CellComplex& complex() const { return merging_.merged(); }
    int dimension() const { return complex().dimension(); }
    const CellVolumes& volumes() const { return volumes_; }
    const Merging& merging() const { return merging_; }
    const Geometry& geometry() const { return geometry_; }

    /// The same with other volumes of the cells. Throws like the constructor.
    MergedCells with_volumes(const CellVolumes& volumes) const;

    /// The lift of forms on the cells to the pieces (see commuting_lift): made when it is first
    /// asked for, once for all copies.
    const std::vector<SparseMatrix>& lift() const;

    /// The part of |E||*E| that lies in each n-cell, for all its k-cells E: size(n) x size(k). Its
    /// columns sum to |E||*E|, *E between these centers. length^n.
    SparseMatrix parts(int k, const Centers& centers) const;

private:
    Merging merging_;
    Geometry geometry_;
    CellVolumes volumes_;
    std::shared_ptr<const Lazy<std::vector<SparseMatrix>>> lift_;
};

} // namespace polydec
