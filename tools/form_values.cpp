// SPDX-License-Identifier: MIT
#include "tools/form_values.h"

#include "base/errors.h"
#include "dec/discretization/cell_data.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/de_rham.h"
#include "solvers/sources/boundary_forms.h"
#include "tools/common.h"
#include "tools/component_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace polydec::tools {

namespace {

Index binomial(int of, int chosen) {
    double result = 1;
    for (int i = 0; i < chosen; ++i)
        result = result * (of - i) / (i + 1);
    return static_cast<Index>(std::lround(result));
}

/// Integrals over cells, or over their duals, in the units of the file.
Vector integrals(const Discretization& mesh, Side side, int degree,
                 const std::vector<SiteValues>& coefficients, double time) {
    const auto form = [&](const Vector& point) {
        const Points site = point.transpose();
        Vector values(static_cast<Eigen::Index>(coefficients.size()));
        for (std::size_t i = 0; i < coefficients.size(); ++i)
            values[static_cast<Eigen::Index>(i)] = coefficients[i].at(site, Vector{{time}})[0];
        return values;
    };
    return side == Side::primal ? de_rham(mesh, degree, form).values
                                : dual_de_rham(mesh, degree, form).values;
}

} // namespace

CellData cell_values(const Discretization& mesh, const SiteValues& values) {
    if (values.are_of_file())
        return values.at(Points(count_input_cells(mesh), 0));
    const int n = mesh.dimension();
    const bool has_points = mesh.ambient_dimension() > 0;
    const Points sites = has_points ? cell_centroids(mesh, n) : Points(mesh.complex().size(n), 0);
    const std::vector<Index>& tags = mesh.tags();
    const Eigen::Map<const Column<Index>> groups(tags.data(), std::ssize(tags));
    return CellData::on_cells(values.at(sites, groups.cast<double>()));
}

Vector vertex_values(const Discretization& mesh, const SiteValues& values, const Points& places) {
    if (!values.are_of_file())
        return values.at(places);
    return values.at(Points(count_vertices(mesh), 0))(vertices_of_cells(mesh));
}

CLI::Option* add_form(CLI::App& command, const std::string& option, std::string& text,
                      const std::string& what) {
    return command.add_option(option, text, "FORM\t" + what);
}

FormValues::FormValues(const std::string& option, const std::string& text, const std::string& time)
    : option_(option) {
    std::error_code error;
    if (std::filesystem::is_regular_file(text, error)) {
        coefficients_.emplace_back(option, text);
        return;
    }
    for (const std::string& part : divided(text))
        coefficients_.emplace_back(option, part, time);
}

void FormValues::check_count(const Discretization& mesh, int degree) const {
    const int coordinates = mesh.ambient_dimension();
    const Index wanted = degree == 0 ? 1 : binomial(coordinates, degree);
    if (std::ssize(coefficients_) != wanted)
        throw InvalidInput(fmt::format("{} has {} coefficient{}: a {}-form in {} coordinates has "
                                       "{}, separated by ;",
                                       option_, coefficients_.size(),
                                       coefficients_.size() == 1 ? "" : "s", degree, coordinates,
                                       wanted));
}

Vector FormValues::on(const Discretization& mesh, Side side, int degree, double time) const {
    const int n = mesh.dimension();
    if (degree < 0 || degree > n)
        throw InvalidInput(
            fmt::format("there are no forms of degree {}: expected 0 to {}", degree, n));
    const int k = cell_degree(mesh.complex(), side, degree);
    if (coefficients_.front().are_of_file() && k == 0)
        return vertex_values(mesh, coefficients_.front(), {});
    if (coefficients_.front().are_of_file())
        return coefficients_.front().at(Points(mesh.complex().size(k), 0));
    check_count(mesh, degree);
    if (degree > 0 || (side == Side::dual && mesh.ambient_dimension() > 0))
        return integrals(mesh, side, degree, coefficients_, time);
    return coefficients_.front().at(cell_centers(mesh, k), Vector{{time}});
}

Vector FormValues::on_boundary(const Discretization& mesh, Side side, int degree,
                               double time) const {
    if (side == Side::primal)
        return on(mesh, side, degree, time);
    if (degree > 0)
        throw InvalidInput(fmt::format("{} of a dual {}-form: expected a 0-form or a primal form",
                                       option_, degree));
    check_count(mesh, degree);
    return coefficients_.front().at(facet_sites(mesh), Vector{{time}});
}

Vector FormValues::through_boundary(const Discretization& mesh, Side side, int degree,
                                    double time) const {
    if (degree > 0)
        throw InvalidInput(
            fmt::format("{} of a {}-form: expected a 0-form, which has an outward derivative",
                        option_, degree));
    check_count(mesh, degree);
    return outward_flow(mesh, side, coefficients_.front().at(facet_sites(mesh), Vector{{time}}));
}

bool FormValues::uses_time() const {
    return std::any_of(coefficients_.begin(), coefficients_.end(),
                       [](const SiteValues& each) { return each.uses_label(); });
}

} // namespace polydec::tools
