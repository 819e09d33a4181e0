// SPDX-License-Identifier: MIT
#pragma once

#include "backends/registry.h"

#include <filesystem>

namespace polydec {

/// Incremented whenever engines built against older headers would stop working.
inline constexpr int engine_module_version = 4;

/// The registrar through which a module registers its engines: always in the program that loads it,
/// even if the module carries a copy of the library.
class EngineRegistrar {
public:
    virtual ~EngineRegistrar() = default;
    virtual void add_linear_solver(const EngineInfo& info, LinearSolverFactory factory) = 0;
    virtual void add_eigen_solver(const EngineInfo& info, EigenSolverFactory factory) = 0;
    virtual void add_integrator(const EngineInfo& info, IntegratorFactory factory) = 0;
};

/// Registers in this program, through register_linear_solver and similar functions.
EngineRegistrar& program_registrar();

/// Loads a shared library with engines, and registers them. It exports
///     extern "C" int polydec_engine_module_version() { return polydec::engine_module_version; }
///     extern "C" void polydec_register_engines(polydec::EngineRegistrar& registrar) { ... }
/// The library stays loaded until the program ends; loading it again does nothing. Throws IoError
/// if it cannot be loaded or lacks these exports; BackendUnavailable if it was built for another
/// version, or if the limit of address space is too small: the system would end the program. Passes
/// on errors of the registration.
void load_engine_module(const std::filesystem::path& path,
                        EngineRegistrar& registrar = program_registrar());

} // namespace polydec

/// The two functions of an engine module, declared for type checking.
extern "C" int polydec_engine_module_version();
extern "C" void polydec_register_engines(polydec::EngineRegistrar& registrar);
