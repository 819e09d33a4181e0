// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/scaled_pencil.h"
#include "distributed/petsc.h"

namespace polydec {

/// The eigenproblem of a Laplacian over all ranks, A x = lambda M x with A = star_k Delta_k and M =
/// star_k. Vectors have own entries, in the scale in which the mass is 1: y = M^(1/2) x. Every
/// function is collective.
class SharedPencil {
public:
    /// Throws InvalidInput, naming the cells, if star_k or star_(k+1) is not positive, or
    /// star_(k-1) is negative or has a zero.
    SharedPencil(const Ranks& ranks, const DistributedCells& cells, int k);

    GlobalIndex size() const { return size_; }
    Index own_size() const { return static_cast<Index>(mass_.size()); }

    /// M^(-1/2) A M^(-1/2).
    Mat matrix() const { return B_.get(); }

    /// No eigenvalue is larger.
    double norm() const { return norm_; }

    /// A length on the axis below eigenvalues that are not zero: see small_length.
    double small() const { return small_; }

    /// What the columns of Y prove: see ScaledPencil. Residuals are evaluated in double precision
    /// from the parts of A; the radii include the rounding of that, and what the uncertainties of
    /// volumes can do.
    std::vector<Enclosure> enclose(const DenseMatrix& Y) const;

    /// x for the columns y.
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
    double mass_share_ = 0, // by which masses off by as much as may be move an eigenvalue
        roundoff_ = 0;
    OwnedMat B_;
    double norm_ = 0, small_ = 0;
};

} // namespace polydec
