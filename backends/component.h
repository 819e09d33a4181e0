// SPDX-License-Identifier: MIT
#pragma once

#include "backends/engine_module.h"

/// Registration functions of the optional components. The same objects form the module, with entry
/// points in component_module.cpp, and the linkable target, through component_linked.cpp.
namespace polydec::component {

void add_cholmod(EngineRegistrar& registrar);
void add_cvode(EngineRegistrar& registrar);
void add_mumps(EngineRegistrar& registrar);
void add_petsc(EngineRegistrar& registrar);
void add_slepc(EngineRegistrar& registrar);

} // namespace polydec::component
