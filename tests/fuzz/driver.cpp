// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"

#include <cstddef>
#include <cstdint>

/// What libFuzzer calls, for the one target that this program is made for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    polydec::fuzz::POLYDEC_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
