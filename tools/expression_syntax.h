// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace polydec::tools {

/// Describes syntax that the parser would accept with an unintended meaning: assignments, commas
/// outside argument lists, decimal commas, chained comparisons; also texts that are too long or
/// nested too deeply. Empty if there is none.
std::string misread_syntax(std::string_view text);

} // namespace polydec::tools
