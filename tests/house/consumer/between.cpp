// SPDX-License-Identifier: MIT
#include <backends/registry.h>

bool has_engine(const char* name) {
    for (const auto& engine : polydec::engines())
        if (engine.name == name)
            return engine.available;
    return false;
}
