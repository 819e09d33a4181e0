// SPDX-License-Identifier: MIT
#pragma once

#include "base/solve_report.h"
#include "base/types.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

enum class Symmetry { symmetric, general };

/// What the maker of a matrix knows of its spectrum; indefinite promises nothing.
enum class Definiteness { positive, semidefinite, indefinite };

/// Whether the number of negative eigenvalues is asked for besides solutions.
enum class Inertia { unneeded, wanted };

/// What the maker of a matrix knows of it. Engines believe it; the defaults promise nothing.
struct MatrixFacts {
    Symmetry symmetry = Symmetry::general;
    Definiteness definiteness = Definiteness::indefinite; ///< of a symmetric matrix
    Inertia inertia = Inertia::unneeded;

    /// Columns spanning the whole kernel of a symmetric matrix; no columns: none is known.
    /// Right-hand sides must then be orthogonal to it, and solutions are made so.
    DenseMatrix kernel = {};

    /// Dimension of the domain behind the matrix (2 for surfaces, 3 for solids ...): it decides on
    /// the ordering and on when iterating pays. 0: guessed from the number of entries in a row.
    int domain_dimension = 0;

    /// Whether dozens of solves will follow one factorization, as in time steps or an iteration for
    /// eigenvalues: then a factorization pays for longer.
    bool many_solves = false;
};

/// The dimension of the domain behind a matrix: from the facts, else guessed from the pattern, 2
/// or 3.
int domain_dimension(const SparseMatrix& A, const MatrixFacts& facts);

/// How an engine works.
enum class Method { direct, iterative };

/// What is done with a known kernel: an engine gets the matrix without as many rows and columns as
/// make it regular, or the matrix as it is, with right-hand sides orthogonal to the kernel.
enum class KernelTreatment { grounding, projection };

/// What an engine can do; asking for more is refused with InvalidInput.
struct EngineTraits {
    Method method = Method::direct;
    Symmetry symmetry = Symmetry::general; ///< symmetric: takes symmetric matrices only
    /// The least definite symmetric matrix it takes.
    Definiteness definiteness = Definiteness::indefinite;
    Inertia inertia = Inertia::unneeded; ///< wanted: it can count negative eigenvalues
    KernelTreatment kernel = KernelTreatment::grounding;
};

/// Options of every linear engine; each reads those that concern it.
struct LinearSolverOptions {
    double tolerance = 1e-12; ///< iterative engines: |b - A x| / |b| to be reached
    Index max_iterations = 0; ///< iterative engines; 0: min(10 n + 1000, 50000)
    int blas_threads = 1;     ///< engines that call the BLAS; 0: leave it as it is

    /// Options in the engine's own words, for engines that have some; the others pass it over.
    /// For those of PETSc: "-ksp_type fcg -pc_hypre_boomeramg_strong_threshold 0.7".
    std::string engine_options = {};
};

/// Iterations that an iterative engine is allowed for that many unknowns.
Index iteration_limit(const LinearSolverOptions& options, Eigen::Index unknowns);

/// Solves A X = B: factorize once, solve often. One interface for every engine.
/// An object is used by one thread at a time; two objects are independent.
class LinearSolver {
public:
    LinearSolver() = default;
    LinearSolver(const LinearSolver&) = delete;
    LinearSolver& operator=(const LinearSolver&) = delete;
    virtual ~LinearSolver() = default;

    virtual std::string name() const = 0;
    virtual EngineTraits traits() const = 0;

    /// Prepares for solving with A (square, symmetric ones with both triangles), sharing it: the
    /// caller must not change it. May be called again; the analysis is kept if the pattern is
    /// equal. Throws InvalidInput if A is not square, holds NaN or infinity (naming the entry), or
    /// if the facts ask for what the engine cannot do; SolverFailure if A cannot be factorized.
    virtual void factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) = 0;

    /// The same with a copy of A.
    void factorize(const SparseMatrix& A, const MatrixFacts& facts) {
        factorize(std::make_shared<const SparseMatrix>(A), facts);
    }

    /// X with A X = B: as many rows as A, one column per right-hand side; a Vector for a vector.
    /// The true residual is checked: what an engine returns has |b - A x| <= 1e-6 |b| and
    /// |b - A x| <= 1e-10 (|A| |x| + |b|), or 10 times a looser tolerance asked for. Where inertia
    /// is wanted the caller judges by report().backward_error instead: near an eigenvalue large
    /// residuals are what tells of a count not to be trusted.
    /// Throws InvalidInput for NaN, a wrong number of rows, a right-hand side not orthogonal to the
    /// kernel, or without a factorization; SolverFailure if there is no such X to be had.
    template <typename Derived>
    auto solve(const Eigen::MatrixBase<Derived>& B) {
        using Result = Eigen::Matrix<double, Eigen::Dynamic, Derived::ColsAtCompileTime>;
        return Result(solve_columns(B.derived()));
    }

    /// Number of negative eigenvalues of the last matrix factorized (Sylvester's law of inertia);
    /// nullopt if the engine does not know.
    virtual std::optional<Index> negative_pivots() const = 0;

    /// How the last solve went.
    virtual const SolveReport& report() const = 0;

protected:
    virtual DenseMatrix solve_columns(const Eigen::Ref<const DenseMatrix>& B) = 0;
};

} // namespace polydec
