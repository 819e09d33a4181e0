// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cochain.h"
#include "solvers/poisson.h"

namespace polydec {

/// Pressure and flux of a flow through a porous medium.
struct DarcyFlow {
    Cochain pressure; ///< dual 0-form: at sites() of the n-cells
    Cochain flux;     ///< primal (n-1)-form: through the facets, as they are oriented
    SolveReport report;
    Compatibility compatibility;
    std::vector<std::string> warnings = {}; ///< why it may be another one than was asked for
};

/// Darcy's problem: flux = -kappa grad p, div flux = source. The pressure is a dual 0-form, the
/// flux a primal (n-1)-form whose balance d flux = integral of the source is exact in every cell; a
/// pressure that is linear comes out exactly, and so does its flux, on every flat mesh. On a facet
/// of the boundary either the pressure is given (essential) or the flux (natural).
///
/// Where the dual of an essential facet has no length the pressure of its cell is given, and what
/// flows through the facet is what the balance of the cell asks for, shared by area among such
/// facets of one cell. On a mesh all is in the units of the input.
class DarcySolver {
public:
    /// Of the options the side does not matter. Throws like PoissonSolver for dual 0-forms.
    DarcySolver(const Discretization& mesh, const PoissonOptions& options = {});
    explicit DarcySolver(const Cells& cells, const PoissonOptions& options = {});

    /// Places of cells and of facets: circumcenters, or centroids as PoissonSolver tells.
    const Points& sites() const { return poisson_.sites(); }
    const Points& facet_sites() const { return poisson_.flux_sites(); }

    /// source at sites(), per volume; pressures at the essential facets and outflow per area at the
    /// natural ones, both at facet_sites(). Throws like PoissonSolver::solve.
    DarcyFlow solve(const Vector& source, const Vector& pressures, const Vector& outflow) const;

private:
    DarcySolver(const CellComplex& complex, const CellVolumes& volumes, PoissonSolver poisson,
                const BoundaryConditions& conditions);

    DarcyFlow solve_in_unit(const Vector& source, const Vector& pressures,
                            const Vector& outflow) const;
    DarcyFlow mixed_flow(const Vector& source, const Vector& pressures,
                         const Vector& outflow) const;

    PoissonSolver poisson_;
    CellComplex complex_;
    CellVolumes volumes_;
    std::vector<bool> essential_;
};

} // namespace polydec
