// SPDX-License-Identifier: MIT
#include "dec/forms/laplacian.h"

#include "dec/forms/cochain.h"
#include "dec/forms/derivative.h"
#include "dec/forms/gram.h"
#include "dec/forms/star.h"
#include "dec/metric/cell_volumes.h"

namespace polydec {

namespace {

/// d^T star d for the d that leaves degree k; the zero matrix for k = n.
SparseMatrix upper_half(const CellComplex& complex, const CellVolumes& volumes, int k) {
    if (k == complex.dimension())
        return SparseMatrix(complex.size(k), complex.size(k));
    return gram(complex.boundary(k + 1), complex.coboundary(k), star(volumes, k + 1));
}

/// d star^-1 d^T for the d that arrives at degree k; the zero matrix for k = 0.
SparseMatrix lower_half(const CellComplex& complex, const CellVolumes& volumes, int k) {
    if (k == 0)
        return SparseMatrix(complex.size(k), complex.size(k));
    return gram(complex.coboundary(k - 1), complex.boundary(k), inverse_star(volumes, k - 1));
}

/// star_k^-1, not asked for where nothing is multiplied with it.
Vector inverse_for_upper_half(const CellComplex& complex, const CellVolumes& volumes, int k) {
    return k == complex.dimension() ? Vector(Vector::Ones(complex.size(k)))
                                    : inverse_star(volumes, k);
}

/// Throws InvalidInput unless there are k-cells, whose volumes these are.
void check_arguments(const CellComplex& complex, const CellVolumes& volumes, int k) {
    cell_degree(complex, Side::primal, k);
    check_fit(complex, volumes);
}

/// The same for the duals of the (n-j)-cells, whose degree is returned.
int checked_degree(const CellComplex& complex, const CellVolumes& volumes, int j) {
    check_fit(complex, volumes);
    return cell_degree(complex, Side::dual, j);
}

} // namespace

SparseMatrix codifferential(const CellComplex& complex, const CellVolumes& volumes, int k) {
    check_arguments(complex, volumes, k);
    if (k == 0)
        return SparseMatrix(0, complex.size(0));
    const SparseMatrix d = derivative(complex, k - 1);
    return inverse_star(volumes, k - 1).asDiagonal() * SparseMatrix(d.transpose()) *
           star(volumes, k).asDiagonal();
}

SparseMatrix dual_codifferential(const CellComplex& complex, const CellVolumes& volumes, int j) {
    const int k = checked_degree(complex, volumes, j);
    if (k == complex.dimension())
        return SparseMatrix(0, complex.size(k));
    const double sign = k % 2 == 0 ? -1 : 1;
    return sign * star(volumes, k + 1).asDiagonal() * derivative(complex, k) *
           inverse_star(volumes, k).asDiagonal();
}

SparseMatrix laplacian(const CellComplex& complex, const CellVolumes& volumes, int k) {
    check_arguments(complex, volumes, k);
    const SparseMatrix upper =
        inverse_for_upper_half(complex, volumes, k).asDiagonal() * upper_half(complex, volumes, k);
    const SparseMatrix lower = lower_half(complex, volumes, k) * star(volumes, k).asDiagonal();
    return upper + lower;
}

SparseMatrix dual_laplacian(const CellComplex& complex, const CellVolumes& volumes, int j) {
    const int k = checked_degree(complex, volumes, j);
    const SparseMatrix upper =
        upper_half(complex, volumes, k) * inverse_for_upper_half(complex, volumes, k).asDiagonal();
    const SparseMatrix lower = star(volumes, k).asDiagonal() * lower_half(complex, volumes, k);
    return upper + lower;
}

SparseMatrix symmetric_laplacian(const CellComplex& complex, const CellVolumes& volumes, int k) {
    check_arguments(complex, volumes, k);
    if (k == 0)
        return upper_half(complex, volumes, k);
    const Vector mass = star(volumes, k);
    const SparseMatrix weighted = mass.asDiagonal() * lower_half(complex, volumes, k);
    const SparseMatrix lower = weighted * mass.asDiagonal();
    return upper_half(complex, volumes, k) + lower;
}

} // namespace polydec
