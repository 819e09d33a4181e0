// SPDX-License-Identifier: MIT
#include "distributed/petsc_calls.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cstdio>
#include <limits>

namespace polydec {

void require(PetscErrorCode error, const char* what) {
    if (error == 0)
        return;
    const char* reason = nullptr;
    PetscErrorMessage(error, &reason, nullptr);
    std::fprintf(stderr, "PETSc failed while %s: %s\n", what, reason != nullptr ? reason : "");
    MPI_Abort(MPI_COMM_WORLD, 1);
}

PetscInt petsc_number(GlobalIndex number) {
    if (number > std::numeric_limits<PetscInt>::max())
        throw InvalidInput(fmt::format(
            "{} rows are too many: this PETSc supports at most {}; use a PETSc with 64-bit indices",
            number, std::numeric_limits<PetscInt>::max()));
    return static_cast<PetscInt>(number);
}

OwnedVec vector_of(const Ranks& ranks, const Vector& own) {
    Vec vector = nullptr;
    require(VecCreateMPI(communicator(ranks), static_cast<PetscInt>(own.size()), PETSC_DETERMINE,
                         &vector),
            "making a vector");
    OwnedVec result(vector);
    double* entries = nullptr;
    require(VecGetArray(vector, &entries), "filling a vector");
    std::copy(own.begin(), own.end(), entries);
    require(VecRestoreArray(vector, &entries), "filling a vector");
    return result;
}

Vector own_entries(Vec vector) {
    PetscInt size = 0;
    const double* entries = nullptr;
    require(VecGetLocalSize(vector, &size), "reading a vector");
    require(VecGetArrayRead(vector, &entries), "reading a vector");
    Vector result = Eigen::Map<const Vector>(entries, size);
    require(VecRestoreArrayRead(vector, &entries), "reading a vector");
    return result;
}

OwnedMat copied(Mat matrix) {
    return made("copying",
                [&](Mat* result) { return MatDuplicate(matrix, MAT_COPY_VALUES, result); });
}

OwnedMat transposed(Mat matrix) {
    return made("transposing",
                [&](Mat* result) { return MatTranspose(matrix, MAT_INITIAL_MATRIX, result); });
}

OwnedMat multiplied(Mat A, Mat B) {
    return made("multiplying", [&](Mat* result) {
        return MatMatMult(A, B, MAT_INITIAL_MATRIX, PETSC_DEFAULT, result);
    });
}

Vector product(const Ranks& ranks, Mat A, const Vector& x) {
    PetscInt rows = 0;
    require(MatGetLocalSize(A, &rows, nullptr), "multiplying");
    const OwnedVec right = vector_of(ranks, x), result = vector_of(ranks, Vector::Zero(rows));
    require(MatMult(A, right.get(), result.get()), "multiplying");
    return own_entries(result.get());
}

} // namespace polydec
