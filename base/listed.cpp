// SPDX-License-Identifier: MIT
#include "base/listed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

std::string listed(const std::vector<Index>& items, const std::function<std::string(Index)>& name) {
    constexpr std::size_t most = 5;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(items.size(), most); ++i)
        names.push_back(name(items[i]));
    if (items.size() > most)
        names.push_back(fmt::format("and {} more", items.size() - most));
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace polydec
