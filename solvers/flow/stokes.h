// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "base/solve_report.h"
#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "solvers/flow/flow_data.h"

#include <string>
#include <vector>

namespace polydec {

class SaddleSolver;

struct StokesOptions {
    double viscosity = 1;
    FlowBoundary everywhere = FlowBoundary::no_slip;
    std::vector<FlowBoundary> facets = {}; ///< empty, or one for each (n-1)-cell
    std::string linear_solver = "auto";
};

/// Boundary data of a slow flow; empty members are 0.
struct StokesData {
    Vector through = {};   ///< fluxes through facets with a known flux; size(n-1)
    Vector along = {};     ///< tangential velocity on facets where it is known: integrals of star u
                           ///< over the duals of (n-2)-cells within the boundary (see
                           ///< boundary_de_rham); size(n-2)
    Vector vorticity = {}; ///< delta u on the (n-2)-cells of slipping walls; size(n-2)
    Vector pressure = {};  ///< on facets where it is known; size(n-1)
};

/// A slow flow.
struct StokesFlow {
    Cochain flux;      ///< through facets, a primal (n-1)-form, signed by their orientation
    Cochain vorticity; ///< delta of the flux, a primal (n-2)-form
    Cochain pressure;  ///< dual 0-form, of mean 0 on components without a known pressure
    SolveReport report;
};

/// Solves Stokes' problem -nu Delta u + grad p = f, div u = 0, as nu d w + grad p = f, w = delta u
/// for the flux u, a primal (n-1)-form, with one factorization. Each facet of the boundary has two
/// conditions (see FlowBoundary); on slipping walls a vorticity other than 0 may be given. The
/// balance d u is 0 in every cell to rounding. On grids this is the marker-and-cell scheme. All is
/// in the units of the input. Copies share the factorization; use them from one thread at a time.
/// Source: Dubois 2002 (vorticity, velocity, pressure); Harlow, Welch 1965 (grids).
class StokesSolver {
public:
    /// Throws InvalidInput for n < 2, a viscosity that is not positive, and a wrong number of
    /// conditions; naming the cells, if star_(n-2) or star_(n-1) is not positive, where facets with
    /// a known pressure may have no dual; naming the facet, for FlowBoundary::open, which leaves a
    /// slow flow undetermined; and if a component has flows around holes or between facets with
    /// known pressure, and no no-slip wall that resists them.
    explicit StokesSolver(const Cells& cells, const StokesOptions& options = {});

    /// `force` is the flux of f, a primal (n-1)-form. Data on other cells are ignored. Throws
    /// InvalidInput for wrong sizes, for values that are not finite, and if the known fluxes of a
    /// component without known pressure do not balance.
    StokesFlow solve(const Cochain& force, const StokesData& data = {}) const;

private:
    struct System;
    Shared<const System> system_;
};

} // namespace polydec
