// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.h"
#include "base/types.h"

namespace polydec {

/// Orthonormal columns that grow by blocks, for block Krylov methods. Everything is done by matrix
/// products on whole blocks; memory for all columns is taken at once.
class OrthonormalBasis {
public:
    /// Room for `capacity` columns of `rows` entries, capacity <= rows; there are none at first.
    OrthonormalBasis(Eigen::Index rows, Eigen::Index capacity);

    Eigen::Index size() const { return size_; }

    /// The columns first, first + 1, .., as a view.
    auto columns(Eigen::Index first, Eigen::Index count) const {
        return columns_.middleCols(first, count);
    }

    /// Appends as many columns as W has, an orthonormal basis N of what W has outside of the span:
    /// the part of W there is N R, and R is returned. What is not longer than `floor` counts as
    /// zero. Where W so has too few directions, pseudo-random ones fill up and the rows of R that
    /// belong to them are zero. W is used as working space.
    /// Throws InvalidInput if there is no room, SolverFailure if W holds NaN or infinity.
    DenseMatrix append(DenseMatrix& W, double floor);

    /// The first S.rows() columns make way for the columns of their product with S, which must be
    /// orthonormal itself; the columns behind them follow.
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
