// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

/// Registers the engines of a component when the program starts; false if that failed, which the
/// component's own register function tells when it is called. A component defines by this
///     extern "C" const bool polydec_NAME_is_linked = polydec::registered(register_NAME);
/// and its target has all who link it ask for that symbol (see polydec_component), so that linkers
/// keep it, and the component with it.
inline bool registered(void (*register_engines)()) noexcept {
    try {
        register_engines();
        return true;
    } catch (...) {
        return false;
    }
}

} // namespace polydec
