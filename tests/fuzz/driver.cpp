// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

/// What libFuzzer calls, for the one target that this program is made for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto target =
        std::find_if(polydec::fuzz::targets.begin(), polydec::fuzz::targets.end(),
                     [](const auto& each) { return each.name == POLYDEC_FUZZ_TARGET; });
    target->run({reinterpret_cast<const char*>(data), size});
    return 0;
}
