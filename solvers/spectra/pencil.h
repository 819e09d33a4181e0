// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// A part F^T diag(weights) F of a symmetric matrix.
struct GramPart {
    SparseMatrix F;
    Vector weights;          ///< of any sign, one for each row of F
    Vector uncertainty = {}; ///< each weight is known to within so much; empty: exactly
};

/// The symmetric eigenproblem A x = lambda M x, M diagonal and positive, A = C + sum F^T W F.
/// Laplacians are given by their parts: products of large and small weights, added up, have lost
/// what their small eigenvalues are made of.
struct Pencil {
    SparseMatrix C = {}; ///< symmetric; 0 x 0: nothing
    std::vector<GramPart> parts = {};
    Vector M;
    double mass_uncertainty = 0; ///< each mass is known to within this share of itself, < 1
};

} // namespace polydec
