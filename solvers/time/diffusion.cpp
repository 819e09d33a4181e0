// SPDX-License-Identifier: MIT
#include "solvers/time/diffusion.h"

#include "backends/registry.h"
#include "backends/spectra/mass.h"
#include "base/block_matrix.h"
#include "base/checks.h"
#include "base/errors.h"
#include "base/exponent.h"
#include "base/lazy.h"
#include "dec/discretization/advice.h"
#include "dec/discretization/positive_mass.h"
#include "dec/forms/laplacian.h"
#include "meshes/unit_of_length.h"
#include "solvers/sources/constrained_system.h"
#include "solvers/sources/form_equations.h"
#include "solvers/spectra/laplacian_pencil.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// The mixed matrix of a form and its codifferential: M_k + t (d^T M_(k+1) d + weights, if any),
/// off the diagonal t d^T M_k, and -t M_(k-1). Quasi-definite, so it has factors in every order.
SparseMatrix mixed_step(const FormSpace& space, double t) {
    const Cells inside = space.inside();
    const CellComplex& complex = inside.complex();
    const HodgeStars& stars = inside.stars();
    const SparseMatrix weights = space.free_robin_weights();
    const int k = space.cell_degree();
    const Operator mass = Operator::star(stars[k]);
    const Operator below = Operator::derivative(complex, k - 1).transposed();
    Operator A =
        weights.size() > 0 ? mass + t * Operator::star({stars.volumes(), k, weights}) : mass;
    if (k < complex.dimension()) {
        const Operator d = Operator::derivative(complex, k);
        A = A + t * (d.transposed() * Operator::star(stars[k + 1]) * d);
    }
    return block_matrix(A, t * (below * mass), -t * Operator::star(stars[k - 1]));
}

/// The components on which constant functions are in the kernel: their differences vanish exactly,
/// and no Robin condition holds. None for forms of other degrees.
FreeComponents free_components(const FormSpace& space) {
    const Cells inside = space.inside();
    const CellComplex& complex = inside.complex();
    const int k = space.cell_degree(), n = complex.dimension();
    if (k != 0 && k != n)
        return {};
    const SparseMatrix d =
        k == 0 ? derivative(complex, 0) : SparseMatrix(derivative(complex, n - 1).transpose());
    const Vector ones = Vector::Ones(d.cols());
    Vector ties = d.cwiseAbs().transpose() * Vector((d * ones).cwiseAbs());
    if (const SparseMatrix robin = space.free_robin_weights(); robin.size() > 0)
        ties += robin.diagonal();
    std::vector<bool> tied;
    for (const double tie : ties)
        tied.push_back(tie > 0);
    const HodgeStar mass = inside.stars()[k];
    return {d, std::vector<bool>(tied.size(), false), tied,
            k == 0 ? mass * ones : mass.solve(ones)};
}

/// The coefficient in the squared unit of length.
double in_unit_of(const Cells& cells, double coefficient) {
    return in_input_units(Vector{{coefficient}}, cells.unit(), -2, "coefficient of diffusion")[0];
}

bool has_any(const BoundaryForms& data) {
    return data.values.size() > 0 || data.codifferential.size() > 0 || data.flow.size() > 0 ||
           data.derivative_flow.size() > 0;
}

} // namespace

struct Diffusion::Space {
    FormSpace of;
    FreeComponents constants;
    Lazy<FormEquations> equations = {}; // only for data
};

Diffusion::Diffusion(const FormSpace& space, double nu, const std::string& linear_solver)
    : kept_(space.free()),
      side_(space.side()),
      degree_(space.degree()),
      coefficient_(in_unit_of(space.cells(), nu)),
      unit_(space.cells().unit()),
      stiffness_(Operator::zero(0, 0)),
      mass_(space.inside().stars()[space.cell_degree()]),
      linear_solver_(linear_solver) {
    const Cells inside = space.inside();
    const int k = space.cell_degree();
    check_positive_mass(mass_, side_, degree_);
    check_not_negative("the coefficient of diffusion", coefficient_);
    space_ = std::shared_ptr<const Space>(new Space{space, free_components(space)});
    stiffness_ = space.stiffness();
    facts_ = {.symmetry = Symmetry::symmetric,
              .domain_dimension = inside.dimension(),
              .many_solves = true};
    is_mixed_ = k > 0 && !(mass_.is_diagonal() && inside.stars()[k - 1].is_diagonal());
    if (!is_mixed_ && laplacian_definiteness(inside.stars(), k) == Definiteness::semidefinite)
        facts_.definiteness = Definiteness::positive;
}

Diffusion::Diffusion(const HodgeStar& mass, const Operator& stiffness, Side side,
                     const std::string& linear_solver)
    : side_(side),
      degree_(side == Side::primal ? mass.degree() : mass.dimension() - mass.degree()),
      stiffness_(stiffness),
      mass_(mass),
      facts_{.symmetry = Symmetry::symmetric,
             .domain_dimension = mass.dimension(),
             .many_solves = true},
      linear_solver_(linear_solver) {
    if (stiffness.rows() != mass.size() || stiffness.cols() != mass.size())
        throw InvalidInput(fmt::format(
            "the stiffness is {} x {}: expected {} x {}, like the star of {}-cells",
            stiffness.rows(), stiffness.cols(), mass.size(), mass.size(), mass.degree()));
    check_positive_mass(mass, side, degree_);
    for (Index cell = 0; cell < mass.size(); ++cell)
        kept_.push_back(cell);
}

Index Diffusion::all() const {
    return space_ ? space_->of.cells().stars()[mass_.degree()].size() : size();
}

SparseMatrix Diffusion::step_matrix(double gamma) const {
    const double t = gamma * coefficient_;
    if (is_mixed_)
        return mixed_step(space_->of, t);
    return Operator::star(mass_) + t * stiffness_;
}

bool Diffusion::keeps_means() const {
    return space_ && space_->constants.count() > 0;
}

Vector Diffusion::without_means(Vector w) const {
    if (!keeps_means())
        return w;
    const bool has_values = mass_.degree() == 0;
    if (!has_values)
        w = mass_ * w;
    space_->constants.remove_means(w);
    if (!has_values)
        w = mass_.solve(w);
    return w;
}

Vector Diffusion::rate(const Vector& values) const {
    if (side_ == Side::dual)
        return -coefficient_ * (stiffness_ * mass_.solve(values));
    return -coefficient_ * mass_.solve(stiffness_ * values);
}

const FormEquations& Diffusion::equations() const {
    if (!space_)
        throw InvalidInput("diffusion by a stiffness matrix does not support boundary data: add "
                           "their effect to the rate");
    return space_->equations.get([&] { return FormEquations(space_->of); });
}

BoundaryLoads Diffusion::loads(const BoundaryForms& data) const {
    return equations().loads_of_free_values(in_unit(data, unit_, mass_.dimension(), degree_));
}

/// The contribution of fixed values to the mass term of the kept cells.
Vector Diffusion::moved(const Vector& fixed) const {
    if (!space_ || mass_.is_diagonal())
        return Vector::Zero(size());
    const Vector moments = space_->of.cells().stars()[mass_.degree()] * fixed;
    return mass_.solve(Vector(space_->of.restrict(moments)));
}

Vector Diffusion::boundary_rate(const BoundaryForms& data) const {
    const FormEquations& of = equations();
    auto [w, below, b, g, b_terms, g_terms] = loads(data);
    const SparseMatrix kept = of.kept();
    const Vector shift = kept * moved(w);
    b += of.upper * shift + of.robin * shift;
    g += of.down * shift;
    if (of.k > 0) {
        const HodgeStar star = space_->of.inside().stars()[of.k - 1];
        const SparseMatrix kept_below = of.kept_below();
        const Vector s = star.solve(Vector(kept_below.transpose() * g));
        b += of.down.transpose() * Vector(kept_below * s);
    }
    const Vector load = coefficient_ * (kept.transpose() * b);
    return side_ == Side::dual ? load : mass_.solve(load);
}

Vector Diffusion::form_of(const Vector& values, const BoundaryForms& data) const {
    if (!space_)
        return values;
    const HodgeStar star = space_->of.cells().stars()[mass_.degree()];
    Vector w = Vector::Zero(star.size());
    if (has_any(data))
        w = loads(data).w;
    if (side_ == Side::dual && mass_.is_diagonal()) {
        w = star * w;
        w(kept_) = values;
        return w;
    }
    const Vector shift = moved(w);
    w(kept_) = (side_ == Side::primal ? values : mass_.solve(values)) - shift;
    return side_ == Side::primal ? w : star * w;
}

Vector Diffusion::values_of(const Vector& form) const {
    if (side_ == Side::dual || mass_.is_diagonal())
        return form(kept_);
    Vector fixed = form;
    fixed(kept_).setZero();
    return form(kept_) + moved(fixed);
}

Vector Diffusion::values_of(const Vector& form, const BoundaryForms& data) const {
    if (side_ == Side::dual || mass_.is_diagonal())
        return form(kept_);
    Vector whole = has_any(data) ? loads(data).w : Vector::Zero(form.size());
    whole(kept_) = form(kept_);
    return values_of(whole);
}

Fingerprint Diffusion::fingerprint() const {
    Fingerprint result;
    result.add(side_).add(degree_).add(coefficient_).add(unit_).add(linear_solver_);
    if (space_)
        return result.add(space_->of);
    return result.add(mass_).add(stiffness_.matrix());
}

Resolvent::Resolvent(const Diffusion& diffusion)
    : of_(diffusion), solver_(make_linear_solver(diffusion.linear_solver_)) {}

void Resolvent::prepare(double gamma) {
    SparseMatrix A = of_.step_matrix(gamma);
    const Vector of_mass = diagonal(weights(of_.mass_));
    largest_ = A.diagonal().head(of_mass.size()).cwiseQuotient(of_mass).maxCoeff();
    // where M is below the rounding of t K, more of it keeps constants out of the kernel
    constexpr double rounding = 1e-13;
    shift_ = of_.keeps_means() ? std::max(rounding * largest_ - 1, 0.0) : 0;
    if (shift_ > 0)
        A += shift_ * of_.mass_.matrix();
    // forms of different degrees have different units
    scales_ =
        A.diagonal().unaryExpr([](double a) { return a == 0 ? 1 : 1 / std::sqrt(std::abs(a)); });
    if (of_.is_mixed_)
        A = scales_.asDiagonal() * A * scales_.asDiagonal();
    else
        scales_.setOnes();
    solver_->factorize(A, of_.facts_);
}

/// The resolvent of a semidefinite operator is a contraction, up to rounding of long steps.
void Resolvent::check_growth(const Vector& before, const Vector& after) const {
    const auto squared = [&](const Vector& values) {
        return square(values, [&](const Vector& x) { return of_.mass_ * x; });
    };
    const double rounding = 1e-9 + 64 * std::numeric_limits<double>::epsilon() * largest_;
    const ScaledNumber from = squared(before), to = squared(after);
    if (!(std::ldexp(to.part, to.exponent - from.exponent) <= from.part * (1 + rounding)))
        throw SolverFailure(fmt::format(
            "a step of diffusion of {} {}-forms increases their norm by a factor of 1 + {:.2g}: "
            "the Laplacian has negative eigenvalues, probably because of negative duals; use {}",
            name(of_.side_), of_.degree_, std::sqrt(ratio(to, from)) - 1,
            positive_stars(of_.mass_.dimension())));
}

Vector Resolvent::solved(const Vector& w) const {
    Vector right_side = of_.mass_ * w;
    right_side.conservativeResizeLike(Vector::Zero(scales_.size()));
    return of_.without_means(
        solver_->solve(right_side.cwiseProduct(scales_)).cwiseProduct(scales_).head(w.size()));
}

Vector Resolvent::solve(const Vector& values) const {
    // dual forms are stars of primal ones, and stars commute with the Laplacian
    return of_.side_ == Side::primal ? of_primal(values)
                                     : of_.mass_ * of_primal(of_.mass_.solve(values));
}

Vector Resolvent::of_primal(const Vector& values) const {
    // steps lose means in their rounding, and long steps the rounding of means
    constexpr double is_long = 1e4;
    Vector w = of_.without_means(values);
    if (largest_ > is_long)
        w = of_.without_means(std::move(w));
    Vector next = solved(w);
    // undoes the shift s of the mass: (M + t K + s M) x = M (w + s x)
    for (int i = 0; i < 2 && shift_ > 0; ++i)
        next = solved(w + shift_ * next);
    check_growth(w, next);
    next += values - w;
    return next;
}

} // namespace polydec
