// SPDX-License-Identifier: MIT
#include "dec/forms/cochain.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/exponent.h"
#include "dec/forms/laplacian.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

template <class Values>
std::string described(const Values& values, const char* what) {
    return fmt::format("a {} {}-{} of {} values", name(values.side), values.degree, what,
                       values.values.size());
}

template <class Values>
void check_finite(const Values& values, const char* what) {
    for (Index i = 0; i < values.values.size(); ++i)
        if (!std::isfinite(values.values[i]))
            throw InvalidInput(fmt::format("{}: value {} is {}, expected a finite number",
                                           described(values, what), i, values.values[i]));
}

template <class Values>
void check_values(const CellComplex& complex, const Values& values, const char* what) {
    const int k = cell_degree(complex, values.side, values.degree);
    if (values.values.size() != complex.size(k))
        throw InvalidInput(
            fmt::format("{} is given, but the complex has {} {}-cells: expected one value for each",
                        described(values, what), complex.size(k), k));
    check_finite(values, what);
}

/// Whether both are forms of the same kind, or a form and a chain of its cells.
template <class Other>
void check_alike(const Cochain& a, const Other& b, const char* what) {
    if (a.side != b.side || a.degree != b.degree || a.values.size() != b.values.size())
        throw InvalidInput(fmt::format("{} does not go with {}: side, degree and size must agree",
                                       described(b, what), described(a, "form")));
    check_finite(a, "form");
    check_finite(b, what);
}

/// Sign of the dual derivative relative to d_k^T.
double dual_sign(int k) {
    return k % 2 == 0 ? -1 : 1;
}

/// In the units of the input. The exponent of a square is even, because a unit is a power of 4.
ScaledNumber product(const Cells& cells, const Cochain& a, const Cochain& b) {
    check(cells.complex(), a);
    check_alike(a, b, "form");
    const HodgeStar star = cells.stars()[cell_degree(cells.complex(), a.side, a.degree)];
    ScaledNumber result = polydec::product(a.values, b.values, [&](const Vector& values) {
        return a.side == Side::primal ? star * values : star.solve(values);
    });
    result.exponent += (cells.dimension() - 2 * a.degree) * std::ilogb(cells.unit());
    return result;
}

} // namespace

SparseMatrix derivative(const CellComplex& complex, int k) {
    return complex.incidences(k).real_matrix();
}

SparseMatrix dual_derivative(const CellComplex& complex, int j) {
    check_number("the derivative of dual forms of degree", j, -1, complex.dimension());
    const int k = complex.dimension() - j - 1;
    return dual_sign(k) * SparseMatrix(derivative(complex, k).transpose());
}

int cell_degree(const CellComplex& complex, Side side, int degree) {
    const int n = complex.dimension();
    if (degree < 0 || degree > n)
        throw InvalidInput(fmt::format(
            "{} forms and chains of degree {} do not exist in dimension {}: expected 0 to {}",
            name(side), degree, n, n));
    return side == Side::primal ? degree : n - degree;
}

void check(const CellComplex& complex, const Cochain& form) {
    check_values(complex, form, "form");
}

void check(const CellComplex& complex, const Chain& chain) {
    check_values(complex, chain, "chain");
}

void check_factors(const CellComplex& complex, Side side, const Cochain& a, const Cochain& b) {
    check(complex, a);
    check(complex, b);
    if (a.side != side || b.side != side)
        throw InvalidInput(
            fmt::format("this product is not defined for a {} {}-form and a {} {}-form: expected "
                        "two {} forms; use wedge for primal forms, dual_wedge for dual ones, "
                        "primal_dual_wedge for a primal k-form and a dual (n-k)-form",
                        name(a.side), a.degree, name(b.side), b.degree, name(side)));
    if (a.degree + b.degree > complex.dimension())
        throw InvalidInput(fmt::format("the product of a {}-form and a {}-form has degree {}, but "
                                       "dimension {} has no such forms",
                                       a.degree, b.degree, a.degree + b.degree,
                                       complex.dimension()));
}

Chain boundary(const CellComplex& complex, const Chain& chain) {
    check(complex, chain);
    const int k = cell_degree(complex, chain.side, chain.degree);
    return {chain.side, chain.degree - 1,
            chain.side == Side::primal
                ? Operator::derivative(complex, k - 1).transposed() * chain.values
                : Vector(dual_sign(k) * (Operator::derivative(complex, k) * chain.values))};
}

double pairing(const Cochain& form, const Chain& chain) {
    check_alike(form, chain, "chain");
    return form.values.dot(chain.values);
}

Cochain d(const CellComplex& complex, const Cochain& form) {
    check(complex, form);
    const int k = cell_degree(complex, form.side, form.degree);
    return {form.side, form.degree + 1,
            form.side == Side::primal
                ? Operator::derivative(complex, k) * form.values
                : Vector(dual_sign(k - 1) *
                         (Operator::derivative(complex, k - 1).transposed() * form.values))};
}

Cochain star(const Cells& cells, const Cochain& form) {
    check(cells.complex(), form);
    const int n = cells.dimension();
    const int k = cell_degree(cells.complex(), form.side, form.degree);
    const HodgeStar star = polydec::star(cells, k);
    if (form.side == Side::primal)
        return {Side::dual, n - k, star * form.values};
    const double star_star = k * (n - k) % 2 == 0 ? 1 : -1;
    return {Side::primal, k, star_star * star.solve(form.values)};
}

Cochain codifferential(const Cells& cells, const Cochain& form) {
    check(cells.complex(), form);
    return {form.side, form.degree - 1,
            form.side == Side::primal ? codifferential(cells, form.degree) * form.values
                                      : dual_codifferential(cells, form.degree) * form.values};
}

Cochain laplacian(const Cells& cells, const Cochain& form) {
    check(cells.complex(), form);
    return {form.side, form.degree,
            form.side == Side::primal ? laplacian(cells, form.degree) * form.values
                                      : dual_laplacian(cells, form.degree) * form.values};
}

double inner_product(const Cells& cells, const Cochain& a, const Cochain& b) {
    const ScaledNumber found = product(cells, a, b);
    return std::ldexp(found.part, found.exponent) == 0 ? 0 : found.in_range("the inner product");
}

double norm(const Cells& cells, const Cochain& form) {
    const auto [square, exponent] = product(cells, form, form);
    if (square < 0)
        throw InvalidInput(fmt::format("the squared norm of {} is {:.3g}, because some {}-cells "
                                       "have negative duals: use positive stars",
                                       described(form, "form"), std::ldexp(square, exponent),
                                       cell_degree(cells.complex(), form.side, form.degree)));
    return ScaledNumber{std::sqrt(square), exponent / 2}.in_range("the norm of a form");
}

Cochain operator+(const Cochain& a, const Cochain& b) {
    check_alike(a, b, "form");
    return {a.side, a.degree, a.values + b.values};
}

Cochain operator-(const Cochain& a, const Cochain& b) {
    check_alike(a, b, "form");
    return {a.side, a.degree, a.values - b.values};
}

Cochain operator*(double factor, const Cochain& form) {
    return {form.side, form.degree, factor * form.values};
}

} // namespace polydec
