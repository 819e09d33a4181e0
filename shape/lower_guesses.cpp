// SPDX-License-Identifier: MIT
#include "shape/lower_guesses.h"

#include "backends/registry.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "system/memory.h"

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

/// The forms X^T Q(s) X and minus their derivative by s.
struct Projected {
    double s = 0;
    DenseMatrix Q, slope, image; ///< image: Q(s) X
};

Projected project(const FormFamily& family, const DenseMatrix& X, double s) {
    constexpr double step = 1e-4;
    Projected result{s, {}, {}, *family.at(s).matrix * X};
    result.Q = X.transpose() * result.image;
    const DenseMatrix before = X.transpose() * (*family.at(s * (1 - step)).matrix * X);
    result.slope = (before - result.Q) / (s * step);
    return result;
}

/// One step of Newton for all values, in the space of X; X becomes their vectors, and `residuals`
/// are Q(s) times these. Values that differ by a share below `nearby` have one s. False if X says
/// nothing.
bool rotate(const FormFamily& family, DenseMatrix& X, Vector& values, DenseMatrix& residuals,
            double nearby) {
    DenseMatrix rotated(X.rows(), X.cols());
    residuals.resize(X.rows(), X.cols());
    Projected at;
    Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> ritz;
    const double most = 0.98 * family.limit();
    for (Eigen::Index j = 0; j < X.cols(); ++j) {
        const double s = std::clamp(values[j], 0.0, most);
        if (s > 0 && !(std::abs(s - at.s) <= nearby * s)) {
            at = project(family, X, s);
            ritz.compute((at.Q + at.Q.transpose()) / 2, (at.slope + at.slope.transpose()) / 2);
            if (ritz.info() != Eigen::Success || !ritz.eigenvectors().allFinite())
                return false;
        }
        if (!(at.s > 0)) { // zeros
            rotated.col(j) = X.col(j);
            residuals.col(j).setZero();
            continue;
        }
        const auto y = ritz.eigenvectors().col(j);
        values[j] = std::clamp(at.s + ritz.eigenvalues()[j], 0.0, most);
        rotated.col(j) = X * y;
        residuals.col(j) = at.image * y;
    }
    X = rotated;
    return true;
}

} // namespace

LowerGuesses lower_guesses(const FormFamily& family, DenseMatrix X, const Vector& given,
                           const std::string& engine, int domain_dimension) {
    Vector values = given;
    DenseMatrix residuals;
    if (!rotate(family, X, values, residuals, 0.1))
        return {given, X};
    // errors are of functions far above; in between, so that none of these is blown up
    const double shift = std::min(0.7 * values.maxCoeff(), 0.9 * family.limit());
    MatrixFacts facts;
    facts.symmetry = Symmetry::symmetric;
    facts.inertia =
        Inertia::wanted; // residuals of nearly singular matrices are looked at elsewhere
    facts.domain_dimension = domain_dimension;
    const auto solver = make_linear_solver(engine);
    try {
        solver->factorize(family.at(shift).matrix, facts);
        DenseMatrix better = X - solver->solve(residuals);
        if (Vector near = values;
            better.allFinite() && rotate(family, better, near, residuals, 1e-2))
            return {near, better};
    } catch (const OutOfMemory&) {
        throw;
    } catch (const SolverFailure&) { // then these have to do
    }
    return {values, X};
}

} // namespace polydec
