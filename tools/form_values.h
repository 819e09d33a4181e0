// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "tools/expression.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// Adds the option --initial.
void add_initial(CLI::App& command, std::string& text);

/// The form at the beginning. Made before any work, like SiteValues.
class InitialForm {
public:
    /// Throws like SiteValues.
    explicit InitialForm(const std::string& text);

    /// On this mesh: of degree 0 the values of an expression at its sites, or those of a file; of
    /// other degrees those of a file. Throws like SiteValues::at; InvalidInput for an expression in
    /// other degrees, and if there are no such forms.
    Cochain on(const Discretization& mesh, Side side, int degree) const;

    /// All files that are read: those of the mesh, of this form, and the others that are there.
    std::vector<std::filesystem::path>
    inputs(const std::filesystem::path& mesh,
           const std::vector<std::optional<std::filesystem::path>>& others) const;

private:
    SiteValues values_;
};

} // namespace polydec::tools
