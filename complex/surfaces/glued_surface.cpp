// SPDX-License-Identifier: MIT
#include "complex/surfaces/glued_surface.h"

#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

std::vector<std::array<Index, 2>> pair_halfedges(const std::vector<GluedSurface::SignedEdge>& sides,
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
    sides_.resize(std::size_t(triangles) * 3);
    tails_.resize(sides_.size());
    for (Index v = 0; v < vertices_; ++v)
        names_.push_back(surface.vertex_number(v));
    for (Index t = 0; t < triangles; ++t) {
        // the corners a, b, c are passed in their order, or the other way round
        const Index ab = surface.face(2, t, 2), bc = surface.face(2, t, 0);
        const Index ac = surface.face(2, t, 1);
        const Index a = surface.face(1, ab, 1), b = surface.face(1, ab, 0);
        const Index c = surface.face(1, ac, 0);
        const Index h = 3 * t;
        if (surface.orientation(t) > 0) {
            sides_[h] = {ab, 1}, sides_[h + 1] = {bc, 1}, sides_[h + 2] = {ac, -1};
            tails_[h] = a, tails_[h + 1] = b, tails_[h + 2] = c;
        } else {
            sides_[h] = {ac, 1}, sides_[h + 1] = {bc, -1}, sides_[h + 2] = {ab, -1};
            tails_[h] = a, tails_[h + 1] = c, tails_[h + 2] = b;
        }
    }
}

GluedSurface::GluedSurface(const Pieces& surface) : Triangles(surface) {
    check_edges(surface);
    halfedges_ = pair_halfedges(sides_, edges_);
}

GluedSurface::GluedSurface(const std::vector<std::array<SignedEdge, 3>>& triangles) {
    edges_ = count_edges(triangles);
    for (const auto& sides : triangles)
        sides_.insert(sides_.end(), sides.begin(), sides.end());
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
        tails_.push_back(vertex);
    }
}

void GluedSurface::set(Index halfedge, SignedEdge side, Index tail) {
    sides_[halfedge] = side;
    tails_[halfedge] = tail;
}

void GluedSurface::reverse(Index triangle) {
    // corners 0 1 2 become 0 2 1, so sides 0 and 2 change places and all signs
    const Index a = 3 * triangle, b = a + 1, c = a + 2;
    for (const Index h : {a, b, c})
        sides_[h].sign = static_cast<std::int8_t>(-sides_[h].sign);
    std::swap(tails_[b], tails_[c]);
    if (edge(a) != edge(c))
        std::swap(listed(a), listed(c));
    std::swap(sides_[a], sides_[c]);
}

void GluedSurface::flip(Index edge) {
    const auto [h, g] = halfedges_[edge];
    const Index t = 3 * triangle(h), u = 3 * triangle(g);
    const Index h1 = next(h), h2 = previous(h), g1 = next(g), g2 = previous(g);
    const SignedEdge along = sides_[h], against = sides_[g];
    const SignedEdge jk = sides_[h1], ki = sides_[h2], il = sides_[g1], lj = sides_[g2];
    const Index i = tails_[h], j = tails_[h1], k = tails_[h2], l = tails_[g2];

    // where the four outer sides were, as seen from their edges, before any of them moves
    Index &at_jk = listed(h1), &at_ki = listed(h2), &at_il = listed(g1), &at_lj = listed(g2);

    set(t, along, k), set(t + 1, lj, l), set(t + 2, jk, j);
    set(u, against, l), set(u + 1, ki, k), set(u + 2, il, i);
    halfedges_[edge] = {t, u};
    at_lj = t + 1, at_jk = t + 2, at_ki = u + 1, at_il = u + 2;
}

void GluedSurface::split_boundary(Index edge) {
    const Index h = halfedges_[edge][0];
    const Index h1 = next(h);
    const SignedEdge ij = sides_[h], jk = sides_[h1];
    const Index j = tails_[h1], k = tails_[previous(h)];
    const Index m = vertices_++, n = static_cast<Index>(sides_.size());
    if (!names_.empty())
        names_.push_back(names_.back() + 1);
    const Index mj = edges(), mk = mj + 1;

    listed(h1) = n + 1;
    sides_.resize(sides_.size() + 3);
    tails_.resize(tails_.size() + 3);
    set(n, {mj, ij.sign}, m), set(n + 1, jk, j), set(n + 2, {mk, -1}, k);
    set(h1, {mk, 1}, m);
    edges_ += 2;
    halfedges_.push_back({n, -1});
    halfedges_.push_back({h1, n + 2});
}

} // namespace polydec
