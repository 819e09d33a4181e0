// SPDX-License-Identifier: MIT
#include "complex/surfaces/ordered_surface.h"

#include <array>
#include <optional>
#include <utility>

namespace polydec {

namespace {

/// Directions of edges, as signs against those that they have: from the lower vertex to the higher
/// one, and loops such that the sides of no triangle run in a circle.
class EdgeDirections {
public:
    explicit EdgeDirections(const GluedSurface& surface)
        : surface_(surface), signs_(static_cast<std::size_t>(surface.edges()), 0) {
        for (Index e = 0; e < surface.edges(); ++e)
            if (const Index a = surface.first_vertex(e), b = surface.last_vertex(e); a != b)
                signs_[e] = a < b ? 1 : -1;
        // only a triangle with one vertex at all its corners could be a circle
        for (Index t = 0; t < surface.triangles(); ++t)
            while (const std::optional<Index> h = free_side(t))
                walk(*h, -sum(t));
        for (auto& sign : signs_)
            sign = sign == 0 ? 1 : sign;
    }

    /// Whether a half-edge runs along its edge as it is directed now.
    int along(Index halfedge) const {
        return surface_.sign(halfedge) * signs_[surface_.edge(halfedge)];
    }

    int of(Index edge) const { return signs_[edge]; }

    Vector all() const {
        return Eigen::Map<const Column<std::int8_t>>(signs_.data(), surface_.edges())
            .cast<double>();
    }

private:
    /// A side of a triangle of loops that has no direction yet.
    std::optional<Index> free_side(Index t) const {
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (surface_.tail(h) != surface_.head(h))
                return {};
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (signs_[surface_.edge(h)] == 0)
                return h;
        return {};
    }

    int sum(Index t) const { return along(3 * t) + along(3 * t + 1) + along(3 * t + 2); }

    /// From triangle to triangle: what comes in with one sign leaves with the other, so that every
    /// triangle that is passed has both.
    void walk(Index h, int sign) {
        for (std::optional<Index> next = h; next; sign = -along(h)) {
            signs_[surface_.edge(*next)] =
                static_cast<std::int8_t>((sign < 0 ? -1 : 1) * surface_.sign(*next));
            h = surface_.partner(*next);
            if (h < 0)
                return;
            next = free_side(GluedSurface::triangle(h));
        }
    }

    const GluedSurface& surface_;
    std::vector<std::int8_t> signs_;
};

} // namespace

OrderedSurface in_order(const GluedSurface& surface, std::vector<Index> names) {
    const EdgeDirections directions(surface);
    Simplices ends(surface.edges(), 2), sides(surface.triangles(), 3);
    for (Index e = 0; e < surface.edges(); ++e) {
        const bool as_it_is = directions.of(e) > 0;
        ends(e, 0) = as_it_is ? surface.last_vertex(e) : surface.first_vertex(e);
        ends(e, 1) = as_it_is ? surface.first_vertex(e) : surface.last_vertex(e);
    }
    std::vector<std::int8_t> orientations;
    for (Index t = 0; t < surface.triangles(); ++t) {
        // the place of a corner is the number of sides that run into it
        std::array<int, 3> place{};
        for (int i = 0; i < 3; ++i)
            ++place[directions.along(3 * t + i) > 0 ? (i + 1) % 3 : i];
        for (int i = 0; i < 3; ++i)
            sides(t, place[i]) = surface.edge(3 * t + (i + 1) % 3);
        orientations.push_back((place[0] + 1) % 3 == place[1] ? 1 : -1);
    }
    return {Pieces({std::move(ends), std::move(sides)}, std::move(orientations), std::move(names)),
            directions.all()};
}

} // namespace polydec
