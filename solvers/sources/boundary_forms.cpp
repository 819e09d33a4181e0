// SPDX-License-Identifier: MIT
#include "solvers/sources/boundary_forms.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/boundary/boundary_conditions.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace polydec {

Vector outward_flow(const Cells& cells, Side side, const Vector& derivatives) {
    const CellComplex& complex = cells.complex();
    const int n = complex.dimension();
    check_as_many("outward derivatives", derivatives.size(), complex.size(n - 1));
    const auto in_input = [&](const Vector& flow) {
        return form_in_input_units(flow, cells.unit(), n - 1, "flows through facets");
    };
    if (side == Side::primal)
        return in_input(
            dual_boundary_derivative(complex, n - 1).transpose() *
            Vector(cells.boundary_star(0, derivatives) * Vector::Ones(complex.size(0))));
    const Vector& areas = cells.volumes().primal(n - 1);
    Vector flow = Vector::Zero(derivatives.size());
    for (Index t = 0; t < complex.size(n); ++t)
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (complex.coface_counts(n - 1)[f.face] == 1)
                flow[f.face] = f.sign * areas[f.face] * derivatives[f.face];
    return in_input(flow);
}

BoundaryForms boundary_data(const FormSpace& space, const std::vector<FacetValue>& values) {
    const Cells cells = space.cells();
    const int facets = cells.dimension() - 1;
    if (space.degree() != 0)
        throw InvalidInput(
            fmt::format("values by facet are given for {}-forms: expected functions, of degree 0",
                        space.degree()));
    const bool at_vertices = space.side() == Side::primal;
    Vector u = Vector::Zero(cells.size(at_vertices ? 0 : facets));
    Vector derivatives = Vector::Zero(cells.size(facets));
    for (const auto& [marks, value] : values) {
        check_as_many("marks of facets", std::ssize(marks), cells.size(facets));
        std::vector<bool> given = marks;
        for (Index f = 0; f < cells.size(facets); ++f) {
            const bool is_essential = space.conditions().at(f) == BoundaryCondition::essential;
            given[f] = marks[f] && is_essential;
            if (marks[f] && !is_essential)
                derivatives[f] = value;
        }
        const CellMarks held = essential_cells(
            cells.complex(), BoundaryConditions(BoundaryCondition::natural).essential(given));
        for (Index i = 0; i < u.size(); ++i)
            if (held[at_vertices ? 0 : facets][i])
                u[i] = value;
    }
    return {.values = std::move(u),
            .derivative_flow = outward_flow(cells, space.side(), derivatives)};
}

BoundaryForms in_unit(const BoundaryForms& data, double unit, int n, int degree) {
    const auto taken = [&](const Vector& values, int power, const char* what) {
        return form_in_input_units(values, unit, -power, what);
    };
    // exponents relative to u, whose values are unit-free
    return {data.values, taken(data.codifferential, -2, "codifferentials on the boundary"),
            taken(data.flow, n - 2 * degree, "flows through the boundary"),
            taken(data.derivative_flow, n - 2 * degree - 2, "flows of derivatives")};
}

} // namespace polydec
