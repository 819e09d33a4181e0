// SPDX-License-Identifier: MIT
#include "solvers/hodge.h"

#include "backends/blas.h"
#include "backends/registry.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/forms/derivative.h"
#include "dec/forms/operator.h"
#include "solvers/saddle_solver.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <algorithm>
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

/// 1, or the power of 4 that brings the largest entry near 1 if they are extreme.
double unit_of(const Vector& diagonal) {
    constexpr int harmless = 200;
    const int exponent = diagonal.size() > 0 ? std::ilogb(diagonal.maxCoeff()) : 0;
    return std::abs(exponent) <= harmless ? 1 : std::ldexp(1.0, exponent - (exponent & 1));
}

/// The star of the forms over a unit, a power of 4 by which squares of its entries are numbers.
struct ScaledStar {
    double unit;
    SparseMatrix matrix;
    Operator inverse;

    explicit ScaledStar(const HodgeStar& star)
        : unit(unit_of(Operator::star(star).diagonal())),
          matrix(Operator::star(star).matrix() / unit),
          inverse(star.is_diagonal() ? Operator::weights(matrix.diagonal().cwiseInverse())
                                     : unit * Operator::inverse_star(star)) {}
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

/// Makes the columns orthonormal in an inner product, by Gram and Schmidt twice, a block at a time
/// against all before it.
void orthonormalize(DenseMatrix& columns, const SparseMatrix& M) {
    constexpr Index width = 32;
    for (Index begin = 0; begin < columns.cols(); begin += width) {
        const auto done = columns.leftCols(begin);
        auto block = columns.middleCols(begin, std::min<Index>(width, columns.cols() - begin));
        for (int pass = 0; pass < 2; ++pass) {
            const DenseMatrix weighted = M * block;
            add_product(-1, done, transposed_product(done, weighted), 1, block);
            for (Index i = 0; i < block.cols(); ++i) {
                const Vector along = block.leftCols(i).transpose() * (M * block.col(i));
                block.col(i) -= block.leftCols(i) * along;
                block.col(i) /= std::sqrt(block.col(i).dot(M * block.col(i)));
            }
        }
    }
}

} // namespace

struct HodgeSolver::Parts {
    ScaledStar star;
    std::unique_ptr<Projection> exact = nullptr, coexact = nullptr;
};

HodgeSolver::HodgeSolver(const Cells& cells, Side side, int degree, const std::string& engine)
    : complex_(cells.complex()),
      side_(side),
      degree_(degree),
      k_(cell_degree(complex_, side, degree)) {
    const CellComplex& complex = complex_;
    const HodgeStar mass = cells.input_stars()[k_];
    check_positive_mass(mass, side, degree);
    parts_ = std::make_unique<Parts>(Parts{ScaledStar(mass)});
    auto& [star, exact, coexact] = *parts_;
    const int n = complex.dimension();
    const auto least_squares = [&](SparseMatrix D, SparseMatrix weighted,
                                   const std::vector<Index>& kept, int degree_of_potential) {
        return std::make_unique<LeastSquares>(std::move(D), std::move(weighted), kept,
                                              complex.size(degree_of_potential), engine, n);
    };
    const auto faces = k_ > 0 ? regular_minor(complex, k_ - 1).columns : std::vector<Index>{};
    const SparseMatrix below = rows_of(transposed(derivative(complex, k_ - 1)), faces);
    exact = least_squares(transposed(below), below * star.matrix, faces, k_ - 1);
    if (mass.is_diagonal()) {
        const auto cofaces = regular_minor(complex, k_).rows;
        const SparseMatrix above = rows_of(derivative(complex, k_), cofaces);
        coexact = least_squares(star.inverse.matrix() * transposed(above), above, cofaces, k_ + 1);
    } else {
        star.inverse* Vector::Zero(star.inverse.cols()); // refuses what is not definite
        coexact = std::make_unique<ByMultipliers>(derivative(complex, k_), star.matrix, engine, n);
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
    const auto& [star, exact, coexact] = *parts_;
    const Vector w = primal ? form.values : star.inverse * form.values;

    const auto [potential, da] = exact->of(w);
    const auto [c, delta] = coexact->of(w);
    // star delta = d^T c, which is the dual derivative of c up to this sign
    const double dual_sign = k_ % 2 == 0 ? -1 : 1;
    const double star_star = k_ * (n - k_) % 2 == 0 ? 1 : -1;
    const Vector copotential = dual_sign * c;
    // by the star over the unit, a dual form is as if w were the unit times as large, and then c is
    // what it should be; of a primal one c lacks the unit
    if (primal)
        return {{side_, degree_, da},
                {side_, degree_, delta},
                {side_, degree_, w - da - delta},
                {Side::primal, k_ - 1, potential},
                {Side::dual, n - k_ - 1, star.unit * copotential}};
    return {{side_, degree_, star.matrix * delta},
            {side_, degree_, star.matrix * da},
            {side_, degree_, star.matrix * (w - da - delta)},
            {Side::dual, n - k_ - 1, copotential},
            {Side::primal, k_ - 1, star_star * potential / star.unit}};
}

DenseMatrix HodgeSolver::harmonic_forms() const {
    const auto& [star, exact, coexact] = *parts_;
    // a cycle, read as a form through the inverse star, is coclosed
    const SparseMatrix generators = homology_generators(complex_, k_);
    DenseMatrix forms(generators);
    for (Index i = 0; i < forms.cols(); ++i) {
        const Vector w = star.inverse * Vector(forms.col(i));
        forms.col(i) = w - coexact->of(w).form;
    }
    orthonormalize(forms, star.matrix);
    // so far of norm 1 by the star over the unit
    const double root = std::sqrt(star.unit);
    if (side_ == Side::primal)
        return forms / root;
    return root * (star.matrix * forms);
}

HodgeParts hodge_decomposition(const Cells& cells, const Cochain& form, const std::string& engine) {
    return HodgeSolver(cells, form.side, form.degree, engine).decompose(form);
}

DenseMatrix harmonic_forms(const Cells& cells, Side side, int degree, const std::string& engine) {
    return HodgeSolver(cells, side, degree, engine).harmonic_forms();
}

} // namespace polydec
