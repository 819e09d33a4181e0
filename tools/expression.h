// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <memory>
#include <string>

namespace polydec::tools {

/// A function of the position, written in x, y, z (and x1, x2, .. in any dimension).
class Expression {
public:
    /// Throws CLI::ValidationError, with the place, for text that is no expression. `option` names
    /// the option the text was given to.
    Expression(const std::string& option, const std::string& text);
    ~Expression();

    /// Values at the rows of `sites`. Throws InvalidInput, naming the place, where there is none.
    Vector operator()(const Points& sites) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The values an option gives at the sites: numbers of a file, if there is one of that name, else
/// those of the expression. A file holds one number for each site, separated by white space.
Vector values_at(const std::string& option, const std::string& text, const Points& sites);

} // namespace polydec::tools
