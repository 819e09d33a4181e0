// SPDX-License-Identifier: MIT
#pragma once

#include "tools/expression.h"

#include <string>
#include <vector>

namespace polydec::tools {

/// The parts of a text separated by semicolons.
std::vector<std::string> divided(const std::string& text);

/// Values of one or several expressions separated by semicolons, or none.
class ComponentValues {
public:
    /// Throws like SiteValues.
    ComponentValues(const std::string& option, const std::string& text);

    bool given() const { return !components_.empty(); }
    Eigen::Index size() const { return static_cast<Eigen::Index>(components_.size()); }

    /// One column per component. Throws InvalidInput unless there are `wanted` components.
    Points at(const Points& sites, Eigen::Index wanted) const;

    Vector at(const Points& sites) const { return at(sites, 1).col(0); }

private:
    std::string option_;
    std::vector<SiteValues> components_;
};

} // namespace polydec::tools
