// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cochain.h"
#include "distributed/cell_numbers.h"

#include <memory>
#include <petscmat.h>

namespace polydec {

/// PETSc objects, destroyed with their owners.
struct PetscDestroy {
    void operator()(_p_Mat* matrix) const { MatDestroy(&matrix); }
    void operator()(_p_Vec* vector) const { VecDestroy(&vector); }
};
using OwnedMat = std::unique_ptr<_p_Mat, PetscDestroy>;
using OwnedVec = std::unique_ptr<_p_Vec, PetscDestroy>;

/// Collective: the vector with these own entries on each rank.
OwnedVec vector_of(const Ranks& ranks, const Vector& own);

/// The own entries of a vector.
Vector own_entries(Vec vector);

// Operators over all ranks. Row i belongs to the cell with CellNumber::row i. All are collective,
// and throw InvalidInput for a degree that does not exist and for more cells than PETSc's numbers
// can count; an error inside PETSc ends the program.

/// d_k, from k-cells to (k+1)-cells, for k = 0..n-1.
OwnedMat coboundary(const Ranks& ranks, const DistributedCells& cells, int k);

/// Diagonal of star_k.
OwnedVec star(const Ranks& ranks, const DistributedCells& cells, int k);

/// d_k^T diag(weights) d_k, with a weight for every own (k+1)-cell, and d_k diag(weights) d_k^T,
/// with a weight for every own k-cell.
OwnedMat gram_of_columns(const Ranks& ranks, const DistributedCells& cells, int k,
                         const Vector& weights);
OwnedMat gram_of_rows(const Ranks& ranks, const DistributedCells& cells, int k,
                      const Vector& weights);

/// Laplace-de Rham operator on forms of this side and degree: see laplacian and dual_laplacian for
/// one process. Throws InvalidInput, naming the cells, if a star that it divides by has a zero.
OwnedMat laplacian(const Ranks& ranks, const DistributedCells& cells, Side side, int degree);

/// star_k Delta_k, symmetric. Throws InvalidInput, naming the cells, if star_(k-1) has a zero.
OwnedMat symmetric_laplacian(const Ranks& ranks, const DistributedCells& cells, int k);

} // namespace polydec
