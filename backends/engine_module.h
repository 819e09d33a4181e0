// SPDX-License-Identifier: MIT
#pragma once

#include "backends/registry.h"

#include <filesystem>

namespace polydec {

/// Incremented whenever engines built against older headers would stop working.
inline constexpr int engine_module_version = 5;

/// The registrar through which a module registers its engines: always in the program that loads it,
/// even if the module carries a copy of the library.
class EngineRegistrar {
public:
    virtual ~EngineRegistrar() = default;
    /// Sets kind and availability. Throws InvalidInput if the name is empty or taken, or the
    /// factory is empty.
    virtual void add(EngineInfo info, EngineFactory factory) = 0;
};

/// Registers in this program, also in place of known engines that are missing.
EngineRegistrar& program_registrar();

/// The same, passing over engines that the program has already, which may be linked with it.
EngineRegistrar& registrar_of_missing();

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
