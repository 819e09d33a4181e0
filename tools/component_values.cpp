// SPDX-License-Identifier: MIT
#include "tools/component_values.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec::tools {

std::vector<std::string> divided(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) { // a last one may be empty, which is told
        const std::size_t end = std::min(text.find(';', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

ComponentValues::ComponentValues(const std::string& option, const std::string& text)
    : option_(option) {
    if (!text.empty())
        for (const std::string& part : divided(text))
            components_.emplace_back(option, part);
}

Points ComponentValues::at(const Points& sites, Eigen::Index wanted) const {
    if (size() != wanted)
        throw InvalidInput(fmt::format("{} has {} component{}: expected {}, separated by ;",
                                       option_, size(), size() == 1 ? "" : "s", wanted));
    Points result(sites.rows(), wanted);
    for (Eigen::Index i = 0; i < wanted; ++i)
        result.col(i) = components_[i].at(sites);
    return result;
}

} // namespace polydec::tools
