// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/scaled_pencil.h"
#include "distributed/petsc.h"

namespace polydec {

/// The eigenproblem of a Laplacian over all ranks, A x = lambda M x with A = star_k Delta_k and M =
/// star_k. Vectors have own entries, in the scale of unit mass: y = M^(1/2) x. Every function is
/// collective.
class SharedPencil {
public:
    /// Throws InvalidInput, naming the cells, if star_k or star_(k+1) is not positive, or
    /// star_(k-1) is negative or has a zero.
    SharedPencil(const Ranks& ranks, const DistributedCells& cells, int k);

    GlobalIndex size() const { return size_; }
    Index own_size() const { return static_cast<Index>(mass_.size()); }

    /// M^(-1/2) A M^(-1/2).
    Mat matrix() const { return B_.get(); }

    /// An upper bound on the eigenvalues.
    double norm() const { return norm_; }

    /// A length below the nonzero eigenvalues: see small_length.
    double small() const { return small_; }

    /// The enclosures from the columns of Y: see ScaledPencil. Residuals are evaluated in double
    /// precision from the parts of A; the radii include their rounding and the uncertainties of
    /// volumes.
    std::vector<Enclosure> enclose(const DenseMatrix& Y) const;

    /// The columns x for columns y.
    DenseMatrix eigenvectors(const DenseMatrix& Y) const;

    /// X^T Y over all ranks.
    DenseMatrix products(const DenseMatrix& X, const DenseMatrix& Y) const;

private:
    /// F^T W F.
    struct Part {
        OwnedMat F, transposed, sizes, transposed_sizes; ///< the last two: of |F|
        Vector weights, uncertainty;
    };
    struct SharedImage {
        Vector Ax, doubt;
    };

    void add_part(OwnedMat F, OwnedMat transposed, Vector weights, Vector uncertainty);
    void measure();
    SharedImage apply(const Vector& x) const;
    Enclosure enclose(const Vector& y) const;

    Ranks ranks_;
    GlobalIndex size_ = 0;
    std::vector<Part> parts_;
    Vector mass_;
    double mass_share_ = 0, // bound on the shift of eigenvalues by errors of masses
        roundoff_ = 0;
    OwnedMat B_;
    double norm_ = 0, small_ = 0;
};

} // namespace polydec
