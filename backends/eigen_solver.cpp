// SPDX-License-Identifier: MIT
#include "backends/eigen_solver.h"

#include "base/checks.h"
#include "base/random.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace polydec {

namespace {

void check(const std::string& name, const SymmetricOperator& A, Index count,
           const EigenOptions& options) {
    if (A.size < 0 || !A.apply)
        throw InvalidInput(name + ": the operator has a negative size or no apply()");
    if (count < 0 || count > A.size)
        throw InvalidInput(fmt::format("{}: {} eigenpairs requested, but the operator has size {}",
                                       name, count, A.size));
    check_positive(fmt::format("{}: the tolerance", name), options.tolerance);
    if (options.krylov_dimension < 0 || options.max_restarts < 0)
        throw InvalidInput(fmt::format("{}: Krylov dimension {} and restarts {} must not be "
                                       "negative",
                                       name, options.krylov_dimension, options.max_restarts));
    if (options.start.size() > 0 &&
        (options.start.size() != A.size || !options.start.allFinite() || options.start.isZero(0.0)))
        throw InvalidInput(
            fmt::format("{}: the start vector has {} entries; expected {}, finite and not all zero",
                        name, options.start.size(), A.size));
}

EigenOptions filled_in(const EigenOptions& options, Index size, Index count, std::int64_t usual) {
    EigenOptions result = options;
    const std::int64_t wished = options.krylov_dimension > 0 ? options.krylov_dimension : usual;
    const std::int64_t least = std::int64_t{count} + 1;
    result.krylov_dimension =
        static_cast<Index>(std::min<std::int64_t>(std::max(wished, least), size));
    if (options.start.size() == 0) {
        result.start.resize(size);
        Noise(1).fill(result.start);
    }
    return result;
}

// A NaN in a Krylov basis spreads to everything, so it is caught where it comes in.
SymmetricOperator watched(const SymmetricOperator& A, const std::string& name) {
    const auto check = [name](bool is_good, const char* reason) {
        if (!is_good)
            throw SolverFailure(name + reason, SolveReport::failed(name));
    };
    const auto check_input = [check](const auto& X) {
        check(X.allFinite(), ": the iteration broke down (an invariant subspace)\n"
                             "Use another start vector.");
    };
    const auto check_output = [check, size = A.size](const auto& Y, Eigen::Index columns) {
        check(Y.rows() == size && Y.cols() == columns && Y.allFinite(),
              ": the operator returned NaN, infinity or a vector of another size");
    };
    const auto apply = [=, &A](const Vector& x, Vector& y) {
        check_input(x);
        y.resize(A.size);
        A.apply(x, y);
        check_output(y, 1);
    };
    const auto apply_to_columns = [=, &A](const DenseMatrix& X, DenseMatrix& Y) {
        Y.resize(A.size, X.cols());
        if (A.apply_to_columns) {
            check_input(X);
            A.apply_to_columns(X, Y);
            check_output(Y, X.cols());
            return;
        }
        Vector y;
        for (Eigen::Index j = 0; j < X.cols(); ++j) {
            apply(X.col(j), y);
            Y.col(j) = y;
        }
    };
    return {A.size, apply, apply_to_columns};
}

} // namespace

std::int64_t EigenSolver::usual_dimension(Index count) const {
    return std::max<std::int64_t>(2 * std::int64_t{count} + 1, 20);
}

EigenPairs EigenSolver::largest(const SymmetricOperator& A, Index count,
                                const EigenOptions& options) const {
    check(name(), A, count, options);
    if (count == 0)
        return {Vector(0), DenseMatrix(A.size, 0), 0, 0};
    try {
        return compute(watched(A, name()), count,
                       filled_in(options, A.size, count, usual_dimension(count)));
    } catch (const std::bad_alloc&) {
        throw OutOfMemory(
            fmt::format("{}: not enough memory for {} eigenpairs of an operator of size {}\n"
                        "Request fewer, or allow more memory.",
                        name(), count, A.size));
    }
}

} // namespace polydec
