// SPDX-License-Identifier: MIT
#include "dec/forms/laplacian.h"

#include "dec/forms/cochain.h"

namespace polydec {

namespace {

/// left d^T star d right for the d that leaves degree k; 0 for k = n, in which case left and right
/// (each star^-1 or nothing) are not evaluated.
template <class Weighted>
Operator upper_half(const Cells& cells, int k, Weighted weighted) {
    const CellComplex& complex = cells.complex();
    if (k == complex.dimension())
        return Operator::zero(complex.size(k), complex.size(k));
    const Operator d = Operator::derivative(complex, k);
    return weighted(d.transposed() * Operator::star(cells.input_stars()[k + 1]) * d);
}

/// d star^-1 d^T for the d that maps to degree k, with weights; 0 for k = 0.
template <class Weighted>
Operator lower_half(const Cells& cells, int k, Weighted weighted) {
    const CellComplex& complex = cells.complex();
    if (k == 0)
        return Operator::zero(complex.size(k), complex.size(k));
    const Operator d = Operator::derivative(complex, k - 1);
    return weighted(d * Operator::inverse_star(cells.input_stars()[k - 1]) * d.transposed());
}

} // namespace

Operator codifferential(const Cells& cells, int k) {
    const CellComplex& complex = cells.complex();
    cell_degree(complex, Side::primal, k); // throws for an invalid degree
    if (k == 0)
        return Operator::zero(0, complex.size(0));
    const HodgeStars& stars = cells.input_stars();
    return Operator::inverse_star(stars[k - 1]) *
           Operator::derivative(complex, k - 1).transposed() * Operator::star(stars[k]);
}

Operator dual_codifferential(const Cells& cells, int j) {
    const CellComplex& complex = cells.complex();
    const int k = cell_degree(complex, Side::dual, j);
    if (k == complex.dimension())
        return Operator::zero(0, complex.size(k));
    const HodgeStars& stars = cells.input_stars();
    const double sign = k % 2 == 0 ? -1 : 1;
    return sign * (Operator::star(stars[k + 1]) * Operator::derivative(complex, k) *
                   Operator::inverse_star(stars[k]));
}

Operator laplacian(const Cells& cells, int k) {
    cell_degree(cells.complex(), Side::primal, k); // throws for an invalid degree
    const HodgeStar star = cells.input_stars()[k];
    return upper_half(cells, k,
                      [&](const Operator& A) { return Operator::inverse_star(star) * A; }) +
           lower_half(cells, k, [&](const Operator& A) { return A * Operator::star(star); });
}

Operator dual_laplacian(const Cells& cells, int j) {
    const HodgeStar star = cells.input_stars()[cell_degree(cells.complex(), Side::dual, j)];
    const int k = star.degree();
    return upper_half(cells, k,
                      [&](const Operator& A) { return A * Operator::inverse_star(star); }) +
           lower_half(cells, k, [&](const Operator& A) { return Operator::star(star) * A; });
}

Operator symmetric_laplacian(const Cells& cells, int k) {
    cell_degree(cells.complex(), Side::primal, k); // throws for an invalid degree
    const Operator star = Operator::star(cells.input_stars()[k]);
    return upper_half(cells, k, [](const Operator& A) { return A; }) +
           lower_half(cells, k, [&](const Operator& A) { return star * A * star; });
}

} // namespace polydec
