// SPDX-License-Identifier: MIT
#include "distributed/shared_lanczos.h"

#include "base/errors.h"
#include "distributed/petsc_calls.h"

#ifdef POLYDEC_WITH_SLEPC
#include "backends/eigen/slepc_session.h"

#include <algorithm>
#include <exception>
#include <vector>

namespace polydec {

namespace {

/// An exception must not travel through C: it waits here, and the operator is zero from then on.
struct SharedShell {
    const SharedOperator& apply;
    std::exception_ptr thrown = {};
};

PetscErrorCode apply_shell(Mat matrix, Vec x, Vec y) {
    SharedShell* shell = nullptr;
    if (const auto error = MatShellGetContext(matrix, &shell))
        return error;
    double* to = nullptr;
    Vector result = Vector::Zero(own_entries(x).size());
    try {
        if (!shell->thrown)
            result = shell->apply(own_entries(x));
    } catch (...) {
        shell->thrown = std::current_exception();
    }
    if (const auto error = VecGetArray(y, &to))
        return error;
    std::copy(result.begin(), result.end(), to);
    return VecRestoreArray(y, &to);
}

PetscErrorCode stop_after_errors(EPS solver, PetscInt restarts, PetscInt most_restarts,
                                 PetscInt converged, PetscInt wanted, EPSConvergedReason* reason,
                                 void* shell) {
    const auto error =
        EPSStoppingBasic(solver, restarts, most_restarts, converged, wanted, reason, nullptr);
    if (static_cast<SharedShell*>(shell)->thrown)
        *reason = EPS_CONVERGED_USER;
    return error;
}

} // namespace

DenseMatrix largest_eigenvectors(const Ranks& ranks, const SharedOperator& apply, Index count,
                                 const Vector& start, double tolerance) {
    const petsc::Session session("slepc");
    petsc::start_slepc(session);
    const GlobalIndex size = ranks.sum(std::ssize(start));
    SharedShell shell{apply};
    const OwnedMat matrix = made("making an operator", [&](Mat* result) {
        return MatCreateShell(communicator(ranks), static_cast<PetscInt>(start.size()),
                              static_cast<PetscInt>(start.size()), static_cast<PetscInt>(size),
                              static_cast<PetscInt>(size), &shell, result);
    });
    require(
        MatShellSetOperation(matrix.get(), MATOP_MULT, reinterpret_cast<void (*)()>(apply_shell)),
        "making an operator");
    require(MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE), "making an operator");

    // with few vectors more than wanted the last copies take many restarts
    constexpr GlobalIndex room = 40;
    constexpr PetscInt most_restarts = 300;
    const auto columns = static_cast<PetscInt>(
        std::min<GlobalIndex>(size, std::max<GlobalIndex>(2 * count, count + room)));
    petsc::Owned<EPS, EPSDestroy> owner;
    require(EPSCreate(communicator(ranks), owner.put()), "making an eigensolver");
    EPS solver = owner.get();
    require(EPSSetOperators(solver, matrix.get(), nullptr), "making an eigensolver");
    require(EPSSetProblemType(solver, EPS_HEP), "making an eigensolver");
    require(EPSSetType(solver, EPSKRYLOVSCHUR), "making an eigensolver");
    require(EPSSetWhichEigenpairs(solver, EPS_LARGEST_REAL), "making an eigensolver");
    require(EPSSetDimensions(solver, count, columns, PETSC_DEFAULT), "making an eigensolver");
    require(EPSSetTolerances(solver, tolerance, most_restarts), "making an eigensolver");
    require(EPSSetConvergenceTest(solver, EPS_CONV_REL), "making an eigensolver");
    require(EPSSetStoppingTestFunction(solver, stop_after_errors, &shell, nullptr),
            "making an eigensolver");
    const OwnedVec first = vector_of(ranks, start);
    Vec initial = first.get();
    require(EPSSetInitialSpace(solver, 1, &initial), "making an eigensolver");
    const auto done = EPSSolve(solver);
    if (shell.thrown)
        std::rethrow_exception(shell.thrown);
    ranks.together("iteration", [&] { session.require(done, "the iteration"); });

    PetscInt converged = 0;
    require(EPSGetConverged(solver, &converged), "reading eigenvectors");
    DenseMatrix vectors(start.size(), std::min<PetscInt>(converged, count));
    for (Index i = 0; i < vectors.cols(); ++i) {
        require(EPSGetEigenvector(solver, i, first.get(), nullptr), "reading eigenvectors");
        vectors.col(i) = own_entries(first.get());
    }
    return vectors;
}

} // namespace polydec

#else

namespace polydec {

DenseMatrix largest_eigenvectors(const Ranks&, const SharedOperator&, Index, const Vector&,
                                 double) {
    throw BackendUnavailable(
        "slepc: spectra over several ranks need SLEPc, which was missing when polydec was built\n"
        "Install slepc-dev and build polydec again.");
}

} // namespace polydec

#endif
