// SPDX-License-Identifier: MIT
#pragma once

#include "backends/engine_module.h"

/// What each optional component hands over its engines by. The same objects make the module, whose
/// entry points are component_module.cpp, and the target to link, by component_linked.cpp.
namespace polydec::component {

void add_cholmod(EngineRegistrar& registrar);
void add_cvode(EngineRegistrar& registrar);
void add_mumps(EngineRegistrar& registrar);
void add_petsc(EngineRegistrar& registrar);
void add_slepc(EngineRegistrar& registrar);

} // namespace polydec::component
