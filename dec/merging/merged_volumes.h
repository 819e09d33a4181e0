// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/metric/cell_volumes.h"

#include <span>
#include <vector>

namespace polydec {

/// Sums over the pieces s of one cell, in ascending order: |s|, and |s| times the dual volume, the
/// terms and the rounding of s.
struct PieceSum {
    double primal = 0, dual = 0, terms = 0, rounding = 0;

    void add(const CellVolumes& of_pieces, int k, Index s) {
        const double volume = of_pieces.primal(k)[s];
        add({volume, volume * of_pieces.dual(k)[s], volume * of_pieces.terms(k)[s],
             volume * of_pieces.rounding(k)[s]});
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

/// Volumes of merged cells: |F| = sum |s| over the pieces, |*F| = (sum |s||*s|) / |F|. `diamonds`
/// lists the pieces for degrees 0..n.
CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input);
CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input);

} // namespace polydec
