// SPDX-License-Identifier: MIT
#include "solvers/sources/boundary_forms.h"

#include "base/checks.h"
#include "dec/forms/boundary_conditions.h"
#include "meshes/unit_of_length.h"

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

BoundaryForms in_unit(const BoundaryForms& data, double unit, int n, int degree) {
    const auto taken = [&](const Vector& values, int power, const char* what) {
        return form_in_input_units(values, unit, -power, what);
    };
    // relative to u, whose values are the same
    return {data.values, taken(data.codifferential, -2, "codifferentials on the boundary"),
            taken(data.flow, n - 2 * degree, "flows through the boundary"),
            taken(data.derivative_flow, n - 2 * degree - 2, "flows of derivatives")};
}

} // namespace polydec
