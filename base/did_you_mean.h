// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Ends a message about an unknown name: ": did you mean 'heat'?" with the known name that takes
/// the fewest edits, or an empty text if all take more than 2 and more than a third of the name's
/// length. An edit inserts, deletes or replaces a byte, or swaps two neighbors.
/// Source: Damerau 1964; distances by optimal string alignment.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

} // namespace polydec
