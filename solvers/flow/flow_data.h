// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "base/types.h"
#include "dec/discretization/discretization.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

/// What is known of a flow at a facet of the boundary: the flux through it or the pressure, and the
/// velocity along it or that it has no vorticity.
enum class FlowBoundary {
    free_slip, ///< the flux, and no vorticity: a wall that holds nothing back
    no_slip,   ///< the flux, and the velocity along the wall
    open,      ///< the pressure, and no vorticity: the fluid enters and leaves as it likes
    pressure,  ///< the pressure, and the velocity along the facet
};

/// Facets that a condition is chosen for.
struct FlowFacets {
    FlowBoundary kind;
    std::vector<bool> marks; ///< of the (n-1)-cells, or one for all
    std::string name;        ///< for messages
};

/// The condition of each (n-1)-cell: the last one chosen for it, else free slip. Throws
/// InvalidInput for another number of marks, and, like require_facets, for marks of which none is
/// on the boundary.
std::vector<FlowBoundary> flow_boundary(const CellComplex& complex,
                                        const std::vector<FlowFacets>& chosen);

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

struct FlowOperators;

/// Projects momenta to flows without divergence, with implicit friction. Made by
/// IncompressibleFlow. A handle; use it from one thread at a time. In the units of the input.
class FlowProjection {
public:
    /// `theta` is a time that multiplies the friction. Throws InvalidInput for theta * viscosity <
    /// 0, and like LinearSolver.
    FlowProjection(std::shared_ptr<const FlowOperators> operators, double theta);

    struct Flow {
        Vector flux;       ///< w: size(n-1)
        Vector multiplier; ///< c: size(n), in the unit of the mesh; may be rounding only
    };

    /// The flow w without divergence that has the boundary data and satisfies star w - theta
    /// friction(w) + d^T c = momentum at all facets without a known flux.
    Flow solve(const Vector& momentum) const;

    /// The same with boundary data 0 and without friction, for rates of change. Throws InvalidInput
    /// unless theta is 0.
    Flow solve_at_rest(const Vector& momentum) const;

private:
    struct Solver;

    /// Takes data in the unit of the mesh.
    Flow solve(const Vector& momentum, const Vector& boundary) const;

    Shared<const FlowOperators> operators_;
    double theta_;
    Shared<const Solver> solver_;
};

} // namespace polydec
