// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "distributed/ranks.h"

namespace polydec {

/// Collective: eigenvectors of the `count` largest eigenvalues, as many as converge, by SLEPc's
/// Krylov-Schur method; columns of own entries. May miss copies of an eigenvalue. The operator maps
/// own entries to own entries, collectively; `start` is the own part of the start vector. Throws
/// BackendUnavailable without SLEPc; passes on errors of the operator, which must be the same on
/// all ranks.
DenseMatrix largest_eigenvectors(const Ranks& ranks, const SymmetricOperator& own, Index count,
                                 const Vector& start, double tolerance);

} // namespace polydec
