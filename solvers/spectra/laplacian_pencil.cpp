// SPDX-License-Identifier: MIT
#include "solvers/spectra/laplacian_pencil.h"

#include "dec/forms/derivative.h"
#include "dec/forms/star.h"

#include <algorithm>

namespace polydec {

namespace {

/// What rounding has done at most to a star entry.
Vector star_uncertainty(const CellVolumes& volumes, int k) {
    return volumes.rounding(k).cwiseQuotient(volumes.primal(k));
}

/// The largest share of an entry of star_k that is uncertain; below 1, or it would not be positive.
double largest_share(const CellVolumes& volumes, int k) {
    const Vector shares = star_uncertainty(volumes, k).cwiseQuotient(star(volumes, k));
    return std::min(shares.maxCoeff(), 0.5);
}

/// d_k^T star_(k+1) d_k.
GramPart upper_part(const CellComplex& complex, const CellVolumes& volumes, int k) {
    return {derivative(complex, k), star(volumes, k + 1), star_uncertainty(volumes, k + 1)};
}

/// star_k d_(k-1) star_(k-1)^-1 d_(k-1)^T star_k.
GramPart lower_part(const CellComplex& complex, const CellVolumes& volumes, int k) {
    const SparseMatrix boundary = derivative(complex, k - 1).transpose();
    const Vector weights = inverse_star(volumes, k - 1);
    const Vector shares = star_uncertainty(volumes, k - 1).cwiseProduct(weights.cwiseAbs());
    const Vector uncertainty =
        weights.cwiseAbs().array() * shares.array() / (1 - shares.array().min(0.5));
    return {boundary * star(volumes, k).asDiagonal(), weights, uncertainty};
}

} // namespace

Pencil laplacian_pencil(const CellComplex& complex, const CellVolumes& volumes, int k) {
    Pencil pencil{.M = star(volumes, k), .mass_uncertainty = largest_share(volumes, k)};
    pencil.parts = {upper_part(complex, volumes, k)};
    if (k > 0)
        pencil.parts.push_back(lower_part(complex, volumes, k));
    return pencil;
}

Pencil dual_function_pencil(const CellComplex& complex, const CellVolumes& volumes, int n) {
    GramPart part = lower_part(complex, volumes, n);
    part.F = derivative(complex, n - 1).transpose();
    return {.parts = {std::move(part)},
            .M = inverse_star(volumes, n),
            .mass_uncertainty = largest_share(volumes, n)};
}

Pencil coexact_pencil(const CellComplex& complex, const CellVolumes& volumes, int k) {
    return {.parts = {upper_part(complex, volumes, k)},
            .M = star(volumes, k),
            .mass_uncertainty = largest_share(volumes, k)};
}

} // namespace polydec
