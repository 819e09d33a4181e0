// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "solvers/flow/advection.h"
#include "solvers/flow/flow_boundary.h"
#include "solvers/flow/flow_projection.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

struct FlowOptions {
    double viscosity = 0; ///< nu, length^2 over time
    /// A known pressure is the total one, and is 0.
    FlowBoundary everywhere = FlowBoundary::free_slip;
    std::vector<FlowBoundary> facets = {}; ///< empty, or one for each (n-1)-cell
    /// Through the boundary, a primal (n-1)-form of which the values at boundary facets that are
    /// not open count; empty: nothing.
    Vector boundary_flux = {};
    /// Velocities along facets that have one, such as moving walls without slip: a row of N
    /// components for each (n-1)-cell, of which the part along the boundary counts; empty: 0.
    Points wall_velocity = {};
    /// Vorticity of the frame, as of a planet: a primal (n-2)-form (n = 2: at vertices); or empty.
    Vector rotation = {};
    std::string linear_solver = "auto";
};

/// The equations of incompressible flow in any dimension n >= 2, on surfaces and in solids:
/// du/dt + i_u omega = -dB - nu delta omega, div u = 0, with omega = du and B the pressure over the
/// density plus |u|^2 / 2. The state is the flux w of u, a primal (n-1)-form with d w = 0, so all
/// of u is there, the harmonic part too; u itself is the dual 1-form star w. Without viscosity,
/// forces and open boundary the energy w . star w / 2 does not change, since the advection is
/// antisymmetric (see Advection); viscosity takes nu |omega|^2 of it.
///
/// The vorticity z is a primal (n-2)-form, star^-1 of the circulation around its cells. The sum of
/// the circulations around all cells is that along the boundary, to rounding: 0 on closed surfaces.
/// A handle; one thread at a time. All is in the units of the input.
/// Source: Mullen, Crane, Pavlov, Tong, Desbrun 2009; Mohamed, Hirani, Samtaney 2016.
class IncompressibleFlow {
public:
    /// Throws InvalidInput like Advection; naming cells where stars are not positive that are
    /// divided by; for data of another size than the cells, no numbers, or more that flows in than
    /// out; for viscosity where star_(n-2) is a matrix.
    IncompressibleFlow(const Discretization& mesh, const FlowOptions& options = {});

    const Discretization& mesh() const;
    const FlowOptions& options() const;
    const Advection& advection() const;

    /// The flow with the fluxes at the boundary and without divergence that is nearest to these
    /// fluxes in the norm of star_(n-1).
    Vector project(const Vector& flux) const;

    /// z, of the flow alone: size(n-2) values.
    Vector vorticity(const Vector& w) const;

    /// -A(z + rotation) w and -nu star d z: what accelerates the flow along duals of facets,
    /// size(n-1) values, the first without stiffness and the second linear in w. dw/dt is star^-1
    /// of their sum less a gradient: rate().
    Vector inertia(const Vector& w) const;
    Vector friction(const Vector& w) const;
    Vector rate(const Vector& w) const;

    /// star w: u along the duals of facets, a dual 1-form but for its sign.
    Vector momentum(const Vector& w) const;

    /// The pressure over the density, a dual 0-form: at the centers of n-cells, with mean 0 if no
    /// boundary is open.
    Cochain pressure(const Vector& w) const;

    /// w . star w / 2, and nu |omega|^2, the rate at which friction takes of it where walls rest.
    double energy(const Vector& w) const;
    double dissipation(const Vector& w) const;

    /// |omega|^2 / 2 in all, length^n over time^2.
    double enstrophy(const Vector& w) const;

    /// The energy of a flow over that of another, whatever the size of the mesh; 1 between flows at
    /// rest. Throws InvalidInput where it is no number.
    double relative_energy(const Vector& w, const Vector& other) const;

    /// Circulations along all cells' duals: star_(n-2) z; and their sum.
    Vector circulations(const Vector& w) const;
    double total_circulation(const Vector& w) const { return circulations(w).sum(); }

    /// The largest |d w| over the sum of |w| of its facets, of n-cells: rounding for flows.
    double divergence(const Vector& w) const;

    /// The time in which the content of some cell is exchanged: explicit steps must be about as
    /// short. Infinity at rest.
    double exchange_time(const Vector& w) const;

    /// What implicit steps solve, theta a part of the step; made once for each theta.
    FlowProjection implicit_part(double theta) const;

private:
    friend class Flow;
    struct Parts;

    double ratio_of_energies(const Vector& w, const Vector& other) const;

    std::shared_ptr<const Parts> parts_;
};

} // namespace polydec
