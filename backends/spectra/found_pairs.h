// SPDX-License-Identifier: MIT
#pragma once

#include "backends/blas.h"
#include "backends/spectra/scaled_pencil.h"

#include <functional>
#include <vector>

namespace polydec {

/// The eigenpairs of a pencil found so far, values ascending, with their accuracy.
class FoundPairs {
public:
    /// X^T Y, for local or distributed rows.
    using Products = std::function<DenseMatrix(const DenseMatrix& X, const DenseMatrix& Y)>;

    /// Starts empty; values below `small` in size may be zero.
    FoundPairs(Index size, double small, Products products = transposed_product)
        : vectors_(size, 0), small_(small), products_(std::move(products)) {}

    Index count() const { return static_cast<Index>(values_.size()); }
    const Vector& values() const { return values_; }

    /// Nearly orthonormal columns, in the scale of unit mass.
    const DenseMatrix& vectors() const { return vectors_; }

    /// Each value and an eigenvalue, matched one to one, are within the radius. Values with
    /// overlapping intervals form a group. All values of a group have the same radius, the norm of
    /// their residuals over the smallest singular value of their vectors, and intervals of
    /// different groups are disjoint. Source: Kahan 1967; Parlett 1980, section 11.5. Zeros of a
    /// semidefinite matrix lie between 0 and the sum of their energies, if that is sharper.
    const Vector& radii() const { return radii_; }

    /// |A x - value M x| / |M x|, 2-norms, as in Enclosure.
    const Vector& residuals() const { return residuals_; }

    /// Adds pairs.
    void take(const DenseMatrix& vectors, const std::vector<Enclosure>& enclosures);

    /// Keeps only these pairs, in ascending order.
    void keep(const std::vector<Index>& chosen);

    /// Projects their span out of every column.
    template <class Columns>
    void project_out(Columns& X) const {
        if (count() > 0)
            add_product(-1, vectors_, products_(vectors_, X), 1, X);
    }

    /// Whether the radius of pair i is at most this share of its value or of its distance to the
    /// next distinguishable values.
    bool is_accurate(Index i, double share) const;

    /// Whether pair i needs no more accuracy, or cannot get more.
    bool is_fine(Index i) const;

    /// The indices of the fine pairs, or of the others.
    std::vector<Index> all(bool fine) const;

    /// The number of leading fine pairs among the first `count`.
    Index fine_before(Index count) const;

    /// The first index i >= count with a gap between values i-1 and i; -1 if none is known.
    Index gap_behind(Index count) const;

private:
    double distance_to_others(Index i) const;

    Vector values_, lone_radii_, doubts_, energies_, radii_, residuals_;
    DenseMatrix vectors_, gram_;
    double small_;
    Products products_;
};

/// Adds vectors known to have the eigenvalue zero, one per column, in unknowns of the pencil, so
/// that iterations need not find every copy of it.
void take_kernel(FoundPairs& pairs, const ScaledPencil& pencil, const DenseMatrix& vectors);

/// Adds the vectors, one per column, that their radii prove to be eigenvectors of distinct pairs;
/// drops the others. Throws InvalidInput for vectors of wrong size or that are not finite.
void take_proved(FoundPairs& pairs, const ScaledPencil& pencil, DenseMatrix vectors);

/// The indices below `count` of values not known to 1e-6 of the value or of its distance to the
/// next ones. Throws SolverFailure, naming it, for a value that its radius does not separate from
/// these. `norm` bounds all eigenvalues; messages multiply values by `unit`.
std::vector<Index> rough_values(const FoundPairs& pairs, double norm, double unit, Index count);

} // namespace polydec
