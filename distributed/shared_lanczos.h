// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

#include <functional>

namespace polydec {

/// A symmetric operator over all ranks, from own entries to own entries. Collective.
using SharedOperator = std::function<Vector(const Vector&)>;

/// Collective: eigenvectors of the `count` largest eigenvalues, as many as converge, by SLEPc's
/// Krylov-Schur method; columns of own entries. May miss copies of an eigenvalue. `start` is the
/// own part of the start vector. Throws BackendUnavailable without SLEPc; passes on errors of the
/// operator, which must be the same on all ranks.
DenseMatrix largest_eigenvectors(const Ranks& ranks, const SharedOperator& apply, Index count,
                                 const Vector& start, double tolerance);

} // namespace polydec
