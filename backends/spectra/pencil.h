// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <variant>
#include <vector>

namespace polydec {

/// Numbers, one per entry, or a symmetric positive definite matrix.
using Weights = std::variant<Vector, SparseMatrix>;

/// The inverse of these weights, kept factored: the inverse of a matrix would be dense, and numbers
/// between many cells would couple all of them.
struct InverseWeights {
    Weights W;
};

/// A part F^T W F of a symmetric matrix.
struct GramPart {
    SparseMatrix F;
    /// One number of any sign for each row of F, or a positive definite matrix; in at most one part
    /// of a pencil, the inverse of a positive definite matrix or of positive numbers.
    std::variant<Vector, SparseMatrix, InverseWeights> weights;
    Vector uncertainty = {};   ///< error bound of each number; empty: exact
    SparseMatrix F_error = {}; ///< error bound of each entry of F, at the same places; 0 x 0: exact
};

/// The symmetric eigenproblem A x = lambda M x, M positive definite, A = C + sum F^T W F.
/// Laplacians are given by their parts: a sum of products of large and small weights loses the
/// digits of small eigenvalues.
struct Pencil {
    SparseMatrix C = {}; ///< symmetric; 0 x 0: none
    std::vector<GramPart> parts = {};
    Weights M;
    double mass_uncertainty = 0; ///< relative error bound of each mass, < 1
};

} // namespace polydec
