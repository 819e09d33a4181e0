// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "dec/forms/cochain.h"
#include "dec/stars/star.h"

namespace polydec {

/// Throws InvalidInput, naming the cells, unless the star that is the mass of forms of this side
/// and degree is positive: without a norm the spectrum cannot be counted.
void check_positive_mass(const HodgeStar& star, Side side, int degree);

/// Semidefinite if the stars of degrees k-1 and k+1 are positive, which guarantees a semidefinite
/// symmetric Laplacian of degree k; else indefinite.
Definiteness laplacian_definiteness(const HodgeStars& stars, int k);

} // namespace polydec
