// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/linear/petsc_session.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <slepceps.h>

/// SLEPc, on one process or over ranks; not installed.
namespace polydec::petsc {

inline void end_slepc() {
    if (is_running() && SlepcInitializeCalled)
        SlepcFinalize();
}

/// Starts SLEPc unless it is running; it ends at program exit, before PETSc.
inline void start_slepc(const Session& session) {
    if (SlepcInitializeCalled)
        return;
    session.require(SlepcInitialize(nullptr, nullptr, nullptr, nullptr), "starting SLEPc");
    static_cast<void>(std::atexit(end_slepc)); // else the system ends it
}

/// The operator as SLEPc calls it. An exception must not travel through C, so it waits here, and
/// from then on the operator is zero until SLEPc asks whether to stop: what comes back from it by
/// an error cannot be taken apart any more, and its memory would be lost.
struct SlepcShell {
    const SymmetricOperator& A;
    Vector in = {}, out = {};
    Index operations = 0;
    std::exception_ptr thrown = {};

    void apply(const double* x, double* y) {
        Eigen::Map<Vector> result(y, A.size);
        result.setZero();
        if (thrown)
            return;
        try {
            in = Eigen::Map<const Vector>(x, A.size);
            A.apply(in, out);
            result = out;
            ++operations;
        } catch (...) {
            thrown = std::current_exception();
        }
    }
};

inline PetscErrorCode apply_shell(Mat matrix, Vec x, Vec y) {
    SlepcShell* shell = nullptr;
    const double* from = nullptr;
    double* to = nullptr;
    if (const auto error = MatShellGetContext(matrix, &shell))
        return error;
    if (const auto error = VecGetArrayRead(x, &from))
        return error;
    if (const auto error = VecGetArray(y, &to)) {
        VecRestoreArrayRead(x, &from);
        return error;
    }
    shell->apply(from, to);
    VecRestoreArray(y, &to);
    return VecRestoreArrayRead(x, &from);
}

inline PetscErrorCode stop_after_errors(EPS solver, PetscInt restarts, PetscInt most_restarts,
                                        PetscInt converged, PetscInt wanted,
                                        EPSConvergedReason* reason, void* shell) {
    const auto error =
        EPSStoppingBasic(solver, restarts, most_restarts, converged, wanted, reason, nullptr);
    if (static_cast<SlepcShell*>(shell)->thrown)
        *reason = EPS_CONVERGED_USER;
    return error;
}

/// SLEPc's Krylov-Schur method for a symmetric operator on the entries of this process. All
/// processes of the communicator make the same calls. `require`(error, what) takes what PETSc
/// returns.
template <class Require>
class SlepcRun {
public:
    SlepcRun(MPI_Comm communicator, const SymmetricOperator& A, Index count,
             const EigenOptions& options, Require require)
        : shell_{A}, require_(require) {
        constexpr const char* step = "making an eigensolver";
        require(MatCreateShell(communicator, A.size, A.size, PETSC_DETERMINE, PETSC_DETERMINE,
                               &shell_, matrix_.put()),
                step);
        Mat matrix = matrix_.get();
        require(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(apply_shell)),
                step);
        require(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE), step);
        require(EPSCreate(communicator, solver_.put()), step);
        EPS solver = solver_.get();
        require(EPSSetOperators(solver, matrix, nullptr), step);
        require(EPSSetProblemType(solver, EPS_HEP), step);
        require(EPSSetType(solver, EPSKRYLOVSCHUR), step);
        require(EPSSetWhichEigenpairs(solver, EPS_LARGEST_REAL), step);
        require(EPSSetDimensions(solver, count, options.krylov_dimension, PETSC_DEFAULT), step);
        require(EPSSetTolerances(solver, options.tolerance, std::max(options.max_restarts, 1)),
                step);
        require(EPSSetConvergenceTest(solver, EPS_CONV_REL), step);
        require(EPSSetStoppingTestFunction(solver, stop_after_errors, &shell_, nullptr), step);
        require(MatCreateVecs(matrix, vector_.put(), nullptr), step);
        Vec start = vector_.get();
        double* entries = nullptr;
        require(VecGetArray(start, &entries), step);
        std::copy(options.start.begin(), options.start.end(), entries);
        require(VecRestoreArray(start, &entries), step);
        require(EPSSetInitialSpace(solver, 1, &start), step);
    }

    /// What PETSc returns; passes on errors of the operator.
    PetscErrorCode solve() {
        const auto error = EPSSolve(solver_.get());
        if (shell_.thrown)
            std::rethrow_exception(shell_.thrown);
        return error;
    }

    /// The first `count`, or as many as have converged.
    EigenPairs pairs(Index count) const {
        constexpr const char* step = "reading the eigenpairs";
        PetscInt found = 0;
        require_(EPSGetConverged(solver_.get(), &found), step);
        const auto converged = static_cast<Index>(std::min<PetscInt>(found, count));
        EigenPairs result{Vector(converged), DenseMatrix(shell_.A.size, converged), converged,
                          shell_.operations};
        for (Index i = 0; i < converged; ++i) {
            const double* entries = nullptr;
            require_(EPSGetEigenpair(solver_.get(), i, &result.values[i], nullptr, vector_.get(),
                                     nullptr),
                     step);
            require_(VecGetArrayRead(vector_.get(), &entries), step);
            result.vectors.col(i) = Eigen::Map<const Vector>(entries, shell_.A.size);
            require_(VecRestoreArrayRead(vector_.get(), &entries), step);
        }
        return result;
    }

private:
    SlepcShell shell_;
    Require require_;
    Owned<Mat, MatDestroy> matrix_;
    Owned<Vec, VecDestroy> vector_; // the start, then the eigenvectors
    Owned<EPS, EPSDestroy> solver_;
};

} // namespace polydec::petsc
