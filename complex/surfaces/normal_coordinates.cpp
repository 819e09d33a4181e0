// SPDX-License-Identifier: MIT
#include "complex/surfaces/normal_coordinates.h"

#include <algorithm>

namespace polydec {

NormalCoordinates::Corners NormalCoordinates::corners(const GluedSurface& surface,
                                                      Index triangle) const {
    // side i runs from corner i to the next one; opposite to corner i is side i + 1
    std::array<Index, 3> n;
    for (Index i = 0; i < 3; ++i)
        n[i] = crossings(surface.edge(3 * triangle + i));
    Corners result;
    for (int i = 0; i < 3; ++i)
        result.leaving[i] = std::max(0, n[(i + 1) % 3] - n[i] - n[(i + 2) % 3]);
    for (int i = 0; i < 3; ++i) {
        const Index others = result.leaving[(i + 1) % 3] + result.leaving[(i + 2) % 3];
        result.cut[i] = (std::max(0, n[i] + n[(i + 2) % 3] - n[(i + 1) % 3]) - others) / 2;
    }
    return result;
}

void NormalCoordinates::flip(const GluedSurface& surface, Index edge) {
    // half-edges i -> j of the triangle with apex k, j -> i of that with apex l; the strands that
    // cross them are numbered from i to j
    const auto [h, g] = surface.halfedges(edge);
    const Corners above = corners(surface, GluedSurface::triangle(h));
    const Corners below = corners(surface, GluedSurface::triangle(g));
    const Index i = h % 3, j = (i + 1) % 3, k = (i + 2) % 3;
    const Index J = g % 3, I = (J + 1) % 3, l = (J + 2) % 3;

    // on each side the first ones turn to i, the next ones end at the apex, the last turn to j
    const Index to_i = above.cut[i], at_k = to_i + above.leaving[k];
    const Index To_i = below.cut[I], at_l = To_i + below.leaving[l];
    const Index across = std::max(0, to_i - at_l) + std::max(0, To_i - at_k);
    const Index from_apex_to_apex = std::min(at_k, at_l) - std::max(to_i, To_i);

    const Index crossings = above.cut[k] + below.cut[l] + above.leaving[i] + above.leaving[j] +
                            below.leaving[I] + below.leaving[J] + across +
                            (numbers_[edge] == strand ? 1 : 0);
    numbers_[edge] = crossings == 0 && from_apex_to_apex > 0 ? strand : crossings;
}

void NormalCoordinates::split_boundary(const GluedSurface& surface, Index edge) {
    // nothing crosses the boundary: all strands of the triangle separate its apex from it
    const Index h = surface.halfedges(edge)[0];
    const Index jk = crossings(surface.edge(GluedSurface::next(h)));
    const Index ki = crossings(surface.edge(GluedSurface::previous(h)));
    numbers_.push_back(strand);
    numbers_.push_back(std::max(jk, ki));
}

namespace {

class Tracer {
public:
    Tracer(const GluedSurface& surface, const NormalCoordinates& coordinates)
        : surface_(surface), coordinates_(coordinates) {}

    Strands trace() {
        strands_.offsets.push_back(0);
        for (Index t = 0; t < surface_.triangles(); ++t) {
            const auto corners = coordinates_.corners(surface_, t);
            for (Index i = 0; i < 3; ++i)
                for (Index strand = 0; strand < corners.leaving[i]; ++strand)
                    follow(3 * t + i, corners.cut[(i + 1) % 3] + strand);
        }
        return std::move(strands_);
    }

private:
    /// From the corner at the tail of a half-edge out by the opposite side, to the strand's end.
    void follow(Index start, Index position) {
        const auto begin = strands_.crossings.size();
        Strands::Crossing crossing{GluedSurface::next(start), position};
        for (;;) {
            strands_.crossings.push_back(crossing);
            const Index g = surface_.partner(crossing.halfedge);
            const Index n = coordinates_.crossings(surface_.edge(g));
            const bool coherent = surface_.sign(g) != surface_.sign(crossing.halfedge);
            const Index p = coherent ? n - 1 - crossing.position : crossing.position;

            // entered over g, as number p from its tail
            const auto corners = coordinates_.corners(surface_, GluedSurface::triangle(g));
            const Index i = g % 3, apex = (i + 2) % 3;
            const Index side = GluedSurface::next(g), back = GluedSurface::previous(g);
            if (p < corners.cut[i]) {
                crossing = {back, coordinates_.crossings(surface_.edge(back)) - 1 - p};
            } else if (p < corners.cut[i] + corners.leaving[apex]) {
                keep_if_ascending(start, back, begin);
                return;
            } else {
                crossing = {side, n - 1 - p};
            }
        }
    }

    /// Every strand is found from both of its ends.
    void keep_if_ascending(Index start, Index end, std::size_t begin) {
        if (surface_.tail(start) < surface_.tail(end)) {
            strands_.ends.push_back({start, end});
            strands_.offsets.push_back(strands_.crossings.size());
        } else {
            strands_.crossings.resize(begin);
        }
    }

    const GluedSurface& surface_;
    const NormalCoordinates& coordinates_;
    Strands strands_;
};

} // namespace

Strands trace(const GluedSurface& surface, const NormalCoordinates& coordinates) {
    return Tracer(surface, coordinates).trace();
}

} // namespace polydec
