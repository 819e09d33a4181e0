// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/mass.h"
#include "backends/spectra/pencil.h"

#include <memory>

namespace polydec {

/// A x of a pencil, with error bounds.
struct Image {
    LongVector Ax;
    Vector rounding;   ///< rounding error bound of Ax, entry by entry
    Vector doubt;      ///< the same, with the uncertainties of weights
    double energy = 0; ///< upper bound on x^T A x
    /// The error of solves with inverse weights W^-1, in their norm. Times the root of the largest
    /// eigenvalue, it bounds the error of Ax in the M^-1-norm.
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

    /// Adds the contribution of this part to A x.
    void add_to(Image& image, const Vector& x) const;

    /// F^T W F; for inverse weights with only the diagonal of W, enlarged to an upper bound.
    SparseMatrix lumped() const;

    /// For inverse weights: the mass W, and the error bounds of F; else null and 0 x 0.
    virtual const Mass* inverse_of() const { return nullptr; }
    const SparseMatrix& F_error() const { return F_error_; }

    /// |F|^T E |F| x, where E bounds the errors of the weights in the sum F^T W F if that is
    /// formed: from rounding and, if requested, from uncertainty; and from the errors of F itself.
    Vector doubts(const Vector& x, bool with_uncertainty) const;

    /// An upper bound on the diagonal of F^T |W| F.
    Vector sizes() const;

    /// The largest relative uncertainty of a weight; infinity if one may not be positive.
    virtual double largest_share() const { return 0; }

protected:
    ScaledPart(const GramPart& part, const Vector& rows, const Vector& columns);

    /// W y with its error bounds: on input `error` is for y, on output for W y.
    virtual LongVector weigh(const LongVector& y, Vector& error, Vector& unknown,
                             Image& image) const = 0;
    virtual SparseMatrix weights() const = 0;
    virtual Vector spread(const Vector& sizes) const = 0; ///< |W| sizes
    virtual Vector uncertainty() const { return Vector::Zero(F_.rows()); }

private:
    SparseMatrix F_, F_error_;
    Index longest_column_ = 0;    // of F
    bool exact_products_ = false; // when multiplying entries of F
    double rounding_ = 0;         // of a sum F^T (W F x), relative to its terms
};

/// The part with its columns multiplied by these powers of two. Throws like make_mass.
std::unique_ptr<ScaledPart> make_scaled_part(const GramPart& part, const Vector& columns);

/// 2^(sign e) with 1/2 <= |x| 2^-2e < 2; 1 for 0.
Vector powers_of_two(const Vector& x, int sign);

/// A 2^exponent. Throws InvalidInput if an entry leaves the normal range.
void scale_entries(SparseMatrix& A, int exponent);

/// A x, and a bound on its error. Differences of neighboring values are exact, so the partial sums
/// dominate.
LongVector multiply(const SparseMatrix& A, bool exact_products, const Vector& x, Vector& error);

} // namespace polydec
