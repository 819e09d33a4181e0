// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "dec/conditioned_complex.h"
#include "dec/forms/cochain.h"
#include "dec/forms/operator.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

struct DiffusionOptions {
    double coefficient = 1; ///< nu, at least 0; length squared over time
    /// Without, those that hold where nothing is done about the boundary (built_in_conditions).
    /// Robin's as well, of which the data are 0: what flows out is the coefficient times the trace.
    std::optional<BoundaryConditions> conditions = {};
    std::string linear_solver = "auto";
};

/// The rate -nu Delta u of primal or dual forms of any degree under conditions on the boundary, and
/// solutions of x + gamma nu Delta x = b, by which steps in time need not be as short as the mesh
/// is fine. Where star_k or star_(k-1) is a matrix, each solves for the codifferential beside the
/// form: the inverse of star_(k-1) is dense, or its entries are of such different sizes that
/// products with it lose the star's digits.
///
/// Values are those of the cells kept(), which no condition fixes: of primal forms all but those on
/// essential facets, of dual ones all but those whose duals are on natural facets, or all but
/// those on essential facets without a dual.
class Diffusion {
public:
    /// Throws InvalidInput if there is no such degree, the mass of these forms is not positive or a
    /// star that must be inverted has a zero (naming the cells), the coefficient is negative or not
    /// finite, or there are conditions but not one for each facet; for Robin's condition like
    /// with_robin.
    Diffusion(const Discretization& mesh, Side side, int degree, const DiffusionOptions& options);
    Diffusion(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
              const DiffusionOptions& options);

    /// M u' = -A u in place of that, for any symmetric A, of primal forms, or of those of which
    /// dual ones are stars; all cells are kept. Throws InvalidInput for sizes that do not fit.
    Diffusion(const HodgeStar& mass, const Operator& stiffness, Side side,
              const std::string& linear_solver = "auto");

    Side side() const { return side_; }
    int degree() const { return degree_; }
    const std::vector<Index>& kept() const { return kept_; }
    Index size() const { return static_cast<Index>(kept_.size()); } ///< of all that is given

    /// -nu Delta u.
    Vector rate(const Vector& values) const;

    /// What values other than 0 on essential facets add to the rate. They are given as
    /// boundary_values of an Unknown are. Throws InvalidInput for another number of values, for
    /// stars that are no diagonals, as where dual forms have Robin's condition too, and for dual
    /// forms if an essential facet has no dual.
    Vector boundary_rate(const Vector& boundary_values) const;

    /// Gets ready for solving with this gamma > 0. Throws SolverFailure if the engine fails.
    void prepare(double gamma);

    /// x with x + gamma nu Delta x = u - explicit_part nu Delta u. Throws like LinearSolver.
    Vector solve(const Vector& values, double explicit_part = 0) const;

private:
    Diffusion(const CellComplex& whole, const HodgeStars& stars, RobinComplex space, Side side,
              int degree, const DiffusionOptions& options);

    SparseMatrix step_matrix(double gamma) const;
    Vector primal_load(const Vector& boundary_values) const;
    Vector dual_load(const Vector& boundary_values) const;

    std::vector<Index> kept_;
    Side side_;
    int degree_;
    double coefficient_ = 1;
    Operator stiffness_;
    HodgeStar mass_;
    Vector robin_; // what Robin's condition adds to the stiffness of primal forms
    bool is_mixed_ = false;
    MatrixFacts facts_;
    std::shared_ptr<LinearSolver> solver_;
    Index unknowns_ = 0; // solved for in a step

    // of forms under conditions
    struct Space {
        CellComplex whole;
        HodgeStars stars;
        ConditionedComplex kept;
    };
    std::optional<Space> space_;
};

} // namespace polydec
