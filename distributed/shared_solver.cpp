// SPDX-License-Identifier: MIT
#include "distributed/shared_solver.h"

#include "backends/linear/solution_quality.h"
#include "base/errors.h"
#include "base/exponent.h"
#include "distributed/ksp.h"
#include "distributed/petsc_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace polydec {

namespace {

/// The rows and columns of A that are solved for.
OwnedMat part(const Ranks& ranks, Mat A, const std::vector<Index>& unknowns) {
    PetscInt begin = 0;
    require(MatGetOwnershipRange(A, &begin, nullptr), "dividing a matrix");
    std::vector<PetscInt> rows;
    for (const Index i : unknowns)
        rows.push_back(begin + i);
    IS set = nullptr;
    require(ISCreateGeneral(communicator(ranks), static_cast<PetscInt>(rows.size()), rows.data(),
                            PETSC_COPY_VALUES, &set),
            "dividing a matrix");
    OwnedMat result = made("dividing a matrix", [&](Mat* matrix) {
        return MatCreateSubMatrix(A, set, set, MAT_INITIAL_MATRIX, matrix);
    });
    ISDestroy(&set);
    return result;
}

} // namespace

struct SharedSolver::State {
    State(const Ranks& ranks_, SharedSystem system_, const SharedEngine& engine_)
        : ranks(ranks_),
          system(std::move(system_)),
          engine(engine_),
          components(ranks, system.A.get(), system.held, system.weights) {
        for (Index i = 0; i < system.weights.size(); ++i)
            if (!system.held.fixed[i] && !components.grounded()[i])
                unknowns.push_back(i);
        count = ranks.sum(std::ssize(unknowns));
        if (engine.name == "auto")
            left = Ksp::engines(system.definiteness);
        else
            left = {engine.name};
        if (count == 0)
            return;
        reduced = part(ranks, system.A.get(), unknowns);
        require(MatNorm(reduced.get(), NORM_INFINITY, &matrix_norm), "looking at a matrix");
        next_engine();
    }

    /// Sets up the first engine of those that are left which can be.
    void next_engine() {
        while (true) {
            solver.reset();
            if (left.empty())
                throw SolverFailure(
                    fmt::format("no engine solves the system: {}", fmt::join(tried, "; ")));
            const SharedEngine one{left.front(), engine.options};
            left.erase(left.begin());
            try {
                solver = std::make_unique<Ksp>(ranks, reduced.get(), one, definiteness());
                name = one.name;
                return;
            } catch (const SolverFailure& failure) { // of all ranks
                tried.emplace_back(failure.what());
            }
        }
    }

    /// Of what is left where nothing is free.
    Definiteness definiteness() const {
        return system.definiteness == Definiteness::indefinite ? Definiteness::indefinite
                                                               : Definiteness::positive;
    }

    double norm(const Vector& own) const { return std::sqrt(ranks.sum(own.squaredNorm())); }
    double largest(const Vector& own) const {
        return ranks.largest(own.size() > 0 ? own.lpNorm<Eigen::Infinity>() : 0.0);
    }

    SolutionQuality quality(const Vector& x, const Vector& b, const Vector& rest) const {
        return {.residual = norm(rest) / norm(b),
                .backward_error = largest(rest) / (matrix_norm * largest(x) + largest(b))};
    }

    Vector solve(const Vector& right_side, SolveReport& report);

    Ranks ranks;
    SharedSystem system;
    SharedEngine engine;
    SharedComponents components;
    std::vector<Index> unknowns;
    GlobalIndex count = 0;
    OwnedMat reduced;
    PetscReal matrix_norm = 0;            // the largest sum of a row
    std::vector<std::string> left, tried; // engines
    std::unique_ptr<Ksp> solver;
    std::string name;
};

/// Refined until the residual does not shrink any more, or is small enough. In the unit of the
/// data, a power of two, whose squares stay in range.
Vector SharedSolver::State::solve(const Vector& right_side, SolveReport& report) {
    constexpr double enough = 1e-12;
    constexpr int most_refinements = 3;
    const double size = largest(right_side);
    if (size == 0)
        return right_side;
    const int unit = std::ilogb(size);
    const Vector b = times_power(right_side, -unit);
    while (true) {
        try {
            Vector x = Vector::Zero(b.size()), r = b;
            SolutionQuality reached{.residual = 1, .backward_error = 1};
            for (int i = 0; i <= most_refinements && reached.residual > enough; ++i) {
                const Vector better = x + solver->solve(r, report.iterations);
                const Vector rest = b - product(ranks, reduced.get(), better);
                const SolutionQuality now = quality(better, b, rest);
                if (!(now.residual < reached.residual))
                    break;
                x = better;
                r = rest;
                reached = now;
            }
            if (!reached.is_good())
                throw SolverFailure(fmt::format("{}: {}", name, reached.failure()));
            report.residual = reached.residual;
            report.backward_error = reached.backward_error;
            return times_power(x, unit);
        } catch (const SolverFailure& failure) { // of all ranks
            tried.emplace_back(failure.what());
            next_engine();
        }
    }
}

SharedSolver::SharedSolver(const Ranks& ranks, SharedSystem system, const SharedEngine& engine)
    : state_(std::make_shared<State>(ranks, std::move(system), engine)) {}

Solution SharedSolver::solve(const Vector& b, const Vector& fixed_values) const {
    State& s = *state_;
    if (s.ranks.any(!b.allFinite() || !fixed_values.allFinite()))
        throw InvalidInput("the right-hand side or fixed values of a constrained system are not "
                           "all finite: scale the data");
    Vector u = Vector::Zero(b.size());
    for (Index i = 0; i < u.size(); ++i)
        if (s.system.held.fixed[i])
            u[i] = fixed_values[i];
    Vector right_side = b - product(s.ranks, s.system.A.get(), u);
    Solution result;
    result.compatibility = s.components.balance(right_side);
    if (s.count > 0) {
        const Vector reduced = right_side(s.unknowns);
        u(s.unknowns) = s.solve(reduced, result.report);
    }
    result.report.engine = s.name;
    result.report.tried = s.tried;
    result.report.tried.push_back(s.name);
    s.components.remove_means(u);
    if (s.ranks.any(!u.allFinite()))
        throw SolverFailure("the solution has values that are not finite: data or weights leave "
                            "the range of double precision; scale them");
    result.values = std::move(u);
    return result;
}

} // namespace polydec
