// SPDX-License-Identifier: MIT
#include "solvers/time/largest_pair.h"

#include "backends/registry.h"
#include "base/errors.h"

namespace polydec {

namespace {

/// A Chebyshev polynomial of A, of odd degree: at most 1 for eigenvalues in [0, end], and growing
/// so fast beyond that neighbors there come to lie far apart.
SymmetricOperator spread_out(const SymmetricOperator& A, double end) {
    constexpr int degree = 17;
    return {A.size, [&A, end](const Vector& x, Vector& y) {
                Vector before = x, image;
                A.apply(x, image);
                y = 2 / end * image - x;
                for (int i = 1; i < degree; ++i) {
                    A.apply(y, image);
                    before = 4 / end * image - 2 * y - before;
                    before.swap(y);
                }
            }};
}

} // namespace

std::pair<double, Vector> largest_pair(const SymmetricOperator& A) {
    const auto find = [](const SymmetricOperator& of, const EigenOptions& options) {
        EigenPairs pairs = make_eigen_solver("spectra")->largest(of, 1, options);
        if (pairs.converged < 1)
            throw SolverFailure("the fastest oscillation or decay could not be found: the "
                                "eigensolver did not converge");
        return pairs;
    };
    const auto rough = find(A, {.tolerance = 0.03});
    const double below = 0.99 * rough.values[0];
    if (!(below > 0))
        return {0, rough.vectors.col(0)};
    const Vector x = find(spread_out(A, below), {.tolerance = 1e-5}).vectors;
    Vector image;
    A.apply(x, image);
    return {x.dot(image) / x.squaredNorm(), x};
}

} // namespace polydec
