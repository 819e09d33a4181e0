// SPDX-License-Identifier: MIT
#pragma once

#include "backends/registry.h"

#include <filesystem>

namespace polydec {

/// Grows whenever an engine built against older headers would not work any more.
inline constexpr int engine_module_version = 2;

/// What a module is handed to register its engines with: those of the program that loads it, also
/// where the module carries a copy of the library.
class EngineRegistrar {
public:
    virtual ~EngineRegistrar() = default;
    virtual void add_linear_solver(const EngineInfo& info, LinearSolverFactory factory) = 0;
    virtual void add_eigen_solver(const EngineInfo& info, EigenSolverFactory factory) = 0;
    virtual void add_integrator(const EngineInfo& info, IntegratorFactory factory) = 0;
};

/// Registers in this program, by register_linear_solver and its like.
EngineRegistrar& program_registrar();

/// Loads a shared library that brings engines, and registers them. It exports
///     extern "C" int polydec_engine_module_version() { return polydec::engine_module_version; }
///     extern "C" void polydec_register_engines(polydec::EngineRegistrar& registrar) { ... }
/// It stays loaded as long as the program runs; loading it again does nothing.
/// Throws IoError if it cannot be loaded or exports no such functions; BackendUnavailable if it was
/// built for another version, or if the limit of address space leaves too little for it: what the
/// system cannot give to a library ends the program; what its registration throws.
void load_engine_module(const std::filesystem::path& path,
                        EngineRegistrar& registrar = program_registrar());

} // namespace polydec

/// The two functions of an engine module, declared such that their types are checked.
extern "C" int polydec_engine_module_version();
extern "C" void polydec_register_engines(polydec::EngineRegistrar& registrar);
