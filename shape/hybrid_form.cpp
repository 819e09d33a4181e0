// SPDX-License-Identifier: MIT
#include "base/decompositions.h"
#include "shape/forms.h"

#include <limits>

namespace polydec {

namespace {

/// How the part of |grad w|^2, and the products of linear and other functions, are divided.
constexpr double share_of_gradient = 0.5, share_of_linear = 0.3;

/// The unknown of facet i at corner a, its mean times lambda_a.
int moment(int n, int i, int a) {
    return n * i + (a < i ? a : a - 1);
}

/// A polynomial, the sum of products of two coordinates, and its gradient, the sum of
/// lambda_a grad lambda_b over pairs (a, b).
struct Quadratic {
    std::vector<Pair> products, gradient;
};

/// A basis of the quadratic polynomials modulo constants: the coordinates without one, and their
/// products. From an end of the shortest edge on, those that vary across a flat simplex keep apart
/// from those along it.
std::vector<Quadratic> quadratics(int n, int origin) {
    std::vector<Quadratic> result;
    for (int i = 0; i <= n; ++i) {
        if (i == origin)
            continue;
        result.emplace_back();
        for (int a = 0; a <= n; ++a) { // lambda_i times the sum of all
            result.back().products.push_back({i, a});
            result.back().gradient.push_back({a, i});
        }
        for (int j = i; j <= n; ++j)
            if (j != origin)
                result.push_back({{{i, j}}, {{i, j}, {j, i}}});
    }
    return result;
}

/// What all simplices of dimension n have in common.
struct ReferenceSimplex {
    ReferenceSimplex(int dimension, int origin);

    void compare_polynomials();
    void compare_fields();

    int n;
    std::vector<Quadratic> basis;
    std::vector<Pair> edges; // j < k: fields lambda_j lambda_k (x_k - x_j)
    LongMatrix covariance;   // of the polynomials
    LongMatrix linear_part;  // of a polynomial less its mean: coefficients of lambda_k
    LongMatrix moments;      // of the polynomials less their means: R moments = 1
    LongMatrix linear_mass;  // means of lambda_i lambda_j
    LongMatrix divergences;  // means of (lambda_k - lambda_j) p: a row for each field
    LongMatrix field_means;  // means of products of lambda_j lambda_k
    LongMatrix fields;       // with - divergence sum q_k lambda_k, for q of sum 0
    LongMatrix circulations; // fields without divergence
};

ReferenceSimplex::ReferenceSimplex(int dimension, int origin)
    : n(dimension), basis(quadratics(dimension, origin)) {
    for (int j = 0; j <= n; ++j)
        for (int k = j + 1; k <= n; ++k)
            edges.push_back({j, k});
    linear_mass.resize(n + 1, n + 1);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            linear_mass(i, j) = mean_of_product(n, {i, j});
    compare_polynomials();
    compare_fields();
}

void ReferenceSimplex::compare_polynomials() {
    const auto size = static_cast<Eigen::Index>(basis.size());
    const auto fields_size = static_cast<Eigen::Index>(edges.size());
    covariance = LongMatrix::Zero(size, size);
    linear_part = LongMatrix::Zero(n + 1, size);
    divergences = LongMatrix::Zero(fields_size, size);
    moments = LongMatrix::Zero(n * (n + 1), size);
    for (Eigen::Index p = 0; p < size; ++p)
        for (const auto& [i, j] : basis[p].products) {
            const long double mean = mean_of_product(n, {i, j});
            for (Eigen::Index q = 0; q < size; ++q)
                for (const auto& [k, l] : basis[q].products)
                    covariance(p, q) +=
                        mean_of_product(n, {i, j, k, l}) - mean * mean_of_product(n, {k, l});
            for (int k = 0; k <= n; ++k)
                linear_part(k, p) +=
                    (n + 1) * (n + 2) * (mean_of_product(n, {i, j, k}) - mean / (n + 1));
            for (Eigen::Index e = 0; e < fields_size; ++e)
                divergences(e, p) += mean_of_product(n, {i, j, edges[e][1]}) -
                                     mean_of_product(n, {i, j, edges[e][0]});
            for (int omitted = 0; omitted <= n; ++omitted)
                for (int a = 0; a <= n; ++a)
                    if (a != omitted)
                        moments(moment(n, omitted, a), p) +=
                            (omitted == i || omitted == j ? 0 : mean_of_product(n - 1, {i, j, a})) -
                            mean / n;
        }
}

void ReferenceSimplex::compare_fields() {
    const auto size = static_cast<Eigen::Index>(edges.size());
    field_means.resize(size, size);
    fields = LongMatrix::Zero(size, n + 1);
    circulations = LongMatrix::Zero(size, n * (n - 1) / 2);
    for (Eigen::Index e = 0, cycle = 0; e < size; ++e) {
        const auto [j, k] = edges[e];
        for (Eigen::Index f = 0; f < size; ++f)
            field_means(e, f) = mean_of_product(n, {j, k, edges[f][0], edges[f][1]});
        fields(e, k) = 1.0L / (n + 1);
        fields(e, j) = -1.0L / (n + 1);
        if (j == 0) // edges 0 k come first, in order
            continue;
        circulations(e, cycle) = circulations(j - 1, cycle) = 1;
        circulations(k - 1, cycle) = -1;
        ++cycle;
    }
}

/// Products of the gradients of the polynomials.
LongMatrix stiffness(const ReferenceSimplex& reference, const MeasuredSimplex& simplex) {
    const auto size = static_cast<Eigen::Index>(reference.basis.size());
    LongMatrix S = LongMatrix::Zero(size, size);
    for (Eigen::Index p = 0; p < size; ++p)
        for (Eigen::Index q = 0; q <= p; ++q) {
            for (const auto& [a, b] : reference.basis[p].gradient)
                for (const auto& [c, d] : reference.basis[q].gradient)
                    S(p, q) += reference.linear_mass(a, c) * simplex.gradients(b, d);
            S(q, p) = S(p, q);
        }
    return simplex.volume * S;
}

/// Integrals of grad u . grad p for the polynomials p, by moments of u less its mean in the cell.
LongMatrix flux_products(const ReferenceSimplex& reference, const MeasuredSimplex& simplex) {
    const int n = reference.n;
    const auto size = static_cast<Eigen::Index>(reference.basis.size());
    LongMatrix B = LongMatrix::Zero(size, n * (n + 1));
    for (Eigen::Index p = 0; p < size; ++p)
        for (const auto& [a, b] : reference.basis[p].gradient)
            for (int i = 0; i <= n; ++i)
                if (i != a)
                    B(p, moment(n, i, a)) -= n * simplex.volume * simplex.gradients(i, b);
    return B;
}

/// |G d|^2, G d the gradient of u projected on linear fields.
LongMatrix gradient_square(int n, const MeasuredSimplex& simplex) {
    LongMatrix K(n * (n + 1), n * (n + 1));
    const long double factor = n * n * simplex.volume * (n + 1) * (n + 2);
    for (int i = 0; i <= n; ++i)
        for (int a = 0; a <= n; ++a)
            for (int j = 0; j <= n; ++j)
                for (int b = 0; b <= n; ++b)
                    if (a != i && b != j)
                        K(moment(n, i, a), moment(n, j, b)) =
                            factor * simplex.gradients(i, j) * ((a == b) - 1.0L / (n + 2));
    return K;
}

/// N with (q, w)^2 <= q^T N q |grad w|^2 for linear q of mean 0, by coefficients, and w with
/// gradient orthogonal to those of quadratic polynomials: of the quadratic fields tau with
/// - div tau = q and no flow through facets the one that is nearest to such gradients.
LongMatrix flow_distance(const ReferenceSimplex& reference, const MeasuredSimplex& simplex,
                         const Eigen::LDLT<LongMatrix>& stiffness) {
    const auto size = static_cast<Eigen::Index>(reference.edges.size());
    LongMatrix products(size, size);
    for (Eigen::Index e = 0; e < size; ++e)
        for (Eigen::Index f = 0; f < size; ++f) {
            const auto [j, k] = reference.edges[e];
            const auto [l, m] = reference.edges[f];
            const auto& squares = simplex.squares;
            products(e, f) = simplex.volume * reference.field_means(e, f) *
                             (squares(k, l) + squares(j, m) - squares(k, m) - squares(j, l)) / 2;
        }
    const LongMatrix T = simplex.volume * reference.divergences;
    const LongMatrix W = products - T * stiffness.solve(T.transpose());
    LongMatrix tau = reference.fields;
    if (const auto& Z = reference.circulations; Z.cols() > 0) {
        const LongMatrix inner = Z.transpose() * W * Z;
        tau -= Z * inner.ldlt().solve(Z.transpose() * W * tau);
    }
    LongMatrix N = tau.transpose() * W * tau;
    const LongMatrix all = tau.transpose() * products * tau;
    const long double rounding = 256 * std::numeric_limits<long double>::epsilon();
    N.diagonal() += rounding * simplex.sensitivity * all.cwiseAbs().rowwise().sum();
    return N;
}

/// The error of R, at the moments of the polynomials that it is to give.
double error_of(const ReferenceSimplex& reference, const LongMatrix& R) {
    const auto size = R.rows();
    const LongMatrix off = R * reference.moments - LongMatrix::Identity(size, size);
    return static_cast<double>(off.cwiseAbs().maxCoeff() +
                               std::numeric_limits<long double>::epsilon());
}

/// Robin's part: the squares of the traces projected on linear functions.
LongMatrix robin_part(int n, const MeasuredSimplex& simplex, const FacetSide* sides) {
    LongMatrix result;
    for (int i = 0; i <= n; ++i) {
        if (!(sides[i].robin > 0))
            continue;
        if (result.size() == 0)
            result = LongMatrix::Zero(n * (n + 1), n * (n + 1));
        const long double factor = sides[i].robin * simplex.facet_volume(i) * n * (n + 1);
        result.block(n * i, n * i, n, n) =
            factor * (LongMatrix::Identity(n, n) - LongMatrix::Constant(n, n, 1.0L / (n + 1)));
    }
    return result;
}

LocalForms local_forms(const Shape& shape, const std::vector<ReferenceSimplex>& references,
                       const FacetSide* sides, Index s) {
    const auto simplex = measured_simplex(shape, s);
    const ReferenceSimplex& reference = references[simplex.origin];
    const int n = reference.n;
    const long double kappa = conductivity_of(shape, s), rho = density_of(shape, s);
    const Eigen::LDLT<LongMatrix> S(stiffness(reference, simplex));
    const LongMatrix B = flux_products(reference, simplex);
    const LongMatrix R = S.solve(B);
    const LongMatrix of_quadratic = B.transpose() * R;
    const LongMatrix mass = simplex.volume * (R.transpose() * reference.covariance * R);
    const LongMatrix q = reference.linear_part * R;
    const LongMatrix linear = simplex.volume * (q.transpose() * reference.linear_mass * q);
    const long double square = simplex.longest_square * (1 + 1e-15L) * poincare_square(n);
    const LongMatrix doubt =
        (1 + share_of_linear) * (q.transpose() * flow_distance(reference, simplex, S) * q) +
        (1 + 1 / share_of_linear) * square * (mass - linear);
    LocalForms forms;
    forms.parts = {kappa * of_quadratic, kappa * (gradient_square(n, simplex) - of_quadratic),
                   rho * mass, rho * rho / kappa * doubt};
    for (LongMatrix& part : forms.parts)
        part = LongMatrix((part + part.transpose()) / 2);
    forms.robin = robin_part(n, simplex, sides);
    forms.cell = LongMatrix::Constant(n * (n + 1), 1, 1.0L / n);
    forms.mass = static_cast<double>(rho * simplex.volume);
    forms.reach = static_cast<double>(square * rho / kappa) * (1 + 1e-15);
    forms.error = 64 * error_of(reference, R);
    return forms;
}

} // namespace

FormFamily hybrid_form(const Shape& shape) {
    const int n = shape.pieces.dimension();
    const auto sides = facet_sides(shape);
    std::vector<ReferenceSimplex> references; // by origin
    for (int origin = 0; origin <= n; ++origin)
        references.emplace_back(n, origin);
    const auto factors = [](double s, double reach) {
        const double eps = share_of_gradient;
        return std::vector<double>{1, eps * (1 - reach), -s, -s * s / ((1 - eps) * (1 - reach))};
    };
    const auto local = [&](Index s) {
        return local_forms(shape, references, &sides[std::size_t(n + 1) * s], s);
    };
    return {shape, facet_unknowns(shape, sides, n), factors, local};
}

} // namespace polydec
