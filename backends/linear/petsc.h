// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Makes the engines `petsc.cg-hypre` and `petsc.cg-gamg` known: PETSc's conjugate gradients with
/// algebraic multigrid, hypre's BoomerAMG (Henson and Yang 2002) or PETSc's own smoothed
/// aggregation, for symmetric positive (semi)definite matrices; their time and memory grow in
/// proportion to the matrix, so they are for large solids. Programs that link polydec::petsc with
/// CMake have them without calling this, which does nothing then, as when called again.
/// BoomerAMG is tuned for solids: HMIS coarsening, one aggressive level, extended+i interpolation
/// from at most 4 points, strong threshold 0.5. LinearSolverOptions::engine_options takes what
/// PETSc's command line takes and goes before all of that; factorize() throws InvalidInput for an
/// option that nobody reads. max_iterations = 0: 1000.
/// PETSc and MPI are started by the first factorization unless the program has done so, and ended
/// with the program; an MPI that cannot start ends it. Each process solves its own matrices. Only
/// one thread at a time is in PETSc. BackendUnavailable is thrown once they have been ended.
/// Part of the separate target polydec::petsc; `petsc.cg-hypre` only where PETSc was built with
/// hypre. Throws InvalidInput if another engine has taken a name.
void register_petsc();

} // namespace polydec
