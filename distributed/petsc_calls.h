// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/communicator.h"
#include "distributed/petsc.h"

namespace polydec {

inline MPI_Comm communicator(const Ranks& ranks) {
    return ranks.state().communicator;
}

/// Ends the program on all ranks if `error` is one: inside a PETSc collective the other ranks wait,
/// so they cannot vote on it.
void require(PetscErrorCode error, const char* what);

/// Throws InvalidInput for numbers beyond PETSc's range.
PetscInt petsc_number(GlobalIndex number);

/// The result of a PETSc function such as MatTranspose.
template <class Make>
OwnedMat made(const char* what, Make make) {
    Mat matrix = nullptr;
    require(make(&matrix), what);
    return OwnedMat(matrix);
}

OwnedMat copied(Mat matrix);
OwnedMat transposed(Mat matrix);
OwnedMat multiplied(Mat A, Mat B);

/// Collective: A x, own rows.
Vector product(const Ranks& ranks, Mat A, const Vector& x);

} // namespace polydec
