// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

/// The parts of the circumcentric duals: entry (t, s) is the signed (m-k)-volume of the part of
/// the dual of k-simplex s, taken in the plane of m-simplex t, that lies in t; s is a face of t,
/// k <= m <= n. size(m) x size(k). The sum over s of |s| times its part is C(m,k) |t|; for m = n
/// the columns sum to the dual volumes. A part is negative where the circumcenter of t lies beyond
/// a face. volumes are those of `complex`. Throws InvalidInput for other degrees.
SparseMatrix dual_parts(const SimplicialComplex& complex, const SimplexMetric& metric,
                        const CellVolumes& volumes, int k, int m);

} // namespace polydec
