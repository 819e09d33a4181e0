// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "dec/fingerprint.h"
#include "dec/form_space.h"
#include "solvers/sources/boundary_forms.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

struct BoundaryLoads;
struct FormEquations;

/// The rate -nu Delta u of the forms of a space, and solutions of x + gamma nu Delta x = b, by
/// which steps in time need not be as short as the mesh is fine. Where star_k or star_(k-1) is a
/// matrix, each solves for the codifferential beside the form: the inverse of star_(k-1) is dense,
/// or its entries are of such different sizes that products with it lose the star's digits.
///
/// Values are the free ones of the space. Where Robin's condition holds, what flows out is the
/// coefficient times the trace, but for data.
class Diffusion {
public:
    /// nu is at least 0, length squared over time, of a mesh's input. Throws InvalidInput for
    /// another nu and, naming the cells, if the mass of these forms is not positive or a star that
    /// must be inverted has a zero; for Robin's condition like Cells::boundary_star.
    explicit Diffusion(const FormSpace& space, double nu = 1,
                       const std::string& linear_solver = "auto");

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

    /// What data on the boundary add to the rate, those of PoissonSolver. Throws InvalidInput
    /// for other numbers of them, for what is not finite, and for a stiffness of one's own.
    Vector boundary_rate(const BoundaryForms& data) const;

    /// The form at all cells: what data fix, beside its values at the kept ones. Where there are
    /// data this and the next throw like boundary_rate.
    Vector form_of(const Vector& values, const BoundaryForms& data = {}) const;

    /// The values of a form, with what data fix in place of its own at the other cells. Where the
    /// mass M of a primal form is a matrix, they are those x that M takes to what the form's
    /// moments are at the kept cells, M_kk x = (M u)_k, so that fixed values may change in time.
    Vector values_of(const Vector& form, const BoundaryForms& data) const;
    /// Of a form, or a rate, that is known at all cells.
    Vector values_of(const Vector& form) const;

    /// Gets ready for solving with this gamma > 0. Throws SolverFailure if the engine fails.
    void prepare(double gamma);

    /// x with x + gamma nu Delta x = u - explicit_part nu Delta u, explicit_part at most gamma.
    /// Throws like LinearSolver, and SolverFailure where x is longer than u in its own norm: then
    /// the Laplacian has negative eigenvalues.
    Vector solve(const Vector& values, double explicit_part = 0) const;

    /// Of all that makes rates and solutions: cells, stars, conditions, coefficient, engine, or a
    /// stiffness of one's own. Throws like Operator::matrix.
    Fingerprint fingerprint() const;

private:
    SparseMatrix step_matrix(double gamma) const;
    const FormEquations& equations() const;
    BoundaryLoads loads(const BoundaryForms& data) const;
    Vector moved(const Vector& fixed) const;
    void check_growth(const Vector& before, const Vector& after) const;

    std::vector<Index> kept_;
    Side side_;
    int degree_;
    double coefficient_ = 1, unit_ = 1; // of length
    Operator stiffness_;
    HodgeStar mass_;
    bool is_mixed_ = false;
    MatrixFacts facts_;
    std::shared_ptr<LinearSolver> solver_;
    Vector scales_; // of rows and columns of what is solved in a step

    struct Space;
    std::shared_ptr<const Space> space_; // none for a stiffness of one's own
};

} // namespace polydec
