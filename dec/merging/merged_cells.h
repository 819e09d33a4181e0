// SPDX-License-Identifier: MIT
#pragma once

#include "base/lazy.h"
#include "base/shared.h"
#include "complex/merging.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/geometry.h"

#include <vector>

namespace polydec {

/// Cells and the simplices that were merged into them: the data for Hodge stars of every kind.
/// A handle: copies cost nothing.
class MergedCells {
public:
    /// `geometry`: of the pieces. `volumes`: of the cells. Throws InvalidInput, naming the degree,
    /// unless their sizes match the merging.
    MergedCells(const Merging& merging, const Geometry& geometry, const CellVolumes& volumes);

    const CellComplex& complex() const& { return merging_.merged(); }
    CellComplex complex() && { return complex(); }
    int dimension() const { return complex().dimension(); }
    const CellVolumes& volumes() const& { return volumes_; }
    CellVolumes volumes() && { return volumes(); }
    const Merging& merging() const& { return merging_; }
    Merging merging() && { return merging(); }
    const Geometry& geometry() const& { return geometry_; }
    Geometry geometry() && { return geometry(); }

    /// The lift of forms on the cells to the pieces (see commuting_lift); computed on first use,
    /// once for all copies.
    const std::vector<SparseMatrix>& lift() const&;
    std::vector<SparseMatrix> lift() && { return lift(); }

    /// The part of |E||*E| in each n-cell, for all k-cells E: size(n) x size(k). Columns sum to
    /// |E||*E|, with *E between these centers. length^n.
    SparseMatrix parts(int k, const Centers& centers) const;

private:
    Merging merging_;
    Geometry geometry_;
    CellVolumes volumes_;
    Shared<const Lazy<std::vector<SparseMatrix>>> lift_;
};

/// Sums over the pieces s of one cell, in ascending order: |s|, and |s| times the dual volume, the
/// terms and the rounding of s.
struct PieceSum {
    double primal = 0, dual = 0, terms = 0, rounding = 0;

    void add(const CellVolumes::Degree& of_pieces, Index s) {
        const auto& [volumes, dual_volumes, of_terms, of_rounding] = of_pieces;
        const double volume = volumes[s];
        add({volume, volume * dual_volumes[s], volume * of_terms[s], volume * of_rounding[s]});
    }
    void add(const PieceSum& piece) {
        primal += piece.primal;
        dual += piece.dual;
        terms += piece.terms;
        rounding += piece.rounding;
    }
};

/// Volumes of cells of degrees 0..n from these sums.
CellVolumes volumes_of(const std::vector<std::vector<PieceSum>>& sums);

/// Volumes of merged cells: |F| = sum |s| over the pieces, |*F| = (sum |s||*s|) / |F|.
CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input);

} // namespace polydec
