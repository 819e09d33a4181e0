// SPDX-License-Identifier: MIT
#include "dec/metric/side_lengths.h"

#include "base/errors.h"
#include "dec/metric/triangle.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace polydec {

namespace {

[[noreturn]] void refuse_length(const Triangles& surface, Index edge, double length) {
    Index h = 0;
    while (surface.edge(h) != edge)
        ++h;
    const bool along = surface.sign(h) > 0;
    const Index first = surface.vertex_number(along ? surface.tail(h) : surface.head(h));
    const Index last = surface.vertex_number(along ? surface.head(h) : surface.tail(h));
    throw InvalidInput(fmt::format("edge {} from vertex {} to {} has length {}: expected a "
                                   "positive number",
                                   edge, first, last, length),
                       {.degree = 1, .cells = {edge}, .vertices = {first, last}});
}

} // namespace

void check_lengths(const Triangles& surface, const Vector& lengths) {
    if (lengths.size() != surface.edges())
        throw InvalidInput(fmt::format("{} lengths are given for {} edges: expected one for each",
                                       lengths.size(), surface.edges()));
    for (Index e = 0; e < surface.edges(); ++e)
        if (!(lengths[e] > 0 && std::isfinite(lengths[e])))
            refuse_length(surface, e, lengths[e]);
    for (Index t = 0; t < surface.triangles(); ++t) {
        const auto [a, b, c] = side_lengths(surface, lengths, t);
        const double longest = std::max({a, b, c});
        if (triangle_area(a / longest, b / longest, c / longest) > 0)
            continue;
        std::vector<Index> corners;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            corners.push_back(surface.vertex_number(surface.tail(h)));
        throw InvalidInput(
            fmt::format(
                "triangle {} with vertices {} has sides of lengths {}, {} and {}: no triangle of "
                "positive area has such sides",
                t, fmt::join(corners, ", "), a, b, c),
            {.degree = 2, .cells = {t}, .vertices = corners});
    }
}

std::array<double, 3> side_lengths(const Triangles& surface, const Vector& lengths,
                                   Index triangle) {
    return {lengths[surface.edge(3 * triangle)], lengths[surface.edge(3 * triangle + 1)],
            lengths[surface.edge(3 * triangle + 2)]};
}

} // namespace polydec
