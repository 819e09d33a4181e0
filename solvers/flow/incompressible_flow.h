// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "dec/discretization/discretization.h"
#include "solvers/flow/advection.h"
#include "solvers/flow/flow_data.h"

#include <string>
#include <vector>

namespace polydec {

struct FlowOptions {
    double viscosity = 0; ///< nu, length^2 over time
    /// A known pressure is the total pressure, and is 0.
    FlowBoundary everywhere = FlowBoundary::free_slip;
    std::vector<FlowBoundary> facets = {}; ///< empty, or one for each (n-1)-cell
    /// Fluxes through the boundary, a primal (n-1)-form; only values at facets with a known flux
    /// are used. Empty: 0.
    Vector boundary_flux = {};
    /// Velocities of facets with a known tangential velocity, such as moving walls: a row of N
    /// components per (n-1)-cell, of which only the tangential part is used. Empty: 0.
    Points wall_velocity = {};
    /// Vorticity of a rotating frame, a primal (n-2)-form (n = 2: at vertices). Empty: 0.
    Vector rotation = {};
    std::string linear_solver = "auto";
};

/// Incompressible flow in any dimension n >= 2, on surfaces and in solids: du/dt + i_u omega = -dB
/// - nu delta omega, div u = 0, with omega = du and B the pressure over the density plus |u|^2 / 2.
/// The state is the flux w of u, a primal (n-1)-form with d w = 0, so it includes the harmonic
/// part; u itself is the dual 1-form star w. Without viscosity, forces and known pressures the
/// energy w . star w / 2 is constant, because the advection is antisymmetric (see Advection).
/// Viscosity dissipates nu |omega|^2.
///
/// The vorticity z is a primal (n-2)-form, star^-1 of the circulation around its cells. A handle;
/// use it from one thread at a time. All is in the units of the input. Source: Mullen, Crane,
/// Pavlov, Tong, Desbrun 2009; Mohamed, Hirani, Samtaney 2016.
class IncompressibleFlow {
public:
    /// Throws InvalidInput like Advection; naming the cells, if star_(n-1) or star_(n-2) is not
    /// positive; for data of wrong size or not finite; for fluxes that do not balance; and for
    /// viscosity if star_(n-2) is a matrix.
    IncompressibleFlow(const Discretization& mesh, const FlowOptions& options = {});

    const Discretization& mesh() const&;
    Discretization mesh() && { return mesh(); }
    const FlowOptions& options() const&;
    FlowOptions options() && { return options(); }

    /// The flow without divergence, with the given boundary fluxes, that is nearest to these fluxes
    /// in the norm of star_(n-1). If only rounding errors are left of these fluxes, the flow
    /// nearest to rest; see warning_of_rest.
    Vector project(const Vector& flux) const;

    /// z, of the flow alone: size(n-2) values.
    Vector vorticity(const Vector& w) const;

    /// Forces along duals of facets, size(n-1) values: the inertia -A(z + rotation) w, which is not
    /// stiff, and the friction -nu star d z, which is linear in w. rate() is dw/dt: star^-1 of
    /// their sum minus a gradient.
    Vector inertia(const Vector& w) const;
    Vector friction(const Vector& w) const;
    Vector rate(const Vector& w) const;

    /// star w: u along the duals of facets, a dual 1-form but for its sign.
    Vector momentum(const Vector& w) const;

    /// The pressure over the density, a dual 0-form: at the centers of n-cells, with mean 0 if it
    /// is known nowhere on the boundary.
    Cochain pressure(const Vector& w) const;

    /// The energy w . star w / 2, and nu |omega|^2, its rate of loss by friction if walls rest.
    double energy(const Vector& w) const;
    double dissipation(const Vector& w) const;

    /// The integral of |omega|^2 / 2, in length^n over time^2.
    double enstrophy(const Vector& w) const;

    /// The ratio of the energies of two flows, for meshes of any size; 1 if both are at rest.
    /// Throws InvalidInput if it is not finite.
    double relative_energy(const Vector& w, const Vector& other) const;

    /// Circulations around all (n-2)-cells: star_(n-2) z, so 0 where the vorticity is fixed at 0.
    /// On a surface whose walls all have a known velocity, their sum is the circulation along the
    /// walls; on a closed surface it is 0 to rounding.
    Vector circulations(const Vector& w) const;

    /// The largest |d w| of an n-cell, relative to the largest sum of |w| over its facets. At
    /// rounding level for flows.
    double divergence(const Vector& w) const;

    /// The shortest time in which the flow exchanges the content of a cell, about the longest
    /// stable explicit step. Infinity at rest.
    double exchange_time(const Vector& w) const;

    /// The solver of implicit steps, for theta, a fraction of the time step. Make it once per
    /// theta.
    FlowProjection implicit_part(double theta) const;

private:
    friend class Flow;
    struct Parts;

    double ratio_of_energies(const Vector& w, const Vector& other) const;
    double friction_rate() const;

    Shared<const Parts> parts_;
};

/// A warning if some motion is given, such as fluxes, vorticities or velocities of walls, but
/// `flow`, what is left of it without divergence, is 0.
std::vector<std::string> warning_of_rest(const Vector& given, const Vector& flow);

} // namespace polydec
