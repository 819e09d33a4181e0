// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec::test {

/// Largest entry in size; 0 of an empty matrix.
double largest(const SparseMatrix& A);

/// Largest entry of A - B over that of B (over 1 if B is 0).
double relative_difference(const SparseMatrix& A, const SparseMatrix& B);
double relative_difference(const Vector& a, const Vector& b);

/// Expects a found matrix or vector to be the expected one but for a relative difference.
#define EXPECT_CLOSE(found, expected, difference)                                                  \
    EXPECT_LE(::polydec::test::relative_difference(found, expected), difference)

/// The same but for a difference of each entry, in the entry's units.
#define EXPECT_WITHIN(found, expected, difference)                                                 \
    EXPECT_LE(((found) - (expected)).cwiseAbs().maxCoeff(), difference)

/// Products of incidences in 32 bits, in which nothing overflows.
using IntegerMatrix = Eigen::SparseMatrix<int, Eigen::RowMajor, Index>;
IntegerMatrix integers(const IncidenceMatrix& D);

/// Whether A and B have the same shape and no entry differs.
bool equal(const IntegerMatrix& A, const IntegerMatrix& B);
bool is_zero(const IntegerMatrix& A);

/// Entries uniform in -1 .. 1, the same for the same seed.
Vector random_vector(Index size, unsigned seed);

SparseMatrix identity(Index size);

/// A B, to be compared with another one.
SparseMatrix product(const SparseMatrix& A, const SparseMatrix& B);

/// The entries that are not 0.
SparseMatrix sparse(const DenseMatrix& A);

} // namespace polydec::test
