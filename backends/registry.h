// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/integrator.h"
#include "backends/linear_solver.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace polydec {

enum class EngineKind { linear, eigen, integrator, mesher };

/// What `polydec backends` tells of an engine.
struct EngineInfo {
    std::string name = {};
    EngineKind kind = EngineKind::linear;
    bool available = true;
    std::string description = {};
    std::string how_to_get = {}; ///< package and build option; empty for what is always there
};

using LinearSolverFactory =
    std::function<std::unique_ptr<LinearSolver>(const LinearSolverOptions&)>;
using EigenSolverFactory = std::function<std::unique_ptr<EigenSolver>()>;
using IntegratorFactory = std::function<std::unique_ptr<Integrator>(const IntegratorOptions&)>;

/// A new solver of that name: auto, eigen.ldlt, eigen.lu, eigen.cg, eigen.bicgstab, one of a module
/// that is there (the optional engines' are loaded when one is first asked for), or what was
/// registered. Throws InvalidInput, listing the known names, if there is none of that name or an
/// option makes no sense; BackendUnavailable, naming package and build option, if the engine is
/// known but not to be had in this program.
std::unique_ptr<LinearSolver> make_linear_solver(const std::string& name,
                                                 const LinearSolverOptions& options = {});

/// The same for eigensolvers: block-lanczos, spectra, or what there is else.
std::unique_ptr<EigenSolver> make_eigen_solver(const std::string& name);

/// The same for integrators in time: runge-kutta, or what there is else.
std::unique_ptr<Integrator> make_integrator(const std::string& name,
                                            const IntegratorOptions& options = {});

/// Makes an engine known under a name; `available` is set by the registry.
/// Throws InvalidInput if the name is empty or taken, or the factory is empty.
void register_linear_solver(const EngineInfo& info, LinearSolverFactory factory);
void register_linear_solver(const std::string& name, LinearSolverFactory factory);
void register_eigen_solver(const EngineInfo& info, EigenSolverFactory factory);
void register_eigen_solver(const std::string& name, EigenSolverFactory factory);
void register_integrator(const EngineInfo& info, IntegratorFactory factory);
void register_integrator(const std::string& name, IntegratorFactory factory);

/// Every engine that is known, the missing ones too; linear first, then eigensolvers, integrators
/// and the mesher, TetGen, which tetrahedralize runs; each kind ordered by name; of a module that
/// cannot be loaded, how_to_get says why. Loads every module there is. TetGen is available if the
/// program is on PATH now.
std::vector<EngineInfo> engines();

/// The same for one kind only; modules, which bring no mesher, are loaded for the other kinds.
std::vector<EngineInfo> engines(EngineKind kind);

/// Whether make_linear_solver(name) would find an engine.
bool has_linear_solver(const std::string& name);

/// The same for make_eigen_solver(name).
bool has_eigen_solver(const std::string& name);

/// The same for make_integrator(name).
bool has_integrator(const std::string& name);

} // namespace polydec
