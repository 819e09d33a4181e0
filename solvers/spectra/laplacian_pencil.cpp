// SPDX-License-Identifier: MIT
#include "solvers/spectra/laplacian_pencil.h"

#include "dec/forms/cochain.h"
#include "dec/stars/star.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// The largest relative uncertainty of an entry of star_k; below 1, else the entry might not be
/// positive. Matrices count as exact.
double mass_share(const HodgeStar& star) {
    if (!star.is_diagonal())
        return 0;
    return std::min(star.uncertainty().cwiseQuotient(star.diagonal()).maxCoeff(), 0.5);
}

/// d_k^T star_(k+1) d_k.
GramPart upper_part(const CellComplex& complex, const HodgeStars& stars, int k) {
    const HodgeStar& star = stars[k + 1];
    if (star.is_diagonal())
        return {derivative(complex, k), star.diagonal(), star.uncertainty()};
    return {derivative(complex, k), star.matrix()};
}

/// F^T star_(k-1)^-1 F.
GramPart inverse_part(SparseMatrix F, const HodgeStar& star) {
    if (!star.is_diagonal())
        return {std::move(F), InverseWeights{star.matrix()}};
    const Vector weights = star.inverse();
    const Vector shares = star.uncertainty().cwiseProduct(weights.cwiseAbs());
    return {std::move(F), weights,
            weights.cwiseAbs().array() * shares.array() / (1 - shares.array().min(0.5))};
}

/// Error bounds of the entries of a product of incidences and a matrix.
SparseMatrix sum_errors(const SparseMatrix& incidences, const SparseMatrix& matrix) {
    const double unit = std::numeric_limits<double>::epsilon();
    return unit * SparseMatrix(incidences.cwiseAbs() * matrix.cwiseAbs());
}

/// Such a star's inverse is kept factored beside a matrix star_k; else all cells around one would
/// become neighbors.
bool has_positive_diagonal(const HodgeStar& star) {
    return star.is_diagonal() && star.zeros().empty() && star.negatives().empty();
}

/// star_k d_(k-1) star_(k-1)^-1 d_(k-1)^T star_k.
GramPart lower_part(const CellComplex& complex, const HodgeStars& stars, int k) {
    const SparseMatrix boundary = derivative(complex, k - 1).transpose();
    const SparseMatrix star = stars[k].matrix();
    if (stars[k].is_diagonal())
        return inverse_part(boundary * star, stars[k - 1]);
    GramPart part = has_positive_diagonal(stars[k - 1])
                        ? GramPart{boundary * star, InverseWeights{stars[k - 1].diagonal()}}
                        : inverse_part(boundary * star, stars[k - 1]);
    part.F_error = sum_errors(boundary, star);
    return part;
}

} // namespace

Weights weights(const HodgeStar& star) {
    return star.is_diagonal() ? Weights(star.diagonal()) : Weights(star.matrix());
}

Pencil laplacian_pencil(const CellComplex& complex, const HodgeStars& stars, int k) {
    Pencil pencil{.M = weights(stars[k]), .mass_uncertainty = mass_share(stars[k])};
    if (k < complex.dimension())
        pencil.parts.push_back(upper_part(complex, stars, k));
    if (k > 0)
        pencil.parts.push_back(lower_part(complex, stars, k));
    return pencil;
}

Pencil dual_function_pencil(const CellComplex& complex, const HodgeStars& stars, int n) {
    return {.parts = {inverse_part(derivative(complex, n - 1).transpose(), stars[n - 1])},
            .M = stars[n].inverse(),
            .mass_uncertainty = mass_share(stars[n])};
}

Pencil coexact_pencil(const CellComplex& complex, const HodgeStars& stars, int k) {
    return {.parts = {upper_part(complex, stars, k)},
            .M = weights(stars[k]),
            .mass_uncertainty = mass_share(stars[k])};
}

} // namespace polydec
