// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"

namespace polydec::test::in_dual_wedge {

constexpr double rounding = 1e-11;

/// By how much star^-1 of degree p magnifies rounding, at worst.
double condition(const CellVolumes& volumes, int p) {
    const Vector values = star(volumes, p).diagonal().cwiseAbs();
    return values.maxCoeff() / values.minCoeff();
}

/// Calls law(mesh, k, l) for simplices and for merged cells, in all degrees that have a product: in
/// these, no star to be inverted is zero.
template <class Law>
void for_products(const std::string& name, Law law) {
    for_merged_and_not(name, [&](const Discretization& on) {
        const int n = on.dimension();
        for (int k = 0; k <= n; ++k)
            for (int l = 0; k + l <= n; ++l)
                if (star(on.volumes(), n - k).zeros().empty() &&
                    star(on.volumes(), n - l).zeros().empty()) {
                    SCOPED_TRACE(fmt::format("k = {}, l = {}", k, l));
                    law(on, k, l);
                }
    });
}

class DualWedges : public OverMeshes {
protected:
    Index N() const { return static_cast<Index>(mesh().points.cols()); }

    /// Rounding as star^-1 magnifies it: the mesh of almost squares has duals of 1e-6.
    double tolerance_of(const Discretization& on, int k, int l) const {
        return 1e-14 * std::max({100.0, condition(on.volumes(), mesh().n() - k),
                                 condition(on.volumes(), mesh().n() - l)});
    }

    /// Integrals of a constant j-form over the duals.
    static Cochain constant(const Discretization& on, int j, const Vector& coefficients) {
        return dual_de_rham(on, j, constant_form(coefficients), 1);
    }
};

TEST_P(DualWedges, are_anticommutative) {
    for_products(GetParam(), [&](const Discretization& on, int k, int l) {
        const auto a = random_form(on.complex(), Side::dual, k, 1);
        const auto b = random_form(on.complex(), Side::dual, l, 2);
        const double sign = k * l % 2 == 0 ? 1 : -1;
        const Vector product = dual_wedge(on, a, b).values,
                     other = sign * dual_wedge(on, b, a).values;
        EXPECT_CLOSE(other, product, rounding);
        EXPECT_GT(relative_difference(Vector(-other), product), 1) << "with the wrong sign";
    });
}

TEST_P(DualWedges, multiply_constant_forms_exactly_on_flat_meshes) {
    if (!is_flat(mesh_named(GetParam())))
        return;
    for_products(GetParam(), [&](const Discretization& on, int k, int l) {
        const Vector a = random_vector(coefficients(N(), k), 3);
        const Vector b = random_vector(coefficients(N(), l), 4);
        const auto exact = constant(on, k + l, exterior_product(N(), k, a, l, b)).values;
        const auto found = dual_wedge(on, constant(on, k, a), constant(on, l, b)).values;
        EXPECT_CLOSE(found, exact, tolerance_of(on, k, l));
        EXPECT_GT(relative_difference(Vector(-found), exact), 1) << "with the wrong sign";
    });
}

TEST_P(DualWedges, of_functions_on_cells_are_their_products) {
    for_products(GetParam(), [&](const Discretization& on, int k, int l) {
        if (k + l > 0)
            return;
        const auto f = random_form(on.complex(), Side::dual, 0, 1);
        const auto g = random_form(on.complex(), Side::dual, 0, 2);
        EXPECT_CLOSE(dual_wedge(on, f, g).values, f.values.cwiseProduct(g.values), rounding);
    });
}

POLYDEC_OVER_MESHES(DualWedges);

/// Where dual forms are stars of primal forms, products are too.
TEST(DualWedgesByStars, multiply_constant_forms_exactly) {
    for (const Mesh& mesh : {shaken(grid(4, 4), 0.06, 1), shaken(kuhn(3, 2), 0.1, 2)})
        for (const StarKind kind :
             {StarKind::automatic, StarKind::galerkin, StarKind::barycentric}) {
            const Discretization on = discretize(mesh, {.star = kind});
            const int n = on.dimension();
            for (int k = 0; k <= n; ++k)
                for (int l = 0; k + l <= n; ++l) {
                    SCOPED_TRACE(fmt::format("{} stars, k = {}, l = {}", name(kind), k, l));
                    const auto constant = [&](int j, const Vector& coefficients) {
                        return dual_de_rham(on, j, [&](const Vector&) { return coefficients; });
                    };
                    const Vector a = random_vector(coefficients(n, k), 3),
                                 b = random_vector(coefficients(n, l), 4);
                    EXPECT_CLOSE(dual_wedge(on, constant(k, a), constant(l, b)).values,
                                 constant(k + l, exterior_product(n, k, a, l, b)).values, 1e-10);
                }
        }
}

TEST(DualWedgesBetweenCentroids, are_exact_for_constants_of_the_first_and_last_degree_alone) {
    for (const Mesh& mesh : {well_centered(3), shaken(kuhn(3, 2), 0.1, 2)}) {
        const auto on =
            discretize(mesh, {.centers = Centers::centroids(), .star = StarKind::circumcentric});
        const int n = on.dimension();
        const Cochain one{Side::dual, 0, Vector::Ones(on.complex().size(n))};
        for (int j = 0; j <= n; ++j) {
            const Vector a = random_vector(coefficients(n, j), 3);
            const auto form = dual_de_rham(on, j, constant_form(a), 1);
            const Vector product = dual_wedge(on, one, form).values;
            const double error = relative_difference(product, form.values);
            EXPECT_EQ(error < 1e-12, j == 0 || j == n) << error << ", j = " << j;
        }
    }
}

/// L2 error of the product of two smooth 1-forms on the merged cells of the unit square, as a
/// mean over the dual cells. Duals cut off by the boundary, which have their values off the middle
/// of their primal cells, are kept away from.
double smooth_error(const Mesh& input) {
    const auto mesh = circumcentric(input, {MergeCriterion::dual_length, tolerance});
    const auto first = [](const Vector& x) -> Vector {
        return Eigen::Vector2d(std::sin(x[0] + 2 * x[1]), std::cos(x[0]));
    };
    const auto second = [](const Vector& x) -> Vector {
        return Eigen::Vector2d(std::exp(x[1]), std::sin(2 * x[0] - x[1]));
    };
    const auto product = [&](const Vector& x) {
        return exterior_product(2, 1, first(x), 1, second(x));
    };
    const auto exact = dual_de_rham(mesh, 2, product, 3);
    const auto found =
        dual_wedge(mesh, dual_de_rham(mesh, 1, first, 3), dual_de_rham(mesh, 1, second, 3));
    double sum = 0, area = 0;
    for (Index v = 0; v < mesh.complex().size(0); ++v)
        if ((mesh.points().row(v).array() - 0.5).abs().maxCoeff() < 0.3) {
            const double dual = mesh.volumes().dual(0)[v];
            const double error = (found.values[v] - exact.values[v]) / dual;
            sum += dual * error * error;
            area += dual;
        }
    return std::sqrt(sum / area);
}

TEST(DualWedgeConvergence, is_of_second_order_on_lattices_and_of_first_on_others) {
    const auto order = [](const Mesh& coarse, const Mesh& fine) {
        return std::log2(smooth_error(coarse) / smooth_error(fine));
    };
    EXPECT_NEAR(order(grid(16, 16), grid(32, 32)), 2, 0.15);
    EXPECT_NEAR(order(well_centered(16), well_centered(32)), 2, 0.15);
    const auto irregular = [](int rows) { return perturbed(well_centered(rows), 0.05 / rows, 1); };
    EXPECT_NEAR(order(irregular(16), irregular(32)), 1, 0.15);
}

TEST(DualWedgesBroken, obey_the_rule_of_leibniz_for_constants_alone) {
    const auto& mesh = discretized("wellcentred4", MergeCriterion::none);
    const auto& K = mesh.complex();
    const auto f = random_form(K, Side::dual, 0, 1), g = random_form(K, Side::dual, 0, 2);
    const auto left = d(K, dual_wedge(mesh, f, g));
    const auto right = dual_wedge(mesh, d(K, f), g) + dual_wedge(mesh, f, d(K, g));
    EXPECT_GT(relative_difference(left.values, right.values), 0.1);
}

TEST(DualWedgeErrors, name_the_forms_and_the_zeros_of_the_star) {
    const auto& mesh = discretized("grid4", MergeCriterion::none);
    const auto& K = mesh.complex();
    const auto multiply = [&](const Cochain& a, const Cochain& b) {
        return refusal([&] { dual_wedge(mesh, a, b); });
    };
    const auto one = random_form(K, Side::dual, 1, 1), two = random_form(K, Side::dual, 2, 1);
    EXPECT_SAYS(multiply(one, two), "1-form", "2-form", "degree 3", "dimension 2");
    EXPECT_SAYS(multiply(one, random_form(K, Side::primal, 1, 1)), "dual 1-form", "primal 1-form",
                "dual_wedge");
    EXPECT_SAYS(multiply(one, one), "inverse star", "degree 1", "zero", "16 1-cells",
                "2, 5, 8, 11, 15");
}

} // namespace polydec::test::in_dual_wedge
