// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/checked_solver.h"
#include "backends/registry.h"

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace polydec {

namespace detail {

template <typename Solver>
auto matrix_of() {
    if constexpr (requires { typename Solver::MatrixType; })
        return std::remove_cvref_t<typename Solver::MatrixType>();
    else
        return SparseMatrix();
}

template <typename Solver>
class AdaptedSolver final : public CheckedSolver {
public:
    AdaptedSolver(const std::string& name, const EngineTraits& traits,
                  const LinearSolverOptions& options, const std::function<void(Solver&)>& configure)
        : CheckedSolver(name, traits, options) {
        if constexpr (requires { solver_.setTolerance(options.tolerance); })
            solver_.setTolerance(options.tolerance);
        if constexpr (requires { solver_.setMaxIterations(options.max_iterations); })
            if (options.max_iterations > 0)
                solver_.setMaxIterations(options.max_iterations);
        if (configure)
            configure(solver_);
    }

protected:
    void compute(const SparseMatrix& A, const MatrixFacts&, Pattern) override {
        // Iterative solvers keep a reference, so the matrix must live as long as they do.
        matrix_ = A;
        solver_.compute(matrix_);
        check_success("the factorization");
    }

    Solution apply_inverse(const DenseMatrix& B) override {
        DenseMatrix X = solver_.solve(B);
        check_success("the solution");
        return {std::move(X), iterations()};
    }

private:
    void check_success(const char* what) const {
        if constexpr (requires { solver_.info() == Eigen::Success; }) {
            if (solver_.info() == Eigen::NoConvergence)
                fail(std::string(what) + " did not converge within its limit of iterations");
            if (solver_.info() != Eigen::Success)
                fail(std::string(what) + " failed: the matrix is singular, or its facts are wrong");
        }
    }

    Index iterations() const {
        if constexpr (requires { solver_.iterations(); })
            return static_cast<Index>(solver_.iterations());
        else
            return 0;
    }

    decltype(matrix_of<Solver>()) matrix_;
    Solver solver_;
};

} // namespace detail

/// Makes an engine from any type with Eigen's compute(A) and solve(B), and optionally info() and
/// iterations(). A is passed as Solver::MatrixType if that type exists, else as SparseMatrix.
///     register_engine("mine", adapt<Eigen::SparseQR<...>>("mine"));
///     auto solver = adapt<MySolver>("mine", {.symmetry = Symmetry::symmetric})({});
/// traits: its capabilities, by default everything but inertia. Tolerance and iteration limit are
/// passed on if it has Eigen's setters; configure is then called once on each new solver. Solutions
/// are checked as for every engine.
template <typename Solver>
LinearSolverFactory adapt(std::string name, const EngineTraits& traits = {},
                          std::function<void(Solver&)> configure = {}) {
    return [name = std::move(name), traits,
            configure = std::move(configure)](const LinearSolverOptions& options) {
        return std::make_unique<detail::AdaptedSolver<Solver>>(name, traits, options, configure);
    };
}

} // namespace polydec
