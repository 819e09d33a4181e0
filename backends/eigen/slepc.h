// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Registers the eigensolver `slepc`: SLEPc's Krylov-Schur method (Stewart 2001; Hernandez, Roman
/// and Vidal 2005). It accesses a matrix only through SymmetricOperator::apply(); for eigenvalues
/// near a shift, apply() is a solve with any LinearSolver, and the caller keeps the factorization.
/// Programs that link polydec::slepc with CMake need not call this; repeated calls do nothing. The
/// first call of largest() starts PETSc and SLEPc unless the program has done so, and they end with
/// the program; an MPI that cannot start ends the program. Each process solves its own problems.
/// Only one thread at a time is in SLEPc, including apply(). Throws BackendUnavailable once they
/// have ended. Part of the separate target polydec::slepc. Throws InvalidInput if the name is
/// taken.
void register_slepc();

} // namespace polydec
