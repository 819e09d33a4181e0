// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/integrator.h"
#include "backends/linear_solver.h"

#include <memory>

/// Factories of the built-in engines; the registry knows them by name.
namespace polydec::builtin {

std::unique_ptr<LinearSolver> make_auto(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_ldlt(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_lu(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_cg(const LinearSolverOptions& options);
std::unique_ptr<LinearSolver> make_eigen_bicgstab(const LinearSolverOptions& options);
std::unique_ptr<EigenSolver> make_block_lanczos();
std::unique_ptr<EigenSolver> make_spectra();
std::unique_ptr<Integrator> make_runge_kutta(const IntegratorOptions& options);
std::unique_ptr<Integrator> make_backward_euler(const IntegratorOptions& options);
std::unique_ptr<Integrator> make_implicit_midpoint(const IntegratorOptions& options);

} // namespace polydec::builtin
