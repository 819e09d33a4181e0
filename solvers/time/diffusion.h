// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "base/shared.h"
#include "dec/boundary/form_space.h"
#include "dec/discretization/fingerprint.h"
#include "solvers/sources/boundary_forms.h"
#include "solvers/time/run.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

struct BoundaryLoads;
struct FormEquations;

/// The rate -nu Delta u of the forms of a space. Its Resolvent frees time steps from the mesh size.
///
/// Vectors of values have one entry per free cell (see kept). With a Robin condition, the outflow
/// is the coefficient times the trace, up to data.
class Diffusion {
public:
    /// nu is at least 0, length squared over time, in the input's units. Throws InvalidInput for
    /// another nu and, naming the cells, if the mass of these forms is not positive or a star to be
    /// inverted has a zero; with a Robin condition, like Cells::boundary_star.
    explicit Diffusion(const FormSpace& space, double nu = 1,
                       const std::string& linear_solver = "auto");

    /// For M u' = -A u instead, with any symmetric A on primal forms, or on those whose stars are
    /// the dual forms. Keeps all cells. Throws InvalidInput for sizes that do not fit.
    Diffusion(const HodgeStar& mass, const Operator& stiffness, Side side,
              const std::string& linear_solver = "auto");

    Side side() const { return side_; }
    int degree() const { return degree_; }
    const std::vector<Index>& kept() const& { return kept_; }
    std::vector<Index> kept() && { return kept(); }
    Index size() const { return static_cast<Index>(kept_.size()); } ///< the number of values
    Index all() const; ///< the number of cells, free or not

    /// -nu Delta u.
    Vector rate(const Vector& values) const;

    /// The contribution of boundary data, as in PoissonSolver, to the rate. Throws InvalidInput for
    /// a wrong number of data, for values that are not finite, and for a user-defined stiffness.
    Vector boundary_rate(const BoundaryForms& data) const;

    /// The form at all cells: fixed values from data, and the free values. With data, form_of and
    /// values_of throw like boundary_rate.
    Vector form_of(const Vector& values, const BoundaryForms& data = {}) const;

    /// The free values of a form, with its other values replaced by data. If the mass M of a primal
    /// form is a matrix, the free values x keep the moments of the form at the kept cells: M_kk x =
    /// (M u)_k. So fixed values may change in time.
    Vector values_of(const Vector& form, const BoundaryForms& data) const;
    /// The free values of a form, or a rate, known at all cells.
    Vector values_of(const Vector& form) const;

    /// Identifies everything that determines rates and solutions: cells, stars, conditions,
    /// coefficient, engine, or a user-defined stiffness. Throws like Operator::matrix.
    Fingerprint fingerprint() const;

private:
    friend class Resolvent;

    SparseMatrix step_matrix(double gamma) const;
    const FormEquations& equations() const;
    BoundaryLoads loads(const BoundaryForms& data) const;
    Vector moved(const Vector& fixed) const;

    /// Removes the means of a function on components through whose boundary nothing flows, which
    /// diffusion keeps. Of primal forms whose stars are the dual ones.
    Vector without_means(Vector w) const;
    bool keeps_means() const;

    std::vector<Index> kept_;
    Side side_;
    int degree_;
    double coefficient_ = 1, unit_ = 1; // of length
    Operator stiffness_;
    HodgeStar mass_;
    bool is_mixed_ = false;
    MatrixFacts facts_;
    std::string linear_solver_;

    struct Space;
    Shared<const Space> space_; // none for a user-defined stiffness
};

/// Solves (I + gamma nu Delta) x = u for a Diffusion. If star_k or star_(k-1) is a matrix, it
/// solves for the codifferential as a second unknown: the inverse of star_(k-1) would be dense, or
/// entries of very different sizes would lose the star's digits. Use an object from one thread at a
/// time.
class Resolvent {
public:
    /// Throws BackendUnavailable or InvalidInput for a linear solver that does not exist.
    explicit Resolvent(const Diffusion& diffusion);

    /// Factorizes for this gamma > 0. Throws SolverFailure if the engine fails.
    void prepare(double gamma);

    /// Solves with the last gamma. Throws like LinearSolver, and SolverFailure if x has a larger
    /// norm than u: then the Laplacian has negative eigenvalues.
    Vector solve(const Vector& values) const;

private:
    void check_growth(const Vector& before, const Vector& after) const;

    /// The solution of the factorized system for w, without the mean that rounding leaves.
    Vector solved(const Vector& w) const;
    Vector of_primal(const Vector& values) const;

    Diffusion of_;
    std::unique_ptr<LinearSolver> solver_;
    Vector scales_;      // of rows and columns of the matrix
    double largest_ = 1; // of its diagonal, over the mass
    double shift_ = 0;   // what the mass is multiplied by in addition
};

/// A run with fixed steps from time 0. A march to a time ends after the step that is nearest to it.
class FixedSteps : public Run {
public:
    double time() const final { return static_cast<double>(steps_) * time_step_; }
    double time_step() const { return time_step_; }

    /// Takes this many steps. Throws like march.
    void advance(std::int64_t steps = 1, const TimeListener& progress = {});

    Arrival march(double until, const TimeListener& progress = {}) final;
    StepPlan plan(const std::vector<double>& times) const final;
    std::vector<Vector> state() const final { return state_; }
    void resume(double time, const std::vector<Vector>& state) final;
    bool resumes_anywhere() const final { return true; }

protected:
    /// Throws InvalidInput unless the step is finite and above 0.
    FixedSteps(double time_step, std::vector<Vector> state);

    /// Advances a state at time() by one step. If it throws, the state is unchanged.
    virtual void step(std::vector<Vector>& state) const = 0;

    /// The limit and the advice of the plan.
    virtual StepPlan limit() const = 0;

    const std::vector<Vector>& now() const { return state_; }

private:
    /// The number of the step that is nearest to a time. Throws InvalidInput if it is below
    /// `least`.
    std::int64_t steps_to(double time, std::int64_t least) const;

    double time_step_;
    std::int64_t steps_ = 0;
    std::vector<Vector> state_;
};

} // namespace polydec
