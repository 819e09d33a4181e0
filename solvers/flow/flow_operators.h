// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/input_units.h"
#include "dec/forms/operator.h"
#include "solvers/flow/flow_spaces.h"
#include "solvers/flow/incompressible_flow.h"

namespace polydec {

/// The linear operators of a flow, built once: its spaces with their stars, and its boundary data.
/// Everything is in the unit of the mesh; the options given to the constructor are in the input's.
struct FlowOperators : FlowUnits {
    FlowOperators(const Discretization& mesh, const FlowOptions& options);

    Discretization mesh;
    FlowOptions options;
    int n;
    FlowSpaces spaces;
    Operator star;            // of all (n-1)-forms
    Operator curl;            // d_(n-2) of all (n-2)-forms
    HodgeStar flux_star;      // of free fluxes
    HodgeStar vorticity_star; // of free vorticities
    Vector wall_circulation;  // around all (n-2)-cells, along facets with a known velocity
    Vector boundary_flux;     // size(n-1), 0 at the free ones

    /// Circulations around all (n-2)-cells, 0 where the vorticity is fixed at 0. `along` is a
    /// factor of the known velocities on the boundary: 1, or 0 for the linear part.
    Vector circulation(const Vector& w, double along) const {
        return spaces.vorticity.extend(free_circulation(w, along));
    }
    Vector free_circulation(const Vector& w, double along) const;

    /// The vorticity z: star^-1 of the circulations.
    Vector vorticity(const Vector& w, double along) const;

    /// star d z, size(n-1).
    Vector curl_of(const Vector& vorticity) const { return star * (curl * vorticity); }

    /// The largest rate at which friction takes vorticity away, 1 / time: the viscosity times the
    /// largest eigenvalue of d delta. Exact but for no-slip walls, where it is an upper bound.
    double friction_rate() const;
};

} // namespace polydec
