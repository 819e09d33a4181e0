// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/metric/geometry.h"

namespace polydec {

/// The lifts S_0, .., S_n of forms on merged cells to the simplices: S_k is size of K times size of
/// P, with dia_k S_k = I and d_k S_k = S_(k+1) d^P_k, so Stokes' theorem holds inside every merged
/// cell. S_n shares a cell's value among its pieces in proportion to volume, S_0 = I unless
/// pieces have vertices inside of cells. Where the
/// values inside a cell are not unique, those of least Whitney energy are taken; then the integrals
/// of every constant form over a flat cell are returned exactly. Dimensionless.
///
/// Flat n-pieces have no meaning of their own (see CosphericalMerging): they have no part in the
/// energy, which grows with the inverse of their height. Instead, (n-1)-forms have one
/// normal density on each of them, so that those on all its facets agree.
///
/// S(s, E) is not 0 only for E in the closure of the carrier of s. Within a polygon of p corners
/// that is of the order of p^2 entries.
/// The geometry is that of the pieces. Throws InvalidInput beyond 2^31 - 1 entries, and, naming the
/// cell, where one with simplices inside has more than 2000 pieces; IoError beyond memory_limit().
std::vector<SparseMatrix> commuting_lift(const Merging& merging, const Geometry& geometry);

} // namespace polydec
