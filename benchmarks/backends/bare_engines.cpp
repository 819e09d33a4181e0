// SPDX-License-Identifier: MIT
#include "benchmarks/backends/bare_engines.h"

#include "backends/linear_solver.h"
#include "base/errors.h"

#include <Eigen/SparseCholesky>
#include <Spectra/SymEigsSolver.h>
#ifdef POLYDEC_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif
#ifdef POLYDEC_HAS_PETSC
#include <petscksp.h>
#endif

#include <cstdlib>

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

#if defined(POLYDEC_HAS_PETSC) && defined(PETSC_HAVE_HYPRE)

namespace {

void require(PetscErrorCode error) {
    if (error)
        throw SolverFailure("bare PETSc: its error " + std::to_string(static_cast<int>(error)));
}

void start_petsc() {
    PetscBool is_started = PETSC_FALSE;
    require(PetscInitialized(&is_started));
    if (is_started)
        return;
    require(PetscInitializeNoArguments());
    static_cast<void>(std::atexit([] { static_cast<void>(PetscFinalize()); }));
}

void set_options() {
    const char* const options[][2] = {
        {"-bare_ksp_type", "cg"},
        {"-bare_ksp_norm_type", "unpreconditioned"},
        {"-bare_pc_type", "hypre"},
        {"-bare_pc_hypre_type", "boomeramg"},
        {"-bare_pc_hypre_boomeramg_coarsen_type", "HMIS"},
        {"-bare_pc_hypre_boomeramg_interp_type", "ext+i"},
        {"-bare_pc_hypre_boomeramg_agg_nl", "1"},
        {"-bare_pc_hypre_boomeramg_P_max", "4"},
        {"-bare_pc_hypre_boomeramg_strong_threshold", "0.5"},
    };
    for (const auto& [name, value] : options)
        require(PetscOptionsSetValue(nullptr, name, value));
}

/// The objects of one solution, which go with it.
struct PetscObjects {
    Mat A = nullptr;
    Vec b = nullptr, x = nullptr;
    KSP solver = nullptr;

    PetscObjects() = default;
    ~PetscObjects() {
        KSPDestroy(&solver);
        VecDestroy(&x);
        VecDestroy(&b);
        MatDestroy(&A);
    }
    PetscObjects(const PetscObjects&) = delete;
    PetscObjects& operator=(const PetscObjects&) = delete;
};

} // namespace

bool has_bare_hypre() {
    return true;
}

Vector solve_by_bare_hypre(const SparseMatrix& A, const Vector& b) {
    start_petsc();
    set_options();
    Vector x = Vector::Zero(b.size());
    const auto size = static_cast<Index>(b.size());
    PetscObjects with;
    // PETSc does not write to what it is given here, though its types do not say so.
    require(MatCreateSeqAIJWithArrays(
        PETSC_COMM_SELF, size, size, const_cast<Index*>(A.outerIndexPtr()),
        const_cast<Index*>(A.innerIndexPtr()), const_cast<double*>(A.valuePtr()), &with.A));
    require(MatSetOption(with.A, MAT_SPD, PETSC_TRUE));
    require(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, b.data(), &with.b));
    require(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, x.data(), &with.x));

    require(KSPCreate(PETSC_COMM_SELF, &with.solver));
    require(KSPSetOptionsPrefix(with.solver, "bare_"));
    require(KSPSetOperators(with.solver, with.A, with.A));
    require(KSPSetTolerances(with.solver, LinearSolverOptions{}.tolerance, 0.0, PETSC_DEFAULT,
                             PETSC_DEFAULT));
    require(KSPSetFromOptions(with.solver));
    require(KSPSolve(with.solver, with.b, with.x));

    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    require(KSPGetConvergedReason(with.solver, &reason));
    if (reason <= 0)
        throw SolverFailure("bare hypre: no convergence");
    return x;
}

#else

bool has_bare_hypre() {
    return false;
}

Vector solve_by_bare_hypre(const SparseMatrix&, const Vector&) {
    throw BackendUnavailable("bare hypre: not in this program; build with POLYDEC_PETSC=ON and a "
                             "PETSc that has hypre");
}

#endif

} // namespace polydec::benchmarks
