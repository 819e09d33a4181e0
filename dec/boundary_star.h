// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// The star of k-cells within the boundary, 0 <= k < n: for each the volume of the part of its dual
/// that lies there over its own, the part in each facet times the facet's weight; where the star of
/// (k+1)-cells is a matrix, the inner products of the traces of Whitney forms. 0 off the boundary.
/// size(k) x size(k); weights has one value for each (n-1)-cell, and only those of the boundary
/// matter. Units length^(n-1-2k) times those of the weights, in unit() as stars() are. With the
/// coefficients of Robin's condition it is what that adds to a Laplacian; with ones the inner
/// product of traces. Throws InvalidInput for other degrees and numbers of weights.
SparseMatrix boundary_star(const Discretization& mesh, int k, const Vector& weights);

/// The same of any cells: for k = n-1, where the dual within the boundary is a point. Throws
/// InvalidInput for all others, of which parts of duals are not known.
SparseMatrix boundary_star(const CellComplex& complex, const CellVolumes& volumes, int k,
                           const Vector& weights);

} // namespace polydec
