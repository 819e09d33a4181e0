// SPDX-License-Identifier: MIT
#include "dec/forms/laplacian.h"

#include "dec/forms/cochain.h"
#include "dec/forms/star.h"
#include "dec/metric/cell_volumes.h"

namespace polydec {

namespace {

Operator mass(const CellVolumes& volumes, int k) {
    return Operator::weights(star(volumes, k));
}

Operator inverse_mass(const CellVolumes& volumes, int k) {
    return Operator::weights(inverse_star(volumes, k));
}

/// left d^T star d right for the d that leaves degree k; 0 for k = n, where left and right, each
/// star^-1 or nothing, are not asked for either.
template <class Weighted>
Operator upper_half(const CellComplex& complex, const CellVolumes& volumes, int k,
                    Weighted weighted) {
    if (k == complex.dimension())
        return Operator::zero(complex.size(k), complex.size(k));
    const Operator d = Operator::derivative(complex, k);
    return weighted(d.transposed() * mass(volumes, k + 1) * d);
}

/// d star^-1 d^T for the d that arrives at degree k, with weights; 0 for k = 0.
template <class Weighted>
Operator lower_half(const CellComplex& complex, const CellVolumes& volumes, int k,
                    Weighted weighted) {
    if (k == 0)
        return Operator::zero(complex.size(k), complex.size(k));
    const Operator d = Operator::derivative(complex, k - 1);
    return weighted(d * inverse_mass(volumes, k - 1) * d.transposed());
}

/// The degree of the cells that carry the forms, whose volumes these are.
int checked_degree(const CellComplex& complex, const CellVolumes& volumes, Side side, int degree) {
    check_fit(complex, volumes);
    return cell_degree(complex, side, degree);
}

} // namespace

Operator codifferential(const CellComplex& complex, const CellVolumes& volumes, int k) {
    checked_degree(complex, volumes, Side::primal, k);
    if (k == 0)
        return Operator::zero(0, complex.size(0));
    return inverse_mass(volumes, k - 1) * Operator::derivative(complex, k - 1).transposed() *
           mass(volumes, k);
}

Operator dual_codifferential(const CellComplex& complex, const CellVolumes& volumes, int j) {
    const int k = checked_degree(complex, volumes, Side::dual, j);
    if (k == complex.dimension())
        return Operator::zero(0, complex.size(k));
    const double sign = k % 2 == 0 ? -1 : 1;
    return Operator::weights(sign * star(volumes, k + 1)) * Operator::derivative(complex, k) *
           inverse_mass(volumes, k);
}

Operator laplacian(const CellComplex& complex, const CellVolumes& volumes, int k) {
    checked_degree(complex, volumes, Side::primal, k);
    return upper_half(complex, volumes, k,
                      [&](const Operator& A) { return inverse_mass(volumes, k) * A; }) +
           lower_half(complex, volumes, k, [&](const Operator& A) { return A * mass(volumes, k); });
}

Operator dual_laplacian(const CellComplex& complex, const CellVolumes& volumes, int j) {
    const int k = checked_degree(complex, volumes, Side::dual, j);
    return upper_half(complex, volumes, k,
                      [&](const Operator& A) { return A * inverse_mass(volumes, k); }) +
           lower_half(complex, volumes, k, [&](const Operator& A) { return mass(volumes, k) * A; });
}

Operator symmetric_laplacian(const CellComplex& complex, const CellVolumes& volumes, int k) {
    checked_degree(complex, volumes, Side::primal, k);
    const Operator star = mass(volumes, k);
    return upper_half(complex, volumes, k, [](const Operator& A) { return A; }) +
           lower_half(complex, volumes, k, [&](const Operator& A) { return star * A * star; });
}

} // namespace polydec
