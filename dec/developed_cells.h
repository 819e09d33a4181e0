// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// Coordinates in R^n of the corners of the n-pieces, n + 1 rows for each, in the order of its
/// corners: the pieces of one merged cell lie beside each other as in the cell when it is laid flat
/// (bent cells can be: what is merged is intrinsic). Each cell has coordinates of its own, but in
/// R^n, where they are the points. Needs lengths alone. Linear time.
Points developed_corners(const Discretization& mesh);

} // namespace polydec
