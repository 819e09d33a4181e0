// SPDX-License-Identifier: MIT
#include "base/listed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string listed(const std::vector<Index>& items, const std::function<std::string(Index)>& name) {
    return listed(items, items.size(), name);
}

std::string listed(const std::vector<Index>& items, std::size_t count,
                   const std::function<std::string(Index)>& name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(items.size(), most_listed); ++i)
        names.push_back(name(items[i]));
    if (count > most_listed)
        names.push_back(fmt::format("and {} more", count - most_listed));
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace polydec
