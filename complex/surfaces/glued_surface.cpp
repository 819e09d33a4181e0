// SPDX-License-Identifier: MIT
#include "complex/surfaces/glued_surface.h"

#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

std::vector<std::array<Index, 2>> pair_halfedges(const std::vector<GluedSurface::Halfedge>& sides,
                                                 Index edges) {
    std::vector<std::array<Index, 2>> pairs(static_cast<std::size_t>(edges), {-1, -1});
    for (std::size_t h = 0; h < sides.size(); ++h) {
        auto& [first, second] = pairs[sides[h].edge];
        if (second >= 0)
            throw InvalidInput(fmt::format("three triangles meet at edge {} (triangles {}, {} and "
                                           "{}): expected at most two triangles at each edge",
                                           sides[h].edge, first / 3, second / 3, h / 3),
                               {.degree = 1, .cells = {sides[h].edge}});
        (first < 0 ? first : second) = static_cast<Index>(h);
    }
    return pairs;
}

void check_edges(const Pieces& surface) {
    const auto& counts = surface.coface_counts(1);
    for (std::size_t e = 0; e < counts.size(); ++e)
        if (counts[e] > 2)
            throw InvalidInput(fmt::format("{} triangles meet at the edge from vertex {} to {}: "
                                           "expected at most two triangles at each edge",
                                           counts[e],
                                           surface.vertex_number(surface.simplices(1)(e, 0)),
                                           surface.vertex_number(surface.simplices(1)(e, 1))),
                               {.degree = 1,
                                .cells = {static_cast<Index>(e)},
                                .vertices = surface.vertex_numbers(1, static_cast<Index>(e))});
}

/// The largest edge number and one, if all sides make sense.
Index count_edges(const std::vector<std::array<GluedSurface::SignedEdge, 3>>& triangles) {
    Index edges = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const auto& side : triangles[t]) {
            if (side.edge < 0 || side.edge >= static_cast<Index>(3 * triangles.size()) ||
                (side.sign != 1 && side.sign != -1))
                throw InvalidInput(
                    fmt::format("triangle {} has a side on edge {} with sign {}: expected edge "
                                "numbers from 0 without gaps, and the sign 1 or -1",
                                t, side.edge, side.sign),
                    {.degree = 2, .cells = {static_cast<Index>(t)}});
            edges = std::max(edges, side.edge + 1);
        }
    return edges;
}

} // namespace

bool GluedSurface::accepts(const Pieces& surface) {
    if (surface.dimension() != dimension)
        return false;
    const auto& counts = surface.coface_counts(1);
    return std::all_of(counts.begin(), counts.end(), [](auto count) { return count <= 2; });
}

Triangles::Triangles(const Pieces& surface) {
    if (surface.dimension() != dimension)
        throw InvalidInput(fmt::format(
            "the complex has dimension {}: expected a surface of triangles", surface.dimension()));
    vertices_ = surface.size(0);
    edges_ = surface.size(1);
    const Index triangles = surface.size(2);
    sides_.reserve(std::size_t(triangles) * 3);
    for (Index v = 0; v < vertices_; ++v)
        names_.push_back(surface.vertex_number(v));
    const FaceTable edges = surface.faces(2);
    const Simplices& corners = surface.simplices(2);
    for (Index t = 0; t < triangles; ++t) {
        // the corners a, b, c are passed in their order, or the other way round
        const Index ab = edges(t, 2), bc = edges(t, 0), ac = edges(t, 1);
        const Index a = corners(t, 0), b = corners(t, 1), c = corners(t, 2);
        if (surface.orientation(t) > 0)
            sides_.insert(sides_.end(), {{{ab, 1}, a}, {{bc, 1}, b}, {{ac, -1}, c}});
        else
            sides_.insert(sides_.end(), {{{ac, 1}, a}, {{bc, -1}, c}, {{ab, -1}, b}});
    }
}

GluedSurface::GluedSurface(const Pieces& surface) : Triangles(surface) {
    check_edges(surface);
    halfedges_ = pair_halfedges(sides_, edges_);
}

GluedSurface::GluedSurface(const std::vector<std::array<SignedEdge, 3>>& triangles) {
    edges_ = count_edges(triangles);
    for (const auto& sides : triangles)
        for (const SignedEdge& side : sides)
            sides_.push_back({side, -1});
    halfedges_ = pair_halfedges(sides_, edges_);
    DisjointSets corners(static_cast<Index>(sides_.size()));
    for (Index e = 0; e < edges_; ++e) {
        const auto& [h, g] = halfedges_[e];
        if (h < 0)
            throw InvalidInput(
                fmt::format("no triangle has edge {}: number the edges from 0 without gaps", e),
                {.degree = 1, .cells = {e}});
        if (g < 0)
            continue;
        const bool alike = sign(h) == sign(g);
        corners.join(h, alike ? g : next(g));
        corners.join(next(h), alike ? next(g) : g);
    }
    std::vector<Index> number(sides_.size(), -1);
    for (std::size_t h = 0; h < sides_.size(); ++h) {
        auto& vertex = number[corners.find(static_cast<Index>(h)).element];
        if (vertex < 0)
            vertex = vertices_++;
        sides_[h].tail = vertex;
    }
}

void GluedSurface::reverse(Index triangle) {
    // corners 0 1 2 become 0 2 1, so sides 0 and 2 change places and all signs
    const Index a = 3 * triangle, b = a + 1, c = a + 2;
    for (const Index h : {a, b, c})
        sides_[h].sign = static_cast<std::int8_t>(-sides_[h].sign);
    std::swap(sides_[b].tail, sides_[c].tail);
    if (edge(a) != edge(c))
        std::swap(listed(a), listed(c));
    std::swap<SignedEdge>(sides_[a], sides_[c]);
}

void GluedSurface::flip(Index edge) {
    const auto [h, g] = halfedges_[edge];
    const Index t = 3 * triangle(h), u = 3 * triangle(g);
    const Index h1 = next(h), h2 = previous(h), g1 = next(g), g2 = previous(g);
    const Halfedge ij = sides_[h], jk = sides_[h1], ki = sides_[h2];
    const Halfedge ji = sides_[g], il = sides_[g1], lj = sides_[g2];

    // where the four outer sides were, as seen from their edges, before any of them moves
    Index &at_jk = listed(h1), &at_ki = listed(h2), &at_il = listed(g1), &at_lj = listed(g2);

    sides_[t] = {ij, ki.tail}, sides_[t + 1] = lj, sides_[t + 2] = jk;
    sides_[u] = {ji, lj.tail}, sides_[u + 1] = ki, sides_[u + 2] = il;
    halfedges_[edge] = {t, u};
    at_lj = t + 1, at_jk = t + 2, at_ki = u + 1, at_il = u + 2;
}

void GluedSurface::split_boundary(Index edge) {
    const Index h = halfedges_[edge][0];
    const Index h1 = next(h);
    const Halfedge ij = sides_[h], jk = sides_[h1];
    const Index k = tail(previous(h));
    const Index m = vertices_++, n = static_cast<Index>(sides_.size());
    if (!names_.empty())
        names_.push_back(names_.back() + 1);
    const Index mj = edges(), mk = mj + 1;

    listed(h1) = n + 1;
    sides_.insert(sides_.end(), {{{mj, ij.sign}, m}, jk, {{mk, -1}, k}});
    sides_[h1] = {{mk, 1}, m};
    edges_ += 2;
    halfedges_.push_back({n, -1});
    halfedges_.push_back({h1, n + 2});
}

} // namespace polydec
