// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

#include <functional>

namespace polydec {

/// A symmetric operator over all ranks: takes own entries to own entries. Collective.
using SharedOperator = std::function<Vector(const Vector&)>;

/// Collective: eigenvectors of the `count` largest eigenvalues, as many as converge, by SLEPc's
/// Krylov-Schur method; columns of own entries. Copies of an eigenvalue may be missing. `start` is
/// the own part of where it begins. Throws BackendUnavailable without SLEPc; what the operator
/// throws, which must be the same on all ranks.
DenseMatrix largest_eigenvectors(const Ranks& ranks, const SharedOperator& apply, Index count,
                                 const Vector& start, double tolerance);

} // namespace polydec
