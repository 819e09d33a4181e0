// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/inertia.h"
#include "backends/spectra/mass.h"
#include "backends/spectra/pencil.h"
#include "backends/spectra/scaled_part.h"

#include <memory>
#include <optional>
#include <vector>

namespace polydec {

/// What an approximate eigenvector x proves: an eigenvalue of the pencil lies within `radius` of
/// its Rayleigh quotient `value`.
struct Enclosure {
    double value = 0;
    double radius = 0;
    double doubt = 0;  ///< the part of it that no better x could take away
    double energy = 0; ///< above x^T A x / x^T M x if A is semidefinite for sure, else infinite
    double residual =
        0; ///< |A x - value M x| / |M x| in 2-norms, x in the units of the pencil given
};

/// A pencil brought by powers of two, so without rounding, to masses and weights of size 1 and a
/// matrix of norm about 1, whatever its units. Eigenvectors are kept in the scale in which the mass
/// is 1: y = R x, M = R^T R. There the matrix of the pencil is B = R^-T A R^-1.
class ScaledPencil {
public:
    /// Throws InvalidInput for sizes that do not fit, entries that are not finite or, of M,
    /// positive, a matrix C that is not symmetric, matrices M or weights that are not positive
    /// definite, uncertainties that are no shares or sizes, and entries that differ by more than
    /// numbers can tell.
    explicit ScaledPencil(const Pencil& pencil);

    Index size() const { return mass_->size(); }

    /// Where B - shift I is what remains; B itself where M is diagonal and no weights are inverse.
    const ShiftedMatrices& matrices() const { return *matrices_; }

    /// The right-hand side of these matrices for that of B - shift I, and what of their solution
    /// is its solution.
    DenseMatrix to_matrices(const DenseMatrix& Y) const;
    DenseMatrix from_matrices(const DenseMatrix& Z) const;

    /// No eigenvalue is larger in size.
    double norm() const { return norm_; }

    /// See small_length.
    double small() const { return small_; }

    /// How far the matrix A of matrices() may be from that of the pencil: by the rounding of its
    /// entries, and what the uncertainties can do.
    Doubt doubt() const;

    /// What the columns of Y prove, from residuals in more than double precision where there is:
    /// |A x - theta M x| in the norm of M^-1 over |x| in that of M, the rounding of this residual
    /// and what the uncertainties of weights and masses can do. Where residuals are asked for,
    /// they are R^-T (A X - M X theta).
    std::vector<Enclosure> enclose(const DenseMatrix& Y, DenseMatrix* residuals = nullptr) const;

    /// Eigenvalues, and all that is measured like them, in the units of the pencil given.
    double eigenvalue(double scaled) const;
    Vector eigenvalues(const Vector& scaled) const;

    /// Eigenvectors x in the units of the pencil given, x^T M x = y^T y; and y for those.
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
    const ScaledPart* inverse_ = nullptr; // the one with inverse weights, if there is one
    std::unique_ptr<const Mass> mass_;
    Vector columns_;           // x in the units given = columns_ * (x here)
    int exponent_ = 0;         // eigenvalue = 2^exponent * scaled eigenvalue
    double mass_share_ = 0;    // by which masses off by as much as may be move an eigenvalue
    double weights_share_ = 0; // the same for weights; infinite unless all are surely positive
    double norm_ = 0, small_ = 0;
    std::optional<ShiftedMatrices> matrices_;
};

} // namespace polydec
