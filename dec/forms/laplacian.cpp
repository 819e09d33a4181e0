// SPDX-License-Identifier: MIT
#include "dec/forms/laplacian.h"

#include "dec/forms/cochain.h"

namespace polydec {

namespace {

/// left d^T star d right for the d that leaves degree k; 0 for k = n, where left and right, each
/// star^-1 or nothing, are not asked for either.
template <class Weighted>
Operator upper_half(const CellComplex& complex, const HodgeStars& stars, int k, Weighted weighted) {
    if (k == complex.dimension())
        return Operator::zero(complex.size(k), complex.size(k));
    const Operator d = Operator::derivative(complex, k);
    return weighted(d.transposed() * Operator::star(stars[k + 1]) * d);
}

/// d star^-1 d^T for the d that arrives at degree k, with weights; 0 for k = 0.
template <class Weighted>
Operator lower_half(const CellComplex& complex, const HodgeStars& stars, int k, Weighted weighted) {
    if (k == 0)
        return Operator::zero(complex.size(k), complex.size(k));
    const Operator d = Operator::derivative(complex, k - 1);
    return weighted(d * Operator::inverse_star(stars[k - 1]) * d.transposed());
}

/// The degree of the cells that carry the forms, whose stars these are.
int checked_degree(const CellComplex& complex, const HodgeStars& stars, Side side, int degree) {
    check_fit(complex, stars);
    return cell_degree(complex, side, degree);
}

} // namespace

Operator codifferential(const CellComplex& complex, const HodgeStars& stars, int k) {
    checked_degree(complex, stars, Side::primal, k);
    if (k == 0)
        return Operator::zero(0, complex.size(0));
    return Operator::inverse_star(stars[k - 1]) *
           Operator::derivative(complex, k - 1).transposed() * Operator::star(stars[k]);
}

Operator dual_codifferential(const CellComplex& complex, const HodgeStars& stars, int j) {
    const int k = checked_degree(complex, stars, Side::dual, j);
    if (k == complex.dimension())
        return Operator::zero(0, complex.size(k));
    const double sign = k % 2 == 0 ? -1 : 1;
    return sign * (Operator::star(stars[k + 1]) * Operator::derivative(complex, k) *
                   Operator::inverse_star(stars[k]));
}

Operator laplacian(const CellComplex& complex, const HodgeStars& stars, int k) {
    checked_degree(complex, stars, Side::primal, k);
    return upper_half(complex, stars, k,
                      [&](const Operator& A) { return Operator::inverse_star(stars[k]) * A; }) +
           lower_half(complex, stars, k,
                      [&](const Operator& A) { return A * Operator::star(stars[k]); });
}

Operator dual_laplacian(const CellComplex& complex, const HodgeStars& stars, int j) {
    const int k = checked_degree(complex, stars, Side::dual, j);
    return upper_half(complex, stars, k,
                      [&](const Operator& A) { return A * Operator::inverse_star(stars[k]); }) +
           lower_half(complex, stars, k,
                      [&](const Operator& A) { return Operator::star(stars[k]) * A; });
}

Operator symmetric_laplacian(const CellComplex& complex, const HodgeStars& stars, int k) {
    checked_degree(complex, stars, Side::primal, k);
    const Operator star = Operator::star(stars[k]);
    return upper_half(complex, stars, k, [](const Operator& A) { return A; }) +
           lower_half(complex, stars, k, [&](const Operator& A) { return star * A * star; });
}

} // namespace polydec
