// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// "1 cell" or "7 cells".
std::string counted(std::size_t count, std::string_view one, std::string_view several);

/// The first five items by name, separated by commas, and the number of others: for messages.
std::string listed(const std::vector<Index>& items, const std::function<std::string(Index)>& name);

/// The same for `count` items of which only the first are known, at least most_listed.
constexpr std::size_t most_listed = 5;
std::string listed(const std::vector<Index>& items, std::size_t count,
                   const std::function<std::string(Index)>& name);

} // namespace polydec
