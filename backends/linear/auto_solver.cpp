// SPDX-License-Identifier: MIT
#include "backends/linear/auto_solver.h"

#include "backends/builtin_engines.h"
#include "backends/registry.h"
#include "system/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

namespace polydec {

namespace {

// Where a factorization of a solid outgrows what iterating costs: CHOLMOD takes 98 s and 8.7 GB for
// a million unknowns, and Eigen's L D L^T is 20 times slower.
constexpr Eigen::Index large_for_cholmod = 200000;
constexpr Eigen::Index large_for_eigen = 50000;

// From here on multigrid solves a problem once in less time than a factorization takes.
constexpr Eigen::Index solid_for_multigrid = 30000;
constexpr Eigen::Index surface_for_multigrid = 1500000;

// From here on dense blocks and pivoting pay: 44 k unknowns of a surface take MUMPS 0.6 s where
// CHOLMOD takes 0.4, twice as many of a solid 6 s instead of 10.
constexpr Eigen::Index surface_for_mumps = 50000;
constexpr Eigen::Index solid_for_mumps = 5000;

// From here on a solve with the factor of a solid takes longer than iterating on a matrix that its
// diagonal dominates: 100 steps of heat on 27^3 cubes take .3 s instead of 1.3.
constexpr Eigen::Index solid_for_dominant = 5000;

/// Whether the rest of each row is at most half of its diagonal. By Gershgorin, conjugate
/// gradients with Jacobi's preconditioner then gain a digit in two iterations.
bool is_dominated_by_diagonal(const SparseMatrix& A) {
    for (Eigen::Index row = 0; row < A.rows(); ++row) {
        double diagonal = 0, others = 0;
        for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry)
            (entry.col() == row ? diagonal : others) += std::abs(entry.value());
        if (!(diagonal > 0 && others <= diagonal / 2))
            return false;
    }
    return true;
}

std::vector<std::string> indefinite_engines(const SparseMatrix& A, const MatrixFacts& facts) {
    const auto large = domain_dimension(A, facts) > 2 ? solid_for_mumps : surface_for_mumps;
    if (A.rows() > large)
        return {"mumps", "cholmod", "eigen.ldlt"};
    return {"cholmod", "eigen.ldlt"};
}

std::vector<std::string> definite_engines(const SparseMatrix& A, const MatrixFacts& facts,
                                          bool has_cholmod) {
    const auto limit = has_cholmod ? large_for_cholmod : large_for_eigen;
    if (A.rows() > limit && domain_dimension(A, facts) > 2)
        return {"eigen.cg", "cholmod", "eigen.ldlt"};
    if (facts.definiteness == Definiteness::semidefinite && facts.kernel.cols() == 0)
        return {"eigen.cg", "cholmod", "eigen.ldlt"};
    return {"cholmod", "eigen.ldlt", "eigen.lu", "eigen.cg"};
}

std::vector<std::string> wished_engines(const SparseMatrix& A, const MatrixFacts& facts,
                                        bool has_cholmod) {
    if (facts.symmetry == Symmetry::general)
        return {"eigen.lu", "eigen.bicgstab"};
    if (facts.inertia == Inertia::wanted)
        return indefinite_engines(A, facts);

    if (facts.definiteness == Definiteness::indefinite) {
        auto names = indefinite_engines(A, facts);
        names.push_back("eigen.lu");
        return names;
    }

    if (A.rows() > solid_for_dominant && domain_dimension(A, facts) > 2 &&
        is_dominated_by_diagonal(A))
        return {"eigen.cg", "cholmod", "eigen.ldlt"};

    auto names = definite_engines(A, facts, has_cholmod);
    if (domain_dimension(A, facts) > 2) {
        if (A.rows() > (facts.many_solves ? large_for_cholmod : solid_for_multigrid))
            names.insert(names.begin(), {"petsc.cg-hypre", "petsc.cg-gamg"});
    } else if (A.rows() >
               large_for_eigen) { // where memory is short for a factor, it may do for this
        const bool is_first = A.rows() > surface_for_multigrid && !facts.many_solves;
        names.insert(names.begin() + (is_first ? 0 : 1), "petsc.cg-gamg");
    }
    return names;
}

// The first line of a message says what was wrong; the others advise on another engine.
std::string first_line(const std::string& message) {
    return message.substr(0, message.find('\n'));
}

// What was missed first, for take_missed_engines().
std::mutex missed_mutex;
std::optional<std::string> missed;

void note_missed_engines(const SparseMatrix& A, const MatrixFacts& facts) {
    const std::lock_guard lock(missed_mutex);
    if (missed)
        return;
    if (auto text = missed_engines(A, facts); !text.empty())
        missed = std::move(text);
}

} // namespace

std::vector<std::string> suitable_engines(const SparseMatrix& A, const MatrixFacts& facts) {
    auto names = wished_engines(A, facts, has_linear_solver("cholmod"));
    std::erase_if(names, [](const std::string& name) { return !has_linear_solver(name); });
    return names;
}

std::string missed_engines(const SparseMatrix& A, const MatrixFacts& facts) {
    const auto slow = domain_dimension(A, facts) > 2 ? solid_for_mumps : surface_for_mumps;
    if (A.rows() <= slow)
        return {};
    std::vector<std::string> names;
    for (const auto& name : wished_engines(A, facts, true)) {
        if (name.starts_with("eigen."))
            break;
        if (has_linear_solver(name))
            return {};
        names.push_back(name);
    }
    if (names.empty())
        return {};
    const bool misses_cholmod = std::find(names.begin(), names.end(), "cholmod") != names.end();
    const std::string nearest = misses_cholmod ? "cholmod" : names.front();
    return fmt::format(
        "the engine `auto` lacks {} for {} unknowns, and uses a slower engine of Eigen\n"
        "To get {}: {}.",
        fmt::join(names, ", "), A.rows(), nearest, how_to_get_linear_solver(nearest));
}

std::string take_missed_engines() {
    const std::lock_guard lock(missed_mutex);
    return missed ? std::exchange(*missed, {}) : std::string{};
}

namespace {

/// The engine `auto`: uses the first of suitable_engines() with a good factorization and good
/// solves, and switches to the next after a failure; report().tried lists the attempts. Throws
/// SolverFailure with all failures if none is left, OutOfMemory if one of them needed more memory;
/// bad input throws as in every engine.
class AutoSolver final : public LinearSolver {
public:
    explicit AutoSolver(const LinearSolverOptions& options) : options_(options) {}

    std::string name() const override { return "auto"; }
    EngineTraits traits() const override { return {.inertia = Inertia::wanted}; }
    using LinearSolver::factorize;

    void factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) override {
        matrix_ = nullptr;
        report_ = {};
        if (!A)
            throw InvalidInput("auto: the pointer to the matrix is null");
        candidates_ = suitable_engines(*A, facts);
        note_missed_engines(*A, facts);
        facts_ = facts;
        matrix_ = std::move(A);
        try {
            start();
        } catch (...) {
            matrix_ = nullptr;
            engine_ = nullptr;
            throw;
        }
    }

    std::optional<Index> negative_pivots() const override {
        return engine_ ? engine_->negative_pivots() : std::nullopt;
    }
    const SolveReport& report() const override { return report_; }

protected:
    DenseMatrix solve_columns(const Eigen::Ref<const DenseMatrix>& B) override {
        if (!matrix_)
            throw InvalidInput("auto: call factorize() successfully before solve()");
        if (!engine_)
            start();
        DenseMatrix X;
        while (!succeeds([&] { X = engine_->solve(B); }))
            advance();
        report_ = engine_->report();
        report_.tried.insert(report_.tried.begin(), failures_.begin(), failures_.end());
        return X;
    }

private:
    void start() {
        next_ = 0;
        failures_.clear();
        lacks_memory_ = false;
        advance();
    }

    void advance() {
        while (next_ < candidates_.size()) {
            const std::string& candidate = candidates_[next_++];
            if (succeeds([&] {
                    // An engine that is there already keeps its analysis.
                    if (!engine_ || engine_->name() != candidate)
                        engine_ = make_linear_solver(candidate, options_);
                    if (lacks_memory_ && engine_->traits().method == Method::direct)
                        throw OutOfMemory(candidate + ": another factor would not fit either");
                    engine_->factorize(matrix_, facts_);
                }))
                return;
        }
        engine_ = nullptr;
        fail();
    }

    template <typename Work>
    bool succeeds(Work work) {
        try {
            work();
            return true;
        } catch (const SolverFailure& failure) {
            lacks_memory_ |= dynamic_cast<const OutOfMemory*>(&failure) != nullptr;
            failures_.push_back(first_line(failure.what()));
        } catch (const BackendUnavailable& failure) {
            failures_.push_back(first_line(failure.what()));
        }
        return false;
    }

    [[noreturn]] void fail() const {
        const auto story = fmt::format("auto: no engine solves this {0} x {0} system: {1}\n",
                                       matrix_->rows(), fmt::join(failures_, "; "));
        SolveReport report = SolveReport::failed("auto");
        report.tried = failures_;
        if (lacks_memory_)
            throw OutOfMemory(story + "Raise the limit (set_memory_limit), or use fewer cells.",
                              report);
        throw SolverFailure(story + "The matrix is singular, or its facts are wrong; if it has a "
                                    "kernel, give it in the facts.",
                            report);
    }

    LinearSolverOptions options_;
    std::shared_ptr<const SparseMatrix> matrix_;
    MatrixFacts facts_;
    std::vector<std::string> candidates_;
    std::size_t next_ = 0;                 // the candidate to try when the engine fails
    std::unique_ptr<LinearSolver> engine_; // null: not factorized
    std::vector<std::string> failures_;
    bool lacks_memory_ = false; // whether one of the failures is lack of memory
    SolveReport report_;
};

} // namespace

std::unique_ptr<LinearSolver> builtin::make_auto(const LinearSolverOptions& options) {
    return std::make_unique<AutoSolver>(options);
}

} // namespace polydec
