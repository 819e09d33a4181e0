// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/inertia.h"
#include "backends/spectra/mass.h"
#include "backends/spectra/pencil.h"
#include "backends/spectra/scaled_part.h"

#include <memory>
#include <vector>

namespace polydec {

/// The enclosure from an approximate eigenvector x: an eigenvalue of the pencil lies within
/// `radius` of its Rayleigh quotient `value`.
struct Enclosure {
    double value = 0;
    double radius = 0;
    double doubt = 0;  ///< the part of it that no better x could remove
    double energy = 0; ///< bounds x^T A x / x^T M x if A is surely semidefinite, else infinite
    double residual =
        0; ///< |A x - value M x| / |M x| in 2-norms, x in the units of the pencil given
};

/// A pencil scaled by powers of two, so without rounding, to masses and weights of size 1 and a
/// matrix of norm about 1, in any units. Eigenvectors are stored in the scale of unit mass: y = R
/// x, M = R^T R. The matrix of the pencil is then B = R^-T A R^-1.
class ScaledPencil {
public:
    /// Throws InvalidInput for sizes that do not fit, entries that are not finite or, in M, not
    /// positive, a matrix C that is not symmetric, matrices M or weights that are not positive
    /// definite, invalid uncertainties, and entries whose ratio exceeds the range of numbers.
    explicit ScaledPencil(const Pencil& pencil);

    Index size() const { return mass_->size(); }

    /// Represent B - shift I as a Schur complement; B itself if M is diagonal and no weights are
    /// inverse.
    const ShiftedMatrices& matrices() const { return matrices_; }

    /// Maps a right-hand side for B - shift I to these matrices, and their solution back.
    DenseMatrix to_matrices(const DenseMatrix& Y) const;
    DenseMatrix from_matrices(const DenseMatrix& Z) const;

    /// An upper bound on the absolute values of the eigenvalues.
    double norm() const { return norm_; }

    /// See small_length.
    double small() const { return small_; }

    /// The error bounds of the matrix A of matrices() relative to the pencil: from rounding of its
    /// entries, and from the uncertainties.
    Doubt doubt() const;

    /// The enclosures from the columns of Y, with residuals in extended precision where available:
    /// |A x - theta M x| in the M^-1-norm over |x| in the M-norm, plus the rounding of this
    /// residual and the uncertainties of weights and masses. `residuals`, if given, receives R^-T
    /// (A X - M X theta).
    std::vector<Enclosure> enclose(const DenseMatrix& Y, DenseMatrix* residuals = nullptr) const;

    /// Eigenvalues, and quantities in the same units, in the units of the given pencil.
    double eigenvalue(double scaled) const;
    Vector eigenvalues(const Vector& scaled) const;

    /// Eigenvectors x in the units of the given pencil, x^T M x = y^T y; and y for these.
    DenseMatrix eigenvectors(const DenseMatrix& Y) const;
    DenseMatrix scaled(const DenseMatrix& X) const;

private:
    void normalize();
    void assemble();
    void add_hidden(Doubt& doubt, const Vector& scaling, Vector& sums) const;
    Image apply(const Vector& x) const;
    Enclosure enclose(const Vector& x, Image& image, LongVector& residual) const;

    /// Whether matrices() are B and I themselves.
    bool is_explicit() const { return mass_->is_diagonal() && !inverse_; }

    SparseMatrix C_; // this and all below: scaled
    std::vector<std::unique_ptr<ScaledPart>> parts_;
    const ScaledPart* inverse_ = nullptr; // the part with inverse weights, if there is one
    std::unique_ptr<const Mass> mass_;
    Vector columns_;           // x in given units = columns_ * (x here)
    int exponent_ = 0;         // eigenvalue = 2^exponent * scaled eigenvalue
    double mass_share_ = 0;    // bound on the shift of eigenvalues by errors of masses
    double weights_share_ = 0; // the same for weights; infinite unless all are surely positive
    double norm_ = 0, small_ = 0;
    ShiftedMatrices matrices_;
};

} // namespace polydec
