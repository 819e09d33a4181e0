// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/linear/iterative_solver.h"
#include "backends/linear/petsc_options.h"
#include "backends/linear/petsc_session.h"
#include "base/block_matrix.h"
#include "base/decompositions.h"

#include <fmt/format.h>

#include <algorithm>
#include <petscksp.h>
#include <utility>
#include <vector>

namespace polydec {

namespace {

using petsc::Owned;
using petsc::Session;
using PetscMatrix = Owned<Mat, MatDestroy>;
using PetscVector = Owned<Vec, VecDestroy>;

// Multigrid that takes more steps than this is the wrong one for the matrix.
constexpr Index most_iterations = 1000;

// Indices as PETSc counts: as they are, or, where its integers are of another width, copied.
[[maybe_unused]] PetscInt* as_petsc_counts(const PetscInt* indices, Eigen::Index,
                                           std::vector<PetscInt>&) {
    return const_cast<PetscInt*>(indices);
}
template <class Other>
PetscInt* as_petsc_counts(const Other* indices, Eigen::Index size, std::vector<PetscInt>& copy) {
    copy.assign(indices, indices + size);
    return copy.data();
}

struct MatrixView {
    std::vector<PetscInt> begins = {}, columns = {}; // of the matrix, if they had to be copied
    PetscMatrix matrix = {};
};

// A view of A: PETSc never writes to what it is given here, though its types do not say so.
void view(const Session& session, const SparseMatrix& A, Definiteness definiteness,
          MatrixView& of) {
    PetscMatrix& result = of.matrix;
    session.require(
        MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, static_cast<PetscInt>(A.rows()),
                                  static_cast<PetscInt>(A.cols()),
                                  as_petsc_counts(A.outerIndexPtr(), A.rows() + 1, of.begins),
                                  as_petsc_counts(A.innerIndexPtr(), A.nonZeros(), of.columns),
                                  const_cast<double*>(A.valuePtr()), result.put()),
        "taking over the matrix");
    MatSetOption(result.get(), MAT_SYMMETRIC, PETSC_TRUE);
    if (definiteness == Definiteness::positive)
        MatSetOption(result.get(), MAT_SPD, PETSC_TRUE);
}

// PETSc takes a kernel as orthonormal vectors of its own.
void set_kernel(const Session& session, Mat matrix, const DenseMatrix& kernel) {
    DenseMatrix basis(kernel.rows(), kernel.cols());
    for (Eigen::Index j = 0; j < kernel.cols(); ++j)
        basis.col(j) = kernel.col(j).stableNormalized();
    basis = orthonormal_columns(basis);

    std::vector<PetscVector> columns(static_cast<std::size_t>(basis.cols()));
    std::vector<Vec> handles;
    for (Eigen::Index j = 0; j < basis.cols(); ++j) {
        auto& column = columns[static_cast<std::size_t>(j)];
        session.require(
            VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(basis.rows()), column.put()),
            "taking over the kernel");
        double* entries = nullptr;
        session.require(VecGetArray(column.get(), &entries), "taking over the kernel");
        Eigen::Map<Vector>(entries, basis.rows()) = basis.col(j);
        VecRestoreArray(column.get(), &entries);
        handles.push_back(column.get());
    }
    Owned<MatNullSpace, MatNullSpaceDestroy> space;
    session.require(MatNullSpaceCreate(PETSC_COMM_SELF, PETSC_FALSE,
                                       static_cast<PetscInt>(handles.size()), handles.data(),
                                       space.put()),
                    "taking over the kernel");
    session.require(MatSetNullSpace(matrix, space.get()), "taking over the kernel");
}

class CgMultigrid final : public IterativeSolver {
public:
    CgMultigrid(const std::string& name, std::string multigrid, std::string for_singular,
                const LinearSolverOptions& options)
        : IterativeSolver(name, of_conjugate_gradients, options),
          multigrid_(std::move(multigrid)),
          for_singular_(std::move(for_singular)) {
        petsc::check_options(name, options.engine_options);
    }
    ~CgMultigrid() override { forget(); }

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern) override {
        const Session session(name());
        forget();
        const bool is_singular = facts.definiteness == Definiteness::semidefinite;
        const SparseMatrix& regular = without_zero_rows(A, facts);
        const petsc::SetOptions set(session, petsc::conjugate_gradients + multigrid_ +
                                                 (is_singular ? for_singular_ : "") +
                                                 options().engine_options);
        try {
            view(session, regular, facts.definiteness, view_);
            if (facts.kernel.cols() > 0)
                set_kernel(session, view_.matrix.get(), facts.kernel);
            set_up(session);
        } catch (...) {
            forget();
            throw;
        }
    }

    Index iterate(const Vector& b, Eigen::Ref<Vector> x) override {
        const Session session(name());
        PetscVector right_hand_side;
        PetscVector solution;
        const auto size = static_cast<PetscInt>(b.size());
        session.require(
            VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, b.data(), right_hand_side.put()),
            "taking over a right-hand side");
        session.require(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, x.data(), solution.put()),
                        "taking over a solution");
        session.require(KSPSolve(solver_.get(), right_hand_side.get(), solution.get()),
                        "the solution");

        PetscInt iterations = 0;
        KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
        KSPGetIterationNumber(solver_.get(), &iterations);
        KSPGetConvergedReason(solver_.get(), &reason);
        if (reason <= 0 || !x.allFinite())
            fail_because(reason, static_cast<Index>(iterations));
        return static_cast<Index>(iterations);
    }

private:
    // Smoothers divide by the diagonal. A row of a semidefinite matrix whose diagonal is zero is
    // all zero, its unknown is without influence, and a one on the diagonal keeps it at zero.
    const SparseMatrix& without_zero_rows(const SparseMatrix& A, const MatrixFacts& facts) {
        const Vector diagonal = A.diagonal();
        const bool may_be_zero = facts.definiteness == Definiteness::semidefinite;
        Vector ones = Vector::Zero(A.rows());
        for (Index i = 0; i < static_cast<Index>(A.rows()); ++i) {
            if (diagonal[i] > 0.0)
                continue;
            if (diagonal[i] < 0.0 || !may_be_zero || A.row(i).norm() > 0.0)
                fail(fmt::format("the matrix is not positive {1}definite, although its facts say "
                                 "so: entry ({0}, {0}) is {2:.3g}",
                                 i, may_be_zero ? "semi" : "", diagonal[i]));
            ones[i] = 1.0;
        }
        if (ones.isZero(0.0))
            return A;

        changed_ = A + diagonal_matrix(ones);
        return changed_;
    }

    void set_up(const Session& session) {
        const auto limit =
            options().max_iterations > 0 ? options().max_iterations : most_iterations;
        session.require(KSPCreate(PETSC_COMM_SELF, solver_.put()), "making a solver");
        KSP solver = solver_.get();
        session.require(KSPSetOptionsPrefix(solver, petsc::prefix), "making a solver");
        session.require(KSPSetOperators(solver, view_.matrix.get(), view_.matrix.get()),
                        "making a solver");
        session.require(KSPSetTolerances(solver, std::min(options().tolerance, 0.5), 0.0,
                                         PETSC_MAX_REAL, limit),
                        "making a solver");
        session.require(KSPSetFromOptions(solver), "reading the options");
        session.require(KSPSetUp(solver), "the setup");
        session.require(KSPSetUpOnBlocks(solver), "the setup");
        petsc::require_read(name(), options().engine_options);
    }

    void forget() {
        if (!petsc::is_running())
            return;
        const Session session(name());
        solver_.reset();
        view_.matrix.reset();
    }

    [[noreturn]] void fail_because(KSPConvergedReason reason, Index iterations) const {
        const char* text = nullptr;
        KSPGetConvergedReasonString(solver_.get(), &text);
        double residual = 0.0;
        KSPGetResidualNorm(solver_.get(), &residual);

        const char* cause = "the matrix is badly conditioned or indefinite, or the right-hand side "
                            "is not in its range";
        if (reason == KSP_DIVERGED_INDEFINITE_MAT)
            cause = "the matrix is not positive semidefinite, although its facts say so";
        if (reason == KSP_DIVERGED_INDEFINITE_PC || reason == KSP_DIVERGED_PC_FAILED)
            cause = "multigrid fails for this matrix";
        fail(fmt::format("no convergence after {} iterations ({}), residual {:.2g}: {}\n"
                         "Use cholmod or another direct engine.",
                         iterations, text ? text : "unknown reason", residual, cause),
             SolveReport::failed(name(), iterations, residual));
    }

    std::string multigrid_;
    std::string for_singular_;
    SparseMatrix changed_;
    MatrixView view_;
    Owned<KSP, KSPDestroy> solver_;
};

} // namespace

void component::add_petsc(EngineRegistrar& registrar) {
    const auto add = [&](const std::string& name, const std::string& multigrid,
                         const std::string& for_singular) {
        registrar.add({.name = name}, [=](const LinearSolverOptions& options) {
            return std::make_unique<CgMultigrid>(name, multigrid, for_singular, options);
        });
    };
    add("petsc.cg-gamg", petsc::gamg, petsc::singular_gamg);
#ifdef PETSC_HAVE_HYPRE
    add("petsc.cg-hypre", petsc::boomeramg, petsc::singular_boomeramg);
#endif
}

} // namespace polydec
