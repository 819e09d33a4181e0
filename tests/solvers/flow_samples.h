// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

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

/// Around the origin between the radii 1 and 2, quads.
inline Mesh ring(int around, int across) {
    Mesh mesh;
    mesh.points.resize(around * (across + 1), 2);
    mesh.simplices.resize(2 * around * across, 3);
    const auto vertex = [&](int i, int j) { return i % around * (across + 1) + j; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j <= across; ++j) {
            const double angle = 2 * pi * i / around, radius = 1 + double(j) / across;
            mesh.points.row(vertex(i, j)) << radius * std::cos(angle), radius * std::sin(angle);
            if (j == across)
                continue;
            const Index first = 2 * (i * across + j);
            mesh.simplices.row(first) << vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1);
            mesh.simplices.row(first + 1) << vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j);
        }
    return mesh;
}

/// A function at the vertices.
inline Vector at_vertices(const Discretization& mesh,
                          const std::function<double(const Vector&)>& function) {
    Vector values(mesh.complex().size(0));
    for (Index v = 0; v < values.size(); ++v)
        values[v] = function(mesh.points().row(v).transpose());
    return values;
}

/// The fluxes of the flow with this stream function, n = 2.
inline Vector flow_of(const Discretization& mesh,
                      const std::function<double(const Vector&)>& stream) {
    return d(mesh.complex(), {Side::primal, 0, at_vertices(mesh, stream)}).values;
}

/// The difference of two flows over the second one, in the norm of the energy.
inline double flow_error(const IncompressibleFlow& flow, const Vector& w, const Vector& exact) {
    return std::sqrt(flow.energy(w - exact) / flow.energy(exact));
}

} // namespace polydec::test
