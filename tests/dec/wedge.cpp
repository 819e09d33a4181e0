// SPDX-License-Identifier: MIT
#include "dec/merging/lift.h"
#include "tests/dec/discretized.h"
#include "tests/dec/products.h"

namespace polydec::test::in_wedge {

constexpr double rounding = 1e-12;

using Product = std::function<Cochain(const Cochain&, const Cochain&)>;

Product product_on(const Discretization& mesh, WedgeWeights weights) {
    return
        [&mesh, weights](const Cochain& a, const Cochain& b) { return wedge(mesh, a, b, weights); };
}

/// Calls law(mesh, product) for the simplices and the merged cells of a mesh, flipped or not, with
/// each of the weights.
template <class Law>
void for_products(const std::string& name, Law law) {
    for_flipped_and_not(name, [&](const Discretization& mesh) {
        for (const auto weights : {WedgeWeights::uniform, WedgeWeights::circumcentric}) {
            SCOPED_TRACE(weights == WedgeWeights::uniform ? "uniform" : "circumcentric");
            law(mesh, product_on(mesh, weights));
        }
    });
}

/// Calls law(k, l) for all degrees whose sum is at most n.
template <class Law>
void for_degrees(int n, Law law) {
    for (int k = 0; k <= n; ++k)
        for (int l = 0; k + l <= n; ++l) {
            SCOPED_TRACE(fmt::format("k = {}, l = {}", k, l));
            law(k, l);
        }
}

double parity(int degree) {
    return degree % 2 == 0 ? 1 : -1;
}

/// How far a ^ b is from (-1)^(kl) b ^ a.
double commutator(const CellComplex& complex, const Product& product, int k, int l) {
    const auto a = random_form(complex, Side::primal, k, 1);
    const auto b = random_form(complex, Side::primal, l, 2);
    return relative_difference(parity(k * l) * product(b, a).values, product(a, b).values);
}

/// d(a ^ b) - (da ^ b + sign a ^ db), the largest entry over that of the two terms, or over 1, the
/// size of the values, where both vanish.
double leibniz_defect(const CellComplex& complex, const Product& product, int k, int l,
                      double sign) {
    const auto a = random_form(complex, Side::primal, k, 1);
    const auto b = random_form(complex, Side::primal, l, 2);
    const Vector first = product(d(complex, a), b).values;
    const Vector second = sign * product(a, d(complex, b)).values;
    const Vector defect = d(complex, product(a, b)).values - first - second;
    const double size = std::max(first.cwiseAbs().maxCoeff(), second.cwiseAbs().maxCoeff());
    return defect.cwiseAbs().maxCoeff() / (size > rounding ? size : 1);
}

class Wedges : public OverMeshes {
protected:
    Index N() const { return static_cast<Index>(mesh().points.cols()); }

    Vector constant_on_simplices(int k, const Vector& coefficients) const {
        return integrate(mesh().K(), mesh().points, k, constant_form(coefficients));
    }
};

TEST_P(Wedges, are_anticommutative) {
    for_products(GetParam(), [](const Discretization& mesh, const Product& product) {
        for_degrees(mesh.dimension(), [&](int k, int l) {
            EXPECT_LE(commutator(mesh.complex(), product, k, l), rounding);
        });
    });
}

TEST_P(Wedges, obey_the_rule_of_leibniz) {
    for_flipped_and_not(GetParam(), [](const Discretization& mesh) {
        const auto& complex = mesh.complex();
        const auto product = product_on(mesh, WedgeWeights::uniform);
        for_degrees(mesh.dimension() - 1, [&](int k, int l) {
            EXPECT_LE(leibniz_defect(complex, product, k, l, parity(k)), rounding);
            // a cell that meets itself in every facet: nothing has a derivative there
            if (d(complex, random_form(complex, Side::primal, k + l, 1)).values.isZero())
                return;
            EXPECT_GT(leibniz_defect(complex, product, k, l, -parity(k)), 1e-2)
                << "with the wrong sign";
        });
    });
}

TEST_P(Wedges, multiply_constant_forms_exactly) {
    for_degrees(mesh().n(), [&](int k, int l) {
        const Vector a = random_vector(coefficients(N(), k), 3);
        const Vector b = random_vector(coefficients(N(), l), 4);
        const Vector first = constant_on_simplices(k, a), second = constant_on_simplices(l, b);
        const Vector exact = constant_on_simplices(k + l, exterior_product(N(), k, a, l, b));
        for_merged_and_not(GetParam(), [&](const Discretization& on) {
            // a bent cell has no constant forms
            if (!on.merging().is_identity() && !is_flat(mesh_named(GetParam())))
                return;
            const auto of = [&](int degree, const Vector& values) -> Cochain {
                return to_merged(on, {Side::primal, degree, values});
            };
            for (const auto weights : {WedgeWeights::uniform, WedgeWeights::circumcentric})
                EXPECT_CLOSE(wedge(on, of(k, first), of(l, second), weights).values,
                             of(k + l, exact).values, rounding);
        });
    });
}

TEST_P(Wedges, have_the_constant_function_1_as_unit) {
    for_products(GetParam(), [](const Discretization& mesh, const Product& product) {
        const Cochain one{Side::primal, 0, Vector::Ones(mesh.complex().size(0))};
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const auto a = random_form(mesh.complex(), Side::primal, k, 5);
            EXPECT_CLOSE(product(one, a).values, a.values, allowed_rounding(mesh)) << "k = " << k;
            EXPECT_CLOSE(product(a, one).values, a.values, allowed_rounding(mesh)) << "k = " << k;
        }
    });
}

TEST_P(Wedges, are_the_same_for_both_weights_up_to_degree_1) {
    for_merged_and_not(GetParam(), [](const Discretization& mesh) {
        for_degrees(1, [&](int k, int l) {
            const auto a = random_form(mesh.complex(), Side::primal, k, 1);
            const auto b = random_form(mesh.complex(), Side::primal, l, 2);
            EXPECT_CLOSE(wedge(mesh, a, b, WedgeWeights::circumcentric).values,
                         wedge(mesh, a, b).values, rounding);
        });
    });
}

/// The product on a p-gon of the forms with these values along its boundary:
/// sum_j (1/2 - j/p) sum_i a_i (b_(i+j) - b_(i-j)), j = 1 .. (p-1)/2.
double polygon_product(const Vector& a, const Vector& b) {
    const auto p = static_cast<Index>(a.size());
    double sum = 0;
    for (Index j = 1; j <= (p - 1) / 2; ++j)
        for (Index i = 0; i < p; ++i)
            sum += (0.5 - double(j) / p) * a[i] * (b[(i + j) % p] - b[(i + p - j) % p]);
    return sum;
}

TEST_P(Wedges, of_closed_1_forms_on_polygons_are_those_of_their_boundary_values) {
    if (mesh().n() == 1)
        return;
    const auto& P = mesh().P();
    const Cochain f{Side::primal, 0, random_vector(P.size(0), 1)};
    const Cochain g{Side::primal, 0, random_vector(P.size(0), 2)};
    const auto found = wedge(discretized(GetParam()), d(P, f), d(P, g));
    for (Index F = 0; F < P.size(2); ++F) {
        const auto walk = corners(mesh().merging(), F);
        const auto along = [&](const Cochain& function) {
            Vector differences(walk.size());
            for (std::size_t i = 0; i < walk.size(); ++i)
                differences[i] =
                    function.values[walk[(i + 1) % walk.size()]] - function.values[walk[i]];
            return differences;
        };
        EXPECT_NEAR(found.values[F], polygon_product(along(f), along(g)), rounding)
            << "polygon " << F;
    }
}

POLYDEC_OVER_MESHES(Wedges);

TEST(WedgesOfRegularSimplices, are_the_same_for_both_weights) {
    for (int n = 1; n <= 5; ++n) {
        Mesh mesh{Points::Identity(n + 1, n + 1), Simplices(1, n + 1), {}};
        std::iota(mesh.simplices.data(), mesh.simplices.data() + n + 1, 0);
        const auto one = discretize(mesh);
        for_degrees(n, [&](int k, int l) {
            const auto a = random_form(one.complex(), Side::primal, k, 1);
            const auto b = random_form(one.complex(), Side::primal, l, 2);
            EXPECT_CLOSE(wedge(one, a, b, WedgeWeights::circumcentric).values,
                         wedge(one, a, b).values, rounding);
        });
    }
}

TEST(WedgesOfDiscretizations, are_those_with_the_lift_of_their_merging) {
    const auto mesh = discretize(hexagons(3));
    const auto& P = mesh.complex();
    const auto a = random_form(P, Side::primal, 1, 1), b = random_form(P, Side::primal, 1, 2);
    const auto lift = commuting_lift(mesh.merging(), mesh.input_geometry());
    const Cochain fine_a{Side::primal, 1, lift[1] * a.values};
    const Cochain fine_b{Side::primal, 1, lift[1] * b.values};
    const SparseMatrix dia = mesh.merging().diamond(2).cast<double>();
    const auto simplices = discretize(hexagons(3), {.criterion = MergeCriterion::none});
    const Vector uniform = dia * wedge(mesh.input(), fine_a, fine_b).values;
    const Vector other = dia * wedge(simplices, fine_a, fine_b, WedgeWeights::circumcentric).values;
    EXPECT_EQ(wedge(mesh, a, b).values, uniform);
    EXPECT_EQ(wedge(mesh, a, b, WedgeWeights::circumcentric).values, other);
    EXPECT_GT(relative_difference(other, uniform), 1e-2);
}

TEST(WedgesBroken, circumcentric_weights_break_the_rule_of_leibniz_from_degree_1_on) {
    for (const char* name : {"wellcentred4", "obtuse_solid", "hex4", "split_cubes", "goldberg2"})
        for_merged_and_not(name, [&](const Discretization& mesh) {
            const auto product = product_on(mesh, WedgeWeights::circumcentric);
            EXPECT_LE(leibniz_defect(mesh.complex(), product, 0, 0, 1), rounding) << name;
            EXPECT_GT(leibniz_defect(mesh.complex(), product, 0, 1, 1), 1e-2) << name;
        });
}

/// The cup product: the first k+1 vertices of a simplex and its last l+1. n-simplices have to be
/// oriented by ascending vertices.
Cochain cup(const SimplicialComplex& K, const Cochain& a, const Cochain& b) {
    const int k = a.degree, m = a.degree + b.degree;
    Vector values(K.size(m));
    for (Index s = 0; s < K.size(m); ++s) {
        Index front = s, back = s;
        for (int v = m; v > k; --v)
            front = K.face(v, front, v);
        for (int v = m; v > b.degree; --v)
            back = K.face(v, back, 0);
        values[s] = a.values[front] * b.values[back];
    }
    return {Side::primal, m, values};
}

TEST(WedgesBroken, the_cup_product_obeys_leibniz_but_is_not_anticommutative) {
    const SimplicialComplex K(boundary_of(kuhn(3, 1)).simplices);
    const Product product = [&](const Cochain& a, const Cochain& b) { return cup(K, a, b); };
    EXPECT_LE(leibniz_defect(K, product, 0, 0, 1), rounding);
    EXPECT_GT(commutator(K, product, 0, 1), 0.1);
    EXPECT_GT(commutator(K, product, 0, 2), 0.1);
    EXPECT_GT(commutator(K, product, 1, 1), 0.1);
}

TEST(WedgesBroken, polygons_know_more_than_the_boundary_values_of_forms_that_are_not_closed) {
    const auto& mesh = merged("grid4");
    const auto a = random_form(mesh.P(), Side::primal, 1, 1);
    const auto b = random_form(mesh.P(), Side::primal, 1, 2);
    const auto found = wedge(discretized("grid4"), a, b);
    double largest_error = 0;
    for (Index F = 0; F < mesh.P().size(2); ++F) {
        const auto walk = corners(mesh.merging(), F);
        Vector first(walk.size()), second(walk.size());
        for (IncidenceMatrix::InnerIterator e(mesh.P().coboundary(1), F); e; ++e) {
            const auto ends = mesh.merging().vertices(1, static_cast<Index>(e.col()));
            for (std::size_t i = 0; i < walk.size(); ++i)
                if (std::set{walk[i], walk[(i + 1) % walk.size()]} == std::set{ends[0], ends[1]}) {
                    first[i] = e.value() * a.values[e.col()];
                    second[i] = e.value() * b.values[e.col()];
                }
        }
        largest_error =
            std::max(largest_error, std::abs(found.values[F] - polygon_product(first, second)));
    }
    EXPECT_GT(largest_error, 1e-2);
}

TEST(WedgesBroken, zeros_instead_of_the_lift_give_a_third_of_dx_dy_on_the_square) {
    const auto mesh = make_merged(grid(1, 1));

    const auto form = [&](Vector coefficients) -> Cochain {
        const Vector values =
            integrate(mesh.K(), mesh.points, 1, constant_form(std::move(coefficients)));
        return {Side::primal, 1, primal_to_merged(mesh.merging(), 1) * values};
    };
    const auto dx = form(Eigen::Vector2d(1, 0)), dy = form(Eigen::Vector2d(0, 1));
    const auto lift = commuting_lift(mesh.merging(), mesh.geometry());
    const auto product = [&](const SparseMatrix& back) {
        return wedge(mesh.K(), {Side::primal, 1, back * dx.values},
                     {Side::primal, 1, back * dy.values})
            .values.sum();
    };
    EXPECT_NEAR(product(lift[1]), 1, rounding);
    EXPECT_NEAR(product(primal_to_input(mesh.merging(), mesh.input_volumes, 1)), 1.0 / 3, rounding);
}

TEST(WedgeErrors, name_the_degrees_and_the_product_to_take) {
    const auto& mesh = merged("grid4");
    const auto& P = mesh.P();
    const auto one = random_form(P, Side::primal, 1, 1), two = random_form(P, Side::primal, 2, 1);
    const auto dual = random_form(P, Side::dual, 1, 1);
    const auto multiply = [&](const Cochain& a, const Cochain& b) {
        return refusal([&] { wedge(discretized("grid4"), a, b); });
    };
    EXPECT_SAYS(multiply(one, two), "1-form", "2-form", "degree 3", "dimension 2");
    EXPECT_SAYS(multiply(one, dual), "primal 1-form", "dual 1-form", "dual_wedge");
    EXPECT_REFUSED(wedge(mesh.K(), one, one), "primal 1-form", "40 values", "56 1-cells");
}

} // namespace polydec::test::in_wedge
