// SPDX-License-Identifier: MIT
#include "backends/spectra/found_pairs.h"
#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/forms/cochain.h"
#include "dec/stars/star.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "solvers/spectra/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace polydec {

namespace {

constexpr double cluster_width = 1e-6; // relative; nearer eigenvalues belong together

/// Eigenvalues in a cluster, begin .. end - 1.
struct Cluster {
    Index begin, end;
};

/// All clusters except the last, which may be incomplete unless these are all eigenvalues.
std::vector<Cluster> whole_clusters(const Spectrum& found, Index size) {
    const Vector &values = found.eigenvalues, &radii = found.radii;
    const auto count = static_cast<Index>(values.size());
    std::vector<Cluster> clusters;
    for (Index i = 0; i < count; ++i) {
        const bool belongs =
            i > 0 && values[i] - values[i - 1] <=
                         std::max(cluster_width * std::abs(values[i]), radii[i] + radii[i - 1]);
        if (belongs)
            clusters.back().end = i + 1;
        else
            clusters.push_back({i, i + 1});
    }
    if (count < size)
        clusters.pop_back();
    return clusters;
}

bool may_be_zero(const Spectrum& found, Index i) {
    return std::abs(found.eigenvalues[i]) <= found.radii[i];
}

/// The rank of d_k: the number of k-forms minus harmonic and exact ones.
Index coexact_forms(const CellComplex& complex, const std::vector<Index>& betti, int k) {
    Index coexact = 0; // of the degree below, which d maps to the exact forms of this degree
    for (int j = 0; j <= k; ++j)
        coexact = complex.size(j) - betti[j] - coexact;
    return coexact;
}

[[noreturn]] void refuse_to_tell(Index zeros, Index harmonic, int k) {
    throw SolverFailure(fmt::format("rounding hides which forms are coexact: {} eigenvalues are "
                                    "zero up to rounding, but there are {} harmonic {}-forms",
                                    zeros, harmonic, k));
}

/// Requires as many zeros as harmonic forms; more zeros could be small eigenvalues.
void check_zeros(const Spectrum& found, Index harmonic) {
    Index zeros = 0;
    for (Index i = 0; i < found.eigenvalues.size(); ++i)
        zeros += may_be_zero(found, i) ? 1 : 0;
    if (zeros > harmonic)
        refuse_to_tell(zeros, harmonic, found.degree);
}

/// The coexact forms in the space of a cluster. The space is invariant under delta d, with the
/// cluster's eigenvalue on coexact forms and 0 on exact ones.
DenseMatrix coexact_modes(const SparseMatrix& d, const SparseMatrix& upper_star,
                          const DenseMatrix& modes, double eigenvalue) {
    const DenseMatrix curls = d * modes;
    const DenseMatrix energies = curls.transpose() * (upper_star * curls);
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> eigen(DenseMatrix(energies / eigenvalue));
    const auto exact = static_cast<Index>((eigen.eigenvalues().array() < 0.5).count());
    return modes * eigen.eigenvectors().rightCols(modes.cols() - exact);
}

/// All coexact modes in complete clusters, one per column.
DenseMatrix coexact_modes(const CellComplex& complex, const HodgeStars& stars,
                          const Spectrum& found, Index harmonic) {
    const int k = found.degree;
    const SparseMatrix d = derivative(complex, k);
    const SparseMatrix upper_star = stars[k + 1].matrix();
    std::vector<DenseMatrix> parts;
    Index count = 0;
    for (const auto [begin, end] : whole_clusters(found, complex.size(k))) {
        Index zeros = 0;
        for (Index i = begin; i < end; ++i)
            zeros += may_be_zero(found, i) ? 1 : 0;
        if (zeros == end - begin)
            continue;
        if (zeros > 0)
            refuse_to_tell(end - begin, harmonic, k);
        parts.push_back(coexact_modes(d, upper_star, found.modes.middleCols(begin, end - begin),
                                      found.eigenvalues[begin]));
        count += static_cast<Index>(parts.back().cols());
    }
    DenseMatrix modes(complex.size(k), count);
    Index next = 0;
    for (const auto& part : parts) {
        modes.middleCols(next, part.cols()) = part;
        next += static_cast<Index>(part.cols());
    }
    return modes;
}

/// Values, radii and residuals of the first modes as eigenforms of delta d alone.
void measure(const Pencil& given, const DenseMatrix& modes, Index count, Spectrum& spectrum) {
    const ScaledPencil pencil(given);
    const DenseMatrix Y = pencil.scaled(modes);
    FoundPairs pairs(pencil.size(), 0);
    pairs.take(Y, pencil.enclose(Y));
    spectrum.eigenvalues = pencil.eigenvalues(pairs.values().head(count));
    spectrum.radii = pencil.eigenvalues(pairs.radii().head(count));
    spectrum.residuals = pencil.eigenvalues(pairs.residuals().head(count));
    spectrum.modes = pencil.eigenvectors(pairs.vectors().leftCols(count));
    spectrum.rough = rough_values(pairs, pencil.norm(), pencil.eigenvalue(1), count);
}

} // namespace

Spectrum coexact_spectrum(const FormSpace& space, const SpectrumOptions& options) {
    space.refuse_robin("a coexact spectrum");
    if (space.side() != Side::primal)
        throw InvalidInput("the forms are dual: expected primal forms; the coexact dual forms are "
                           "the stars of exact primal forms");
    const Cells inside = space.inside();
    const CellComplex& complex = inside.complex();
    const int k = space.degree();
    const auto betti = betti_numbers(complex);
    const Index size = space.size(), all_coexact = coexact_forms(complex, betti, k);
    if (options.count < 1 || options.count > all_coexact)
        throw InvalidInput(
            fmt::format("{} coexact {}-forms requested: {}{}", options.count, k,
                        expected_numbers(1, all_coexact),
                        all_coexact > 0 ? ""
                                        : ", because d maps all forms of this space to 0; choose a "
                                          "smaller degree or other conditions"));
    SpectrumOptions all = options;
    all.count = betti[k] + 2 * options.count + 10;
    if (all.count > size / 2)
        all.count = size;
    // in the unit of the mesh until coexact modes are found
    const auto on_inside = FormSpace::vanishing_on({complex, inside.stars()}, Side::primal, k);
    while (true) {
        Spectrum found = spectrum(on_inside, all);
        const DenseMatrix modes = coexact_modes(complex, inside.stars(), found, betti[k]);
        if (modes.cols() >= options.count) {
            check_zeros(found, betti[k]);
            measure(coexact_pencil(complex, inside.stars(), k), modes, options.count, found);
            use_input_units(found, complex.dimension(), inside.unit());
            found.modes = space.extend(found.modes);
            return found;
        }
        if (all.count == size)
            throw SolverFailure(fmt::format(
                "{} coexact {}-forms requested: {} exist, but rounding hides all but {}",
                options.count, k, all_coexact, modes.cols()));
        all.count = all.count > size / 2 ? size : 2 * all.count;
    }
}

} // namespace polydec
