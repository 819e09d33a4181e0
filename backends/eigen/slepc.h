// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Makes the eigensolver `slepc` known: SLEPc's Krylov-Schur method (Stewart 2001; Hernandez, Roman
/// and Vidal 2005). It sees a matrix only by what SymmetricOperator::apply() does: for eigenvalues
/// near a shift that is a solve with any LinearSolver, whose factorization stays the caller's.
/// Programs that link polydec::slepc with CMake have it without calling this, which does nothing
/// then, as when called again.
/// PETSc and SLEPc are started by the first call of largest() unless the program has done so, and
/// ended with the program; an MPI that cannot start ends it. Each process solves its own problems.
/// Only one thread at a time is in SLEPc, its apply() included. BackendUnavailable is thrown once
/// they have been ended.
/// Part of the separate target polydec::slepc. Throws InvalidInput if another engine has taken the
/// name.
void register_slepc();

} // namespace polydec
