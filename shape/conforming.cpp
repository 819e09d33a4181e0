// SPDX-License-Identifier: MIT
#include "shape/forms.h"

#include <algorithm>

namespace polydec {

namespace {

/// Values at the points of these pairs of corners as coefficients of polynomials: Lagrange's basis
/// in that of barycentric coordinates, or of their products.
LongMatrix lagrange_basis(int degree, const std::vector<Pair>& pairs) {
    const auto size = static_cast<Eigen::Index>(pairs.size());
    if (degree == 1)
        return LongMatrix::Identity(size, size);
    LongMatrix basis = LongMatrix::Zero(size, size); // a row for each product
    for (Eigen::Index p = 0; p < size; ++p) {
        const auto [i, j] = pairs[p];
        basis(p, p) = i == j ? 1 : 4;
        if (i != j)
            for (const int corner : {i, j}) {
                const auto at = std::find(pairs.begin(), pairs.end(), Pair{corner, corner});
                basis(p, at - pairs.begin()) = -1;
            }
    }
    return basis;
}

/// Means of products of the basis over the simplex, or over the facet lacking a corner.
LongMatrix products(int n, int degree, const std::vector<Pair>& pairs, int omitted) {
    const auto size = static_cast<Eigen::Index>(pairs.size());
    LongMatrix result = LongMatrix::Zero(size, size);
    const int m = omitted < 0 ? n : n - 1;
    for (Eigen::Index p = 0; p < size; ++p)
        for (Eigen::Index q = 0; q < size; ++q) {
            const auto [i, j] = pairs[p];
            const auto [k, l] = pairs[q];
            if (i == omitted || j == omitted || k == omitted || l == omitted)
                continue;
            result(p, q) =
                degree == 1 ? mean_of_product(m, {i, k}) : mean_of_product(m, {i, j, k, l});
        }
    return result;
}

/// Products of the gradients of the basis; that of lambda_i lambda_j has two terms, lambda_a grad
/// lambda_b for (a, b) = (i, j) and (j, i).
LongMatrix stiffness(const MeasuredSimplex& simplex, int degree, const std::vector<Pair>& pairs) {
    const int n = simplex.dimension();
    if (degree == 1)
        return simplex.volume * simplex.gradients;
    const auto size = static_cast<Eigen::Index>(pairs.size());
    LongMatrix result = LongMatrix::Zero(size, size);
    const auto terms = [&](Eigen::Index p) {
        return std::array{pairs[p], Pair{pairs[p][1], pairs[p][0]}};
    };
    for (Eigen::Index p = 0; p < size; ++p)
        for (Eigen::Index q = 0; q < size; ++q)
            for (const auto& [a, b] : terms(p))
                for (const auto& [c, d] : terms(q))
                    result(p, q) += mean_of_product(n, {a, c}) * simplex.gradients(b, d);
    return simplex.volume * result;
}

std::vector<Pair> points_of(int n, int degree) {
    std::vector<Pair> pairs;
    for (int i = 0; i <= n; ++i)
        for (int j = i; j <= (degree == 1 ? i : n); ++j)
            pairs.push_back({i, j});
    return pairs;
}

FormFamily family_of(const Shape& shape, int degree, const std::vector<Pair>& pairs,
                     const std::vector<FacetSide>& sides) {
    const int n = shape.pieces.dimension();
    const LongMatrix basis = lagrange_basis(degree, pairs);
    const LongMatrix mass = basis.transpose() * products(n, degree, pairs, -1) * basis;
    const auto local = [&, n, degree](Index s) {
        const auto simplex = measured_simplex(shape, s);
        LocalForms forms;
        forms.parts = {conductivity_of(shape, s) *
                           (basis.transpose() * stiffness(simplex, degree, pairs) * basis),
                       density_of(shape, s) * simplex.volume * mass};
        for (int i = 0; i <= n; ++i)
            if (const double alpha = sides[std::size_t(n + 1) * s + i].robin; alpha > 0)
                forms.parts[0] += alpha * simplex.facet_volume(i) *
                                  (basis.transpose() * products(n, degree, pairs, i) * basis);
        return forms;
    };
    const auto factors = [](double s, double) { return std::vector<double>{1, -s}; };
    return {shape, glued_points(shape, sides, pairs), factors, local};
}

} // namespace

ConformingForm::ConformingForm(const Shape& shape, int degree)
    : pairs_(points_of(shape.pieces.dimension(), degree)),
      family_(family_of(shape, degree, pairs_, facet_sides(shape))) {}

CountedMatrix ConformingForm::sum(double of_a, double of_b) const {
    return family_.sum([=](double, double) { return std::vector<double>{of_a, of_b}; }, 0);
}

} // namespace polydec
