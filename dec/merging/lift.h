// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "dec/metric/geometry.h"

namespace polydec {

/// The lifts S_0, .., S_n of forms on merged cells to the simplices: S_k is size of K times size of
/// P, with dia_k S_k = I and d_k S_k = S_(k+1) d^P_k, so Stokes' theorem holds inside every merged
/// cell. S_n shares a cell's value among its pieces in proportion to volume; S_0 = I unless pieces
/// have vertices inside cells. If the values inside a cell are not unique, they have least Whitney
/// energy; the lift is then exact for the integrals of every constant form over a flat cell.
/// Dimensionless.
///
/// Flat n-pieces carry no information of their own (see CosphericalMerging). They are excluded from
/// the energy, which grows with the inverse of their height. Instead, (n-1)-forms have one normal
/// density on each flat piece, so the values on all its facets are consistent.
///
/// S(s, E) is nonzero only for E in the closure of the carrier of s. A polygon with p corners has
/// of the order of p^2 entries. `geometry`: of the pieces. Throws InvalidInput for more than 2^31 -
/// 1 entries, and, naming the cell, if a cell with simplices inside has more than 2000 pieces;
/// IoError beyond memory_limit().
std::vector<SparseMatrix> commuting_lift(const Merging& merging, const Geometry& geometry);

} // namespace polydec
