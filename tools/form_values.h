// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/cell_data.h"
#include "dec/forms/cochain.h"
#include "tools/expression.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// Values of an option for each n-cell: numbers from a file in the order of the input's cells, or
/// values of an expression at the centroids, with the physical group as label. Throws like
/// SiteValues.
CellData cell_values(const Discretization& mesh, const SiteValues& values);

/// Values of an option for each 0-cell at these places: numbers from a file, one per vertex of the
/// mesh file, or values of an expression. Throws like SiteValues.
Vector vertex_values(const Discretization& mesh, const SiteValues& values, const Points& places);

/// Adds an option that FormValues are made of; `what` says what form it is.
CLI::Option* add_form(CLI::App& command, const std::string& option, std::string& text,
                      const std::string& what);

/// A form given by an option: numbers from a file, one per cell, or its coefficients of dx_I,
/// expressions separated by semicolons, which are integrated over cells. Construct before any work,
/// like SiteValues.
class FormValues {
public:
    /// Throws like SiteValues. `time` names the time in expressions that may use it.
    FormValues(const std::string& option, const std::string& text, const std::string& time = "");

    /// The form on this mesh, by de_rham or dual_de_rham; where only lengths are known, numbers are
    /// 0-forms. Throws like SiteValues::at and de_rham; InvalidInput for a wrong number of
    /// coefficients, other than N over `degree`, and if there are no such forms.
    Vector on(const Discretization& mesh, Side side, int degree, double time = 0) const;

    /// The values on essential facets, as for an Unknown. Throws likewise; InvalidInput for dual
    /// forms of a degree above 0.
    Vector on_boundary(const Discretization& mesh, Side side, int degree, double time) const;

    /// The outward derivatives of a 0-form, as derivative_flow of an Unknown. Throws likewise;
    /// InvalidInput for forms of a degree above 0.
    Vector through_boundary(const Discretization& mesh, Side side, int degree, double time) const;

    bool uses_time() const;

private:
    void check_count(const Discretization& mesh, int degree) const;

    std::string option_;
    std::vector<SiteValues> coefficients_; ///< or one file
};

} // namespace polydec::tools
