// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/spectra/inertia.h"
#include "solvers/spectra/pencil.h"

#include <memory>
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
/// is 1: y = M^1/2 x.
class ScaledPencil {
public:
    /// Throws InvalidInput for sizes that do not fit, entries that are not finite or, of M,
    /// positive, a matrix C that is not symmetric, uncertainties that are no shares or sizes, and
    /// entries that differ by more than numbers can tell.
    explicit ScaledPencil(const Pencil& pencil);

    Index size() const { return static_cast<Index>(M_.size()); }

    /// M^-1/2 A M^-1/2, rounded: for factorizations.
    const std::shared_ptr<const SparseMatrix>& matrix() const { return matrix_; }

    /// How far this matrix may be from that of the pencil: by the rounding of its entries, and what
    /// the uncertainties can do.
    Doubt doubt() const;

    /// What the columns of Y prove, from residuals in more than double precision where there is:
    /// |A x - theta M x| in the norm of M^-1 over |x| in that of M, the rounding of this residual
    /// and what the uncertainties of weights and masses can do. Where residuals are asked for,
    /// they are M^-1/2 (A X - M X theta).
    std::vector<Enclosure> enclose(const DenseMatrix& Y, DenseMatrix* residuals = nullptr) const;

    /// Eigenvalues, and all that is measured like them, in the units of the pencil given.
    double eigenvalue(double scaled) const;
    Vector eigenvalues(const Vector& scaled) const;

    /// Eigenvectors x in the units of the pencil given, x^T M x = y^T y.
    DenseMatrix eigenvectors(const DenseMatrix& Y) const;

private:
    using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

    struct Part {
        SparseMatrix F, transposed;
        Vector weights, uncertainty;
        bool exact_products = false; // with entries of F
        double rounding = 0;         // of a sum F^T (W F x), relative to its terms
    };

    struct Image {
        LongVector Ax;
        Vector rounding;   // what this has done to Ax at most, entry by entry
        Vector doubt;      // and with it the uncertainties of weights
        double energy = 0; // above x^T A x
    };

    Part scaled(const GramPart& part) const;
    void normalize();
    void assemble();
    void add_part(const Part& part, const Vector& x, Image& image) const;
    Image apply(const Vector& x) const;
    Enclosure enclose(const Vector& x, const Image& image) const;

    SparseMatrix C_; // this and all below: scaled
    std::vector<Part> parts_;
    Vector M_, root_;
    Vector columns_;           // x in the units given = columns_ * (x here)
    int exponent_ = 0;         // eigenvalue = 2^exponent * scaled eigenvalue
    double mass_share_ = 0;    // by which masses off by as much as may be move an eigenvalue
    double weights_share_ = 0; // the same for weights; infinite unless all are surely positive
    std::shared_ptr<const SparseMatrix> matrix_;
};

} // namespace polydec
