// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/boundary_conditions.h"
#include "distributed/discretize.h"
#include "distributed/shared_solver.h"

namespace polydec {

/// Collective: the sites of form values on own cells, in units of the mesh: see cell_centers.
Points cell_centers(const Ranks& ranks, const DistributedMesh& mesh, int k);

struct SharedPoissonOptions {
    Side side = Side::primal;
    /// As for a FormSpace; conditions per facet need one for every own (n-1)-cell.
    BoundaryConditions boundary = {};
    SharedEngine engine = {};
};

/// PoissonSolver over all ranks, with circumcentric stars (see check_stars): the same problem and
/// the same solution, up to the engine's accuracy. Vectors and tables have the entries of own
/// cells. Every function is collective.
class SharedPoissonSolver {
public:
    /// Throws like PoissonSolver and check_stars.
    SharedPoissonSolver(const Ranks& ranks, const DistributedMesh& mesh,
                        const SharedPoissonOptions& options = {});

    /// See PoissonSolver::solve. Values of f are at the centers of vertices (primal) or n-cells
    /// (dual), boundary values at those of vertices or facets, derivatives at those of facets; what
    /// is empty is 0.
    Solution solve(const Vector& f, const Vector& boundary_values = {},
                   const Vector& normal_derivatives = {}) const;

private:
    struct Problem;
    Ranks ranks_;
    Shared<Problem> problem_;
    SharedSolver solver_;
};

} // namespace polydec
