// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "dec/metric/cell_volumes.h"

#include <string>
#include <vector>

namespace polydec {

/// Hodge star on primal k-forms, to dual (n-k)-forms: diagonal, dual volume over primal volume.
/// Size size(k); units length^(n-2k); positive iff every dual volume is.
/// Source: Hirani 2003, Def. 4.1.1.
Vector star(const CellVolumes& volumes, int k);

/// The star of dual (n-k)-forms, to primal k-forms: (-1)^(k(n-k)) |s| / |*s|, so that star star is
/// that sign. Throws InvalidInput, naming the cells, if a dual volume is zero.
Vector dual_star(const CellVolumes& volumes, int k);

/// |s| / |*s|, the inverse of star. Throws like dual_star.
Vector inverse_star(const CellVolumes& volumes, int k);

/// The k-cells whose star entry counts as zero: whose dual volume is no larger than the rounding
/// error of what cancels in it (CellVolumes::terms, is_zero). Neither other cells nor scale matter.
std::vector<Index> zero_star_cells(const CellVolumes& volumes, int k);

/// The k-cells whose star entry is negative and not zero in the above sense.
std::vector<Index> negative_star_cells(const CellVolumes& volumes, int k);

/// The first five of some k-cells for messages, "3, 7, 8, 10, 12, ..": by CellVolumes::number.
std::string numbers_of(const CellVolumes& volumes, int k, const std::vector<Index>& cells);

} // namespace polydec
