// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.h"
#include "base/types.h"

namespace polydec {

/// Orthonormal columns that grow by blocks, for block Krylov methods. Works by matrix products on
/// whole blocks; allocates memory for all columns at once.
class OrthonormalBasis {
public:
    /// Reserves `capacity` columns of `rows` entries, capacity <= rows; the basis is empty at
    /// first.
    OrthonormalBasis(Eigen::Index rows, Eigen::Index capacity);

    Eigen::Index size() const { return size_; }

    /// The columns first, first + 1, .., as a view.
    auto columns(Eigen::Index first, Eigen::Index count) const {
        return columns_.middleCols(first, count);
    }

    /// Appends as many columns as W has: an orthonormal basis N of the part of W outside the span.
    /// This part is N R; returns R. Vectors of length at most `floor` count as zero. If W has too
    /// few new directions, pseudo-random ones fill up, with zero rows in R. W is overwritten.
    /// Throws InvalidInput if the capacity is exceeded, SolverFailure if W holds NaN or infinity.
    DenseMatrix append(DenseMatrix& W, double floor);

    /// Replaces the first S.rows() columns by their product with S, which must be orthonormal
    /// itself; the later columns move up.
    void combine(const DenseMatrix& S);

private:
    DenseMatrix orthonormalize(DenseMatrix& W, double floor);
    DenseMatrix orthonormalize_one_by_one(DenseMatrix& W, double floor);
    void fill_with_noise(DenseMatrix& W, Eigen::Index j);

    DenseMatrix columns_;
    DenseMatrix scratch_;
    Eigen::Index size_ = 0;
    Noise noise_{7};
};

} // namespace polydec
