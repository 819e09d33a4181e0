// SPDX-License-Identifier: MIT
#include "backends/engine_module.h"

#include <cstdlib>

int polydec_engine_module_version() {
    return 0;
}

void polydec_register_engines(polydec::EngineRegistrar&) {
    std::abort();
}
