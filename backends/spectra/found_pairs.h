// SPDX-License-Identifier: MIT
#pragma once

#include "backends/blas.h"
#include "backends/spectra/scaled_pencil.h"

#include <functional>
#include <vector>

namespace polydec {

/// The eigenpairs of a pencil found so far, values ascending, and what is known of their accuracy.
class FoundPairs {
public:
    /// X^T Y, wherever the rows of vectors are.
    using Products = std::function<DenseMatrix(const DenseMatrix& X, const DenseMatrix& Y)>;

    /// None; values below `small` in size may be zero.
    FoundPairs(
        Index size, double small,
        Products products = [](const DenseMatrix& X, const DenseMatrix& Y) -> DenseMatrix {
            return transposed_product(X, Y);
        })
        : vectors_(size, 0), small_(small), products_(std::move(products)) {}

    Index count() const { return static_cast<Index>(values_.size()); }
    const Vector& values() const { return values_; }

    /// Nearly orthonormal columns, in the scale in which the mass is 1.
    const DenseMatrix& vectors() const { return vectors_; }

    /// As many eigenvalues as there are values lie each within its radius, matched one to one:
    /// values whose intervals overlap make a group, in which all have the same radius, the norm of
    /// their residuals over the smallest singular value of their vectors, and the intervals of two
    /// groups do not meet. Source: Kahan 1967; Parlett 1980, section 11.5. Zeros of a semidefinite
    /// matrix lie between 0 and the sum of their energies, where that says more.
    const Vector& radii() const { return radii_; }

    /// |A x - value M x| / |M x|, 2-norms, as in Enclosure.
    const Vector& residuals() const { return residuals_; }

    /// Puts more pairs to those found.
    void take(const DenseMatrix& vectors, const std::vector<Enclosure>& enclosures);

    /// Gives up all others than these, in ascending order.
    void keep(const std::vector<Index>& chosen);

    /// Takes the part in their space out of every column.
    template <class Columns>
    void project_out(Columns& X) const {
        if (count() > 0)
            add_product(-1, vectors_, products_(vectors_, X), 1, X);
    }

    /// Whether the radius of pair i is at most this share of its value or of its distance to the
    /// next ones that can be told from it.
    bool is_accurate(Index i, double share) const;

    /// Whether more accuracy of pair i need not be striven for, or cannot be had.
    bool is_fine(Index i) const;

    /// Those that are fine, or the others.
    std::vector<Index> all(bool fine) const;

    /// How many of the first `count` are fine, up to the first that is not.
    Index fine_before(Index count) const;

    /// The first index i >= count such that a gap lies between values i-1 and i; -1 if none is
    /// seen.
    Index gap_behind(Index count) const;

private:
    double distance_to_others(Index i) const;

    Vector values_, lone_radii_, doubts_, energies_, radii_, residuals_;
    DenseMatrix vectors_, gram_;
    double small_;
    Products products_;
};

/// Puts to those found vectors that are known to have the eigenvalue zero, a column each, given as
/// unknowns of the pencil: so that iterations need not find copy after copy of it.
void take_kernel(FoundPairs& pairs, const ScaledPencil& pencil, const DenseMatrix& vectors);

/// Puts to those found the vectors, a column each, whose radii prove that they are eigenvectors,
/// each of another pair; the others are left out. Throws InvalidInput for vectors of another size,
/// or that are not finite.
void take_proved(FoundPairs& pairs, const ScaledPencil& pencil, DenseMatrix vectors);

/// Those of the first `count` values that are not known to 1e-6 of them or of their distance to the
/// next ones. Throws SolverFailure, naming it, for one that its radius does not tell from those. No
/// eigenvalue is larger than `norm`; `unit` is what messages multiply values by.
std::vector<Index> rough_values(const FoundPairs& pairs, double norm, double unit, Index count);

} // namespace polydec
