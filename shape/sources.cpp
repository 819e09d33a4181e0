// SPDX-License-Identifier: MIT
#include "shape/sources.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

void check_sources(const Triangles& surface, std::span<const Index> sources) {
    DisjointSets sets(surface.vertices());
    for (Index h = 0; h < 3 * surface.triangles(); ++h)
        sets.join(surface.tail(h), surface.head(h));
    std::vector<bool> reached(std::size_t(surface.vertices()), false);
    for (const Index v : sources) {
        if (v < 0 || v >= surface.vertices())
            throw InvalidInput(fmt::format("vertex {} is a source but does not exist: {}", v,
                                           expected_numbers(0, surface.vertices() - 1)),
                               {.vertices = {v}});
        reached[sets.find(v).element] = true;
    }
    for (Index v = 0; v < surface.vertices(); ++v)
        if (!reached[sets.find(v).element])
            throw InvalidInput(fmt::format("no source is connected to vertex {}: give every "
                                           "component of the surface a source",
                                           surface.vertex_number(v)),
                               {.vertices = {surface.vertex_number(v)}});
}

Vector in_units_of_lengths(const Triangles& surface, const Vector& unfolded, int exponent) {
    const Vector distances =
        unfolded.unaryExpr([&](double distance) { return std::ldexp(distance, exponent); });
    for (Index v = 0; v < surface.vertices(); ++v)
        if (!std::isfinite(distances[v]))
            throw InvalidInput(fmt::format("the distance of vertex {} is outside the range of "
                                           "double precision: give lengths in a larger unit",
                                           surface.vertex_number(v)),
                               {.vertices = {surface.vertex_number(v)}});
    return distances;
}

} // namespace polydec
