// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace polydec {

/// The first five items by name, separated by commas, and how many more there are: for messages.
std::string listed(const std::vector<Index>& items, const std::function<std::string(Index)>& name);

/// The same of so many items, of which only the first ones are known, most_listed at least.
constexpr std::size_t most_listed = 5;
std::string listed(const std::vector<Index>& items, std::size_t count,
                   const std::function<std::string(Index)>& name);

} // namespace polydec
