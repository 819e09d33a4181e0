// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>
#include <string>
#include <vector>

namespace polydec {

/// The first five items by name, separated by commas, and how many more there are: for messages.
std::string listed(const std::vector<Index>& items, const std::function<std::string(Index)>& name);

} // namespace polydec
