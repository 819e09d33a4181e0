// SPDX-License-Identifier: MIT
//
// Registers the engines of a component in the programs that link it, when they start. CMake says by
// which names: POLYDEC_ADD_ENGINES, its function of component.h; POLYDEC_REGISTER_ENGINES, that of
// its public header; and POLYDEC_IS_LINKED, the symbol that all who link it ask for, so that
// linkers keep it, and the component with it.
#include "backends/component.h"

namespace polydec {

void POLYDEC_REGISTER_ENGINES();

void POLYDEC_REGISTER_ENGINES() {
    [[maybe_unused]] static const bool is_done = [] {
        component::POLYDEC_ADD_ENGINES(program_registrar());
        return true;
    }();
}

} // namespace polydec

// False where that failed, which the function tells when it is called.
extern "C" {
extern const bool POLYDEC_IS_LINKED;
const bool POLYDEC_IS_LINKED = [] {
    try {
        polydec::POLYDEC_REGISTER_ENGINES();
        return true;
    } catch (...) {
        return false;
    }
}();
}
