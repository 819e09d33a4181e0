// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/mass.h"
#include "backends/spectra/pencil.h"

#include <memory>

namespace polydec {

/// A x of a pencil, and what is known of its accuracy.
struct Image {
    LongVector Ax;
    Vector rounding;   ///< what this has done to Ax at most, entry by entry
    Vector doubt;      ///< and with it the uncertainties of weights
    double energy = 0; ///< above x^T A x
    /// What solving with inverse weights W^-1 has lost, in their norm: times the root of the
    /// largest eigenvalue it is what Ax has lost in the norm of M^-1.
    double lost = 0;
};

/// A part F^T W F of a pencil, rows of F and weights scaled by powers of two.
class ScaledPart {
public:
    ScaledPart(const ScaledPart&) = delete;
    ScaledPart& operator=(const ScaledPart&) = delete;
    virtual ~ScaledPart() = default;

    const SparseMatrix& F() const { return F_; }

    /// F 2^exponent.
    void scale(int exponent);

    /// Adds what it makes of x.
    void add_to(Image& image, const Vector& x) const;

    /// F^T W F; with the diagonal of W alone where that is an inverse, larger by as much as makes
    /// it an upper bound.
    SparseMatrix lumped() const;

    /// Where W is an inverse: what of, and how far F may be off; else null and 0 x 0.
    virtual const Mass* inverse_of() const { return nullptr; }
    const SparseMatrix& F_error() const { return F_error_; }

    /// |F|^T E |F| x, E what the weights in the sum F^T W F are off by, where that is formed: by
    /// rounding, and by their uncertainty if that is asked for; and what F itself is.
    Vector doubts(const Vector& x, bool with_uncertainty) const;

    /// At least the diagonal of F^T |W| F.
    Vector sizes() const;

    /// The largest part of a weight that is uncertain; infinity where one may not be positive.
    virtual double largest_share() const { return 0; }

protected:
    ScaledPart(const GramPart& part, const Vector& rows, const Vector& columns);

    /// Wy, and what is to be told of it: error, that of y, becomes that of Wy.
    virtual LongVector weigh(const LongVector& y, Vector& error, Vector& unknown,
                             Image& image) const = 0;
    virtual SparseMatrix weights() const = 0;
    virtual Vector spread(const Vector& sizes) const = 0; ///< |W| sizes
    virtual Vector uncertainty() const { return Vector::Zero(F_.rows()); }

    double rounding() const { return rounding_; }

private:
    SparseMatrix F_, transposed_, F_error_;
    bool exact_products_ = false; // with entries of F
    double rounding_ = 0;         // of a sum F^T (W F x), relative to its terms
};

/// The part with its columns multiplied by these powers of two. Throws like make_mass.
std::unique_ptr<ScaledPart> make_scaled_part(const GramPart& part, const Vector& columns);

/// 2^(sign e) with 1/2 <= |x| 2^-2e < 2; 1 for 0.
Vector powers_of_two(const Vector& x, int sign);

/// A 2^exponent. Throws InvalidInput where an entry does not remain a normal number.
void scale_entries(SparseMatrix& A, int exponent);

double largest_entry(const SparseMatrix& A);

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
        error[i] = unit_roundoff() * sizes;
    }
}

} // namespace polydec
