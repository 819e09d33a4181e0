// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/centers.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

/// The parts of the duals, circumcentric or between other centers, of the k-faces of m-simplices:
/// row t holds for each of its k-faces, in the order of subsets(m+1, k+1) of its corners, the
/// signed (m-k)-volume of the part of the face's dual, taken in the plane of t, that lies in t.
/// size(m) x C(m+1, k+1), k <= m <= n. The sum over the faces of |s| times its part is C(m,k) |t|.
/// A part is negative where the center of t lies beyond a face. volumes are those of `complex`.
/// Throws InvalidInput for other degrees.
Points parts_of_duals(const Pieces& complex, const SimplexMetric& metric,
                      const CellVolumes& volumes, int k, int m, const Centers& centers = {});

/// The same as a matrix: entry (t, s) is the part in t of the dual of its face s, the sum of both
/// where s is a face of t twice. size(m) x size(k); for m = n the columns sum to the dual volumes.
SparseMatrix dual_parts(const Pieces& complex, const SimplexMetric& metric,
                        const CellVolumes& volumes, int k, int m, const Centers& centers = {});

} // namespace polydec
