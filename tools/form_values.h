// SPDX-License-Identifier: MIT
#pragma once

#include "dec/cell_data.h"
#include "dec/forms/cochain.h"
#include "tools/expression.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// What an option gives for each n-cell: numbers of a file in the order of the input's cells, or
/// the values of an expression at the centroids, its label the physical group. Throws like
/// SiteValues.
CellData cell_values(const Discretization& mesh, const SiteValues& values);

/// What an option gives for each 0-cell, which are at these places: numbers of a file, one for each
/// vertex of the mesh file, or the values of an expression. Throws like SiteValues.
Vector vertex_values(const Discretization& mesh, const SiteValues& values, const Points& places,
                     double time = 0);

/// Adds an option that FormValues are made of, a required one; `what` says what form it is.
CLI::Option* add_form(CLI::App& command, const std::string& option, std::string& text,
                      const std::string& what);

/// A form that an option gives: numbers of a file, one for each cell, or its coefficients at dx_I,
/// expressions with semicolons between them, of which the integrals over cells are taken. Made
/// before any work, like SiteValues.
class FormValues {
public:
    /// Throws like SiteValues. `time` names the time in expressions that may use it.
    FormValues(const std::string& option, const std::string& text, const std::string& time = "");

    /// On this mesh. 0-forms are taken at vertices, or where dual ones have their values. Throws
    /// like SiteValues::at and de_rham; InvalidInput for another number of coefficients than N over
    /// `degree`, and if there are no such forms.
    Cochain on(const Discretization& mesh, Side side, int degree, double time = 0) const;

    /// The values on essential facets as an Unknown takes them. Throws likewise; InvalidInput for
    /// dual forms of a degree above 0.
    Vector on_boundary(const Discretization& mesh, Side side, int degree, double time) const;

    /// The outward derivatives of a 0-form as an Unknown takes them, its derivative_flow. Throws
    /// likewise; InvalidInput for forms of a degree above 0.
    Vector through_boundary(const Discretization& mesh, Side side, int degree, double time) const;

    bool uses_time() const;

    /// All files that are read: those of the mesh, of this form, and the others that are there.
    std::vector<std::filesystem::path>
    inputs(const std::filesystem::path& mesh,
           const std::vector<std::optional<std::filesystem::path>>& others) const;

private:
    void check_count(const Discretization& mesh, int degree) const;

    std::string option_;
    std::vector<SiteValues> coefficients_; ///< or one file
};

} // namespace polydec::tools
