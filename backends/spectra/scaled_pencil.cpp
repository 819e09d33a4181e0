// SPDX-License-Identifier: MIT
#include "backends/spectra/scaled_pencil.h"

#include "base/block_matrix.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "base/row_sum_norm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

bool is_finite(const SparseMatrix& A) {
    return std::all_of(A.valuePtr(), A.valuePtr() + A.nonZeros(),
                       [](double entry) { return std::isfinite(entry); });
}

constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

constexpr const char* what = "eigenproblem A x = lambda M x";

/// Throws unless numbers are finite, and a matrix square and symmetric; `name` says which. Opposite
/// entries may differ by rounding, beside the largest of their rows; then their mean counts.
void check_symmetric(const SparseMatrix& A, const char* name) {
    if (!is_finite(A) || A.rows() != A.cols())
        throw InvalidInput(
            fmt::format("{}: expected a symmetric matrix {} of finite numbers", what, name));
    const SparseMatrix difference = A - SparseMatrix(A.transpose());
    Vector largest = Vector::Zero(A.rows());
    for (Index i = 0; i < A.rows(); ++i)
        for (SparseMatrix::InnerIterator at(A, i); at; ++at)
            largest[i] = std::max(largest[i], std::abs(at.value()));
    constexpr double rounding = 1e-12;
    for (Index i = 0; i < A.rows(); ++i)
        for (SparseMatrix::InnerIterator at(difference, i); at; ++at)
            if (std::abs(at.value()) >
                rounding * std::sqrt(largest[i]) * std::sqrt(largest[at.col()]))
                throw InvalidInput(fmt::format(
                    "{}: expected a symmetric matrix {} of finite numbers, but entries ({}, {}) "
                    "and ({}, {}) differ by {:.2g}",
                    what, name, i, at.col(), at.col(), i, std::abs(at.value())));
}

/// Throws unless entries, or those of the diagonal, are positive; `name` says of what.
void check_weights(const Weights& weights, const char* name) {
    if (const auto* matrix = std::get_if<SparseMatrix>(&weights))
        check_symmetric(*matrix, name);
    const Vector numbers = diagonal(weights);
    for (Index i = 0; i < numbers.size(); ++i)
        if (!(numbers[i] > 0) || !std::isfinite(numbers[i]))
            throw InvalidInput(fmt::format("{}: entry {} of {} is {}, expected a positive number",
                                           what, i, name, numbers[i]));
}

void check_part(const GramPart& part, Eigen::Index size) {
    const auto* numbers = std::get_if<Vector>(&part.weights);
    const auto* matrix = std::get_if<SparseMatrix>(&part.weights);
    const auto* inverse = std::get_if<InverseWeights>(&part.weights);
    const auto count = numbers  ? numbers->size()
                       : matrix ? matrix->rows()
                                : diagonal(inverse->W).size();
    const bool fits =
        part.F.cols() == size && part.F.rows() == count &&
        (part.uncertainty.size() == 0 || (numbers && part.uncertainty.size() == count)) &&
        (part.F_error.size() == 0 ||
         (part.F_error.rows() == part.F.rows() && part.F_error.cols() == size));
    if (!fits)
        throw InvalidInput(fmt::format("{}: a part F^T W F of A has a {} x {} matrix F, {} weights "
                                       "and {} uncertainties; M has {} entries",
                                       what, part.F.rows(), part.F.cols(), count,
                                       part.uncertainty.size(), size));
    if (matrix || inverse)
        check_weights(inverse ? inverse->W : Weights(*matrix), "W");
    if ((numbers && !numbers->allFinite()) || !is_finite(part.F) || !is_finite(part.F_error))
        throw InvalidInput(fmt::format("{}: a number of a part F^T W F is not finite", what));
    if (!part.uncertainty.allFinite() || (part.uncertainty.array() < 0).any())
        throw InvalidInput(fmt::format(
            "{}: an uncertainty of a part F^T W F is not a finite number of at least 0", what));
}

void check(const Pencil& pencil) {
    const auto size = diagonal(pencil.M).size();
    const auto& C = pencil.C;
    const bool has_C = C.size() > 0 || pencil.parts.empty();
    if (size == 0 || (has_C && (C.rows() != C.cols() || C.rows() != size)))
        throw InvalidInput(
            fmt::format("{}: A is {} x {}, M has {} entries; expected equal sizes above 0", what,
                        C.rows(), C.cols(), size));
    if (C.size() > 0)
        check_symmetric(C, "C");
    if (!(pencil.mass_uncertainty >= 0) || !(pencil.mass_uncertainty < 1))
        throw InvalidInput(
            fmt::format("{}: the relative error of M is {}, expected a number from 0 to 1", what,
                        pencil.mass_uncertainty));
    check_weights(pencil.M, "M");
    std::ptrdiff_t inverses = 0;
    for (const GramPart& part : pencil.parts) {
        check_part(part, size);
        inverses += std::holds_alternative<InverseWeights>(part.weights) ? 1 : 0;
    }
    if (inverses > 1)
        throw InvalidInput(
            fmt::format("{}: {} parts have inverse weights, expected at most one", what, inverses));
}

/// What makes numbers 1, from both sides.
Vector to_ones(const Vector& sizes) {
    return sizes.unaryExpr([](double size) { return size > 0 ? 1 / std::sqrt(size) : 0.0; });
}

} // namespace

ScaledPencil::ScaledPencil(const Pencil& pencil)
    : mass_share_(pencil.mass_uncertainty / (1 - pencil.mass_uncertainty)) {
    check(pencil);
    columns_ = powers_of_two(diagonal(pencil.M), -1);
    mass_ = make_mass(congruent(pencil.M, columns_));
    if (pencil.C.size() > 0)
        C_ = symmetric_part(columns_.asDiagonal() * pencil.C * columns_.asDiagonal());
    for (const GramPart& part : pencil.parts)
        if (part.F.rows() > 0)
            parts_.push_back(make_scaled_part(part, columns_));
    for (const auto& part : parts_) {
        weights_share_ += part->largest_share();
        if (part->inverse_of())
            inverse_ = part.get();
    }
    if (C_.size() > 0 && weights_share_ > 0)
        weights_share_ = std::numeric_limits<double>::infinity(); // C is of any sign
    normalize();
    assemble();
}

/// Largest entries of about 1.
void ScaledPencil::normalize() {
    constexpr int none = std::numeric_limits<int>::min();
    int half = none;
    if (const double largest = largest_entry(C_); largest > 0)
        half = static_cast<int>(std::floor((std::ilogb(largest) + 1) / 2.0));
    for (const auto& part : parts_)
        if (const double largest = largest_entry(part->F()); largest > 0)
            half = std::max(half, std::ilogb(largest));
    if (half == none)
        half = 0;
    exponent_ = 2 * half;
    scale_entries(C_, -exponent_);
    for (const auto& part : parts_)
        part->scale(-half);
}

void ScaledPencil::assemble() {
    SparseMatrix A = C_;
    if (A.size() == 0)
        A.resize(size(), size());
    SparseMatrix inverse_part(size(), size());
    for (const auto& part : parts_)
        (part.get() == inverse_ ? inverse_part : A) += part->lumped();
    const Vector scale = mass_->diagonal().cwiseSqrt().cwiseInverse();
    const SparseMatrix lumped =
        symmetric_part(scale.asDiagonal() * SparseMatrix(A + inverse_part) * scale.asDiagonal());
    norm_ = row_sum_norm(lumped) / mass_->dominance();
    small_ = small_length(lumped);
    if (is_explicit()) {
        matrices_ = {std::make_shared<const SparseMatrix>(lumped),
                     diagonal_matrix(Vector::Ones(size()))};
        return;
    }
    A = symmetric_part(A);
    SparseMatrix F(0, size()), W(0, 0);
    if (inverse_) {
        F = inverse_->F();
        W = inverse_->inverse_of()->matrix();
    }
    const auto hidden = static_cast<Index>(W.rows());
    matrices_ = {
        std::make_shared<const SparseMatrix>(block_matrix(-W, F.transpose(), A)),
        block_matrix(SparseMatrix(hidden, hidden), SparseMatrix(size(), hidden), mass_->matrix()),
        hidden};
}

DenseMatrix ScaledPencil::to_matrices(const DenseMatrix& Y) const {
    if (is_explicit())
        return Y;
    DenseMatrix result = DenseMatrix::Zero(matrices_.A->rows(), Y.cols());
    result.bottomRows(size()) = mass_->transposed_root(Y);
    return result;
}

DenseMatrix ScaledPencil::from_matrices(const DenseMatrix& Z) const {
    if (is_explicit())
        return Z;
    return mass_->root(Z.bottomRows(size()));
}

/// Where all weights are positive for sure, a share by which they are off is one of x^T A x at
/// most, and so of each eigenvalue.
Doubt ScaledPencil::doubt() const {
    const bool is_share = std::isfinite(weights_share_);
    Vector sizes = Vector::Zero(size());
    if (C_.size() > 0)
        sizes += C_.diagonal().cwiseAbs();
    for (const auto& part : parts_)
        if (part.get() != inverse_)
            sizes += part->sizes();
    Vector unroot = Vector::Ones(size());
    if (is_explicit())
        unroot = mass_->diagonal().cwiseSqrt().cwiseInverse();
    sizes = sizes.cwiseProduct(unroot).cwiseProduct(unroot);
    const Vector x = unroot.cwiseProduct(to_ones(sizes));
    Vector sums = Vector::Zero(size());
    if (C_.size() > 0)
        sums += 6 * unit * (C_.cwiseAbs() * x);
    for (const auto& part : parts_)
        if (part.get() != inverse_)
            sums += part->doubts(x, !is_share);
    Doubt doubt{sizes, 0, mass_share_ + (is_share ? weights_share_ : 0)};
    if (inverse_)
        add_hidden(doubt, x, sums);
    doubt.share = std::max(doubt.share, sums.cwiseProduct(x).maxCoeff());
    return doubt;
}

/// The rows above, and what the columns there add to the sums of the others.
void ScaledPencil::add_hidden(Doubt& doubt, const Vector& scaling, Vector& sums) const {
    const Mass& W = *inverse_->inverse_of();
    const Vector hidden = to_ones(W.diagonal());
    const SparseMatrix error = 2 * unit * inverse_->F().cwiseAbs() + inverse_->F_error();
    const Vector of_hidden = 2 * unit * W.spread(hidden) + error * scaling;
    sums += SparseMatrix(error.transpose()) * hidden;
    doubt.share = of_hidden.cwiseProduct(hidden).maxCoeff();
    Vector sizes(W.size() + size());
    sizes << W.diagonal(), doubt.sizes;
    doubt.sizes = sizes;
}

Image ScaledPencil::apply(const Vector& x) const {
    Image image{LongVector::Zero(x.size()), Vector::Zero(x.size()), Vector::Zero(x.size())};
    if (C_.size() > 0) {
        image.Ax = multiply(C_, false, x, image.rounding);
        image.doubt = image.rounding;
        image.energy = std::numeric_limits<double>::infinity();
    }
    for (const auto& part : parts_)
        part->add_to(image, x);
    return image;
}

Enclosure ScaledPencil::enclose(const Vector& x, Image& image, LongVector& residual) const {
    Vector error;
    const LongVector product = mass_->times(x.cast<long double>(), error);
    long double energy = 0, square = 0, given = 0, given_mass = 0;
    for (Index i = 0; i < size(); ++i) {
        energy += image.Ax[i] * x[i];
        square += product[i] * x[i];
    }
    Enclosure result;
    result.value = static_cast<double>(energy / square);
    residual = image.Ax - static_cast<long double>(result.value) * product;

    // in the scale given, columns_.minCoeff() / columns_ stands for M^-1
    const double smallest = columns_.minCoeff();
    for (Index i = 0; i < size(); ++i) {
        const double own =
            std::abs(result.value) *
            (4 * unit_roundoff() * static_cast<double>(std::abs(product[i])) + error[i]);
        image.rounding[i] += own;
        image.doubt[i] += own;
        const long double unscaled = smallest / columns_[i];
        given += unscaled * residual[i] * unscaled * residual[i];
        given_mass += unscaled * product[i] * unscaled * product[i];
    }
    const long double known =
        std::sqrt(mass_->inverse_square(residual)) + std::sqrt(norm_) * image.lost;
    // what the sums above have lost is far below a millionth
    constexpr double safety = 1 + 1e-6;
    // uncertain weights count by what they do to A x, or by their share of every eigenvalue
    const auto widened = [&](long double certain) {
        const auto radius = [&](const Vector& sizes, double share) {
            const auto absolute = static_cast<double>(
                (certain + std::sqrt(mass_->inverse_square_bound(sizes))) / std::sqrt(square));
            return safety * (absolute * (1 + share) + share * std::abs(result.value));
        };
        return std::min(radius(image.doubt, mass_share_),
                        radius(image.rounding, mass_share_ + weights_share_ * (1 + mass_share_)));
    };
    result.radius = widened(known);
    result.doubt = widened(std::sqrt(norm_) * image.lost);
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
            const Vector x = mass_->unroot(Y.col(i));
            Image image = apply(x);
            LongVector residual;
            enclosures[i] = enclose(x, image, residual);
            if (residuals)
                residuals->col(i) = mass_->transposed_unroot(residual.cast<double>());
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
    return columns_.asDiagonal() * mass_->unroot(Y);
}

DenseMatrix ScaledPencil::scaled(const DenseMatrix& X) const {
    return mass_->root(columns_.cwiseInverse().asDiagonal() * X);
}

} // namespace polydec
