// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/integrator.h"
#include "backends/linear_solver.h"
#include "backends/mesher.h"

#include <memory>

/// Makers of the engines that are always there, one .cpp each; the registry knows them by name.
namespace polydec::builtin {

std::unique_ptr<LinearSolver> make_auto(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_ldlt(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_lu(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_cg(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_bicgstab(const LinearSolverOptions& options);
std::unique_ptr<EigenSolver> make_block_lanczos();
std::unique_ptr<EigenSolver> make_spectra();
std::unique_ptr<Integrator> make_runge_kutta(const IntegratorOptions& options);

/// The mesher `tetgen`. TetGen is under the AGPL, and ends its process in a crash on much of what
/// it cannot do, so it is not linked but run as a program, with limits of time and memory, in a
/// temporary folder that is gone afterwards, also after Ctrl-C (held_signals.h). The first tells
/// whether the program is on PATH now; the second does what tetrahedralize says, of a checked
/// input.
bool has_tetgen();
MesherOutput run_tetgen(const MesherInput& input, const MesherOptions& options);

} // namespace polydec::builtin
