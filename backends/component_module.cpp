// SPDX-License-Identifier: MIT
//
// The entry points of a component's module. POLYDEC_ADD_ENGINES is its function of component.h.
#include "backends/component.h"

int polydec_engine_module_version() {
    return polydec::engine_module_version;
}

void polydec_register_engines(polydec::EngineRegistrar& registrar) {
    polydec::component::POLYDEC_ADD_ENGINES(registrar);
}
