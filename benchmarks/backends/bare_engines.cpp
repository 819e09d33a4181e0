// SPDX-License-Identifier: MIT
#include "benchmarks/backends/bare_engines.h"

#include "base/errors.h"

#include <Eigen/SparseCholesky>
#include <Spectra/SymEigsSolver.h>
#ifdef POLYDEC_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace polydec::benchmarks {

namespace {

using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// A symmetric matrix read by columns instead of rows, in place.
Eigen::Map<const Columns> by_columns(const SparseMatrix& A) {
    return {A.rows(), A.cols(), A.nonZeros(), A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr()};
}

} // namespace

Vector solve_by_bare_ldlt(const SparseMatrix& A, const Vector& b) {
    Eigen::SimplicialLDLT<Columns> solver;
    solver.compute(by_columns(A));
    return solver.solve(b);
}

#ifdef POLYDEC_HAS_CHOLMOD

namespace {

/// Eigen's class does nothing but to call cholmod_analyze, cholmod_factorize and cholmod_solve.
class Factorization {
public:
    explicit Factorization(const SparseMatrix& A) {
        auto& common = solver_.cholmod();
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
        solver_.compute(A);
        if (solver_.info() != Eigen::Success)
            throw SolverFailure("bare CHOLMOD: the matrix is not positive definite");
    }
    Vector solve(const Vector& b) const { return solver_.solve(b); }

private:
    // Lower by rows is upper by columns, which is how CHOLMOD reads it.
    Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> solver_;
};

class InverseOperator {
public:
    using Scalar = double;
    explicit InverseOperator(const SparseMatrix& A) : size_(A.rows()), factorization_(A) {}
    Eigen::Index rows() const { return size_; }
    Eigen::Index cols() const { return size_; }
    void perform_op(const double* x, double* y) const {
        Eigen::Map<Vector>(y, size_) =
            factorization_.solve(Vector(Eigen::Map<const Vector>(x, size_)));
    }

private:
    Eigen::Index size_;
    Factorization factorization_;
};

} // namespace

bool has_bare_cholmod() {
    return true;
}

Vector solve_by_bare_cholmod(const SparseMatrix& A, const Vector& b) {
    return Factorization(A).solve(b);
}

Vector eigenvalues_by_bare_spectra(const SparseMatrix& A, const Vector& M, Index count) {
    const Vector scale = M.cwiseSqrt().cwiseInverse();
    SparseMatrix B = scale.asDiagonal() * A * scale.asDiagonal();
    const double shift = 1e-6 * B.diagonal().mean();
    for (Index i = 0; i < B.rows(); ++i)
        B.coeffRef(i, i) += shift;

    InverseOperator inverse(B);
    Spectra::SymEigsSolver<InverseOperator> solver(inverse, count, 2 * count + 1);
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge, 1000, 1e-10);
    if (solver.info() != Spectra::CompInfo::Successful)
        throw SolverFailure("bare Spectra: no convergence");
    return solver.eigenvalues().cwiseInverse().array() - shift;
}

#else

bool has_bare_cholmod() {
    return false;
}

Vector solve_by_bare_cholmod(const SparseMatrix&, const Vector&) {
    throw BackendUnavailable("bare CHOLMOD: not in this program; build with POLYDEC_CHOLMOD=ON");
}

Vector eigenvalues_by_bare_spectra(const SparseMatrix&, const Vector&, Index) {
    throw BackendUnavailable("bare CHOLMOD: not in this program; build with POLYDEC_CHOLMOD=ON");
}

#endif

} // namespace polydec::benchmarks
