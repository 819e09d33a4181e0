// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "complex/surfaces/glued_surface.h"

#include <span>
#include <string>

namespace polydec {

/// Distance along a surface by the heat method, for GeodesicDistance. The surface may branch: each
/// triangle has its own plane, so any number of triangles may meet at an edge. If heat far away is
/// too faint for trusted digits, the time is extended on that component for that call. With a
/// direct engine this begins some 500 edges from the sources; with an iterative one, at 18 edges.
/// Source: Crane, Weischedel, Wardetzky, Geodesics in Heat, ACM Trans. Graph. 32(5), 2013; the
/// logarithm is new here.
class HeatDistance {
public:
    /// Throws like GeodesicDistance.
    HeatDistance(const Triangles& surface, const Vector& lengths, double time_scale,
                 const std::string& engine);

    /// In the unit of the lengths; 0 at the sources. Triangles far from Delaunay can cause negative
    /// values.
    Vector to(std::span<const Index> sources) const;

private:
    struct Parts;
    Shared<Parts> parts_;
};

} // namespace polydec
