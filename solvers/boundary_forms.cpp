// SPDX-License-Identifier: MIT
#include "solvers/boundary_forms.h"

#include "base/checks.h"
#include "dec/boundary_star.h"
#include "dec/forms/boundary_conditions.h"
#include "meshes/unit_of_length.h"

namespace polydec {

Vector outward_flow(const Discretization& mesh, Side side, const Vector& given) {
    const CellComplex& complex = mesh.complex();
    const int n = complex.dimension();
    check_as_many("outward derivatives", given.size(), complex.size(n - 1));
    const Vector derivatives = in_input_units(given, mesh.unit(), 1, "outward derivatives");
    if (side == Side::primal)
        return dual_boundary_derivative(complex, n - 1).transpose() *
               Vector(boundary_star(mesh, 0, derivatives) * Vector::Ones(complex.size(0)));
    const Vector& areas = mesh.volumes().primal(n - 1);
    Vector flow = Vector::Zero(derivatives.size());
    for (Index t = 0; t < complex.size(n); ++t)
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (complex.coface_counts(n - 1)[f.face] == 1)
                flow[f.face] = f.sign * areas[f.face] * derivatives[f.face];
    return flow;
}

} // namespace polydec
