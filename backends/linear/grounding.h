// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// Regularizes a symmetric matrix A with known kernel: as many unknowns as the kernel's dimension
/// are set to zero (grounded). The choice leaves A regular, with its inertia: the omitted rows
/// depend on the others.
class Kernel {
public:
    /// basis: n rows, columns spanning the kernel. Throws InvalidInput if it does not fit A, is not
    /// finite, has dependent columns, or if A times a column is not zero (to 1e-8 |A|).
    Kernel(const SparseMatrix& A, const DenseMatrix& basis);

    /// A without the rows and columns of the grounded unknowns.
    SparseMatrix grounded(const SparseMatrix& A) const;

    /// The rows of B that are not grounded; the reverse, with zeros in the others.
    DenseMatrix restrict(const DenseMatrix& B) const;
    DenseMatrix extend(const DenseMatrix& X) const;

    /// B without its part in the kernel.
    DenseMatrix project_out(const DenseMatrix& B) const;

private:
    DenseMatrix basis_;        // orthonormal columns
    std::vector<Index> kept_;  // ascending
    std::vector<Index> place_; // of an unknown in kept_; -1 if grounded
};

} // namespace polydec
