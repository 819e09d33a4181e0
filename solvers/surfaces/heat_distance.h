// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <memory>
#include <span>
#include <string>

namespace polydec {

/// Distance along a surface by the heat method, for GeodesicDistance. The surface may branch: each
/// triangle has a plane of its own, so any number of them may meet at an edge. Where the time is so
/// short that the heat far away is too faint for its digits to be trusted, it flows longer, on that
/// component and for that call. With a direct engine this begins at some 500 edges from the
/// sources; with one that iterates, at 18.
/// Source: Crane, Weischedel, Wardetzky, Geodesics in Heat, ACM Trans. Graph. 32(5), 2013; the
/// logarithm is ours.
class HeatDistance {
public:
    /// Throws like GeodesicDistance.
    HeatDistance(const Triangles& surface, const Vector& lengths, double time_scale,
                 const std::string& engine);
    HeatDistance(HeatDistance&&) noexcept;
    ~HeatDistance();

    /// In the unit of the lengths; 0 at the sources. Triangles far from Delaunay can bring values
    /// below 0.
    Vector to(std::span<const Index> sources) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace polydec
