// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/integrator.h"
#include "backends/linear_solver.h"

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace polydec {

enum class EngineKind { linear, eigen, integrator, mesher };

/// The entry of an engine in `polydec backends`.
struct EngineInfo {
    std::string name = {};
    EngineKind kind = EngineKind::linear;
    bool available = true;
    std::string description = {};
    std::string how_to_get = {}; ///< package and build option; empty for built-in engines
    std::string license = {};    ///< SPDX expression of the code behind it; empty: unknown
};

using LinearSolverFactory =
    std::function<std::unique_ptr<LinearSolver>(const LinearSolverOptions&)>;
using EigenSolverFactory = std::function<std::unique_ptr<EigenSolver>()>;
using IntegratorFactory = std::function<std::unique_ptr<Integrator>(const IntegratorOptions&)>;

/// Makes engines of a kind; the kinds are in the order of EngineKind.
using EngineFactory = std::variant<LinearSolverFactory, EigenSolverFactory, IntegratorFactory>;

inline EngineKind kind_of(const EngineFactory& factory) {
    return static_cast<EngineKind>(factory.index());
}

/// A new solver with this name: auto, eigen.ldlt, eigen.lu, eigen.cg, eigen.bicgstab, an engine of
/// an installed module (loaded at the first request), or a registered one. Throws InvalidInput,
/// listing the known names, for an unknown name or an invalid option; BackendUnavailable, naming
/// package and build option, if the engine is known but missing in this program.
std::unique_ptr<LinearSolver> make_linear_solver(const std::string& name,
                                                 const LinearSolverOptions& options = {});

/// The same for eigensolvers: block-lanczos, spectra, or others available.
std::unique_ptr<EigenSolver> make_eigen_solver(const std::string& name);

/// The same for time integrators: runge-kutta, or others available.
std::unique_ptr<Integrator> make_integrator(const std::string& name,
                                            const IntegratorOptions& options = {});

/// Registers an engine under a name that is new for its kind: it does not take the place of one
/// that a module may bring. Throws InvalidInput if the name is empty or taken, or the factory is
/// empty.
void register_engine(const std::string& name, EngineFactory factory);

/// All known engines, including missing ones: linear first, then eigensolvers, integrators and the
/// mesher, TetGen, which tetrahedralize runs; each kind ordered by name. If a module cannot be
/// loaded, how_to_get gives the reason. Loads all modules. TetGen is available if the program is
/// currently on PATH.
std::vector<EngineInfo> engines();

/// Package and build option of a known linear solver that is not there, and why its module could
/// not be loaded; else empty. Loads no module.
std::string how_to_get_linear_solver(const std::string& name);

/// Whether make_linear_solver(name) would find an engine.
bool has_linear_solver(const std::string& name);

} // namespace polydec
