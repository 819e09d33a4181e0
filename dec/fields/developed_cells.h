// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/metric/simplex_layout.h"

namespace polydec {

/// Coordinates in R^n of the corners of the n-pieces, n + 1 rows per piece, in the order of its
/// corners. The pieces of one merged cell lie side by side as in the cell laid flat; bent cells can
/// be laid flat because merging is intrinsic. Each cell has its own coordinate system; in R^n the
/// coordinates are the points. Needs only lengths. Linear time.
Points developed_corners(const Discretization& mesh);

/// The edges of a facet, given by its n corners, from its first corner, and the unit normal that
/// points to a place beside the facet; 0 for a place on it. n x N.
DenseMatrix basis_at(const DenseMatrix& facet, const Eigen::RowVectorXd& beside);

/// Coordinates of the corners of one n-simplex in its own plane, relative to its first corner:
/// (n+1) x n, lower triangular below the first row.
DenseMatrix in_own_plane(const Corners& corners);

} // namespace polydec
