// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/boundary_conditions.h"
#include "distributed/discretize.h"
#include "distributed/shared_solver.h"

#include <functional>

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

    /// See PoissonSolver.
    const Points& sites() const& { return sites_; }
    const Points& boundary_sites() const& { return side_ == Side::primal ? sites_ : flux_sites_; }
    const Points& flux_sites() const& { return flux_sites_; }
    Points sites() && { return sites_; }
    Points boundary_sites() && { return boundary_sites(); }
    Points flux_sites() && { return flux_sites_; }

    /// See PoissonSolver::solve.
    Solution solve(const Vector& f, const Vector& boundary_values,
                   const Vector& normal_derivatives) const;

private:
    struct Problem;
    explicit SharedPoissonSolver(const Ranks& ranks, Problem problem, const SharedEngine& engine);

    using FromFacets = std::function<Vector(const Vector& boundary_values, const Vector& flows)>;
    using FromBoundary = std::function<Vector(const Vector& boundary_values)>;

    Ranks ranks_;
    Side side_;
    Points sites_, flux_sites_;
    Vector mass_;        // of own unknowns
    FromFacets load_;    // boundary data to right-hand side
    FromBoundary fixed_; // boundary values to fixed unknowns
    SharedSolver solver_;
};

} // namespace polydec
