// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/pencil.h"
#include "base/types.h"

#include <memory>

namespace polydec {

using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// The machine epsilon of the numbers in LongVector.
double unit_roundoff();

/// The largest number of entries in a row.
Index longest_row(const SparseMatrix& A);

/// A positive definite matrix M = R^T R, R diagonal or sparse, as an operator.
class Mass {
public:
    Mass(const Mass&) = delete;
    Mass& operator=(const Mass&) = delete;
    virtual ~Mass() = default;

    Index size() const { return static_cast<Index>(diagonal_.size()); }
    const Vector& diagonal() const { return diagonal_; }

    /// Some a <= 1 with M >= a diag(M). For a matrix it comes from inverse iteration, with a
    /// margin.
    double dominance() const { return dominance_; }

    virtual bool is_diagonal() const = 0;
    virtual SparseMatrix matrix() const = 0;

    /// M x, and a bound on its error.
    virtual LongVector times(const LongVector& x, Vector& error) const = 0;

    /// An upper bound on |M x|, entry by entry, for all x with |x_i| <= sizes_i.
    virtual Vector spread(const Vector& sizes) const = 0;

    /// M^-1 z, to nearly full accuracy, and a bound on the residual of M times it.
    virtual LongVector solve(const LongVector& z, Vector& error) const = 0;

    /// R X, R^-1 X, R^T X and R^-T X.
    virtual DenseMatrix root(const DenseMatrix& X) const = 0;
    virtual DenseMatrix unroot(const DenseMatrix& X) const = 0;
    virtual DenseMatrix transposed_root(const DenseMatrix& X) const = 0;
    virtual DenseMatrix transposed_unroot(const DenseMatrix& X) const = 0;

    /// x^T M^-1 x, and an upper bound on it for all x with |x_i| <= sizes_i.
    virtual long double inverse_square(const LongVector& x) const = 0;
    long double inverse_square_bound(const Vector& sizes) const;

protected:
    Mass(Vector diagonal, double dominance)
        : diagonal_(std::move(diagonal)), dominance_(dominance) {}

    Vector diagonal_;
    double dominance_;
};

/// The numbers, or the diagonal of the matrix.
Vector diagonal(const Weights& weights);

/// (B + B^T) / 2.
SparseMatrix symmetric_part(const SparseMatrix& B);

/// D W D, D a diagonal.
Weights congruent(const Weights& W, const Vector& D);

/// Of a matrix, opposite entries count by their mean. Throws InvalidInput for numbers that are not
/// positive and matrices that are not positive definite; SolverFailure if the root of a matrix
/// exceeds memory.
std::unique_ptr<const Mass> make_mass(const Weights& weights);

} // namespace polydec
