// SPDX-License-Identifier: MIT
#include "backends/linear/matrix_free.h"

#include "base/errors.h"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

class Applied;

} // namespace

} // namespace polydec

// What Eigen has to know of a type to multiply vectors by it.
namespace Eigen::internal {

template <>
struct traits<polydec::Applied> : traits<polydec::SparseMatrix> {};

} // namespace Eigen::internal

namespace polydec {

namespace {

/// The operator in the clothes of a sparse matrix.
class Applied : public Eigen::EigenBase<Applied> {
public:
    using Scalar = double;
    using RealScalar = double;
    using StorageIndex = Index;
    enum {
        ColsAtCompileTime = Eigen::Dynamic,
        MaxColsAtCompileTime = Eigen::Dynamic,
        IsRowMajor = true
    };

    explicit Applied(const SymmetricOperator& A) : A_(A) {}

    Eigen::Index rows() const { return A_.size; }
    Eigen::Index cols() const { return A_.size; }

    template <class Rhs>
    Eigen::Product<Applied, Rhs, Eigen::AliasFreeProduct>
    operator*(const Eigen::MatrixBase<Rhs>& x) const {
        return {*this, x.derived()};
    }

    Vector product(const Vector& x) const {
        Vector y;
        A_.apply(x, y);
        if (y.size() != A_.size || !y.allFinite())
            throw SolverFailure("eigen.cg: the operator gives another number of values, or one "
                                "that is not finite",
                                SolveReport::failed("eigen.cg"));
        return y;
    }

private:
    const SymmetricOperator& A_;
};

/// Division by the diagonal.
class Scaling {
public:
    void set(const Vector& inverse) { inverse_ = inverse; }

    template <class Matrix>
    Scaling& compute(const Matrix&) {
        return *this;
    }
    template <class Matrix>
    Scaling& factorize(const Matrix&) {
        return *this;
    }
    template <class Matrix>
    Scaling& analyzePattern(const Matrix&) {
        return *this;
    }
    Vector solve(const Vector& b) const { return inverse_.cwiseProduct(b); }
    Eigen::ComputationInfo info() const { return Eigen::Success; }

private:
    Vector inverse_;
};

void check(const SymmetricOperator& A, const Vector& b, const Vector& diagonal) {
    if (b.size() != A.size || (diagonal.size() != 0 && diagonal.size() != A.size))
        throw InvalidInput(fmt::format("eigen.cg: {} values and a diagonal of {} for {} unknowns",
                                       b.size(), diagonal.size(), A.size));
    if (!b.allFinite())
        throw InvalidInput("eigen.cg: the right-hand side has a value that is not finite");
    for (Eigen::Index i = 0; i < diagonal.size(); ++i)
        if (!(diagonal[i] > 0 && std::isfinite(diagonal[i])))
            throw InvalidInput(fmt::format("eigen.cg: entry {0} of the diagonal is {1}: expected a "
                                           "positive number",
                                           i, diagonal[i]));
}

} // namespace

} // namespace polydec

namespace Eigen::internal {

template <class Rhs>
struct generic_product_impl<polydec::Applied, Rhs, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<polydec::Applied, Rhs,
                                generic_product_impl<polydec::Applied, Rhs>> {
    using Scalar = typename Product<polydec::Applied, Rhs>::Scalar;

    template <class Dest>
    static void scaleAndAddTo(Dest& result, const polydec::Applied& A, const Rhs& x,
                              const Scalar& factor) {
        result += factor * A.product(x);
    }
};

} // namespace Eigen::internal

namespace polydec {

Vector solve_matrix_free(const SymmetricOperator& A, const Vector& b, const Vector& diagonal,
                         const LinearSolverOptions& options, SolveReport* report) {
    check(A, b, diagonal);
    // squares of tiny numbers vanish, so the iteration sees a right-hand side of size one
    const double scale = b.size() > 0 ? b.lpNorm<Eigen::Infinity>() : 0.0;
    SolveReport how{.engine = "eigen.cg", .tried = {"eigen.cg"}};
    Vector x = Vector::Zero(b.size());
    if (scale > 0) {
        const Applied applied(A);
        Eigen::ConjugateGradient<Applied, Eigen::Lower | Eigen::Upper, Scaling> cg;
        cg.preconditioner().set(diagonal.size() > 0 ? Vector(diagonal.cwiseInverse())
                                                    : Vector(Vector::Ones(b.size())));
        cg.setTolerance(options.tolerance);
        cg.setMaxIterations(iteration_limit(options, b.size()));
        cg.compute(applied);
        x = cg.solve(b / scale);
        how.iterations = static_cast<Index>(cg.iterations());
        how.residual = (b / scale - applied.product(x)).norm() / (b / scale).norm();
        if (cg.info() != Eigen::Success || !(how.residual <= 10 * options.tolerance))
            throw SolverFailure(
                fmt::format("eigen.cg: no convergence after {} iterations, residual {:.2g}: the "
                            "operator is badly conditioned, indefinite, or the right-hand side is "
                            "none of its images",
                            how.iterations, how.residual),
                SolveReport::failed("eigen.cg", how.iterations, how.residual));
        x *= scale;
    }
    if (report)
        *report = how;
    return x;
}

} // namespace polydec
