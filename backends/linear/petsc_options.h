// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/petsc_session.h"

#include <string>
#include <vector>

/// Options of PETSc as texts; installed nowhere.
namespace polydec::petsc {

/// What stands before the names of the options of our solvers, so that they meet no others.
inline constexpr const char* prefix = "polydec_";

/// The residual itself is what is asked for, not the one that the preconditioner sees.
inline const std::string conjugate_gradients = "-ksp_type cg -ksp_norm_type unpreconditioned ";

/// Dropping weak neighbors costs little where coefficients are even, and saves most of the
/// iterations where they are not.
inline const std::string gamg = "-pc_type gamg -pc_gamg_threshold 0.01 ";

/// With its own defaults BoomerAMG takes about twice the time in three dimensions.
inline const std::string boomeramg =
    "-pc_type hypre -pc_hypre_type boomeramg -pc_hypre_boomeramg_coarsen_type HMIS "
    "-pc_hypre_boomeramg_interp_type ext+i -pc_hypre_boomeramg_agg_nl 1 "
    "-pc_hypre_boomeramg_P_max 4 -pc_hypre_boomeramg_strong_threshold 0.5 ";

/// The coarsest matrix of a singular one is singular as well, and must not be factorized, also
/// where the kernel is not known.
inline const std::string singular_gamg = "-mg_coarse_pc_type svd ";
inline const std::string singular_boomeramg =
    "-pc_hypre_boomeramg_relax_type_coarse symmetric-SOR/Jacobi ";

/// Throws InvalidInput, naming the engine, unless a line of a user's options is empty or begins
/// with one.
void check_options(const std::string& engine, const std::string& options);

/// Options stand in PETSc's one table, under our prefix, as long as a solver is being set up.
class SetOptions {
public:
    SetOptions(const Session& session, const std::string& options);
    ~SetOptions() { clear(); }
    SetOptions(const SetOptions&) = delete;
    SetOptions& operator=(const SetOptions&) = delete;

private:
    void clear() const;

    std::vector<std::string> names_;
};

/// Throws InvalidInput, naming the engine and the option, for one of a user's that nobody has read
/// while a solver was set up. A small matrix may have no levels between the finest and the coarsest
/// to have options.
void require_read(const std::string& engine, const std::string& options);

} // namespace polydec::petsc
