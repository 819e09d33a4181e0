// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "dec/forms/side.h"
#include "dec/metric/cell_volumes.h"

namespace polydec {

/// Throws InvalidInput, naming the cells, if the star of degree k, the mass of forms of that side
/// and degree, is not positive: then they have no norm and their spectrum cannot be counted.
void check_positive_mass(const CellVolumes& volumes, Side side, int degree, int k);

/// Semidefinite if the stars of degrees k-1 and k+1 are positive, where the symmetric Laplacian of
/// degree k is so for sure; else indefinite.
Definiteness laplacian_definiteness(const CellVolumes& volumes, int k);

} // namespace polydec
