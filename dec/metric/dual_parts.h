// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

/// The parts of the circumcentric duals: entry (t, s) is the signed (m-k)-volume of the part of
/// the dual of k-simplex s, taken in the plane of m-simplex t, that lies in t; s is a face of t,
/// k <= m <= n. size(m) x size(k). The sum over s of |s| times its part is C(m,k) |t|; for m = n
/// the columns sum to the dual volumes. A part is negative where the circumcenter of t lies beyond
/// a face. volumes are those of `complex`. Throws InvalidInput for other degrees.
SparseMatrix dual_parts(const Pieces& complex, const SimplexMetric& metric,
                        const CellVolumes& volumes, int k, int m);

/// The parts of the duals of an m-simplex's corners in it: size(m) x (m+1), a column for each
/// corner in order. As dual_parts of degree 0, but a vertex that is a corner twice has a part at
/// each.
DenseMatrix corner_parts(const Pieces& complex, const SimplexMetric& metric,
                         const CellVolumes& volumes, int m);

} // namespace polydec
