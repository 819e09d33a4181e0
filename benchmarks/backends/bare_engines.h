// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec::benchmarks {

/// CHOLMOD as its manual shows it, with the settings that are best: supernodal, one ordering.
/// Declared in any case; whether the program has it says has_bare_cholmod().
bool has_bare_cholmod();

/// A^-1 b for a positive definite A: analysis, factorization and one solve.
Vector solve_by_bare_cholmod(const SparseMatrix& A, const Vector& b);

/// The same by Eigen's SimplicialLDLT.
Vector solve_by_bare_ldlt(const SparseMatrix& A, const Vector& b);

/// Conjugate gradients and hypre's BoomerAMG as PETSc's manual shows them, with the options that
/// are best for solids. Declared in any case; whether the program has it says has_bare_hypre().
bool has_bare_hypre();

/// A^-1 b for a positive definite A, to the tolerance that is the default of the library's engines.
/// PETSc is started where nobody has. Throws SolverFailure where it does not converge.
Vector solve_by_bare_hypre(const SparseMatrix& A, const Vector& b);

/// The smallest eigenvalues, ascending, of A x = lambda M x, A semidefinite, M diagonal, by Spectra
/// on the shifted inverse, for which CHOLMOD solves: in the scale in which M is the identity, with
/// twice as many Lanczos vectors as eigenvalues. Nothing is certified.
Vector eigenvalues_by_bare_spectra(const SparseMatrix& A, const Vector& M, Index count);

} // namespace polydec::benchmarks
