// SPDX-License-Identifier: MIT
// Keeps libraries preloaded into a test program, such as a sanitizer, out of programs it starts.
#include "tests/support/test.h"

namespace {

[[maybe_unused]] const int forgotten = ::unsetenv("LD_PRELOAD");

} // namespace
