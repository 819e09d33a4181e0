// SPDX-License-Identifier: MIT
#include "tests/dec/products.h"

namespace polydec::test::in_interior_product_convergence {

/// A smooth k-form and a smooth vector field of R^N.
Vector smooth_form(const Vector& x, int k) {
    const Vector phase = random_vector(coefficients(Index(x.size()), k), 5);
    Vector result(phase.size());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = std::sin(x.sum() + x[i % x.size()] + phase[i]);
    return result;
}

Vector smooth_field(const Vector& x) {
    Vector result(x.size());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = std::cos(x[i] + x[(i + 1) % x.size()] + double(i));
    return result;
}

/// Largest errors of i_X on a smooth k-form, as means over the merged (k-1)-cells.
struct Errors {
    double everywhere = 0;
    double inside = 0; // off the boundary
};

Errors errors_of(const Discretization& mesh, int k, Sampling sampling) {
    Points field(mesh.points().rows(), mesh.points().cols());
    for (Index v = 0; v < field.rows(); ++v)
        field.row(v) = smooth_field(mesh.points().row(v));

    const auto integrals = [&](int degree, const Form& form) {
        return to_merged(mesh, {Side::primal, degree,
                                integrate(mesh.input(), mesh.points(), degree, form)})
            .values;
    };
    const Vector a = integrals(k, [&](const Vector& x) { return smooth_form(x, k); });
    const Vector exact = integrals(
        k - 1, [&](const Vector& x) { return contraction(smooth_field(x), k, smooth_form(x, k)); });
    const SparseMatrix X = interior_product(mesh, field, k, sampling);
    const Vector difference = (X * a - exact).cwiseQuotient(mesh.volumes().primal(k - 1));

    Errors errors;
    const auto boundary = boundary_cells(mesh.complex());
    for (Index s = 0; s < difference.size(); ++s) {
        errors.everywhere = std::max(errors.everywhere, std::abs(difference[s]));
        if (!boundary[k - 1][s])
            errors.inside = std::max(errors.inside, std::abs(difference[s]));
    }
    return errors;
}

struct Family {
    std::string name;
    Discretization coarse, fine; // of half the size
    bool symmetric;              // the simplices around every inner cell
};

TEST(InteriorProductConvergence, is_of_first_order_and_centered_of_second_where_symmetric) {
    const std::vector<Family> families = {
        {"grid", discretize(grid(12, 12)), discretize(grid(24, 24)), true},
        {"hexagons", discretize(hexagons(12)), discretize(hexagons(24)), false},
        {"acute", discretize(well_centered(12)), discretize(well_centered(24)), false},
        {"kuhn", discretize(kuhn(3, 4)), discretize(kuhn(3, 8)), true}};
    for (const auto& [name, coarse, fine, symmetric] : families)
        for (int k = 1; k <= fine.dimension(); ++k)
            for (const auto sampling : {Sampling::centered, Sampling::upwind}) {
                const auto first = errors_of(coarse, k, sampling);
                const auto second = errors_of(fine, k, sampling);
                const double order = std::log2(first.everywhere / second.everywhere);
                const double inside = std::log2(first.inside / second.inside);
                EXPECT_GT(order, 0.85) << name << ", k = " << k;
                EXPECT_LT(order, 1.15) << name << ", k = " << k;
                EXPECT_EQ(inside > 1.7, symmetric && sampling == Sampling::centered)
                    << name << ", k = " << k << ", order " << inside;
            }
}

} // namespace polydec::test::in_interior_product_convergence
