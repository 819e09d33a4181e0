// SPDX-License-Identifier: MIT
#include "dec/forms/operator.h"

#include "base/block_matrix.h"
#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "dec/forms/gram.h"
#include "dec/forms/input_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Number of rows in one piece of work.
constexpr Index rows_at_once = 1 << 13;

/// D x, row by row.
Vector along_rows(const Incidences& D, const Vector& x) {
    constexpr Index part_size = 1 << 15;
    Vector result(D.rows());
    D.visit([&](const auto& rows) {
        for_each_part(D.rows(), part_size, [&](Index first, Index last) {
            for (Index t = first; t < last; ++t) {
                double sum = 0;
                rows.for_each(t, 1, [&](Index face, double sign) { sum += sign * x[face]; });
                result[t] = sum;
            }
        });
    });
    return result;
}

/// D^T y.
Vector across_rows(const Incidences& D, const Vector& y) {
    Vector result = Vector::Zero(D.cols());
    D.visit([&](const auto& rows) {
        for (Index t = 0; t < y.size(); ++t)
            rows.for_each(t, y[t], [&](Index face, double value) { result[face] += value; });
    });
    return result;
}

/// Multiplies rows by left weights and columns by right weights, if given.
void scale(SparseMatrix& A, const Vector& left, const Vector& right) {
    for_each_part(static_cast<Index>(A.rows()), rows_at_once, [&](Index first, Index last) {
        for (Index row = first; row < last; ++row) {
            const double weight = left.size() > 0 ? left[row] : 1;
            for (Index e = A.outerIndexPtr()[row]; e < A.outerIndexPtr()[row + 1]; ++e)
                A.valuePtr()[e] *= right.size() > 0 ? weight * right[A.innerIndexPtr()[e]] : weight;
        }
    });
}

void check_shapes(const Operator& A, const Operator& B, const char* joined, bool fit) {
    if (!fit)
        throw InvalidInput(
            fmt::format("a {} x {} operator is {} a {} x {} operator: the sizes do not match",
                        A.rows(), A.cols(), joined, B.rows(), B.cols()));
}

} // namespace

Operator Operator::derivative(const CellComplex& complex, int k) {
    const Incidences& D = complex.incidences(k);
    return {D.rows(), D.cols(), {{Derivative{complex, k, false}}}};
}

Operator Operator::weights(Vector weights) {
    const auto size = static_cast<Index>(weights.size());
    return {size, size, {{std::make_shared<const Vector>(std::move(weights))}}};
}

Operator Operator::star(const HodgeStar& star) {
    if (star.is_diagonal())
        return weights(star.diagonal());
    return {star.size(), star.size(), {{Mass{star, false}}}};
}

Operator Operator::inverse_star(const HodgeStar& star) {
    if (star.is_diagonal())
        return weights(star.inverse());
    return {star.size(), star.size(), {{Mass{star, true}}}};
}

Operator Operator::zero(Index rows, Index cols) {
    for (const Index size : {rows, cols})
        check_number("an operator of size", size, 0, std::numeric_limits<Index>::max());
    return {rows, cols, {}};
}

Vector Operator::apply(const Factor& factor, const Vector& x) {
    if (const auto* weights = std::get_if<Weights>(&factor))
        return x.cwiseProduct(**weights);
    if (const auto* mass = std::get_if<Mass>(&factor))
        return mass->inverted ? mass->star.solve(x) : mass->star * x;
    if (const auto* to = std::get_if<Conversion>(&factor))
        return form_in_input_units(x, to->unit, to->power, to->what);
    const auto& [complex, k, transposed] = std::get<Derivative>(factor);
    return transposed ? across_rows(complex.incidences(k), x)
                      : along_rows(complex.incidences(k), x);
}

Vector Operator::operator*(const Vector& values) const {
    if (values.size() != cols_)
        throw InvalidInput(
            fmt::format("{} values are given to an operator: expected {}", values.size(), cols_));
    Vector sum = Vector::Zero(terms_.empty() ? rows_ : 0);
    for (const Product& product : terms_) {
        Vector x;
        const Vector* given = &values;
        for (auto factor = product.rbegin(); factor != product.rend(); ++factor, given = &x)
            x = apply(*factor, *given);
        sum = sum.size() == 0 ? std::move(x) : Vector(sum + x);
    }
    return sum;
}

/// Whether factors i, i+1, i+2 are a derivative, weights and its transpose.
bool Operator::is_gram(const Product& product, std::size_t i) {
    if (i + 2 >= product.size())
        return false;
    const auto* left = std::get_if<Derivative>(&product[i]);
    const auto* right = std::get_if<Derivative>(&product[i + 2]);
    return left != nullptr && right != nullptr && std::holds_alternative<Weights>(product[i + 1]) &&
           left->k == right->k && left->transposed != right->transposed &&
           &left->complex.incidences(left->k) == &right->complex.incidences(right->k);
}

/// Matrix of a derivative, or of a star that is a matrix.
SparseMatrix Operator::matrix(const Factor& factor) {
    if (const auto* mass = std::get_if<Mass>(&factor)) {
        if (mass->inverted)
            throw InvalidInput(
                fmt::format("the operator inverts the star of {}-cells, which is not diagonal, so "
                            "its matrix is dense: apply the operator to values instead",
                            mass->star.degree()),
                {.degree = mass->star.degree()});
        return mass->star.matrix();
    }
    const auto& [complex, k, transposed] = std::get<Derivative>(factor);
    return transposed ? SparseMatrix(complex.boundary(k + 1).cast<double>())
                      : complex.incidences(k).real_matrix();
}

SparseMatrix Operator::matrix(const Product& product) {
    SparseMatrix result;
    Vector pending; // weights before the first matrix
    bool begun = false;
    const auto multiply = [&](SparseMatrix next) {
        if (begun)
            SparseMatrix(result * next).swap(next);
        else if (pending.size() > 0)
            scale(next, pending, Vector());
        result.swap(next);
        begun = true;
    };
    for (std::size_t i = 0; i < product.size(); ++i)
        if (is_gram(product, i)) {
            const auto& [complex, k, transposed] = std::get<Derivative>(product[i]);
            const Vector& weights = *std::get<Weights>(product[i + 1]);
            multiply(transposed ? gram_of_columns(complex, k, weights)
                                : gram_of_rows(complex.incidences(k), weights));
            i += 2;
        } else if (const auto* weights = std::get_if<Weights>(&product[i])) {
            if (begun)
                scale(result, Vector(), **weights);
            else
                pending = pending.size() > 0 ? Vector(pending.cwiseProduct(**weights)) : **weights;
        } else if (!std::holds_alternative<Conversion>(product[i]))
            multiply(matrix(product[i]));
    if (!begun)
        result = diagonal_matrix(pending);
    for (const Factor& factor : product)
        if (const auto* to = std::get_if<Conversion>(&factor))
            result = in_input_units(std::move(result), to->unit, to->power, to->what);
    if (product.size() > 3 || !is_gram(product, 0))
        result.coeffs() += 0.0; // -0 becomes 0, as in the halves of a Laplacian
    return result;
}

SparseMatrix Operator::matrix() const {
    SparseMatrix sum(rows_, cols_);
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        SparseMatrix term = matrix(terms_[i]);
        if (i > 0)
            sum_of(sum, term).swap(term);
        sum.swap(term);
    }
    return sum;
}

/// Diagonal of weights times, from factor i on, a derivative, weights and its transpose.
Vector Operator::gram_diagonal(const Product& product, std::size_t i) {
    const auto& [complex, k, transposed] = std::get<Derivative>(product[i]);
    const Vector& weights = *std::get<Weights>(product[i + 1]);
    const Incidences& D = complex.incidences(k);
    Vector sum = Vector::Zero(transposed ? D.cols() : D.rows());
    for (Index t = 0; t < D.rows(); ++t)
        for (const auto& [s, sign] : D[t])
            sum[transposed ? s : t] += sign * sign * weights[transposed ? t : s];
    for (std::size_t j = 0; j < product.size(); ++j)
        if (j < i || j > i + 2)
            sum = sum.cwiseProduct(*std::get<Weights>(product[j]));
    return sum;
}

Vector Operator::diagonal() const {
    Vector sum = Vector::Zero(std::min(rows_, cols_));
    for (const Product& product : terms_) {
        std::size_t i = 0;
        while (i < product.size() && std::holds_alternative<Weights>(product[i]))
            ++i;
        const auto weights =
            std::count_if(product.begin(), product.end(), [](const Factor& factor) {
                return std::holds_alternative<Weights>(factor);
            });
        sum += std::ssize(product) == weights + 2 && is_gram(product, i)
                   ? gram_diagonal(product, i)
                   : Vector(matrix(product).diagonal());
    }
    return sum;
}

Operator Operator::transposed() const {
    Operator result(cols_, rows_, terms_);
    for (Product& product : result.terms_) {
        std::reverse(product.begin(), product.end());
        for (Factor& factor : product)
            if (auto* derivative = std::get_if<Derivative>(&factor))
                derivative->transposed = !derivative->transposed;
    }
    return result;
}

Operator operator*(const Operator& A, const Operator& B) {
    check_shapes(A, B, "multiplied by", A.cols_ == B.rows_);
    Operator result(A.rows_, B.cols_, {});
    for (const auto& left : A.terms_)
        for (const auto& right : B.terms_) {
            result.terms_.push_back(left);
            result.terms_.back().insert(result.terms_.back().end(), right.begin(), right.end());
        }
    return result;
}

Operator operator*(double factor, const Operator& A) {
    return Operator::weights(Vector::Constant(A.rows(), factor)) * A;
}

Operator in_input_units(const Operator& A, double unit, double power, std::string what) {
    if (unit == 1)
        return A;
    const Operator::Conversion conversion{unit, power, std::move(what)};
    return Operator(A.rows(), A.rows(), {{conversion}}) * A;
}

Operator operator+(const Operator& A, const Operator& B) {
    check_shapes(A, B, "added to", A.rows_ == B.rows_ && A.cols_ == B.cols_);
    Operator result = A;
    result.terms_.insert(result.terms_.end(), B.terms_.begin(), B.terms_.end());
    return result;
}

} // namespace polydec
