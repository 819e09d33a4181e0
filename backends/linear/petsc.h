// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Registers the engines `petsc.cg-hypre` and `petsc.cg-gamg`: PETSc's conjugate gradients with
/// algebraic multigrid, hypre's BoomerAMG (Henson and Yang 2002) or PETSc's own smoothed
/// aggregation, for symmetric positive (semi)definite matrices. Their time and memory grow linearly
/// with the matrix, so they suit large solids. Programs that link polydec::petsc with CMake need
/// not call this; repeated calls do nothing. BoomerAMG is tuned for solids: HMIS coarsening, one
/// aggressive level, extended+i interpolation from at most 4 points, strong threshold 0.5.
/// LinearSolverOptions::engine_options takes PETSc's command line options and overrides all of
/// these; factorize() throws InvalidInput for unused options. max_iterations = 0: 1000. The first
/// factorization starts PETSc and MPI unless the program has done so, and they end with the
/// program; an MPI that cannot start ends the program. Each process solves its own matrices. Only
/// one thread at a time is in PETSc. Throws BackendUnavailable once they have ended. Part of the
/// separate target polydec::petsc; `petsc.cg-hypre` only if PETSc was built with hypre. Throws
/// InvalidInput if a name is taken.
void register_petsc();

} // namespace polydec
