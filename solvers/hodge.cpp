// SPDX-License-Identifier: MIT
#include "solvers/hodge.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/forms/derivative.h"
#include "solvers/saddle_solver.h"
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

/// The star of the forms over a unit, a power of 4 by which squares of its entries are numbers.
class Mass {
public:
    explicit Mass(const HodgeStar& star) : star_(star) {
        const Vector diagonal = star.is_diagonal() ? star.diagonal() : star.matrix().diagonal();
        unit = unit_of(diagonal);
        if (star.is_diagonal())
            diagonal_ = diagonal / unit;
    }

    bool is_diagonal() const { return star_.is_diagonal(); }
    const Vector& diagonal() const { return diagonal_; }
    SparseMatrix matrix() const { return star_.matrix() / unit; }

    Vector operator*(const Vector& x) const {
        return is_diagonal() ? Vector(diagonal_.cwiseProduct(x)) : Vector(star_ * x / unit);
    }
    Vector solve(const Vector& x) const {
        return is_diagonal() ? Vector(x.cwiseQuotient(diagonal_)) : unit * star_.solve(x);
    }
    double square(const Vector& x) const {
        return is_diagonal() ? diagonal_.dot(x.cwiseAbs2()) : x.dot(*this * x);
    }

    double unit = 1;

private:
    HodgeStar star_;
    Vector diagonal_; // over the unit; empty if the star is a matrix
};

/// The part of a form in some space, orthogonal in the inner product, and its potential.
class Projection {
public:
    struct Part {
        Vector potential, form;
    };

    Projection() = default;
    Projection(const Projection&) = delete;
    Projection& operator=(const Projection&) = delete;
    virtual ~Projection() = default;
    virtual Part of(const Vector& w) const = 0;
};

/// D x for the x, 0 but at some of its cells, for which it is nearest to w. D are the columns of
/// these cells, whose rank is full, and D^T M comes with it.
class LeastSquares final : public Projection {
public:
    LeastSquares(SparseMatrix D, SparseMatrix weighted_transpose, std::vector<Index> cells,
                 Index size, const std::string& engine, int domain_dimension)
        : D_(std::move(D)),
          weighted_transpose_(std::move(weighted_transpose)),
          cells_(std::move(cells)),
          size_(size) {
        if (D_.cols() == 0)
            return;
        solver_ = make_linear_solver(engine);
        solver_->factorize(SparseMatrix(weighted_transpose_ * D_),
                           {.symmetry = Symmetry::symmetric,
                            .definiteness = Definiteness::positive,
                            .domain_dimension = domain_dimension});
    }

    Part of(const Vector& w) const override {
        Vector x = Vector::Zero(D_.cols());
        // the second pass removes what rounding left of the first
        for (int pass = 0; solver_ && pass < 2; ++pass) {
            const Vector left = w - D_ * x;
            const Vector force = weighted_transpose_ * left;
            if (force.isZero(0))
                break;
            x += solver_->solve(force);
        }
        return {spread(x, cells_, size_), D_ * x};
    }

private:
    SparseMatrix D_, weighted_transpose_;
    std::vector<Index> cells_;
    Index size_;
    std::unique_ptr<LinearSolver> solver_;
};

/// M^-1 d^T c for the c for which it is nearest to w, where M^-1 is dense: what the closed form
/// nearest to w leaves, whose multipliers c are.
class ByMultipliers final : public Projection {
public:
    ByMultipliers(const SparseMatrix& d, SparseMatrix M, const std::string& engine,
                  int domain_dimension)
        : M_(std::move(M)), size_(d.rows()), solver_(M_, d, engine, domain_dimension) {}

    Part of(const Vector& w) const override {
        auto [closed, c, report] = solver_.solve(M_ * w, Vector::Zero(size_));
        return {std::move(c), w - closed};
    }

private:
    SparseMatrix M_;
    Eigen::Index size_; // of potentials
    SaddleSolver solver_;
};

/// Makes the columns orthonormal in an inner product, by Gram and Schmidt twice.
void orthonormalize(DenseMatrix& columns, const Mass& mass) {
    for (Index i = 0; i < columns.cols(); ++i) {
        for (int pass = 0; pass < 2; ++pass) {
            const Vector products =
                columns.leftCols(i).transpose() * (mass * Vector(columns.col(i)));
            columns.col(i) -= columns.leftCols(i) * products;
        }
        columns.col(i) /= std::sqrt(mass.square(columns.col(i)));
    }
}

} // namespace

struct HodgeSolver::Parts {
    Mass mass;
    std::unique_ptr<Projection> exact = nullptr, coexact = nullptr;
};

HodgeSolver::HodgeSolver(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
                         const std::string& engine)
    : complex_(complex), side_(side), degree_(degree), k_(cell_degree(complex, side, degree)) {
    check_fit(complex, stars);
    check_positive_mass(stars[k_], side, degree);
    parts_ = std::make_unique<Parts>(Parts{Mass(stars[k_])});
    auto& [mass, exact, coexact] = *parts_;
    const int n = complex.dimension();
    const auto faces = k_ > 0 ? regular_minor(complex, k_ - 1).columns : std::vector<Index>{};
    const SparseMatrix below = rows_of(transposed(derivative(complex, k_ - 1)), faces);
    const auto least_squares = [&](SparseMatrix D, SparseMatrix weighted,
                                   const std::vector<Index>& cells, int degree_of_potential) {
        return std::make_unique<LeastSquares>(std::move(D), std::move(weighted), cells,
                                              complex.size(degree_of_potential), engine, n);
    };
    if (mass.is_diagonal()) {
        const Vector& weights = mass.diagonal();
        const auto cofaces = regular_minor(complex, k_).rows;
        const SparseMatrix above = rows_of(derivative(complex, k_), cofaces);
        const SparseMatrix inverted = weights.cwiseInverse().asDiagonal() * transposed(above);
        exact = least_squares(transposed(below), below * weights.asDiagonal(), faces, k_ - 1);
        coexact =
            least_squares(inverted, transposed(inverted) * weights.asDiagonal(), cofaces, k_ + 1);
    } else {
        stars[k_].solve(Vector::Zero(stars[k_].size())); // refuses what is not definite
        const SparseMatrix M = mass.matrix();
        exact = least_squares(transposed(below), below * M, faces, k_ - 1);
        coexact = std::make_unique<ByMultipliers>(derivative(complex, k_), M, engine, n);
    }
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
    const auto& [mass, exact, coexact] = *parts_;
    const Vector w = primal ? form.values : mass.solve(form.values);

    const auto [potential, da] = exact->of(w);
    const auto [c, delta] = coexact->of(w);
    // star delta = d^T c, which is the dual derivative of c up to this sign
    const double dual_sign = k_ % 2 == 0 ? -1 : 1;
    const double star_star = k_ * (n - k_) % 2 == 0 ? 1 : -1;
    const Vector copotential = dual_sign * c;
    // in the mass over the unit, a dual form is as if w were the unit times as large, and then c is
    // what it should be; of a primal one c lacks the unit
    if (primal)
        return {{side_, degree_, da},
                {side_, degree_, delta},
                {side_, degree_, w - da - delta},
                {Side::primal, k_ - 1, potential},
                {Side::dual, n - k_ - 1, mass.unit * copotential}};
    return {{side_, degree_, mass * delta},
            {side_, degree_, mass * da},
            {side_, degree_, mass * (w - da - delta)},
            {Side::dual, n - k_ - 1, copotential},
            {Side::primal, k_ - 1, star_star * potential / mass.unit}};
}

DenseMatrix HodgeSolver::harmonic_forms() const {
    const auto& [mass, exact, coexact] = *parts_;
    // a cycle, read as a form through the inverse star, is coclosed
    const SparseMatrix generators = homology_generators(complex_, k_);
    DenseMatrix forms(generators);
    for (Index i = 0; i < forms.cols(); ++i) {
        const Vector w = mass.solve(forms.col(i));
        forms.col(i) = w - coexact->of(w).form;
    }
    orthonormalize(forms, mass);
    // so far of norm 1 in the mass over the unit
    const double root = std::sqrt(mass.unit);
    if (side_ == Side::primal)
        return forms / root;
    for (Index i = 0; i < forms.cols(); ++i)
        forms.col(i) = root * (mass * Vector(forms.col(i)));
    return forms;
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
