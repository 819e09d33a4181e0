// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "dec/forms/cells.h"

namespace polydec {

/// Primal k-forms live on the k-cells, dual k-forms on the duals of the (n-k)-cells.
enum class Side { primal, dual };

inline const char* name(Side side) {
    return side == Side::primal ? "primal" : "dual";
}

/// Exterior derivative of primal k-forms: the coboundary d_k as a real matrix, size(k+1) x size(k).
/// Needs no metric; d_(k+1) d_k = 0 exactly. k = -1..n, with empty matrices at both ends.
SparseMatrix derivative(const CellComplex& complex, int k);

/// Exterior derivative of dual j-forms, which live on the (n-j)-cells, to dual (j+1)-forms:
/// (-1)^(k+1) d_k^T with k = n-j-1, size(k) x size(k+1). j = -1..n, like k.
SparseMatrix dual_derivative(const CellComplex& complex, int j);

/// A discrete k-form: its integral over each oriented k-cell, primal or dual. The dual k-cells are
/// the duals of the (n-k)-cells and are numbered like them.
struct Cochain {
    Side side = Side::primal;
    int degree = 0;
    Vector values = {};
};

/// A formal sum of oriented cells of degree k, primal or dual: one coefficient per cell.
struct Chain {
    Side side = Side::primal;
    int degree = 0;
    Vector values = {};
};

/// Degree of the primal cells that carry primal or dual k-forms: k or n-k.
/// Throws InvalidInput if there is no such degree.
int cell_degree(const CellComplex& complex, Side side, int degree);

/// Throw InvalidInput, naming side, degree and sizes, if the form or chain does not live on this
/// complex, and, naming the value, if it is not finite. Every function of forms on a complex checks
/// this.
void check(const CellComplex& complex, const Cochain& form);
void check(const CellComplex& complex, const Chain& chain);

/// Throws InvalidInput, naming both forms, unless both live on this complex and on that side, and
/// their degrees add up to at most n: the conditions for an exterior product.
void check_factors(const CellComplex& complex, Side side, const Cochain& a, const Cochain& b);

/// The boundary, of degree k-1: the transpose of the derivative of forms of that side, so Stokes'
/// theorem pairing(d w, c) = pairing(w, boundary(c)) is exact. The boundary of a dual cell leaves
/// out its part on the boundary of the domain. Chains of degree 0 have the empty boundary, of
/// degree -1. Throws like check.
Chain boundary(const CellComplex& complex, const Chain& chain);

/// The value of a form on a chain: the integral of the form over the chain. Throws InvalidInput,
/// naming both, if their sides, degrees or sizes differ, and naming the value if it is not finite.
double pairing(const Cochain& form, const Chain& chain);

/// Exterior derivative, of degree k+1, by derivative or dual_derivative; empty for k = n. Throws
/// like check.
Cochain d(const CellComplex& complex, const Cochain& form);

/// Hodge star: primal k-forms to dual (n-k)-forms and back, star star = (-1)^(k(n-k)).
/// Throws like check, and for a dual form like HodgeStar::solve.
Cochain star(const Cells& cells, const Cochain& form);

/// Codifferential, of degree k-1, the adjoint of d in the inner products below; empty for k = 0.
/// Throws like check and codifferential or dual_codifferential.
Cochain codifferential(const Cells& cells, const Cochain& form);

/// Laplace-de Rham operator d delta + delta d. Throws like check and laplacian or dual_laplacian.
Cochain laplacian(const Cells& cells, const Cochain& form);

/// L2 product: values weighted with |*s| / |s| for primal forms, |s| / |*s| for dual forms.
/// Symmetric; positive definite iff every dual volume is positive; units: values squared times
/// length^(n-2k). Throws like check and, for dual forms, HodgeStar::solve; throws InvalidInput,
/// naming both forms, if sides or degrees differ, and for overflow.
double inner_product(const Cells& cells, const Cochain& a, const Cochain& b);

/// Square root of the inner product with itself, which need not be in range. Throws like check and
/// HodgeStar::solve, and InvalidInput if negative duals make the square negative, and if the norm
/// is no number of double precision.
double norm(const Cells& cells, const Cochain& form);

/// Sums and multiples. Sums throw like pairing.
Cochain operator+(const Cochain& a, const Cochain& b);
Cochain operator-(const Cochain& a, const Cochain& b);
Cochain operator*(double factor, const Cochain& form);

} // namespace polydec
