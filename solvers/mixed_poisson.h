// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/star.h"
#include "solvers/constrained_system.h"
#include "solvers/saddle_solver.h"

#include <string>
#include <vector>

namespace polydec {

/// Dual 0-forms p and their fluxes u, primal (n-1)-forms, with star u = -d p and d u given. Where
/// star_(n-1) is a matrix, fluxes are no differences of two values over a length, and both are
/// found together: the mixed method, on simplices by Galerkin's star that of Raviart and Thomas
/// 1977.
class MixedPoisson {
public:
    /// On a complex of two sides. Essential facets are those of the boundary where p is given, or
    /// where robin, 0 elsewhere, is positive: there p and its derivative r - robin p are unknown,
    /// and r / robin stands for p.
    /// Throws like SaddleSolver.
    MixedPoisson(const CellComplex& complex, const HodgeStars& stars,
                 const std::vector<bool>& essential, const Vector& robin,
                 const std::string& engine);

    struct Flow {
        Vector values;
        Vector flux; ///< through the facets, as they are oriented
        SolveReport report;
        Compatibility compatibility;
    };

    /// What arises in each n-cell, values at the facets (essential ones matter), and what flows out
    /// through them (natural ones). On components without essential facet the part of the sources
    /// that nothing can balance is removed, in proportion to volume, and the mean of the values
    /// is 0. Throws InvalidInput, naming the cell, where data are no numbers.
    Flow solve(const Vector& sources, const Vector& boundary_values, const Vector& outflow) const;

private:
    SparseMatrix divergence_, M_;
    Vector outward_; // of facets: the sign of the cell beside it on the boundary, 0 inside
    std::vector<bool> essential_;
    std::vector<Index> unknown_; // facets whose flux is not given
    SaddleSolver solver_;
    FreeComponents components_;
};

/// Throws InvalidInput, naming the cell, where a right-hand side, that of cells of a degree, is no
/// number: data are, but their products with volumes and weights need not be.
void check_loads(const char* what, const DenseMatrix& loads, int degree);

} // namespace polydec
