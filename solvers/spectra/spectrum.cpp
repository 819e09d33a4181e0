// SPDX-License-Identifier: MIT
#include "solvers/spectra/spectrum.h"

#include "base/errors.h"
#include "complex/homology.h"
#include "dec/conditioned_complex.h"
#include "dec/forms/cochain.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <utility>

namespace polydec {

namespace {

void check_count(const CellComplex& complex, const SpectrumOptions& options, int k) {
    if (complex.size(k) == 0)
        throw InvalidInput(
            fmt::format("{} {}-forms have no eigenvalues here: with these conditions "
                        "they are 0 on all {}-cells",
                        name(options.side), options.degree, k));
    if (options.count < 1 || options.count > complex.size(k))
        throw InvalidInput(fmt::format("{} eigenvalues asked for: {} {}-forms live on {} {}-cells, "
                                       "so 1 to {} can be had",
                                       options.count, name(options.side), options.degree,
                                       complex.size(k), k, complex.size(k)));
}

/// The pencil of the Laplacian with these weights, if there are, added.
Pencil pencil_of(const CellComplex& complex, const HodgeStars& stars, int k,
                 const SparseMatrix& weights) {
    Pencil pencil = laplacian_pencil(complex, stars, k);
    pencil.C = weights;
    return pencil;
}

/// Of a complex under conditions, of which Robin's adds weights.
Spectrum spectrum_with(const CellComplex& complex, const HodgeStars& stars,
                       const SparseMatrix& weights,
                       const SpectrumOptions& options) {
    const int k = cell_degree(complex, options.side, options.degree);
    check_count(complex, options, k);
    check_fit(complex, stars);
    check_positive_mass(stars[k], options.side, options.degree);

    const bool is_dual_function = k == complex.dimension() && stars[k].is_diagonal();
    CertifiedEigensolver solver(is_dual_function ? dual_function_pencil(complex, stars, k)
                                                 : pencil_of(complex, stars, k, weights),
                                {.linear_solver = options.linear_solver,
                                 .eigen_solver = options.eigen_solver,
                                 .certification = options.certification,
                                 .domain_dimension = complex.dimension(),
                                 .definiteness = laplacian_definiteness(stars, k),
                                 .zeros = weights.size() > 0 ? 0 : betti_numbers(complex)[k],
                                 .progress = options.progress,
                                 .found = options.found,
                                 .start = options.start});
    auto pairs = solver.smallest(options.count);
    if (options.side == Side::dual && !is_dual_function)
        pairs.vectors = SparseMatrix(stars[k].matrix()) * pairs.vectors;
    if (options.side == Side::primal && is_dual_function)
        pairs.vectors = stars[k].inverse().asDiagonal() * pairs.vectors;
    return {options.side,
            options.degree,
            std::move(pairs.values),
            std::move(pairs.radii),
            std::move(pairs.vectors),
            std::move(pairs.residuals),
            pairs.certificate,
            std::move(pairs.linear_solver),
            std::move(pairs.eigen_solver),
            std::move(pairs.rough)};
}

/// With modes that have values on all cells of the whole.
Spectrum spectrum_in(const CellComplex& whole, const RobinComplex& given,
                     const SpectrumOptions& options) {
    const ConditionedComplex& space = given.space;
    auto result = spectrum_with(space.relative.complex, space.stars, given.weights, options);
    result.modes =
        space.relative.extend(cell_degree(whole, options.side, options.degree), result.modes);
    return result;
}

} // namespace

Spectrum spectrum(const CellComplex& complex, const HodgeStars& stars,
                  const SpectrumOptions& options) {
    return spectrum_with(complex, stars, {}, options);
}

Spectrum spectrum(const Discretization& discretization, const SpectrumOptions& options) {
    return spectrum(discretization, built_in_conditions(options.side), options);
}

Spectrum spectrum(const Discretization& discretization, const BoundaryConditions& conditions,
                  const SpectrumOptions& options) {
    return spectrum_in(discretization.complex(),
                       with_robin(discretization, options.side, options.degree, conditions),
                       options);
}

Spectrum spectrum(const CellComplex& complex, const HodgeStars& stars,
                  const BoundaryConditions& conditions, const SpectrumOptions& options) {
    return spectrum_in(
        complex, with_robin(complex, stars, options.side, options.degree, conditions), options);
}

} // namespace polydec
