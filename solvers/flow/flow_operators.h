// SPDX-License-Identifier: MIT
#pragma once

#include "complex/relative.h"
#include "dec/forms/input_units.h"
#include "dec/forms/operator.h"
#include "solvers/flow/incompressible_flow.h"

#include <vector>

namespace polydec {

/// The linear operators of a flow, made once: star_(n-1), the vorticity where it is not 0 by the
/// conditions, and the facets whose flux is not given. All is in the unit of the mesh, but for the
/// options that are handed over.
struct FlowOperators {
    FlowOperators(const Discretization& mesh, const FlowOptions& options);

    Discretization mesh;
    FlowOptions options;
    int n;
    Operator star;              // of (n-1)-forms
    RelativeComplex swirling;   // without the (n-2)-cells whose vorticity is 0
    HodgeStar vorticity_star;   // of its (n-2)-forms
    Operator curl;              // d_(n-2) of these
    Vector wall_circulation;    // around them, along walls that move
    std::vector<Index> unknown; // facets whose flux is not given
    Vector boundary_flux;       // size(n-1), 0 at the unknown ones
    SparseMatrix divergence;    // d_(n-1) of the unknown ones
    HodgeStar unknown_star;     // of the unknown ones
    std::vector<bool> tied;     // n-cells at an open facet

    /// z on the cells that swirl; along = 1: walls that move count, 0: they rest.
    Vector vorticity(const Vector& w, double along) const;

    /// star d z, without viscosity.
    Vector curl_of(const Vector& vorticity) const { return star * (curl * vorticity); }

    Vector unknowns_of(const Vector& all) const { return all(unknown); }

    /// Values of a power of length in the unit of the mesh, and the other way round.
    Vector in_unit(const Vector& values, int power, const char* what) const {
        return form_in_input_units(values, mesh.unit(), -power, what);
    }
    Vector in_input(const Vector& values, int power, const char* what) const {
        return form_in_input_units(values, mesh.unit(), power, what);
    }
};

} // namespace polydec
