// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/petsc_session.h"

#include <string>
#include <vector>

/// PETSc options as texts; not installed.
namespace polydec::petsc {

/// The prefix of our solvers' options, so that they do not clash with others.
inline constexpr const char* prefix = "polydec_";

/// Convergence is tested on the true residual, not the preconditioned one.
inline const std::string conjugate_gradients = "-ksp_type cg -ksp_norm_type unpreconditioned ";

/// Dropping weak neighbors costs little for even coefficients, and saves most of the iterations for
/// uneven ones.
inline const std::string gamg = "-pc_type gamg -pc_gamg_threshold 0.01 ";

/// With its own defaults BoomerAMG takes about twice the time in three dimensions.
inline const std::string boomeramg =
    "-pc_type hypre -pc_hypre_type boomeramg -pc_hypre_boomeramg_coarsen_type HMIS "
    "-pc_hypre_boomeramg_interp_type ext+i -pc_hypre_boomeramg_agg_nl 1 "
    "-pc_hypre_boomeramg_P_max 4 -pc_hypre_boomeramg_strong_threshold 0.5 ";

/// The coarsest matrix of a singular one is singular, and must not be factorized, even if the
/// kernel is unknown.
inline const std::string singular_gamg = "-mg_coarse_pc_type svd ";
inline const std::string singular_boomeramg =
    "-pc_hypre_boomeramg_relax_type_coarse symmetric-SOR/Jacobi ";

/// Throws InvalidInput, naming the engine, unless a user's option line is empty or begins with an
/// option.
void check_options(const std::string& engine, const std::string& options);

/// Keeps options in PETSc's global table, under our prefix, while a solver is being set up.
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

/// Throws InvalidInput, naming the engine and the option, for a user's option that was not read
/// during setup. A small matrix may lack the intermediate levels that some options need.
void require_read(const std::string& engine, const std::string& options);

} // namespace polydec::petsc
