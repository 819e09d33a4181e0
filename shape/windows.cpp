// SPDX-License-Identifier: MIT
#include "shape/windows.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// A way is shorter than another one if it is so by more than rounding: of two that are equal, none
/// rules out the other.
constexpr double shorter = 1 - 1e-15;

/// Fans are dropped that reach no more than this part of a side, which is rounding.
constexpr double narrow = 1e-14;

constexpr double far = std::numeric_limits<double>::infinity();

double norm(double x, double y) {
    return std::sqrt(x * x + y * y);
}

/// Whether the distances of a fan are no longer than those of another one, from x to y. Their
/// difference is greatest at an end, or where the line through both places meets the side.
bool is_no_longer(const Fan& fan, const Fan& other, double x, double y) {
    const auto at = [&](double z) { return shorter * fan.distance(z) <= other.distance(z); };
    const double z = fan.along + (other.along - fan.along) * fan.below / (fan.below - other.below);
    return at(x) && at(y) && (!(x < z && z < y) || at(z));
}

/// A side by which a fan leaves a triangle, as it runs from `pivot` to `apex`.
struct Exit {
    Index halfedge;
    int sense; ///< 1 along the edge, -1 against it
    Index pivot, apex;
    double length;
    Index turns;
    bool has_branched;
    Index before; ///< as of PassedWindow
};

class Wavefront {
public:
    Wavefront(const UnfoldedTriangles& surface, std::span<const Index> sources, WindowTrace* trace);

    bool is_over() const { return queue_.is_empty(); }

    /// Takes the nearest window, or vertex, one step further.
    void step() {
        const Window next = queue_.pop();
        if (next.side < 0)
            spread(-1 - next.side, next.fan.offset);
        else
            cross(next);
    }

    const Vector& distances() const { return distances_; }

private:
    /// The shortest straight line to the apex of a triangle that came by a side, and where it
    /// crossed that.
    struct Nearest {
        double distance = far, cut = 0;
    };

    void start(Index v, double distance) {
        distances_[v] = distance;
        queue_.push({{0, 0, 0, 0, distance}, -1 - v, 0, -1, false, 0}, distance);
    }

    /// At a corner, by a straight line that came from `before`.
    void lower(Index corner, double distance, Index before) {
        const Index v = surface_.side(corner).tail;
        if (!(distance < shorter * distances_[v]))
            return;
        if (surface_.may_bend(v))
            start(v, distance);
        distances_[v] = distance;
        if (trace_ != nullptr)
            trace_->arrivals[v] = {corner, before};
    }

    Index kept(const Window& window) const {
        if (trace_ == nullptr)
            return -1;
        trace_->windows.push_back({window.fan, window.side, window.before});
        return static_cast<Index>(trace_->windows.size()) - 1;
    }

    void spread(Index v, double distance);
    void cross(const Window& window);
    int useless_part(const Window& window, double cut, double distance, double height);
    void turn(const Fan& fan, const UnfoldedTriangles::Side& corner, Index other, double base,
              double cut, const Exit& exit);
    void pass(const Fan& fan, const Exit& exit);
    void cut_off_known(Fan& fan, Index edge);

    const UnfoldedTriangles& surface_;
    WindowTrace* trace_;
    Vector distances_;
    WindowQueue queue_;
    std::vector<Nearest> nearest_;         // of half-edges
    std::vector<std::vector<Fan>> passed_; // of edges; none if no more than two triangles meet
};

Wavefront::Wavefront(const UnfoldedTriangles& surface, std::span<const Index> sources,
                     WindowTrace* trace)
    : surface_(surface),
      trace_(trace),
      distances_(Vector::Constant(surface.vertices(), far)),
      nearest_(3 * std::size_t(surface.triangles())) {
    for (Index e = 0; e < surface.edges() && passed_.empty(); ++e)
        if (surface.sides_of(e).size() > 2)
            passed_.resize(surface.edges());
    if (trace != nullptr)
        *trace = {{}, std::vector<WindowArrival>(std::size_t(surface.vertices()))};
    for (const Index v : sources)
        if (distances_[v] > 0) // some may be given twice
            start(v, 0);
}

void Wavefront::spread(Index v, double distance) {
    if (distance > distances_[v])
        return; // a shorter way was found since
    for (const Index h : surface_.corners_of(v)) {
        const Index opposite = Triangles::next(h), last = Triangles::previous(h);
        const auto &out = surface_.side(h), &side = surface_.side(opposite),
                   &back = surface_.side(last);
        lower(opposite, distance + out.length, -1 - h);
        lower(last, distance + back.length, -1 - h);
        pass({0, side.length, out.length * side.cosine, out.length * side.sine, distance},
             {opposite, side.sign, side.tail, back.tail, side.length, 0, false, -1 - h});
    }
}

void Wavefront::cross(const Window& window) {
    const Fan& fan = window.fan;
    const Index to_right = Triangles::next(window.side), to_left = Triangles::previous(window.side);
    const auto &base = surface_.side(window.side), &right = surface_.side(to_right),
               &left = surface_.side(to_left);

    // the straight line to the apex crosses the base at `cut`; where that is not seen, the way
    // bends at the end of what is, so that no apex is lost between two windows
    const double x = left.length * base.cosine, y = left.length * base.sine;
    const double cut = fan.along + (x - fan.along) * fan.below / (y + fan.below);
    const double through = std::clamp(cut, fan.begin, fan.end);
    const double distance = fan.distance(through) + norm(x - through, y);
    const Index before = kept(window);
    lower(to_left, distance, before);

    const bool is_seen = fan.begin < cut && cut < fan.end;
    const int useless = is_seen ? useless_part(window, cut, distance, y) : 0;
    if (fan.begin < cut && useless >= 0)
        turn(fan, base, right.tail, base.length, cut,
             {to_left, -left.sign, base.tail, left.tail, left.length, 1 + std::max(window.turns, 0),
              window.has_branched != 0, before});
    if (cut < fan.end && useless <= 0)
        turn(fan.reversed(base.length), right, base.tail, base.length, base.length - cut,
             {to_right, right.sign, right.tail, left.tail, right.length,
              1 + std::max(-window.turns, 0), window.has_branched != 0, before});
}

/// Which part of a window that sees the apex is of no use, -1 left of it, 1 right, or 0: a shorter
/// line to the apex has crossed all lines of one part. Source: Chen, Han, Shortest paths on a
/// polyhedron, Int. J. Comput. Geom. Appl. 6, 1996 (one angle, one split).
int Wavefront::useless_part(const Window& window, double cut, double distance, double height) {
    Nearest& nearest = nearest_[window.side];
    if (distance < nearest.distance) {
        nearest = {distance, cut};
        return 0;
    }
    // the other line may have come by another of the triangles; and two that cannot be told apart
    // may be one line
    const double length = surface_.side(window.side).length;
    const double rounding = 1e-10 * length * (1 + length / height);
    if (window.has_branched != 0 || !(nearest.distance < shorter * distance) ||
        !(std::abs(cut - nearest.cut) > rounding))
        return 0;
    return nearest.cut < cut ? -1 : 1;
}

/// The part of a fan between the line to the apex and the pivot, which lies at 0 on the base, where
/// the triangle has this corner; `other` is the base's other end.
void Wavefront::turn(const Fan& fan, const UnfoldedTriangles::Side& corner, Index other,
                     double base, double cut, const Exit& exit) {
    if (exit.turns > static_cast<Index>(surface_.corners_of(exit.pivot).size()))
        return; // a path through a corner twice is longer than one along its side
    const auto hit = [&](double x) {
        const double down = (fan.along - x) * corner.sine + fan.below * corner.cosine;
        return down > 0 ? std::min(fan.below * x / down, exit.length) : exit.length;
    };
    const Fan leaving{hit(fan.begin), fan.end < cut ? hit(fan.end) : exit.length,
                      fan.along * corner.cosine - fan.below * corner.sine,
                      std::abs(fan.along * corner.sine + fan.below * corner.cosine), fan.offset};

    // ways from the other end, on the far side of the fan, are compared where they gain least
    const double across = norm(base - leaving.begin * corner.cosine, leaving.begin * corner.sine);
    if (distances_[other] + across < shorter * leaving.distance(leaving.begin))
        return;
    pass(leaving, exit);
}

/// Into the other triangles at a side, unless ways along it from one of its ends are shorter to all
/// points of the fan: the difference is least where it ends.
/// Source: Xin, Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, ACM
/// Trans. Graph. 28(4), 2009.
void Wavefront::pass(const Fan& fan, const Exit& exit) {
    if (!(fan.end - fan.begin > narrow * exit.length) ||
        distances_[exit.pivot] + fan.end < shorter * fan.distance(fan.end) ||
        distances_[exit.apex] + (exit.length - fan.begin) < shorter * fan.distance(fan.begin))
        return;
    const Index edge = surface_.side(exit.halfedge).edge;
    const auto sides = surface_.sides_of(edge);
    const bool branches = sides.size() > 2;
    Fan known = exit.sense > 0 ? fan : fan.reversed(exit.length);
    if (branches)
        cut_off_known(known, edge);
    if (!(known.begin < known.end))
        return;

    const double nearest = known.distance(std::clamp(known.along, known.begin, known.end));
    for (const Index h : sides) {
        if (h == exit.halfedge)
            continue;
        const int sign = surface_.side(h).sign;
        queue_.push({sign > 0 ? known : known.reversed(exit.length), h,
                     sign == exit.sense ? exit.turns : -exit.turns, exit.before,
                     exit.has_branched || branches, 0},
                    nearest);
    }
}

/// Where three or more triangles meet at an edge, windows grow in number whenever they cross, and
/// equal ones may come on many ways. Takes from a fan, which runs as the edge does, what earlier
/// ones reach on ways no longer.
void Wavefront::cut_off_known(Fan& fan, Index edge) {
    for (const Fan& earlier : passed_[edge]) {
        const double x = std::max(fan.begin, earlier.begin), y = std::min(fan.end, earlier.end);
        if (!(x < y) || !is_no_longer(earlier, fan, x, y))
            continue;
        if (x == fan.begin)
            fan.begin = y;
        else if (y == fan.end)
            fan.end = x;
    }
    if (fan.begin < fan.end)
        passed_[edge].push_back(fan);
}

} // namespace

std::size_t most_windows(Index triangles) {
    return 100'000 + static_cast<std::size_t>(20 * std::pow(double(triangles), 1.5));
}

WindowDistances distances_by_windows(const UnfoldedTriangles& surface,
                                     std::span<const Index> sources, std::size_t most,
                                     const Progress& progress, WindowTrace* trace) {
    constexpr std::size_t between_reports = 1 << 16; // about a tenth of a second
    Wavefront front(surface, sources, trace);
    std::size_t windows = 0;
    for (; !front.is_over(); ++windows) {
        if (windows >= most)
            throw SolverFailure(fmt::format(
                "{} windows do not suffice for the distances on {} triangles: probably many "
                "triangles are needles. DiscretizeOptions::delaunay gives better triangles with "
                "the same distances; DistanceMethod::heat needs no windows",
                most, surface.triangles()));
        if (progress && windows % between_reports == 0)
            progress(fmt::format("{} windows", windows));
        front.step();
    }
    return {front.distances(), windows};
}

} // namespace polydec
