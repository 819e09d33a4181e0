// SPDX-License-Identifier: MIT
#include "solvers/spectra/scaled_pencil.h"

#include "base/errors.h"
#include "base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double unit_roundoff = static_cast<double>(std::numeric_limits<long double>::epsilon());

/// 2^e with 1/2 <= |x| 2^-2e < 2.
int half_exponent(double x) {
    return static_cast<int>(std::floor((std::ilogb(x) + 1) / 2.0));
}

Vector powers_of_two(const Vector& x, int sign) {
    return x.unaryExpr([=](double entry) {
        return entry == 0 ? 1.0 : std::ldexp(1.0, sign * half_exponent(entry));
    });
}

Index longest_row(const SparseMatrix& A) {
    Index longest = 0;
    for (Index i = 0; i < A.rows(); ++i)
        longest = std::max(longest, A.outerIndexPtr()[i + 1] - A.outerIndexPtr()[i]);
    return longest;
}

void scale(SparseMatrix& A, int exponent) {
    for (Index i = 0; i < A.nonZeros(); ++i) {
        double& entry = A.valuePtr()[i];
        const double before = entry;
        entry = std::ldexp(before, exponent);
        if (before != 0 && !std::isnormal(entry))
            throw InvalidInput(
                "eigenproblem A x = lambda M x: entries of A, in the scale in which M "
                "is 1, differ by more than numbers can tell");
    }
}

double largest_entry(const SparseMatrix& A) {
    double largest = 0;
    for (Index i = 0; i < A.nonZeros(); ++i)
        largest = std::max(largest, std::abs(A.valuePtr()[i]));
    return largest;
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

/// A x, and how far it may be from exact. Differences of neighboring values are exact, so it is the
/// partial sums that count.
template <class Result>
void multiply(const SparseMatrix& A, bool exact_products, const Vector& x, Result& y,
              Vector& error) {
    y.resize(A.rows());
    error.resize(A.rows());
    for (Index i = 0; i < A.rows(); ++i) {
        typename Result::Scalar sum = 0;
        double sizes = 0;
        bool is_first = true;
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry) {
            const auto product = typename Result::Scalar(entry.value()) * x[entry.col()];
            sum += product;
            if (!is_first)
                sizes += static_cast<double>(std::abs(sum));
            if (!exact_products)
                sizes += static_cast<double>(std::abs(product));
            is_first = false;
        }
        y[i] = sum;
        error[i] = unit_roundoff * sizes;
    }
}

/// The largest part of a weight that is uncertain; infinity where one may not be positive.
double largest_share(const Vector& uncertainty, const Vector& weights) {
    double share = 0;
    for (Index e = 0; e < weights.size(); ++e)
        share = weights[e] > uncertainty[e] ? std::max(share, uncertainty[e] / weights[e])
                                            : std::numeric_limits<double>::infinity();
    return share;
}

bool is_finite(const SparseMatrix& A) {
    return std::all_of(A.valuePtr(), A.valuePtr() + A.nonZeros(),
                       [](double entry) { return std::isfinite(entry); });
}

void check(const Pencil& pencil) {
    const auto size = pencil.M.size();
    const auto& C = pencil.C;
    const bool has_C = C.size() > 0 || pencil.parts.empty();
    if (size == 0 || (has_C && (C.rows() != C.cols() || C.rows() != size)))
        throw InvalidInput(fmt::format("eigenproblem A x = lambda M x: A is {} x {}, M has {} "
                                       "entries; expected equal sizes above 0",
                                       C.rows(), C.cols(), size));
    if (!is_finite(C) || (C.size() > 0 && !SparseMatrix(C.transpose()).isApprox(C, 1e-12)))
        throw InvalidInput("eigenproblem A x = lambda M x: a symmetric matrix C of finite numbers "
                           "is expected");
    if (!(pencil.mass_uncertainty >= 0) || !(pencil.mass_uncertainty < 1))
        throw InvalidInput(fmt::format("eigenproblem A x = lambda M x: M is known to within {} of "
                                       "itself, expected a share from 0 to 1",
                                       pencil.mass_uncertainty));
    for (Index i = 0; i < size; ++i)
        if (!(pencil.M[i] > 0) || !std::isfinite(pencil.M[i]))
            throw InvalidInput(
                fmt::format("eigenproblem A x = lambda M x: entry {} of M is {}, expected a "
                            "positive number",
                            i, pencil.M[i]));
    for (const GramPart& part : pencil.parts) {
        const bool fits =
            part.F.cols() == size && part.F.rows() == part.weights.size() &&
            (part.uncertainty.size() == 0 || part.uncertainty.size() == part.weights.size());
        if (!fits)
            throw InvalidInput(fmt::format("eigenproblem A x = lambda M x: a part F^T W F of A has "
                                           "a {} x {} matrix F, {} weights and {} uncertainties; "
                                           "M has {} entries",
                                           part.F.rows(), part.F.cols(), part.weights.size(),
                                           part.uncertainty.size(), size));
        if (!part.weights.allFinite() || !is_finite(part.F))
            throw InvalidInput("eigenproblem A x = lambda M x: a number of a part F^T W F is not "
                               "finite");
        if (!part.uncertainty.allFinite() || (part.uncertainty.array() < 0).any())
            throw InvalidInput("eigenproblem A x = lambda M x: an uncertainty of a part F^T W F is "
                               "not a finite number from 0 on");
    }
}

} // namespace

ScaledPencil::ScaledPencil(const Pencil& pencil)
    : mass_share_(pencil.mass_uncertainty / (1 - pencil.mass_uncertainty)) {
    check(pencil);
    columns_ = powers_of_two(pencil.M, -1);
    M_ = pencil.M.cwiseProduct(columns_).cwiseProduct(columns_);
    root_ = M_.cwiseSqrt();
    if (pencil.C.size() > 0)
        C_ = columns_.asDiagonal() * pencil.C * columns_.asDiagonal();
    for (const GramPart& part : pencil.parts)
        parts_.push_back(scaled(part));
    for (const Part& part : parts_)
        weights_share_ += largest_share(part.uncertainty, part.weights);
    if (C_.size() > 0 && weights_share_ > 0)
        weights_share_ = std::numeric_limits<double>::infinity(); // C is of any sign
    normalize();
    assemble();
}

ScaledPencil::Part ScaledPencil::scaled(const GramPart& part) const {
    const Vector rows = powers_of_two(part.weights, 1);
    const Vector squares = rows.cwiseProduct(rows);
    Part result;
    result.F = rows.asDiagonal() * part.F * columns_.asDiagonal();
    result.weights = part.weights.cwiseQuotient(squares);
    result.uncertainty = part.uncertainty.size() == 0
                             ? Vector(Vector::Zero(part.weights.size()))
                             : Vector(part.uncertainty.cwiseQuotient(squares));
    return result;
}

/// Largest entries of about 1.
void ScaledPencil::normalize() {
    constexpr int none = std::numeric_limits<int>::min();
    const auto exponent = [](double x) { return x > 0 ? half_exponent(x) : none; };
    int half = exponent(largest_entry(C_));
    for (const Part& part : parts_)
        if (const double largest = largest_entry(part.F); largest > 0)
            half = std::max(half, std::ilogb(largest));
    if (half == none)
        half = 0;
    exponent_ = 2 * half;
    scale(C_, -exponent_);
    for (Part& part : parts_) {
        scale(part.F, -half);
        part.transposed = part.F.transpose();
        part.exact_products = has_exact_products(part.F);
        part.rounding = unit_roundoff * (longest_row(part.transposed) + 4);
    }
}

void ScaledPencil::assemble() {
    SparseMatrix A = C_;
    if (A.size() == 0)
        A.resize(size(), size());
    for (const Part& part : parts_) {
        const SparseMatrix weighted = part.weights.asDiagonal() * part.F;
        A += SparseMatrix(part.transposed * weighted);
    }
    const Vector inverse = root_.cwiseInverse();
    const SparseMatrix B = inverse.asDiagonal() * A * inverse.asDiagonal();
    matrix_ = std::make_shared<SparseMatrix>((B + SparseMatrix(B.transpose())) / 2);
}

/// An entry is a sum of as many terms as a column of F has, each of them a product of six numbers.
/// Where all weights are positive for sure, a share by which they are off is one of x^T A x at
/// most, and so of each eigenvalue.
Doubt ScaledPencil::doubt() const {
    constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
    const bool is_share = std::isfinite(weights_share_);
    const Vector inverse = root_.cwiseInverse();
    Doubt doubt{Vector::Zero(size()), 0, mass_share_ + (is_share ? weights_share_ : 0)};
    if (C_.size() > 0)
        doubt.sizes += C_.diagonal().cwiseAbs();
    for (const Part& part : parts_)
        doubt.sizes += part.transposed.cwiseAbs2() * part.weights.cwiseAbs();
    doubt.sizes = doubt.sizes.cwiseProduct(inverse).cwiseProduct(inverse);
    const Vector scaling =
        doubt.sizes.unaryExpr([](double size) { return size > 0 ? 1 / std::sqrt(size) : 0.0; });
    const Vector x = inverse.cwiseProduct(scaling);
    Vector sums = Vector::Zero(size());
    if (C_.size() > 0)
        sums += 6 * unit * (C_.cwiseAbs() * x);
    for (const Part& part : parts_) {
        const auto terms = static_cast<double>(longest_row(part.transposed) + 6);
        Vector errors = unit * terms * part.weights.cwiseAbs();
        if (!is_share)
            errors += part.uncertainty;
        const Vector image = part.F.cwiseAbs() * x;
        sums += part.transposed.cwiseAbs() * Vector(errors.cwiseProduct(image));
    }
    doubt.share = sums.cwiseProduct(x).maxCoeff();
    return doubt;
}

void ScaledPencil::add_part(const Part& part, const Vector& x, Image& image) const {
    LongVector Fx;
    Vector error;
    multiply(part.F, part.exact_products, x, Fx, error);
    Vector unknown(error.size());
    for (Index e = 0; e < Fx.size(); ++e) {
        const double weight = std::abs(part.weights[e]), unsure = part.uncertainty[e];
        const double size = std::abs(static_cast<double>(Fx[e]));
        image.energy += part.weights[e] < unsure && weight + unsure > 0
                            ? std::numeric_limits<double>::infinity()
                            : (weight + unsure) * (size + error[e]) * (size + error[e]);
        error[e] = (weight + unsure) * error[e] + part.rounding * weight * size;
        unknown[e] = unsure * size;
        Fx[e] *= part.weights[e];
    }
    for (Index i = 0; i < x.size(); ++i)
        for (SparseMatrix::InnerIterator entry(part.transposed, i); entry; ++entry) {
            image.Ax[i] += entry.value() * Fx[entry.col()];
            const double size = std::abs(entry.value());
            image.rounding[i] += size * error[entry.col()];
            image.doubt[i] += size * (error[entry.col()] + unknown[entry.col()]);
        }
}

ScaledPencil::Image ScaledPencil::apply(const Vector& x) const {
    Image image{LongVector::Zero(x.size()), Vector::Zero(x.size()), Vector::Zero(x.size())};
    if (C_.size() > 0) {
        multiply(C_, false, x, image.Ax, image.rounding);
        image.doubt = image.rounding;
        image.energy = std::numeric_limits<double>::infinity();
    }
    for (const Part& part : parts_)
        add_part(part, x, image);
    return image;
}

Enclosure ScaledPencil::enclose(const Vector& x, const Image& image) const {
    long double energy = 0, square = 0;
    for (Index i = 0; i < size(); ++i) {
        energy += image.Ax[i] * x[i];
        square += static_cast<long double>(M_[i]) * x[i] * x[i];
    }
    Enclosure result;
    result.value = static_cast<double>(energy / square);

    // in the scale given, columns_.minCoeff() / columns_ stands for M^-1
    const double smallest = columns_.minCoeff();
    long double residual = 0, rounding = 0, doubt = 0, given = 0, given_mass = 0;
    for (Index i = 0; i < size(); ++i) {
        const long double product = static_cast<long double>(M_[i]) * x[i];
        const long double r = image.Ax[i] - result.value * product;
        const long double own = 4 * unit_roundoff * std::abs(result.value * product);
        const long double lost = image.rounding[i] + own, unknown = image.doubt[i] + own;
        const long double unscaled = smallest / columns_[i];
        residual += r * r / M_[i];
        rounding += lost * lost / M_[i];
        doubt += unknown * unknown / M_[i];
        given += unscaled * r * unscaled * r;
        given_mass += unscaled * product * unscaled * product;
    }
    // what the sums above have lost is far below a millionth
    constexpr double safety = 1 + 1e-6;
    // uncertain weights count by what they do to A x, or by their share of every eigenvalue
    const auto widened = [&](long double known) {
        const auto radius = [&](long double sum, double share) {
            const auto absolute = static_cast<double>((known + std::sqrt(sum)) / std::sqrt(square));
            return safety * (absolute * (1 + share) + share * std::abs(result.value));
        };
        return std::min(radius(doubt, mass_share_),
                        radius(rounding, mass_share_ + weights_share_ * (1 + mass_share_)));
    };
    result.radius = widened(std::sqrt(residual));
    result.doubt = widened(0);
    result.energy = safety * (1 + 2 * mass_share_) * image.energy / static_cast<double>(square);
    result.residual = static_cast<double>(std::sqrt(given) / std::sqrt(given_mass));
    return result;
}

std::vector<Enclosure> ScaledPencil::enclose(const DenseMatrix& Y, DenseMatrix* residuals) const {
    std::vector<Enclosure> enclosures(Y.cols());
    if (residuals)
        residuals->resize(Y.rows(), Y.cols());
    for_each_part(static_cast<Index>(Y.cols()), 1, [&](Index begin, Index end) {
        for (Index i = begin; i < end; ++i) {
            const Vector x = Y.col(i).cwiseQuotient(root_);
            const Image image = apply(x);
            enclosures[i] = enclose(x, image);
            if (residuals)
                for (Index j = 0; j < size(); ++j)
                    (*residuals)(j, i) = static_cast<double>(
                        (image.Ax[j] -
                         enclosures[i].value * static_cast<long double>(M_[j]) * x[j]) /
                        root_[j]);
        }
    });
    return enclosures;
}

double ScaledPencil::eigenvalue(double scaled) const {
    return std::ldexp(scaled, exponent_);
}

Vector ScaledPencil::eigenvalues(const Vector& scaled) const {
    return scaled.unaryExpr([this](double value) { return eigenvalue(value); });
}

DenseMatrix ScaledPencil::eigenvectors(const DenseMatrix& Y) const {
    return columns_.cwiseQuotient(root_).asDiagonal() * Y;
}

} // namespace polydec
