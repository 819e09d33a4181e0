// SPDX-License-Identifier: MIT
//
// The laws of products, vector fields and decompositions on surfaces as they are found. How far a
// law is from holding is told cell by cell, over the sum of all that is added up there in size
// (worst_share): so the bound is one of rounding, wherever cells are thin and lifts are large.
#include "tests/real/surfaces.h"

namespace polydec::test::in_calculus {

constexpr double rounding = 1e-12;
constexpr double orthogonal = 1e-10; // what is solved for has the residuals of an engine

double parity(int degree) {
    return degree % 2 == 0 ? 1 : -1;
}

class RealProducts : public OnRealSurfaces {
protected:
    /// d(a ^ b) - da ^ b - sign a ^ db over what is summed.
    double leibniz_defect(int k, int l, double sign, WedgeWeights weights) const {
        const auto a = random(Side::primal, k, 1), b = random(Side::primal, l, 2);
        const auto da = d(P(), a), db = d(P(), b);
        const Vector defect = d(P(), wedge(mesh(), a, b, weights)).values -
                              wedge(mesh(), da, b, weights).values -
                              sign * wedge(mesh(), a, db, weights).values;
        const Sizes sizes(mesh());
        return worst_share(defect,
                           sizes.d(k + l, sizes.wedge(k, a.values, l, b.values, weights)) +
                               sizes.wedge(k + 1, sizes.d(k, a.values), l, b.values, weights) +
                               sizes.wedge(k, a.values, l + 1, sizes.d(l, b.values), weights));
    }
};

TEST_P(RealProducts, are_anticommutative_with_both_weights) {
    const Sizes sizes(mesh());
    for (const auto weights : {WedgeWeights::uniform, WedgeWeights::circumcentric})
        for (int k = 0; k <= 2; ++k)
            for (int l = 0; k + l <= 2; ++l) {
                const auto a = random(Side::primal, k, 1), b = random(Side::primal, l, 2);
                const Vector here = wedge(mesh(), a, b, weights).values,
                             there = wedge(mesh(), b, a, weights).values,
                             size = sizes.wedge(k, a.values, l, b.values, weights);
                const double sign = parity(k * l);
                EXPECT_LE(worst_share(here - sign * there, size), rounding) << k << ", " << l;
                EXPECT_GT(worst_share(here + sign * there, size), 1e-2) << "with the wrong sign";
            }
}

TEST_P(RealProducts, obey_the_rule_of_Leibniz) {
    for (const auto& [k, l] : {std::pair{0, 0}, {0, 1}, {1, 0}}) {
        EXPECT_LE(leibniz_defect(k, l, parity(k), WedgeWeights::uniform), rounding)
            << k << ", " << l;
        EXPECT_GT(leibniz_defect(k, l, -parity(k), WedgeWeights::uniform), 1e-2)
            << "with the wrong sign";
    }
    EXPECT_GT(leibniz_defect(0, 1, 1, WedgeWeights::circumcentric), 1e-4) << "with other weights";
}

POLYDEC_ON_REAL_SURFACES(RealProducts);

/// i_X and L_X of a field, on the cells and on the simplices of the input by which they are made.
class RealTransport : public OnRealSurfaces {
protected:
    Points field() const { return mesh().points().array().sin() + 0.5; }
    Points input_field() const { return mesh().input_points().array().sin() + 0.5; }

    SparseMatrix i(int k, Sampling sampling) const {
        return interior_product(mesh(), field(), k, sampling);
    }
    /// Without what comes in through the boundary, which does not commute with d.
    SparseMatrix L(int k, Sampling sampling) const {
        const SparseMatrix all = lie_derivative(mesh(), field(), k, sampling);
        return sampling == Sampling::upwind ? SparseMatrix(all - inflow(mesh(), field(), k)) : all;
    }

    SparseMatrix i_on_simplices(int k, Sampling sampling) const {
        Mesh simplices;
        simplices.points = mesh().input_points();
        simplices.simplices = mesh().input().simplices(mesh().dimension());
        return interior_product(discretize(simplices, {.criterion = MergeCriterion::none}),
                                input_field(), k, sampling)
            .cwiseAbs();
    }
    SparseMatrix d_on_simplices(int k) const {
        return SparseMatrix(derivative(mesh().input(), k)).cwiseAbs();
    }

    /// What is summed in i_X a, and in both terms of L_X a.
    Vector i_sizes(int k, const Vector& a, Sampling sampling) const {
        const Sizes sizes(mesh());
        if (k == 0 || k > mesh().dimension())
            return Vector::Zero(P().size(k - 1));
        return sizes.to_cells(k - 1, i_on_simplices(k, sampling) * sizes.to_simplices(k, a));
    }
    Vector L_sizes(int k, const Vector& a, Sampling sampling) const {
        const Sizes sizes(mesh());
        const Vector there = sizes.to_simplices(k, a);
        const Vector upper = i_on_simplices(k + 1, sampling) * (d_on_simplices(k) * there);
        const Vector lower = d_on_simplices(k - 1) * (i_on_simplices(k, sampling) * there);
        return sizes.to_cells(k, upper + lower);
    }
};

TEST_P(RealTransport, has_Cartans_formula) {
    const Sizes sizes(mesh());
    const auto sampling = Sampling::centered;
    for (int k = 0; k <= 2; ++k) {
        const Vector a = random(Side::primal, k, 3).values;
        const Vector found = L(k, sampling) * a;
        const Vector upper = i(k + 1, sampling) * (derivative(P(), k) * a);
        const Vector lower = derivative(P(), k - 1) * (i(k, sampling) * a);
        const Vector size = L_sizes(k, a, sampling) + i_sizes(k + 1, sizes.d(k, a), sampling) +
                            sizes.d(k - 1, i_sizes(k, a, sampling));
        EXPECT_LE(worst_share(found - upper - lower, size), rounding) << k;
        EXPECT_GT(worst_share(found - upper, size) + worst_share(found - lower, size), 1e-2)
            << "with one term alone";
    }
}

TEST_P(RealTransport, commutes_with_d) {
    const Sizes sizes(mesh());
    for (const auto sampling : {Sampling::centered, Sampling::upwind})
        for (int k = 0; k < 2; ++k) {
            const auto a = random(Side::primal, k, 4);
            const auto da = d(P(), a);
            const Vector first = derivative(P(), k) * (L(k, sampling) * a.values),
                         second = L(k + 1, sampling) * da.values,
                         size = sizes.d(k, L_sizes(k, a.values, sampling)) +
                                L_sizes(k + 1, sizes.d(k, a.values), sampling);
            EXPECT_LE(worst_share(first - second, size), rounding) << k;
            const auto other = sampling == Sampling::upwind ? Sampling::centered : Sampling::upwind;
            EXPECT_GT(worst_share(first - L(k + 1, other) * da.values, size), 1e-3)
                << "sampled in another way";
        }
}

POLYDEC_ON_REAL_SURFACES(RealTransport);

class RealDecompositions : public OnRealSurfaces {
protected:
    double product(const Cochain& a, const Cochain& b) const {
        return inner_product({P(), mesh().volumes()}, a, b);
    }

    static Cochain rest(Cochain form, const std::vector<Cochain>& parts) {
        for (const auto& part : parts)
            form = form - part;
        return form;
    }

    /// The largest product of two parts over the square of the form.
    template <class Product>
    static double worst_product(const std::vector<Cochain>& parts, double square, Product product) {
        double worst = 0;
        for (std::size_t i = 0; i < parts.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                worst = std::max(worst, std::abs(product(parts[i], parts[j])) / square);
        return worst;
    }

    /// d of a form that is d of a potential, over what is summed.
    double closedness(const Cochain& form, const Cochain& potential) const {
        const auto next = d(P(), form);
        const auto derivative_of = [&](int degree) -> SparseMatrix {
            return SparseMatrix(form.side == Side::primal ? derivative(P(), degree)
                                                          : dual_derivative(P(), degree))
                .cwiseAbs();
        };
        if (form.degree == 0 || form.degree == mesh().dimension())
            return 0; // of degree 0 the part is 0, of degree n it has no derivative
        const Vector size = derivative_of(form.degree - 1) * potential.values.cwiseAbs();
        return worst_share(next.values, derivative_of(form.degree) * size);
    }
};

TEST_P(RealDecompositions, are_orthogonal_sums_of_closed_and_coclosed_parts_or_refused_by_name) {
    const auto& V = mesh().volumes();
    for (const Side side : {Side::primal, Side::dual})
        for (int degree = 0; degree <= 2; ++degree) {
            SCOPED_TRACE(fmt::format("{} {}", name(side), degree));
            const int k = cell_degree(P(), side, degree);
            const auto w = random(side, degree, 5);
            auto bad = star(V, k).negatives();
            if (bad.empty())
                bad = star(V, k).zeros();
            if (!bad.empty()) {
                EXPECT_NE(refusal([&] {
                              hodge_decomposition({mesh(), w.side, w.degree}, w);
                          }).find("(cells " + star(V, k).numbers(bad)),
                          std::string::npos);
                continue;
            }
            const auto& cofaces = P().coface_counts(1);
            if (k == 2 && side == Side::dual &&
                *std::max_element(cofaces.begin(), cofaces.end()) > 2) {
                EXPECT_NE(refusal([&] { FormSpace(mesh(), side, 0); }).find("cells meet at facet"),
                          std::string::npos);
                continue;
            }
            const auto parts = hodge_decomposition({mesh(), w.side, w.degree}, w);
            const std::vector<Cochain> all{parts.exact, parts.coexact, parts.harmonic};
            const double square = product(w, w);
            const auto weighted = [&](const Cochain& a, const Cochain& b) { return product(a, b); };
            EXPECT_LE(worst_product(all, square, weighted), orthogonal);
            EXPECT_LE(std::sqrt(product(rest(w, all), rest(w, all)) / square), rounding);
            EXPECT_LE(closedness(parts.exact, parts.potential), rounding);
            EXPECT_LE(closedness(star({P(), V}, parts.coexact), parts.copotential), rounding);
            if (degree != 1)
                continue;
            const auto plain = [](const Cochain& a, const Cochain& b) {
                return a.values.dot(b.values);
            };
            EXPECT_GT(worst_product(all, plain(w, w), plain), 1e-4) << "without the star";
            EXPECT_GT(closedness(parts.coexact, parts.potential), 1e-2) << "the other part";
        }
}

POLYDEC_ON_REAL_SURFACES(RealDecompositions);

} // namespace polydec::test::in_calculus
