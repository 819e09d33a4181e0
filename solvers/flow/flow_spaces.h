// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"
#include "meshes/unit_of_length.h"
#include "solvers/flow/flow_data.h"
#include "solvers/sources/constrained_system.h"

#include <vector>

namespace polydec {

/// Converts values of a power of length between the unit of a mesh and the units of its input.
struct FlowUnits {
    double unit;

    Vector in_unit(const Vector& values, int power, const char* what) const {
        return form_in_input_units(values, unit, -power, what);
    }
    Vector in_input(const Vector& values, int power, const char* what) const {
        return form_in_input_units(values, unit, power, what);
    }
};

/// The spaces of a flow: fluxes, primal (n-1)-forms that are fixed on facets with a known flux, and
/// vorticities, primal (n-2)-forms that are fixed on facets without vorticity and on their faces.
/// So there is no vorticity where walls with and without slip meet.
struct FlowSpaces {
    /// `facets` is empty or has one entry for each (n-1)-cell. Throws InvalidInput for n < 2 and
    /// for another number of entries.
    FlowSpaces(const Cells& cells, FlowBoundary everywhere,
               const std::vector<FlowBoundary>& facets);

    /// Throws InvalidInput if a flux does not balance on a component without known pressure.
    void check_balance(const Vector& flux) const;

    FormSpace flux, vorticity;
    std::vector<BoundaryFacet> open;    // with a known pressure
    std::vector<BoundaryFacet> dragged; // with a known velocity along them
    SparseMatrix divergence;            // d_(n-1) of the free fluxes
    std::vector<bool> tied;             // n-cells at an open facet
    FreeComponents loose;               // n-cells whose pressure is known up to a constant
};

} // namespace polydec
