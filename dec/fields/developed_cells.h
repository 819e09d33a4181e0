// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

namespace polydec {

/// Coordinates in R^n of the corners of the n-pieces, n + 1 rows per piece, in the order of its
/// corners. The pieces of one merged cell lie side by side as in the cell laid flat; bent cells can
/// be laid flat because merging is intrinsic. Each cell has its own coordinate system; in R^n the
/// coordinates are the points. Needs only lengths. Linear time.
Points developed_corners(const Discretization& mesh);

} // namespace polydec
