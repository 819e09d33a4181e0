// SPDX-License-Identifier: MIT
#include "dec/forms/apply.h"

#include "base/errors.h"
#include "base/parallel.h"
#include "dec/forms/cochain.h"
#include "dec/forms/star.h"
#include "dec/metric/cell_volumes.h"

#include <fmt/format.h>

namespace polydec {

namespace {

void check_size(const Vector& values, Index cells, int k) {
    if (values.size() != cells)
        throw InvalidInput(
            fmt::format("{} values are given for {} {}-cells", values.size(), cells, k));
}

/// The degree of the cells that carry the values, which there must be one of for each.
int checked_degree(const CellComplex& complex, const CellVolumes& volumes, Side side, int degree,
                   const Vector& values) {
    const int k = cell_degree(complex, side, degree);
    check_fit(complex, volumes);
    check_size(values, complex.size(k), k);
    return k;
}

/// What the upper half of a Laplacian divides by; for k = n there is no such half.
Vector inverse_below_top(const CellComplex& complex, const CellVolumes& volumes, int k) {
    return k == complex.dimension() ? Vector(Vector::Zero(complex.size(k)))
                                    : inverse_star(volumes, k);
}

/// d^T star d x.
Vector upper_half(const CellComplex& complex, const CellVolumes& volumes, int k, const Vector& x) {
    if (k == complex.dimension())
        return Vector::Zero(complex.size(k));
    const Vector dx = star(volumes, k + 1).cwiseProduct(apply_derivative(complex, k, x));
    return apply_transposed_derivative(complex, k, dx);
}

/// d star^-1 d^T x.
Vector lower_half(const CellComplex& complex, const CellVolumes& volumes, int k, const Vector& x) {
    if (k == 0)
        return Vector::Zero(complex.size(k));
    const Vector sum = apply_transposed_derivative(complex, k - 1, x);
    return apply_derivative(complex, k - 1, inverse_star(volumes, k - 1).cwiseProduct(sum));
}

} // namespace

Vector apply_derivative(const CellComplex& complex, int k, const Vector& x) {
    const IncidenceMatrix& D = complex.coboundary(k);
    check_size(x, static_cast<Index>(D.cols()), k);
    const Index *begin = D.outerIndexPtr(), *face = D.innerIndexPtr();
    const std::int8_t* sign = D.valuePtr();
    constexpr Index part_size = 1 << 15;
    Vector result(D.rows());
    for_each_part(static_cast<Index>(D.rows()), part_size, [&](Index first, Index last) {
        for (Index t = first; t < last; ++t) {
            double sum = 0;
            for (Index e = begin[t]; e < begin[t + 1]; ++e)
                sum += sign[e] * x[face[e]];
            result[t] = sum;
        }
    });
    return result;
}

Vector apply_transposed_derivative(const CellComplex& complex, int k, const Vector& y) {
    const IncidenceMatrix& D = complex.coboundary(k);
    check_size(y, static_cast<Index>(D.rows()), k + 1);
    const Index *begin = D.outerIndexPtr(), *face = D.innerIndexPtr();
    const std::int8_t* sign = D.valuePtr();
    Vector result = Vector::Zero(D.cols());
    for (Index t = 0; t < y.size(); ++t)
        for (Index e = begin[t]; e < begin[t + 1]; ++e)
            result[face[e]] += sign[e] * y[t];
    return result;
}

Vector apply_codifferential(const CellComplex& complex, const CellVolumes& volumes, int k,
                            const Vector& x) {
    checked_degree(complex, volumes, Side::primal, k, x);
    if (k == 0)
        return Vector(0);
    const Vector weighted = star(volumes, k).cwiseProduct(x);
    return inverse_star(volumes, k - 1)
        .cwiseProduct(apply_transposed_derivative(complex, k - 1, weighted));
}

Vector apply_dual_codifferential(const CellComplex& complex, const CellVolumes& volumes, int j,
                                 const Vector& y) {
    const int k = checked_degree(complex, volumes, Side::dual, j, y);
    if (k == complex.dimension())
        return Vector(0);
    const Vector weighted = inverse_star(volumes, k).cwiseProduct(y);
    return (k % 2 == 0 ? -1 : 1) *
           star(volumes, k + 1).cwiseProduct(apply_derivative(complex, k, weighted));
}

Vector apply_laplacian(const CellComplex& complex, const CellVolumes& volumes, int k,
                       const Vector& x) {
    checked_degree(complex, volumes, Side::primal, k, x);
    const Vector upper =
        inverse_below_top(complex, volumes, k).cwiseProduct(upper_half(complex, volumes, k, x));
    return upper + lower_half(complex, volumes, k, star(volumes, k).cwiseProduct(x));
}

Vector apply_symmetric_laplacian(const CellComplex& complex, const CellVolumes& volumes, int k,
                                 const Vector& x) {
    checked_degree(complex, volumes, Side::primal, k, x);
    const Vector upper = upper_half(complex, volumes, k, x);
    if (k == 0)
        return upper;
    const Vector mass = star(volumes, k);
    return upper + mass.cwiseProduct(lower_half(complex, volumes, k, mass.cwiseProduct(x)));
}

Vector symmetric_laplacian_diagonal(const CellComplex& complex, const CellVolumes& volumes, int k) {
    Vector diagonal = Vector::Zero(complex.size(cell_degree(complex, Side::primal, k)));
    check_fit(complex, volumes);
    if (k < complex.dimension()) {
        const Vector weights = star(volumes, k + 1);
        const IncidenceMatrix& D = complex.coboundary(k);
        for (Index t = 0; t < D.rows(); ++t)
            for (IncidenceMatrix::InnerIterator s(D, t); s; ++s)
                diagonal[s.col()] += s.value() * s.value() * weights[t];
    }
    if (k > 0) {
        const Vector mass = star(volumes, k), inverse = inverse_star(volumes, k - 1);
        const IncidenceMatrix& D = complex.coboundary(k - 1);
        for (Index s = 0; s < D.rows(); ++s)
            for (IncidenceMatrix::InnerIterator f(D, s); f; ++f)
                diagonal[s] += mass[s] * mass[s] * f.value() * f.value() * inverse[f.col()];
    }
    return diagonal;
}

Vector apply_dual_laplacian(const CellComplex& complex, const CellVolumes& volumes, int j,
                            const Vector& y) {
    const int k = checked_degree(complex, volumes, Side::dual, j, y);
    const Vector upper =
        upper_half(complex, volumes, k, inverse_below_top(complex, volumes, k).cwiseProduct(y));
    return upper + star(volumes, k).cwiseProduct(lower_half(complex, volumes, k, y));
}

} // namespace polydec
