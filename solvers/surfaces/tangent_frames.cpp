// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "complex/disjoint_sets.h"
#include "dec/metric/triangle.h"
#include "solvers/surfaces/parallel_transport.h"
#include "solvers/surfaces/surface_metric.h"

#include <fmt/format.h>

#include <numbers>

namespace polydec {

namespace {

void check_orientation(const GluedSurface& surface) {
    DisjointSets sides(surface.triangles());
    Index incoherent = -1;
    for (Index e = 0; e < surface.edges(); ++e) {
        if (surface.is_boundary(e))
            continue;
        const auto& [h, g] = surface.halfedges(e);
        const bool coherent = surface.is_coherent(e);
        const Index first = surface.vertex_number(surface.first_vertex(e)),
                    last = surface.vertex_number(surface.last_vertex(e));
        if (!sides.join(h / 3, g / 3, coherent ? 1 : -1))
            throw InvalidInput(
                fmt::format(
                    "the surface is one-sided: a path across edge {} (from vertex {} to {}) "
                    "returns with left and right exchanged. Angles need a surface with two sides",
                    e, first, last),
                {.degree = 1, .cells = {e}, .vertices = {first, last}});
        if (!coherent && incoherent < 0)
            incoherent = e;
    }
    if (incoherent >= 0)
        throw InvalidInput(
            fmt::format(
                "triangles {} and {} at edge {} have opposite orientations: reverse one of them",
                surface.halfedges(incoherent)[0] / 3, surface.halfedges(incoherent)[1] / 3,
                incoherent),
            {.degree = 1, .cells = {incoherent}});
}

/// For every vertex, an outgoing half-edge without predecessor, or else the first one.
std::vector<Index> first_halfedges(const GluedSurface& surface) {
    std::vector<Index> first(std::size_t(surface.vertices()), -1);
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        Index& f = first[surface.tail(h)];
        if (f < 0 || (surface.partner(h) < 0 && surface.partner(f) >= 0))
            f = h;
    }
    return first;
}

/// The triangles around a vertex, one after the other.
struct Fan {
    std::vector<Index> halfedges; // from the vertex, one per corner
    Index last = -1;              // ends the last corner; points to the vertex
    bool closed = false;
};

Fan fan(const GluedSurface& surface, Index first) {
    Fan result;
    Index h = first;
    do {
        result.halfedges.push_back(h);
        result.last = surface.previous(h);
        h = surface.partner(result.last);
    } while (h >= 0 && h != first);
    result.closed = h >= 0;
    return result;
}

/// Sets the angles at a vertex.
void measure(const GluedSurface& surface, const SurfaceMetric& metric, Index vertex, const Fan& fan,
             TangentFrames& frames) {
    const auto length = [&](Index h) { return metric.lengths[surface.edge(h)]; };
    double angle = 0;
    for (const Index h : fan.halfedges) {
        frames.at_tail[h] = angle;
        const double area = metric.areas[GluedSurface::triangle(h)];
        angle +=
            corner_angle(length(surface.next(h)), length(h), length(surface.previous(h)), area);
    }
    frames.sums[vertex] = angle;
    if (!fan.closed)
        frames.at_head[fan.last] = angle;
    for (const Index h : fan.halfedges) {
        if (fan.closed)
            frames.at_tail[h] *= 2 * std::numbers::pi / angle;
        if (const Index g = surface.partner(h); g >= 0)
            frames.at_head[g] = frames.at_tail[h];
    }
}

} // namespace

TangentFrames tangent_frames(const GluedSurface& surface, const Vector& lengths) {
    const SurfaceMetric metric = surface_metric(surface, lengths);
    check_orientation(surface);
    const Index halfedges = 3 * surface.triangles();
    std::vector<std::size_t> corners(std::size_t(surface.vertices()), 0);
    for (Index h = 0; h < halfedges; ++h)
        ++corners[surface.tail(h)];

    TangentFrames frames{.reference = first_halfedges(surface),
                         .at_tail = Vector(halfedges),
                         .at_head = Vector(halfedges),
                         .sums = Vector(surface.vertices())};
    for (Index v = 0; v < surface.vertices(); ++v) {
        const Fan around = fan(surface, frames.reference[v]);
        if (around.halfedges.size() != corners[v])
            throw InvalidInput(
                fmt::format("the triangles around vertex {} form several fans (the first has {} of "
                            "{} corners): split the vertex into one for each fan",
                            surface.vertex_number(v), around.halfedges.size(), corners[v]),
                {.vertices = {surface.vertex_number(v)}});
        measure(surface, metric, v, around, frames);
    }
    return frames;
}

} // namespace polydec
