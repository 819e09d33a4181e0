// SPDX-License-Identifier: MIT
// What the sanitizers have to know of MPI, on which the engines of PETSc stand.

/// Open MPI never frees part of what it makes when it starts and ends, and PETSc forgets the names
/// of what it was reading when it found an option without meaning. What solvers make is not among
/// it, so forgotten solvers are still found.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:ompi_mpi_init\n"
           "leak:ompi_mpi_finalize\n"
           "leak:PetscOptionsBegin_Private\n";
}

/// Its libraries have no frame pointers, so without this nobody would know who has allocated what.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "fast_unwind_on_malloc=0";
}
