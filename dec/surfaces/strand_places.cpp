// SPDX-License-Identifier: MIT
#include "dec/surfaces/strand_places.h"

#include "dec/metric/triangle.h"

#include <algorithm>
#include <complex>

namespace polydec {

namespace {

using Place = std::complex<double>; // in the plane of the strip

double cross(Place a, Place b) {
    return (std::conj(a) * b).imag();
}

/// The triangles along one strand, laid flat, with its first vertex at the origin. The strand
/// leaves each triangle across an edge from P on its right to Q on its left; passed triangles are
/// behind it.
class Strip {
public:
    Strip(const GluedSurface& surface, const Vector& lengths)
        : surface_(surface), lengths_(lengths) {}

    void begin(Index start) {
        const double a = length(start), b = length(GluedSurface::previous(start));
        P_ = a;
        Q_ = apex(a, b, length(GluedSurface::next(start)));
        tail_is_P_ = true;
    }

    Place P() const { return P_; }
    Place Q() const { return Q_; }
    Place last_apex() const { return R_; }

    /// Lays down the triangle behind half-edge h.
    void enter_behind(Index h) {
        entered_ = surface_.partner(h);
        if (surface_.sign(entered_) != surface_.sign(h))
            tail_is_P_ = !tail_is_P_;
        const double next = length(GluedSurface::next(entered_));
        const double last = length(GluedSurface::previous(entered_));
        const double l = length(entered_);
        const Place direction = (Q_ - P_) / std::abs(Q_ - P_);
        const Place from_P = tail_is_P_ ? apex(l, last, next) : apex(l, next, last);
        R_ = P_ + direction * std::conj(from_P);
    }

    /// Moves to the side of that triangle across which the strand leaves.
    void leave_by(Index side) {
        const bool is_next = side == GluedSurface::next(entered_);
        const bool has_P = is_next != tail_is_P_;
        (has_P ? Q_ : P_) = R_;
        tail_is_P_ = is_next == has_P;
    }

private:
    double length(Index halfedge) const { return lengths_[surface_.edge(halfedge)]; }

    /// The third corner of a triangle with corners 0 and l, above the axis, at these distances.
    static Place apex(double l, double first, double second) {
        return {(l + (first - second) * ((first + second) / l)) / 2,
                2 * triangle_area(l, first, second) / l};
    }

    const GluedSurface& surface_;
    const Vector& lengths_;
    Place P_, Q_, R_;
    Index entered_ = -1;
    bool tail_is_P_ = true; // of the half-edge last crossed or entered
};

} // namespace

std::vector<double> strand_places(const GluedSurface& surface, const Vector& lengths,
                                  const Strands& strands) {
    std::vector<double> places(strands.crossings.size());
    std::vector<std::pair<Place, Place>> edges;
    Strip strip(surface, lengths);
    for (std::size_t s = 0; s < strands.ends.size(); ++s) {
        const std::size_t begin = strands.offsets[s], end = strands.offsets[s + 1];
        edges.clear();
        strip.begin(strands.ends[s][0]);
        for (std::size_t c = begin; c < end; ++c) {
            if (c > begin)
                strip.leave_by(strands.crossings[c].halfedge);
            edges.emplace_back(strip.P(), strip.Q());
            strip.enter_behind(strands.crossings[c].halfedge);
        }
        const Place strand = strip.last_apex();
        double last = 0;
        for (std::size_t c = begin; c < end; ++c) {
            const auto& [P, Q] = edges[c - begin];
            const double place = cross(P, Q - P) / cross(strand, Q - P);
            if (place > last) // rounding may swap neighbors; also excludes NaN
                last = std::min(place, 1.0);
            places[c] = last;
        }
    }
    return places;
}

} // namespace polydec
