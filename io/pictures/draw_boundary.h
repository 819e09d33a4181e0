// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "io/pictures/svg_drawing.h"

namespace polydec {

/// The boundary matrix of the k-cells, 1 <= k <= n <= 3, as a table: a row for each (k-1)-cell and
/// a column for each k-cell, with their numbers in the colors of draw_structure. Throws
/// InvalidInput for another k, and above 60 rows or columns.
SvgDrawing draw_boundary(const CellComplex& complex, int k);

} // namespace polydec
