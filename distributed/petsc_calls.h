// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/communicator.h"
#include "distributed/petsc.h"

namespace polydec {

inline MPI_Comm communicator(const Ranks& ranks) {
    return ranks.state().communicator;
}

/// An error of one rank within a collective of PETSc cannot be voted on, since the others wait for
/// it: ends the program, on all ranks.
void require(PetscErrorCode error, const char* what);

/// Throws InvalidInput for more than PETSc can count.
PetscInt petsc_number(GlobalIndex number);

/// What a function makes, such as MatTranspose.
template <class Make>
OwnedMat made(const char* what, Make make) {
    Mat matrix = nullptr;
    require(make(&matrix), what);
    return OwnedMat(matrix);
}

/// Collective: A x, of own rows.
Vector product(const Ranks& ranks, Mat A, const Vector& x);

} // namespace polydec
