// SPDX-License-Identifier: MIT
#include "solvers/coexact_spectrum.h"

#include "base/errors.h"
#include "dec/derivative.h"
#include "dec/star.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

constexpr double cluster_width = 1e-6; // relative; eigenvalues nearer than this belong together

/// How many of the values, ascending, make whole clusters: the last one may have been cut.
Index whole_clusters(const Vector& values, Index size) {
    Index count = static_cast<Index>(values.size());
    if (count == size)
        return count;
    while (count > 1 && values[count - 1] - values[count - 2] <= cluster_width * values[count - 1])
        --count;
    return count - 1;
}

struct CoexactPart {
    Vector values;
    DenseMatrix modes;
};

/// The coexact forms in the space that whole clusters of eigenforms span. It is invariant under
/// delta d, which vanishes on the exact and harmonic ones.
CoexactPart coexact_part(const CellComplex& complex, const CellVolumes& volumes, int k,
                         const Vector& values, const DenseMatrix& modes) {
    const DenseMatrix curls = derivative(complex, k) * modes;
    const DenseMatrix C = curls.transpose() * star(volumes, k + 1).asDiagonal() * curls;
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> eigen(C);
    constexpr double rounding = 1e-7;
    Index zeros = 0;
    while (zeros < C.rows() && eigen.eigenvalues()[zeros] <= rounding * values.maxCoeff())
        ++zeros;
    const Index count = static_cast<Index>(C.rows()) - zeros;
    return {eigen.eigenvalues().tail(count), modes * eigen.eigenvectors().rightCols(count)};
}

} // namespace

Spectrum coexact_spectrum(const CellComplex& complex, const CellVolumes& volumes,
                          const SpectrumOptions& options) {
    if (options.side != Side::primal)
        throw InvalidInput("coexact spectra are of primal forms: a coexact dual form is the star "
                           "of an exact primal one");
    const int k = options.degree;
    const Index size = complex.size(k);
    SpectrumOptions all = options;
    all.count = std::min<Index>(size, 2 * options.count + 10);
    while (true) {
        Spectrum found = spectrum(complex, volumes, all);
        const Index whole = whole_clusters(found.eigenvalues, size);
        auto part = coexact_part(complex, volumes, k, found.eigenvalues.head(whole),
                                 found.modes.leftCols(whole));
        if (part.values.size() >= options.count) {
            found.eigenvalues = part.values.head(options.count);
            found.modes = part.modes.leftCols(options.count);
            found.residuals.resize(options.count);
            const Vector mass = star(volumes, k), upper = star(volumes, k + 1);
            const SparseMatrix d = derivative(complex, k);
            for (Index i = 0; i < options.count; ++i) {
                const Vector x = found.modes.col(i);
                const Vector image = d.transpose() * upper.cwiseProduct(d * x);
                const Vector weighted = mass.cwiseProduct(x);
                found.residuals[i] =
                    (image - found.eigenvalues[i] * weighted).norm() / weighted.norm();
            }
            return found;
        }
        if (all.count == size)
            throw InvalidInput(fmt::format("{} coexact {}-forms asked for: there are {}",
                                           options.count, k, part.values.size()));
        all.count = std::min<Index>(size, 2 * all.count);
    }
}

} // namespace polydec
