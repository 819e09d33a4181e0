// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace polydec::tools {

/// What is wrong with a text that the parser would take, but for something else than was meant:
/// assignments, commas that separate no arguments, decimal commas, comparisons of comparisons; or
/// that is longer or nested deeper than any formula. Empty if nothing is.
std::string misread_syntax(std::string_view text);

} // namespace polydec::tools
