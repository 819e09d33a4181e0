// SPDX-License-Identifier: MIT
#include "shape/unfolded_triangles.h"

#include "complex/disjoint_sets.h"
#include "dec/metric/side_lengths.h"
#include "dec/metric/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace polydec {

namespace {

/// Cosine and sine of the angle opposite to a in a triangle, of any size.
std::array<double, 2> corner(double a, double b, double c) {
    const int exponent = std::ilogb(std::max({a, b, c}));
    for (double* side : {&a, &b, &c})
        *side = std::ldexp(*side, -exponent); // which rounds nothing
    return {twice_scalar_product(a, b, c) / (2 * b * c), 2 * triangle_area(a, b, c) / (b * c)};
}

} // namespace

UnfoldedTriangles::UnfoldedTriangles(const Triangles& surface, const Vector& lengths)
    : edges_(surface.edges()) {
    check_lengths(surface, lengths);
    const Index halfedges = 3 * surface.triangles();
    if (halfedges > 0)
        exponent_ = std::ilogb(lengths.maxCoeff()) - 400;
    sides_.reserve(halfedges);
    for (Index h = 0; h < halfedges; ++h) {
        const double a = lengths[surface.edge(surface.next(h))],
                     b = lengths[surface.edge(surface.previous(h))], c = lengths[surface.edge(h)];
        const auto angle = corner(a, b, c);
        sides_.push_back({std::ldexp(c, -exponent_), angle[0], angle[1], surface.tail(h),
                          surface.edge(h), surface.sign(h)});
    }
    sides_of_ = Groups(halfedges, surface.edges(), [&](Index h) { return surface.edge(h); });
    corners_of_ = Groups(halfedges, surface.vertices(), [&](Index h) { return surface.tail(h); });
    find_bends(surface);
}

void UnfoldedTriangles::find_bends(const Triangles& surface) {
    // the link of a vertex: its corners join the ends of edges there
    const auto end = [&](Index h, bool tail) {
        return 2 * surface.edge(h) + ((surface.sign(h) > 0) == tail ? 0 : 1);
    };
    DisjointSets ends(2 * surface.edges());
    for (Index h = 0; h < 3 * surface.triangles(); ++h)
        ends.join(end(h, true), end(surface.previous(h), false));

    constexpr double rounding = 1e-12;
    may_bend_.assign(surface.vertices(), false);
    for (Index v = 0; v < surface.vertices(); ++v) {
        double angles = 0;
        Index free_ends = 0;
        bool is_simple = true;
        for (const Index h : corners_of(v)) {
            angles += std::atan2(sides_[h].sine, sides_[h].cosine);
            is_simple &= ends.find(end(h, true)).element ==
                         ends.find(end(corners_of(v).front(), true)).element;
            for (const Index side : {h, surface.previous(h)}) {
                const auto count = sides_of(surface.edge(side)).size();
                is_simple &= count <= 2;
                free_ends += count == 1;
            }
        }
        const double most = free_ends == 0 ? 2 * std::numbers::pi : std::numbers::pi;
        may_bend_[v] = !is_simple || angles > most * (1 + rounding);
    }
}

} // namespace polydec
