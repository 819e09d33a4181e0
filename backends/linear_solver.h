// SPDX-License-Identifier: MIT
#pragma once

#include "base/solve_report.h"
#include "base/types.h"

#include <memory>
#include <optional>
#include <string>

namespace polydec {

enum class Symmetry { symmetric, general };

/// What the caller knows of a matrix's spectrum; indefinite promises nothing.
enum class Definiteness { positive, semidefinite, indefinite };

/// Whether the caller needs the number of negative eigenvalues besides solutions.
enum class Inertia { unneeded, wanted };

/// Known properties of a matrix. Engines trust them; the defaults promise nothing.
struct MatrixFacts {
    Symmetry symmetry = Symmetry::general;
    Definiteness definiteness = Definiteness::indefinite; ///< of a symmetric matrix
    Inertia inertia = Inertia::unneeded;

    /// Columns spanning the whole kernel of a symmetric matrix; no columns: unknown. Right-hand
    /// sides must then be orthogonal to it, and solutions are made orthogonal.
    DenseMatrix kernel = {};

    /// Dimension of the domain behind the matrix (2 for surfaces, 3 for solids ...). It determines
    /// the ordering and the choice between direct and iterative methods. 0: guessed from the number
    /// of entries in a row.
    int domain_dimension = 0;

    /// Whether dozens of solves will follow one factorization, as in time steps or eigenvalue
    /// iterations: a factorization is then preferred up to larger sizes.
    bool many_solves = false;
};

/// The dimension of the domain behind a matrix: from the facts, else guessed from the pattern as 2
/// or 3.
int domain_dimension(const SparseMatrix& A, const MatrixFacts& facts);

/// The type of an engine's method.
enum class Method { direct, iterative };

/// The treatment of a known kernel. Grounding removes rows and columns to make the matrix regular;
/// projection keeps the matrix, with right-hand sides orthogonal to the kernel.
enum class KernelTreatment { grounding, projection };

/// The capabilities of an engine; more is an InvalidInput.
struct EngineTraits {
    Method method = Method::direct;
    Symmetry symmetry = Symmetry::general; ///< symmetric: only symmetric matrices
    /// The least definite symmetric matrices that it accepts.
    Definiteness definiteness = Definiteness::indefinite;
    Inertia inertia = Inertia::unneeded; ///< wanted: it can count negative eigenvalues
    KernelTreatment kernel = KernelTreatment::grounding;
};

/// Options of every linear engine; each reads the ones that apply to it.
struct LinearSolverOptions {
    double tolerance = 1e-12; ///< iterative engines: target for |b - A x| / |b|
    Index max_iterations = 0; ///< iterative engines; 0: min(10 n + 1000, 50000)

    /// Engine-specific options; engines without any ignore them. For PETSc's: "-ksp_type fcg
    /// -pc_hypre_boomeramg_strong_threshold 0.7".
    std::string engine_options = {};
};

/// The iteration limit of an iterative engine for this many unknowns.
Index iteration_limit(const LinearSolverOptions& options, Eigen::Index unknowns);

/// Solves A X = B: factorize once, solve often. One interface for every engine. Use an object from
/// one thread at a time; two objects are independent.
class LinearSolver {
public:
    LinearSolver() = default;
    LinearSolver(const LinearSolver&) = delete;
    LinearSolver& operator=(const LinearSolver&) = delete;
    virtual ~LinearSolver() = default;

    virtual std::string name() const = 0;
    virtual EngineTraits traits() const = 0;

    /// Prepares solves with A (square; symmetric ones with both triangles), sharing it: the caller
    /// must not change it. May be called again; an equal pattern reuses the analysis. Throws
    /// InvalidInput if A is not square, holds NaN or infinity (naming the entry), or if the facts
    /// need more than the engine's capabilities; SolverFailure if A cannot be factorized.
    virtual void factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) = 0;

    /// The same with an A of its own: a temporary is not copied.
    void factorize(SparseMatrix A, const MatrixFacts& facts) {
        const auto own = std::make_shared<SparseMatrix>();
        own->swap(A); // Eigen's matrices cannot be moved
        factorize(own, facts);
    }

    /// Solves A X = B: as many rows as A, one column per right-hand side; a Vector for a vector.
    /// The true residual is checked: results have |b - A x| <= 1e-6 |b| and |b - A x| <= 1e-10 (|A|
    /// |x| + |b|), or 10 times a looser requested tolerance. If inertia is wanted, the caller
    /// judges by report().backward_error instead: near an eigenvalue, large residuals reveal an
    /// untrusted count. Throws InvalidInput for NaN, a wrong number of rows, a right-hand side not
    /// orthogonal to the kernel, or without a factorization; SolverFailure if no such X is found.
    template <typename Derived>
    auto solve(const Eigen::MatrixBase<Derived>& B) {
        using Result = Eigen::Matrix<double, Eigen::Dynamic, Derived::ColsAtCompileTime>;
        return Result(solve_columns(B.derived()));
    }

    /// Number of negative eigenvalues of the last factorized matrix (Sylvester's law of inertia);
    /// nullopt if the engine does not count.
    virtual std::optional<Index> negative_pivots() const = 0;

    /// The report of the last solve.
    virtual const SolveReport& report() const = 0;

protected:
    virtual DenseMatrix solve_columns(const Eigen::Ref<const DenseMatrix>& B) = 0;
};

} // namespace polydec
