// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/eigen/dense_pairs.h"
#include "backends/eigen/slepc_session.h"

#include <algorithm>
#include <exception>

namespace polydec {

namespace {

using petsc::Owned;
using petsc::Session;
using PetscVector = Owned<Vec, VecDestroy>;
using PetscMatrix = Owned<Mat, MatDestroy>;

// The operator as SLEPc calls it. An exception must not travel through C, so it waits here, and
// from then on the operator is zero until SLEPc asks whether to stop: what comes back from it by an
// error cannot be taken apart any more, and its memory would be lost.
struct Shell {
    const SymmetricOperator* A = nullptr;
    Vector in = {};
    Vector out = {};
    Index operations = 0;
    std::exception_ptr thrown = {};
};

void apply_to_arrays(Shell& shell, const double* x, double* y) {
    Eigen::Map<Vector> result(y, shell.A->size);
    result.setZero();
    if (shell.thrown)
        return;
    try {
        shell.in = Eigen::Map<const Vector>(x, shell.A->size);
        shell.A->apply(shell.in, shell.out);
        result = shell.out;
        ++shell.operations;
    } catch (...) {
        shell.thrown = std::current_exception();
    }
}

PetscErrorCode apply(Mat matrix, Vec x, Vec y) {
    Shell* shell = nullptr;
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
    apply_to_arrays(*shell, from, to);
    VecRestoreArray(y, &to);
    return VecRestoreArrayRead(x, &from);
}

PetscErrorCode stop(EPS solver, PetscInt restarts, PetscInt most_restarts, PetscInt converged,
                    PetscInt wanted, EPSConvergedReason* reason, void* shell) {
    const auto error =
        EPSStoppingBasic(solver, restarts, most_restarts, converged, wanted, reason, nullptr);
    if (static_cast<Shell*>(shell)->thrown)
        *reason = EPS_CONVERGED_USER;
    return error;
}

// One run of the eigensolver, and what it holds on to.
class Run {
public:
    Run(const Session& session, Shell& shell, Index count, const EigenOptions& options)
        : session_(session), shell_(shell), size_(shell.A->size) {
        use_shell();
        session_.require(EPSCreate(PETSC_COMM_SELF, solver_.put()), "making a solver");
        session_.require(EPSSetOperators(solver_.get(), matrix_.get(), nullptr), "making a solver");
        session_.require(EPSSetProblemType(solver_.get(), EPS_HEP), "making a solver");
        session_.require(EPSSetWhichEigenpairs(solver_.get(), EPS_LARGEST_REAL), "making a solver");
        choose_method(count, options);
    }

    void solve() {
        const auto error = EPSSolve(solver_.get());
        if (shell_.thrown)
            std::rethrow_exception(shell_.thrown);
        session_.require(error, "the iteration");
    }

    EigenPairs pairs(Index count) const {
        PetscInt found = 0;
        session_.require(EPSGetConverged(solver_.get(), &found), "reading the eigenpairs");
        const auto converged = static_cast<Index>(std::min<PetscInt>(found, count));

        EigenPairs result{Vector(converged), DenseMatrix(size_, converged), converged,
                          shell_.operations};
        for (Index i = 0; i < converged; ++i) {
            PetscVector vector;
            session_.require(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size_,
                                                   result.vectors.col(i).data(), vector.put()),
                             "reading the eigenpairs");
            session_.require(EPSGetEigenpair(solver_.get(), i, &result.values[i], nullptr,
                                             vector.get(), nullptr),
                             "reading the eigenpairs");
        }
        return result;
    }

private:
    void use_shell() {
        session_.require(
            MatCreateShell(PETSC_COMM_SELF, size_, size_, size_, size_, &shell_, matrix_.put()),
            "taking over the operator");
        session_.require(
            MatShellSetOperation(matrix_.get(), MATOP_MULT, reinterpret_cast<void (*)()>(apply)),
            "taking over the operator");
        session_.require(MatSetOption(matrix_.get(), MAT_SYMMETRIC, PETSC_TRUE),
                         "taking over the operator");
    }

    void choose_method(Index count, const EigenOptions& options) {
        EPS solver = solver_.get();
        if (size_ <= builtin::dense_size || options.krylov_dimension >= size_) {
            session_.require(EPSSetType(solver, EPSLAPACK), "choosing the method");
            return;
        }
        session_.require(EPSSetType(solver, EPSKRYLOVSCHUR), "choosing the method");
        session_.require(EPSSetDimensions(solver, count, options.krylov_dimension, PETSC_DEFAULT),
                         "choosing the method");
        session_.require(
            EPSSetTolerances(solver, options.tolerance, std::max(options.max_restarts, 1)),
            "choosing the method");
        session_.require(EPSSetConvergenceTest(solver, EPS_CONV_REL), "choosing the method");
        session_.require(EPSSetStoppingTestFunction(solver, stop, &shell_, nullptr),
                         "choosing the method");

        session_.require(
            VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size_, options.start.data(), start_.put()),
            "taking over the start");
        Vec start = start_.get();
        session_.require(EPSSetInitialSpace(solver, 1, &start), "taking over the start");
    }

    const Session& session_;
    Shell& shell_;
    Index size_;
    PetscMatrix matrix_;
    PetscVector start_;
    Owned<EPS, EPSDestroy> solver_;
};

class SlepcSolver final : public EigenSolver {
public:
    std::string name() const override { return "slepc"; }

protected:
    EigenPairs compute(const SymmetricOperator& A, Index count,
                       const EigenOptions& options) const override {
        const Session session(name());
        petsc::start_slepc(session);
        Shell shell{.A = &A};
        Run run(session, shell, count, options);
        run.solve();
        return run.pairs(count);
    }
};

} // namespace

void component::add_slepc(EngineRegistrar& registrar) {
    registrar.add({.name = "slepc"}, [] { return std::make_unique<SlepcSolver>(); });
}

} // namespace polydec
