// SPDX-License-Identifier: MIT
#include "solvers/sources/hodge.h"

#include "backends/blas.h"
#include "backends/registry.h"
#include "complex/homology.h"
#include "dec/discretization/positive_mass.h"
#include "dec/forms/cochain.h"
#include "dec/forms/operator.h"
#include "solvers/sources/saddle_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

SparseMatrix transposed(const SparseMatrix& A) {
    return A.transpose();
}

/// The given rows of a matrix.
SparseMatrix rows_of(const SparseMatrix& A, const std::vector<Index>& rows) {
    return transposed(inclusion(rows, static_cast<Index>(A.rows()))) * A;
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

/// The star of the forms over a unit, a power of 4 that keeps squares of its entries in range.
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

/// D x nearest to w, with x supported on some cells. D has the columns of these cells and full
/// rank; D^T M comes with it.
class LeastSquares final : public Projection {
public:
    LeastSquares(SparseMatrix D, SparseMatrix weighted_transpose, std::vector<Index> cells,
                 Index size, const std::string& engine, const MatrixFacts& facts)
        : D_(std::move(D)),
          weighted_transpose_(std::move(weighted_transpose)),
          cells_(std::move(cells)),
          size_(size) {
        if (D_.cols() == 0)
            return;
        solver_ = make_linear_solver(engine);
        solver_->factorize(SparseMatrix(weighted_transpose_ * D_), facts);
    }

    Part of(const Vector& w) const override {
        Vector x = Vector::Zero(D_.cols());
        // the second pass removes the rounding error of the first
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

/// M^-1 d^T c nearest to w, for a dense M^-1: the rest of w after its nearest closed form, with c
/// as multipliers.
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

/// Makes the columns orthonormal in an inner product, by Gram-Schmidt twice, each block against all
/// earlier ones.
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

HodgeSolver::HodgeSolver(const FormSpace& space, const std::string& linear_solver) : space_(space) {
    space.refuse_robin("a Hodge decomposition");
    const Cells inside = space.inside();
    const CellComplex& complex = inside.complex();
    const int n = complex.dimension(), k = space.cell_degree();
    const HodgeStar mass = polydec::star(inside, k);
    check_positive_mass(mass, space.side(), space.degree());
    parts_ = std::make_shared<Parts>(Parts{ScaledStar(mass)});
    auto& [star, exact, coexact] = *parts_;
    const auto least_squares = [&](SparseMatrix D, SparseMatrix weighted,
                                   const std::vector<Index>& kept, int degree_of_potential) {
        MatrixFacts facts;
        facts.symmetry = Symmetry::symmetric;
        facts.definiteness = Definiteness::positive;
        facts.domain_dimension = n;
        // multigrid is made for functions: for other forms a factorization is faster up to more
        facts.many_solves = degree_of_potential > 0 && degree_of_potential < n;
        return std::make_unique<LeastSquares>(std::move(D), std::move(weighted), kept,
                                              complex.size(degree_of_potential), linear_solver,
                                              facts);
    };
    const auto faces = k > 0 ? regular_minor(complex, k - 1).columns : std::vector<Index>{};
    const SparseMatrix below = rows_of(transposed(derivative(complex, k - 1)), faces);
    exact = least_squares(transposed(below), below * star.matrix, faces, k - 1);
    if (mass.is_diagonal()) {
        const auto cofaces = regular_minor(complex, k).rows;
        const SparseMatrix above = rows_of(derivative(complex, k), cofaces);
        coexact = least_squares(star.inverse.matrix() * transposed(above), above, cofaces, k + 1);
    } else {
        star.inverse* Vector::Zero(star.inverse.cols()); // throws for an indefinite star
        coexact =
            std::make_unique<ByMultipliers>(derivative(complex, k), star.matrix, linear_solver, n);
    }
}

HodgeParts HodgeSolver::decompose(const Cochain& form) const {
    space_.check(form);
    const RelativeComplex& cells = space_.relative();
    const int n = cells.complex.dimension(), k = space_.cell_degree();
    const bool primal = form.side == Side::primal;
    const auto& [star, exact, coexact] = *parts_;
    const Vector values = space_.restrict(form.values);
    const Vector w = primal ? values : star.inverse * values;

    const auto [potential, da] = exact->of(w);
    const auto [c, delta] = coexact->of(w);
    // star delta = d^T c, the dual derivative of c up to this sign
    const double dual_sign = k % 2 == 0 ? -1 : 1;
    const double star_star = k * (n - k) % 2 == 0 ? 1 : -1;
    const Vector copotential = dual_sign * c;
    const auto part = [&](const Vector& of_free) {
        return Cochain{form.side, form.degree, space_.extend(of_free)};
    };
    const auto beside = [&](Side side, int j, const Vector& of_free) {
        const int degree = side == Side::primal ? j : n - j;
        return Cochain{side, degree, j >= 0 && j <= n ? cells.extend(j, of_free) : of_free};
    };
    // with the star over the unit, a dual form behaves like w times the unit, and c is right; for a
    // primal one c lacks the unit
    if (primal)
        return {part(da), part(delta), part(w - da - delta), beside(Side::primal, k - 1, potential),
                beside(Side::dual, k + 1, star.unit * copotential)};
    return {part(star.matrix * delta), part(star.matrix * da), part(star.matrix * (w - da - delta)),
            beside(Side::dual, k + 1, copotential),
            beside(Side::primal, k - 1, star_star * potential / star.unit)};
}

DenseMatrix HodgeSolver::harmonic_forms() const {
    const auto& [star, exact, coexact] = *parts_;
    // a cycle, read as a form through the inverse star, is coclosed
    const SparseMatrix generators =
        homology_generators(space_.relative().complex, space_.cell_degree());
    DenseMatrix forms(generators);
    for (Index i = 0; i < forms.cols(); ++i) {
        const Vector w = star.inverse * Vector(forms.col(i));
        forms.col(i) = w - coexact->of(w).form;
    }
    orthonormalize(forms, star.matrix);
    // so far of norm 1 in the star over the unit
    const double root = std::sqrt(star.unit);
    if (space_.side() == Side::primal)
        return space_.extend(DenseMatrix(forms / root));
    return space_.extend(DenseMatrix(root * (star.matrix * forms)));
}

HodgeParts hodge_decomposition(const FormSpace& space, const Cochain& form,
                               const std::string& linear_solver) {
    return HodgeSolver(space, linear_solver).decompose(form);
}

DenseMatrix harmonic_forms(const FormSpace& space, const std::string& linear_solver) {
    return HodgeSolver(space, linear_solver).harmonic_forms();
}

} // namespace polydec
