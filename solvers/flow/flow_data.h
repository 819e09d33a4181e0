// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

// All is in the units of the input.

/// The flow on a surface (n = 2) with this vorticity at the vertices, length^0 over time, without
/// harmonic part: w = d psi with Delta psi the vorticity and psi 0 on the boundary. On closed
/// components the mean of the vorticity is removed. Size size(1).
/// Throws InvalidInput for n other than 2, and like PoissonSolver.
Vector flow_of_vorticity(const Discretization& mesh, const Vector& vorticity);

/// The fluxes of a field of velocities at vertices, a row of N components each, linear between
/// them: i_X vol, size(n-1). On surfaces in space the tangential part counts. Has a divergence in
/// general: see IncompressibleFlow::project. Throws like interior_product.
Vector flow_of_velocity(const Discretization& mesh, const Points& velocity);

/// The fluxes through the boundary of velocities at its facets, a row of N components for each
/// (n-1)-cell; 0 at facets inside, and where the velocity is along the facet to rounding:
/// FlowOptions::boundary_flux. Throws InvalidInput for another number of rows or columns, and where
/// only lengths are known or edges were flipped.
Vector flux_through_boundary(const Discretization& mesh, const Points& velocity);

} // namespace polydec
