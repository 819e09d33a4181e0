// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/geometry.h"

namespace polydec {

/// Parts of the duals, between these centers, of the k-faces of m-simplices. Row t has one entry
/// per k-face of t, in the order of subsets(m+1, k+1) of its corners: the signed (m-k)-volume of
/// the part of the face's dual, taken in the plane of t, that lies in t. size(m) x C(m+1, k+1), k
/// <= m <= n. The sum over the faces of |s| times its part is C(m,k) |t|. A part is negative if the
/// center of t lies beyond a face. Throws InvalidInput for other degrees.
Points parts_of_duals(const Geometry& geometry, const Centers& centers, int k, int m);

/// The same as a matrix: entry (t, s) is the part in t of the dual of its face s, or the sum of
/// both if t has s as a face twice. size(m) x size(k); for m = n columns sum to the dual volumes.
SparseMatrix dual_parts(const Geometry& geometry, const Centers& centers, int k, int m);

} // namespace polydec
