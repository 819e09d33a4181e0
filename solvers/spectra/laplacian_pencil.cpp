// SPDX-License-Identifier: MIT
#include "solvers/spectra/laplacian_pencil.h"

#include "dec/forms/derivative.h"
#include "dec/forms/star.h"

#include <algorithm>

namespace polydec {

namespace {

/// The largest share of an entry of star_k that is uncertain; below 1, or it would not be positive.
double largest_share(const HodgeStar& star) {
    return std::min(star.uncertainty().cwiseQuotient(star.diagonal()).maxCoeff(), 0.5);
}

/// d_k^T star_(k+1) d_k.
GramPart upper_part(const CellComplex& complex, const HodgeStars& stars, int k) {
    return {derivative(complex, k), stars[k + 1].diagonal(), stars[k + 1].uncertainty()};
}

/// star_k d_(k-1) star_(k-1)^-1 d_(k-1)^T star_k.
GramPart lower_part(const CellComplex& complex, const HodgeStars& stars, int k) {
    const SparseMatrix boundary = derivative(complex, k - 1).transpose();
    const Vector weights = stars[k - 1].inverse();
    const Vector shares = stars[k - 1].uncertainty().cwiseProduct(weights.cwiseAbs());
    const Vector uncertainty =
        weights.cwiseAbs().array() * shares.array() / (1 - shares.array().min(0.5));
    return {boundary * stars[k].diagonal().asDiagonal(), weights, uncertainty};
}

} // namespace

Pencil laplacian_pencil(const CellComplex& complex, const HodgeStars& stars, int k) {
    Pencil pencil{.M = stars[k].diagonal(), .mass_uncertainty = largest_share(stars[k])};
    pencil.parts = {upper_part(complex, stars, k)};
    if (k > 0)
        pencil.parts.push_back(lower_part(complex, stars, k));
    return pencil;
}

Pencil dual_function_pencil(const CellComplex& complex, const HodgeStars& stars, int n) {
    GramPart part = lower_part(complex, stars, n);
    part.F = derivative(complex, n - 1).transpose();
    return {.parts = {std::move(part)},
            .M = stars[n].inverse(),
            .mass_uncertainty = largest_share(stars[n])};
}

Pencil coexact_pencil(const CellComplex& complex, const HodgeStars& stars, int k) {
    return {.parts = {upper_part(complex, stars, k)},
            .M = stars[k].diagonal(),
            .mass_uncertainty = largest_share(stars[k])};
}

} // namespace polydec
