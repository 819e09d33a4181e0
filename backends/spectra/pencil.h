// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <variant>
#include <vector>

namespace polydec {

/// Numbers, one for each entry, or a symmetric positive definite matrix.
using Weights = std::variant<Vector, SparseMatrix>;

/// The inverse of such weights, kept apart: that of a matrix would be dense, and numbers between
/// many cells would couple all of them.
struct InverseWeights {
    Weights W;
};

/// A part F^T W F of a symmetric matrix.
struct GramPart {
    SparseMatrix F;
    /// One number of any sign for each row of F, or a positive definite matrix, or, in one part of
    /// a pencil at most, the inverse of one or of positive numbers.
    std::variant<Vector, SparseMatrix, InverseWeights> weights;
    Vector uncertainty = {};   ///< each number is known to within so much; empty: exactly
    SparseMatrix F_error = {}; ///< each entry of F is, at the same places; 0 x 0: exactly
};

/// The symmetric eigenproblem A x = lambda M x, M positive definite, A = C + sum F^T W F.
/// Laplacians are given by their parts: products of large and small weights, added up, have lost
/// what their small eigenvalues are made of.
struct Pencil {
    SparseMatrix C = {}; ///< symmetric; 0 x 0: nothing
    std::vector<GramPart> parts = {};
    Weights M;
    double mass_uncertainty = 0; ///< each mass is known to within this share of itself, < 1
};

} // namespace polydec
