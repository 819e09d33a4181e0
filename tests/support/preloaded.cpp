// SPDX-License-Identifier: MIT
// What was preloaded into a test program, such as a sanitizer, is not for programs that it starts.
#include <cstdlib>

namespace {

[[maybe_unused]] const int forgotten = ::unsetenv("LD_PRELOAD");

} // namespace
