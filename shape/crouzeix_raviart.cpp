// SPDX-License-Identifier: MIT
#include "shape/forms.h"

namespace polydec {

namespace {

/// Means of products of psi_i = 1 - n lambda_i, the functions of mean 1 over one facet and 0 over
/// the others.
LongMatrix mass_of_means(int n) {
    LongMatrix M(n + 1, n + 1);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            M(i, j) = 1 - 2.0L * n / (n + 1) + n * n * mean_of_product(n, {i, j});
    return M;
}

/// Means of psi_i w1 for the function w1 whose gradient represents integrals over the simplex,
/// among functions of facet means 0; their sum c is the mean of w1.
LongMatrix means_of_bubble(const MeasuredSimplex& simplex, const LongMatrix& mass) {
    const int n = simplex.dimension();
    LongMatrix g = LongMatrix::Zero(n + 1, 1);
    for (int i = 0; i <= n; ++i)
        for (int l = 1; l <= n; ++l)
            for (int k = 0; k < l; ++k) {
                long double interpolated = 0; // facet means of lambda_k lambda_l
                for (int q = 0; q <= n; ++q)
                    if (q != k && q != l)
                        interpolated += mass(i, q) / (n * (n + 1));
                const long double product =
                    mean_of_product(n, {k, l}) - n * mean_of_product(n, {i, k, l});
                g(i) += simplex.squares(k, l) * (product - interpolated) / (2 * n);
            }
    return g;
}

LocalForms local_forms(const Shape& shape, const std::vector<FacetSide>& sides,
                       const LongMatrix& mass, Index s) {
    const auto simplex = measured_simplex(shape, s);
    const int n = simplex.dimension();
    const long double kappa = conductivity_of(shape, s), rho = density_of(shape, s);
    const LongMatrix g = means_of_bubble(simplex, mass);
    const long double c = g.sum();
    const long double square = simplex.longest_square * (1 + 1e-15L) * poincare_square(n) + c;
    const LongMatrix m = LongMatrix::Constant(n + 1, 1, 1.0L / (n + 1));
    const LongMatrix mean_free = mass - m * m.transpose();
    LocalForms forms;
    forms.parts = {
        kappa * n * n * simplex.volume * simplex.gradients, rho * simplex.volume * mass,
        rho * rho / kappa * simplex.volume *
            (m * g.transpose() + g * m.transpose() - c * (m * m.transpose()) + square * mean_free)};
    for (int i = 0; i <= n; ++i)
        if (const double alpha = sides[std::size_t(n + 1) * s + i].robin; alpha > 0)
            forms.parts[0](i, i) += alpha * simplex.facet_volume(i);
    forms.reach = static_cast<double>(square * rho / kappa) * (1 + 1e-15);
    return forms;
}

} // namespace

FormFamily crouzeix_raviart_form(const Shape& shape) {
    const auto sides = facet_sides(shape);
    const LongMatrix mass = mass_of_means(shape.pieces.dimension());
    const auto factors = [](double s, double reach) {
        return std::vector<double>{1, -s, -s * s / (1 - reach)};
    };
    return {shape, facet_unknowns(shape, sides, 1), factors,
            [&](Index s) { return local_forms(shape, sides, mass, s); }};
}

} // namespace polydec
