// SPDX-License-Identifier: MIT
#include "solvers/hodge.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/forms/derivative.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// The given rows, ascending, of a matrix.
SparseMatrix rows_of(const SparseMatrix& A, const std::vector<Index>& rows) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (SparseMatrix::InnerIterator entry(A, rows[i]); entry; ++entry)
            entries.emplace_back(i, entry.col(), entry.value());
    SparseMatrix part(static_cast<Index>(rows.size()), A.cols());
    part.setFromTriplets(entries.begin(), entries.end());
    return part;
}

SparseMatrix transposed(const SparseMatrix& A) {
    return A.transpose();
}

/// The values at the given cells, 0 elsewhere.
Vector spread(const Vector& values, const std::vector<Index>& cells, Index size) {
    Vector whole = Vector::Zero(size);
    whole(cells) = values;
    return whole;
}

/// 1, or the power of 4 that brings the largest of the numbers near 1 if they are extreme.
double unit_of(const Vector& masses) {
    constexpr int harmless = 200;
    const int exponent = masses.size() > 0 ? std::ilogb(masses.maxCoeff()) : 0;
    return std::abs(exponent) <= harmless ? 1 : std::ldexp(1.0, exponent - (exponent & 1));
}

/// Makes the columns orthonormal in the inner product with weights, by Gram and Schmidt twice.
void orthonormalize(DenseMatrix& columns, const Vector& weights) {
    for (Index i = 0; i < columns.cols(); ++i) {
        for (int pass = 0; pass < 2; ++pass) {
            const Vector products =
                columns.leftCols(i).transpose() * weights.cwiseProduct(columns.col(i));
            columns.col(i) -= columns.leftCols(i) * products;
        }
        columns.col(i) /= std::sqrt(weights.dot(columns.col(i).cwiseAbs2()));
    }
}

} // namespace

/// Least-squares solutions x of D x = w in the inner product with weights; D has full column rank.
class HodgeSolver::Projection {
public:
    Projection(SparseMatrix D, const Vector& weights, const std::string& engine,
               int domain_dimension);
    Vector solve(const Vector& w) const;
    const SparseMatrix& D() const { return D_; }

private:
    SparseMatrix D_, weighted_transpose_;
    std::unique_ptr<LinearSolver> solver_;
};

HodgeSolver::Projection::Projection(SparseMatrix D, const Vector& weights,
                                    const std::string& engine, int domain_dimension)
    : D_(std::move(D)), weighted_transpose_(transposed(D_) * weights.asDiagonal()) {
    if (D_.cols() == 0)
        return;
    solver_ = make_linear_solver(engine);
    solver_->factorize(SparseMatrix(weighted_transpose_ * D_),
                       {.symmetry = Symmetry::symmetric,
                        .definiteness = Definiteness::positive,
                        .domain_dimension = domain_dimension});
}

Vector HodgeSolver::Projection::solve(const Vector& w) const {
    Vector x = Vector::Zero(D_.cols());
    if (!solver_)
        return x;
    // the second pass removes what rounding left of the first
    for (int pass = 0; pass < 2; ++pass) {
        const Vector left = w - D_ * x;
        const Vector force = weighted_transpose_ * left;
        if (force.isZero(0))
            break;
        x += solver_->solve(force);
    }
    return x;
}

HodgeSolver::HodgeSolver(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
                         const std::string& engine)
    : complex_(complex),
      side_(side),
      degree_(degree),
      k_(cell_degree(complex, side, degree)),
      mass_(stars[k_].diagonal()) {
    check_fit(complex, stars);
    check_positive_mass(stars[k_], side, degree);
    unit_ = unit_of(mass_);
    mass_ /= unit_;
    const int n = complex.dimension();
    if (k_ > 0)
        faces_ = regular_minor(complex, k_ - 1).columns;
    cofaces_ = regular_minor(complex, k_).rows;

    const SparseMatrix below = rows_of(transposed(derivative(complex, k_ - 1)), faces_);
    const SparseMatrix above = rows_of(derivative(complex, k_), cofaces_);
    exact_ = std::make_unique<Projection>(transposed(below), mass_, engine, n);
    coexact_ = std::make_unique<Projection>(mass_.cwiseInverse().asDiagonal() * transposed(above),
                                            mass_, engine, n);
}

HodgeSolver::HodgeSolver(HodgeSolver&&) noexcept = default;
HodgeSolver::~HodgeSolver() = default;

HodgeParts HodgeSolver::decompose(const Cochain& form) const {
    check(complex_, form);
    if (form.side != side_ || form.degree != degree_)
        throw InvalidInput(fmt::format("a {} {}-form is given: this solver decomposes {} {}-forms",
                                       name(form.side), form.degree, name(side_), degree_));
    const int n = complex_.dimension();
    const bool primal = side_ == Side::primal;
    const Vector w = primal ? form.values : Vector(form.values.cwiseQuotient(mass_));

    const Vector a = exact_->solve(w), c = coexact_->solve(w);
    const Vector da = exact_->D() * a, delta = coexact_->D() * c;
    // star delta = d^T c, which is the dual derivative of c up to this sign
    const double dual_sign = k_ % 2 == 0 ? -1 : 1;
    const double star_star = k_ * (n - k_) % 2 == 0 ? 1 : -1;
    const Vector potential = spread(a, faces_, complex_.size(k_ - 1));
    const Vector copotential = dual_sign * spread(c, cofaces_, complex_.size(k_ + 1));
    // in the mass over the unit, a dual form is as if w were the unit times as large, and then c is
    // what it should be; of a primal one c lacks the unit
    if (primal)
        return {{side_, degree_, da},
                {side_, degree_, delta},
                {side_, degree_, w - da - delta},
                {Side::primal, k_ - 1, potential},
                {Side::dual, n - k_ - 1, unit_ * copotential}};
    return {{side_, degree_, mass_.cwiseProduct(delta)},
            {side_, degree_, mass_.cwiseProduct(da)},
            {side_, degree_, mass_.cwiseProduct(w - da - delta)},
            {Side::dual, n - k_ - 1, copotential},
            {Side::primal, k_ - 1, star_star * potential / unit_}};
}

DenseMatrix HodgeSolver::harmonic_forms() const {
    // a cycle, read as a form through the inverse star, is coclosed
    const SparseMatrix generators = homology_generators(complex_, k_);
    DenseMatrix forms(generators);
    for (Index i = 0; i < forms.cols(); ++i) {
        const Vector w = forms.col(i).cwiseQuotient(mass_);
        forms.col(i) = w - coexact_->D() * coexact_->solve(w);
    }
    orthonormalize(forms, mass_);
    // so far of norm 1 in the mass over the unit
    const double root = std::sqrt(unit_);
    return side_ == Side::primal ? DenseMatrix(forms / root)
                                 : DenseMatrix(root * (mass_.asDiagonal() * forms));
}

HodgeParts hodge_decomposition(const CellComplex& complex, const HodgeStars& stars,
                               const Cochain& form, const std::string& engine) {
    return HodgeSolver(complex, stars, form.side, form.degree, engine).decompose(form);
}

DenseMatrix harmonic_forms(const CellComplex& complex, const HodgeStars& stars, Side side,
                           int degree, const std::string& engine) {
    return HodgeSolver(complex, stars, side, degree, engine).harmonic_forms();
}

HodgeParts hodge_decomposition(const Discretization& mesh, const Cochain& form,
                               const std::string& engine) {
    return hodge_decomposition(mesh.complex(), mesh.stars(), form, engine);
}

DenseMatrix harmonic_forms(const Discretization& mesh, Side side, int degree,
                           const std::string& engine) {
    return harmonic_forms(mesh.complex(), mesh.stars(), side, degree, engine);
}

} // namespace polydec
