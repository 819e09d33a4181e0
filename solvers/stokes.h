// SPDX-License-Identifier: MIT
#pragma once

#include "base/solve_report.h"
#include "dec/discretization.h"
#include "dec/forms/cochain.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

class SaddleSolver;

struct StokesOptions {
    double viscosity = 1;
    std::string linear_solver = "auto";
};

/// A slow flow: what flows through the facets, how it turns, and its pressure.
struct StokesFlow {
    Cochain flux;      ///< primal (n-1)-form, as facets are oriented
    Cochain vorticity; ///< delta of it, a primal (n-2)-form
    Cochain pressure;  ///< dual 0-form, of mean 0
    SolveReport report;
};

/// Stokes' problem -nu Delta u + grad p = f, div u = 0 with the velocity u given on the boundary:
/// nu d w - grad p = f and w = delta u for the flux u, a primal (n-1)-form, with one factorization.
/// No flow is lost: d flux = 0 in every cell to rounding. On grids it is the scheme of markers and
/// cells.
/// Source: Dubois 2002 (vorticity, velocity, pressure); Harlow, Welch 1965 (grids).
/// An object is used by one thread at a time.
class StokesSolver {
public:
    /// n >= 2. Throws InvalidInput for another dimension, a viscosity that is not positive, and,
    /// naming the cells, where star_(n-2), or star_(n-1) inside, is not positive.
    StokesSolver(const Discretization& mesh, const StokesOptions& options = {});
    StokesSolver(const CellComplex& complex, const HodgeStars& stars,
                 const StokesOptions& options = {});

    StokesSolver(StokesSolver&&) noexcept;
    ~StokesSolver();

    /// The force f as its flux, a primal (n-1)-form; what flows through the facets of the boundary
    /// (other values do not matter), and the tangential velocity there, the integrals of star u
    /// over the duals within the boundary of the (n-2)-cells (see boundary_de_rham), of which there
    /// may be none for 0. Throws InvalidInput for other sizes and what is not finite, and if more
    /// flows in than out.
    StokesFlow solve(const Cochain& force, const Vector& through, const Vector& along = {}) const;

private:
    CellComplex complex_;
    double viscosity_;
    std::vector<Index> inside_; // facets, of unknown flux
    SparseMatrix divergence_, turn_, M_, M_below_, boundary_;
    Vector volumes_;
    std::unique_ptr<SaddleSolver> solver_;
};

} // namespace polydec
