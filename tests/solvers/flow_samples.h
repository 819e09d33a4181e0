// SPDX-License-Identifier: MIT
#pragma once

#include "tests/solvers/cases.h"

namespace polydec::test {

constexpr double pi = std::numbers::pi;

/// The square of this side: quads, acute triangles or hexagons, about `cells` to a side.
inline Mesh square(const std::string& shape, int cells, double side = 1) {
    Mesh mesh = shape == "quads"       ? grid(cells, cells)
                : shape == "triangles" ? well_centered(cells / 2)
                                       : hexagons(cells);
    mesh.points *= side;
    return mesh;
}

/// The fluxes of the flow with this stream function, n = 2.
inline Vector flow_of(const Discretization& mesh,
                      const std::function<double(const Vector&)>& stream) {
    return d(mesh.complex(), {Side::primal, 0, at(mesh.points(), stream)}).values;
}

/// The difference of two flows over the second one, in the norm of the energy.
inline double flow_error(const IncompressibleFlow& flow, const Vector& w, const Vector& exact) {
    return std::sqrt(flow.energy(w - exact) / flow.energy(exact));
}

} // namespace polydec::test
