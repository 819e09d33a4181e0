// SPDX-License-Identifier: MIT
#pragma once

#include "base/solve_report.h"
#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "solvers/flow/flow_boundary.h"

#include <memory>
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

/// What is known of a slow flow on the boundary; what is empty is 0.
struct StokesData {
    Vector through = {};   ///< what flows through facets that are not open; size(n-1)
    Vector along = {};     ///< where the velocity along facets is known, the tangential velocity:
                           ///< integrals of star u over the duals within the boundary of the
                           ///< (n-2)-cells (see boundary_de_rham); size(n-2)
    Vector vorticity = {}; ///< where the flow slips, delta u on (n-2)-cells; size(n-2)
    Vector pressure = {};  ///< where it is known; size(n-1)
};

/// A slow flow: what flows through the facets, how it turns, and its pressure.
struct StokesFlow {
    Cochain flux;      ///< primal (n-1)-form, as facets are oriented
    Cochain vorticity; ///< delta of it, a primal (n-2)-form
    Cochain pressure;  ///< dual 0-form, of mean 0 where it is known nowhere
    SolveReport report;
};

/// Stokes' problem -nu Delta u + grad p = f, div u = 0: nu d w + grad p = f and w = delta u for the
/// flux u, a primal (n-1)-form, with one factorization. At each facet of the boundary two things
/// are known (see FlowBoundary); the vorticity where walls slip can be other than 0. The pressure
/// and no vorticity do not determine a flow. No flow is lost: d flux
/// = 0 in every cell to rounding. On grids it is the scheme of markers and cells. Source: Dubois
/// 2002 (vorticity, velocity, pressure); Harlow, Welch 1965 (grids). An object is used by one
/// thread at a time. On a mesh all is in the units of the input.
class StokesSolver {
public:
    /// n >= 2. Throws InvalidInput for another dimension, a viscosity that is not positive, other
    /// numbers of conditions than facets; naming the cells, where star_(n-2), or star_(n-1) at
    /// facets inside, is not positive, or that at open facets negative; and where nothing holds a
    /// flow back: around a hole, or between open facets, if no wall of a component is without slip.
    explicit StokesSolver(const Cells& cells, const StokesOptions& options = {});

    StokesSolver(StokesSolver&&) noexcept;
    ~StokesSolver();

    /// The force f is given as its flux, a primal (n-1)-form. Values of data at other cells than
    /// they are for do not matter. Throws InvalidInput for other sizes and what is not finite, and
    /// if more flows in than out of a component without open facet.
    StokesFlow solve(const Cochain& force, const StokesData& data = {}) const;

private:
    struct System;
    std::unique_ptr<const System> system_;
};

} // namespace polydec
