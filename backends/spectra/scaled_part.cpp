// SPDX-License-Identifier: MIT
#include "backends/spectra/scaled_part.h"

#include "base/block_matrix.h"
#include "base/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// 2^e with 1/2 <= |x| 2^-2e < 2.
int half_exponent(double x) {
    return static_cast<int>(std::floor((std::ilogb(x) + 1) / 2.0));
}

/// Whether all entries are powers of two, so that products with them are exact.
bool has_exact_products(const SparseMatrix& A) {
    for (Index i = 0; i < A.nonZeros(); ++i) {
        int exponent = 0;
        if (std::abs(std::frexp(A.valuePtr()[i], &exponent)) != 0.5 && A.valuePtr()[i] != 0)
            return false;
    }
    return true;
}

/// One number for each row, known to within some uncertainty.
class NumbersPart final : public ScaledPart {
public:
    NumbersPart(const GramPart& part, const Vector& numbers, const Vector& rows,
                const Vector& columns)
        : ScaledPart(part, rows, columns) {
        const Vector squares = rows.cwiseProduct(rows);
        weights_ = numbers.cwiseQuotient(squares);
        uncertainty_ = part.uncertainty.size() == 0
                           ? Vector(Vector::Zero(numbers.size()))
                           : Vector(part.uncertainty.cwiseQuotient(squares));
    }

    double largest_share() const override {
        double share = 0;
        for (Index e = 0; e < weights_.size(); ++e)
            share = weights_[e] > uncertainty_[e] ? std::max(share, uncertainty_[e] / weights_[e])
                                                  : infinity;
        return share;
    }

protected:
    LongVector weigh(const LongVector& y, Vector& error, Vector& unknown,
                     Image& image) const override {
        LongVector result(y.size());
        for (Index e = 0; e < y.size(); ++e) {
            const double weight = std::abs(weights_[e]), unsure = uncertainty_[e];
            const double size = std::abs(static_cast<double>(y[e]));
            image.energy += weights_[e] < unsure && weight + unsure > 0
                                ? infinity
                                : (weight + unsure) * (size + error[e]) * (size + error[e]);
            error[e] = (weight + unsure) * error[e];
            unknown[e] = unsure * size;
            result[e] = y[e] * weights_[e];
        }
        return result;
    }

    SparseMatrix weights() const override { return diagonal_matrix(weights_); }
    Vector spread(const Vector& sizes) const override {
        return weights_.cwiseAbs().cwiseProduct(sizes);
    }
    Vector uncertainty() const override { return uncertainty_; }

private:
    Vector weights_, uncertainty_;
};

class MatrixPart final : public ScaledPart {
public:
    MatrixPart(const GramPart& part, const SparseMatrix& W, const Vector& rows,
               const Vector& columns)
        : ScaledPart(part, rows, columns), mass_(make_mass(congruent(W, rows.cwiseInverse()))) {}

protected:
    LongVector weigh(const LongVector& y, Vector& error, Vector&, Image& image) const override {
        const Vector sizes = Vector(y.cwiseAbs().cast<double>()) + error;
        image.energy += sizes.dot(mass_->spread(sizes));
        const Vector before = mass_->spread(error);
        LongVector result = mass_->times(y, error);
        error += before;
        return result;
    }

    SparseMatrix weights() const override { return mass_->matrix(); }
    Vector spread(const Vector& sizes) const override { return mass_->spread(sizes); }

private:
    std::unique_ptr<const Mass> mass_;
};

class InversePart final : public ScaledPart {
public:
    InversePart(const GramPart& part, const Weights& W, const Vector& rows, const Vector& columns)
        : ScaledPart(part, rows, columns), mass_(make_mass(congruent(W, rows))) {}

    const Mass* inverse_of() const override { return mass_.get(); }

protected:
    LongVector weigh(const LongVector& y, Vector& error, Vector&, Image& image) const override {
        const Vector sizes = Vector(y.cwiseAbs().cast<double>()) + error;
        image.energy += static_cast<double>(mass_->inverse_square_bound(sizes));
        Vector rest;
        LongVector result = mass_->solve(y, rest);
        rest += error;
        if (mass_->is_diagonal()) {
            error = rest.cwiseQuotient(mass_->diagonal());
        } else {
            image.lost += static_cast<double>(std::sqrt(mass_->inverse_square_bound(rest)));
            error.setZero();
        }
        return result;
    }

    SparseMatrix weights() const override {
        return diagonal_matrix(mass_->diagonal().cwiseInverse() / mass_->dominance());
    }
    Vector spread(const Vector& sizes) const override { return weights() * sizes; }

private:
    std::unique_ptr<const Mass> mass_;
};

} // namespace

Vector powers_of_two(const Vector& x, int sign) {
    return x.unaryExpr([=](double entry) {
        return entry == 0 ? 1.0 : std::ldexp(1.0, sign * half_exponent(entry));
    });
}

void scale_entries(SparseMatrix& A, int exponent) {
    for (Index i = 0; i < A.nonZeros(); ++i) {
        double& entry = A.valuePtr()[i];
        const double before = entry;
        entry = std::ldexp(before, exponent);
        if (before != 0 && !std::isnormal(entry))
            throw InvalidInput(
                "eigenproblem A x = lambda M x: entries of A, scaled so that M is 1, leave the "
                "range of double precision; improve cells of extreme shape");
    }
}

LongVector multiply(const SparseMatrix& A, bool exact_products, const Vector& x, Vector& error) {
    LongVector y(A.rows());
    error.resize(A.rows());
    for (Index i = 0; i < A.rows(); ++i) {
        long double sum = 0;
        double sizes = 0;
        bool is_first = true;
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry) {
            const long double product = static_cast<long double>(entry.value()) * x[entry.col()];
            sum += product;
            if (!is_first)
                sizes += static_cast<double>(std::abs(sum));
            if (!exact_products)
                sizes += static_cast<double>(std::abs(product));
            is_first = false;
        }
        y[i] = sum;
        error[i] = unit_roundoff() * sizes;
    }
    return y;
}

ScaledPart::ScaledPart(const GramPart& part, const Vector& rows, const Vector& columns)
    : F_(rows.asDiagonal() * part.F * columns.asDiagonal()),
      F_error_(part.F_error.size() == 0
                   ? SparseMatrix(part.F.rows(), part.F.cols())
                   : SparseMatrix(rows.asDiagonal() * part.F_error * columns.asDiagonal())) {}

void ScaledPart::scale(int exponent) {
    scale_entries(F_, exponent);
    F_error_ *= std::ldexp(1.0, exponent);
    exact_products_ = has_exact_products(F_);
    longest_column_ = longest_row(F_.transpose());
    rounding_ = unit_roundoff() * (longest_column_ + 4);
}

void ScaledPart::add_to(Image& image, const Vector& x) const {
    Vector error;
    const LongVector Fx = multiply(F_, exact_products_, x, error);
    error += F_error_ * x.cwiseAbs();
    Vector unknown = Vector::Zero(error.size());
    const LongVector weighed = weigh(Fx, error, unknown, image);
    const Vector sizes = weighed.cwiseAbs().cast<double>();
    error += rounding_ * sizes;
    for (Index e = 0; e < F_.rows(); ++e)
        for (SparseMatrix::InnerIterator entry(F_, e); entry; ++entry) {
            image.Ax[entry.col()] += entry.value() * weighed[e];
            const double size = std::abs(entry.value());
            image.rounding[entry.col()] += size * error[e];
            image.doubt[entry.col()] += size * (error[e] + unknown[e]);
        }
    const Vector own = F_error_.transpose() * sizes;
    image.rounding += own;
    image.doubt += own;
}

SparseMatrix ScaledPart::lumped() const {
    const SparseMatrix weighted = weights() * F_;
    return SparseMatrix(F_.transpose()) * weighted;
}

/// An entry is a sum of as many terms as a column of F has, each of them a product of six numbers.
Vector ScaledPart::doubts(const Vector& x, bool with_uncertainty) const {
    constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
    const auto terms = static_cast<double>(longest_column_ * longest_row(weights()) + 6);
    const Vector image = F_.cwiseAbs() * x;
    Vector errors = unit * terms * spread(image);
    if (with_uncertainty)
        errors += uncertainty().cwiseProduct(image);
    const Vector own = F_error_ * x;
    return SparseMatrix(F_.cwiseAbs().transpose()) * Vector(errors + spread(own)) +
           SparseMatrix(F_error_.transpose()) * spread(image);
}

Vector ScaledPart::sizes() const {
    return SparseMatrix(F_.cwiseAbs2().transpose()) * spread(Vector::Ones(F_.rows()));
}

std::unique_ptr<ScaledPart> make_scaled_part(const GramPart& part, const Vector& columns) {
    if (const auto* numbers = std::get_if<Vector>(&part.weights))
        return std::make_unique<NumbersPart>(part, *numbers, powers_of_two(*numbers, 1), columns);
    if (const auto* W = std::get_if<SparseMatrix>(&part.weights))
        return std::make_unique<MatrixPart>(part, *W, powers_of_two(W->diagonal(), 1), columns);
    const Weights& W = std::get<InverseWeights>(part.weights).W;
    return std::make_unique<InversePart>(part, W, powers_of_two(diagonal(W), -1), columns);
}

} // namespace polydec
