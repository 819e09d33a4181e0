// SPDX-License-Identifier: MIT
#pragma once

#include "tools/expression.h"

#include <string>
#include <vector>

namespace polydec::tools {

/// The parts of a text between semicolons.
std::vector<std::string> divided(const std::string& text);

/// Values of one or several expressions with semicolons between them, or none.
class ComponentValues {
public:
    /// Throws like SiteValues.
    ComponentValues(const std::string& option, const std::string& text);

    bool given() const { return !components_.empty(); }
    Eigen::Index size() const { return static_cast<Eigen::Index>(components_.size()); }

    /// A column each; as many as wanted. Throws InvalidInput for another number.
    Points at(const Points& sites, Eigen::Index wanted) const;

    Vector at(const Points& sites) const { return at(sites, 1).col(0); }

private:
    std::string option_;
    std::vector<SiteValues> components_;
};

} // namespace polydec::tools
