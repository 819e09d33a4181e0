// SPDX-License-Identifier: MIT
#include "meshes/polygon_splitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double least_relative_area = 1e-6;
constexpr std::size_t no_triangle = std::numeric_limits<std::size_t>::max();
using Quad = std::array<std::size_t, 4>; // the places of a, b, c, d around it, divided from a to c

/// Where the rotation begins that comes first in lexicographic order. Two candidates run against
/// each other; the loser skips all that the comparison ruled out, so that the time is linear.
std::size_t first_rotation(std::span<const Index> corners) {
    const auto size = corners.size();
    std::size_t i = 0, j = 1, same = 0;
    while (i < size && j < size && same < size) {
        const Index a = corners[(i + same) % size], b = corners[(j + same) % size];
        if (a == b) {
            ++same;
            continue;
        }
        (a > b ? i : j) += same + 1;
        j += i == j ? 1 : 0;
        same = 0;
    }
    return std::min(i, j);
}

void rotate_to_first(std::span<Index> corners) {
    const auto begin = static_cast<std::ptrdiff_t>(first_rotation(corners));
    std::rotate(corners.begin(), corners.begin() + begin, corners.end());
}

} // namespace

bool make_canonical(std::span<Index> corners) {
    std::vector<Index> turned(corners.rbegin(), corners.rend());
    rotate_to_first(corners);
    rotate_to_first(turned);
    const bool turns =
        std::lexicographical_compare(turned.begin(), turned.end(), corners.begin(), corners.end());
    if (turns)
        std::copy(turned.begin(), turned.end(), corners.begin());
    return turns;
}

bool PolygonSplitter::split(std::span<const Index> corners, std::span<const EdgeEnds> avoided) {
    corners_ = corners;
    avoided_ = avoided;
    places_.clear();
    scale();
    measure();
    const bool is_fan = make_fan();
    const bool is_large = corners_.size() > most_corners_without_fan;
    if (!is_fan && is_large)
        return false;
    if (!is_fan)
        cut_ears();
    find_neighbors();
    if (!is_large)
        flip_to_delaunay();
    keep_result();
    return true;
}

/// Fourth powers of lengths are then numbers, and all is the same in every unit.
void PolygonSplitter::scale() {
    scaled_.resize(std::ssize(corners_), points_.cols());
    for (Index corner = 0; corner < scaled_.rows(); ++corner)
        scaled_.row(corner) = points_.row(corners_[corner]);
    const double largest = scaled_.size() > 0 ? scaled_.cwiseAbs().maxCoeff() : 0;
    constexpr int most = 1000; // so that the power is a number
    if (largest > 0)
        scaled_ *= std::ldexp(1.0, -std::clamp(std::ilogb(largest), -most, most));
}

/// The area vector, by pairs of axes; relative to the first corner, for accuracy.
void PolygonSplitter::measure() {
    const auto axes = points_.cols();
    area_vector_.assign(static_cast<std::size_t>(axes * (axes - 1) / 2), 0.0);
    for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
        std::size_t pair = 0;
        for (Eigen::Index a = 0; a < axes; ++a)
            for (Eigen::Index b = a + 1; b < axes; ++b)
                area_vector_[pair++] += wedge(0, i, i + 1, a, b);
    }
    double square = 0.0;
    for (const double component : area_vector_)
        square += component * component;
    length_ = std::sqrt(square);
}

double PolygonSplitter::wedge(std::size_t i, std::size_t j, std::size_t k, Eigen::Index a,
                              Eigen::Index b) const {
    const double ua = coordinate(j, a) - coordinate(i, a);
    const double ub = coordinate(j, b) - coordinate(i, b);
    const double va = coordinate(k, a) - coordinate(i, a);
    const double vb = coordinate(k, b) - coordinate(i, b);
    return ua * vb - ub * va;
}

/// Twice the area of a triangle of corners, as seen along the polygon's area vector.
double PolygonSplitter::area(std::size_t i, std::size_t j, std::size_t k) const {
    double product = 0.0;
    std::size_t pair = 0;
    for (Eigen::Index a = 0; a < points_.cols(); ++a)
        for (Eigen::Index b = a + 1; b < points_.cols(); ++b)
            product += area_vector_[pair++] * wedge(i, j, k, a, b);
    return product / length_;
}

double PolygonSplitter::squared_distance(std::size_t i, std::size_t j) const {
    return (scaled_.row(static_cast<Index>(i)) - scaled_.row(static_cast<Index>(j))).squaredNorm();
}

/// False also where the polygon has no area at all, and `area` gives NaN.
bool PolygonSplitter::has_area(std::size_t i, std::size_t j, std::size_t k) const {
    const double longest =
        std::max({squared_distance(i, j), squared_distance(j, k), squared_distance(k, i)});
    return area(i, j, k) > 2.0 * least_relative_area * longest;
}

bool PolygonSplitter::fan_fits(std::size_t apex) const {
    const auto size = corners_.size();
    for (std::size_t step = 1; step + 1 < size; ++step)
        if (!has_area(apex, (apex + step) % size, (apex + step + 1) % size))
            return false;
    return true;
}

/// From the first corner from which one fits, if there is one.
bool PolygonSplitter::make_fan() {
    const auto size = corners_.size();
    const std::size_t apexes = size > most_corners_without_fan ? 1 : size;
    for (std::size_t apex = 0; apex < apexes; ++apex)
        if (fan_fits(apex)) {
            for (std::size_t step = 1; step + 1 < size; ++step)
                add(apex, (apex + step) % size, (apex + step + 1) % size);
            return true;
        }
    return false;
}

/// Cuts off, again and again, a convex corner whose triangle holds no other corner. Where there
/// is none, because the polygon crosses itself, the rest becomes a fan for later checks to judge.
void PolygonSplitter::cut_ears() {
    link_all();
    std::size_t corner = 0;
    std::size_t left = corners_.size();
    std::size_t refused = 0;
    while (left > 3 && refused < left) {
        if (is_ear_[corner] != 0) {
            cut(corner);
            --left;
            refused = 0;
        } else {
            ++refused;
        }
        corner = next_[corner];
    }
    for (auto i = next_[corner]; next_[i] != corner; i = next_[i])
        add(corner, i, next_[i]);
}

void PolygonSplitter::cut(std::size_t ear) {
    const auto before = previous_[ear];
    const auto after = next_[ear];
    add(before, ear, after);
    next_[before] = after;
    previous_[after] = before;
    is_ear_[before] = is_ear(before);
    is_ear_[after] = is_ear(after);
}

void PolygonSplitter::link_all() {
    const auto size = corners_.size();
    next_.resize(size);
    previous_.resize(size);
    is_ear_.assign(size, 0);
    for (std::size_t i = 0; i < size; ++i) {
        next_[i] = (i + 1) % size;
        previous_[i] = (i + size - 1) % size;
    }
    for (std::size_t i = 0; i < size; ++i)
        is_ear_[i] = is_ear(i);
}

bool PolygonSplitter::is_ear(std::size_t j) const {
    const auto i = previous_[j];
    const auto k = next_[j];
    if (!has_area(i, j, k))
        return false;
    for (auto other = next_[k]; other != i; other = next_[other])
        if (is_inside(other, i, j, k))
            return false;
    return true;
}

/// The border counts as inside, but a corner at the same place does not: polygons with a hole
/// visit the ends of their bridge twice.
bool PolygonSplitter::is_inside(std::size_t other, std::size_t i, std::size_t j,
                                std::size_t k) const {
    if (area(i, j, other) < 0.0 || area(j, k, other) < 0.0 || area(k, i, other) < 0.0)
        return false;
    return squared_distance(other, i) > 0.0 && squared_distance(other, j) > 0.0 &&
           squared_distance(other, k) > 0.0;
}

/// Two triangles with a side between the same two places of the polygon are neighbors.
void PolygonSplitter::find_neighbors() {
    struct Side {
        std::size_t low, high, triangle, opposite;
    };
    std::vector<Side> sides;
    sides.reserve(3 * places_.size());
    neighbors_.assign(places_.size(), {no_triangle, no_triangle, no_triangle});
    for (std::size_t t = 0; t < places_.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = places_[t][(i + 1) % 3], b = places_[t][(i + 2) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, i});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    for (std::size_t s = 1; s < sides.size(); ++s) {
        const Side &a = sides[s - 1], &b = sides[s];
        if (a.low == b.low && a.high == b.high) {
            neighbors_[a.triangle][a.opposite] = b.triangle;
            neighbors_[b.triangle][b.opposite] = a.triangle;
        }
    }
}

/// Flips improve the triangulation of a plane polygon, and so come to an end; of a bent one they
/// might not, hence the bound.
void PolygonSplitter::flip_to_delaunay() {
    bool flips = true;
    for (std::size_t pass = 0; flips && pass < places_.size(); ++pass) {
        flips = false;
        for (std::size_t t = 0; t < places_.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                if (neighbors_[t][i] != no_triangle && neighbors_[t][i] > t &&
                    flip_is_better(quad_around(t, i))) {
                    flip(t, i);
                    flips = true;
                }
    }
}

/// The quad of a triangle and its neighbor opposite to corner i, which is b of the quad.
Quad PolygonSplitter::quad_around(std::size_t t, std::size_t i) const {
    const auto other = neighbors_[t][i];
    const auto back =
        static_cast<std::size_t>(std::find(neighbors_[other].begin(), neighbors_[other].end(), t) -
                                 neighbors_[other].begin());
    return {places_[t][(i + 2) % 3], places_[t][i], places_[t][(i + 1) % 3], places_[other][back]};
}

bool PolygonSplitter::flip_is_better(const Quad& quad) const {
    const auto [a, b, c, d] = quad;
    const bool fits = has_area(a, b, c) && has_area(a, c, d);
    const bool flipped_fits = has_area(a, b, d) && has_area(b, c, d);
    if (fits != flipped_fits || !fits)
        return flipped_fits;
    const auto is_avoided = [this](const EdgeEnds& edge) {
        return std::binary_search(avoided_.begin(), avoided_.end(), edge);
    };
    const auto kept = ends(a, c), flipped = ends(b, d);
    if (is_avoided(kept) != is_avoided(flipped))
        return is_avoided(kept);
    const double gain = margin(quad), error = rounding(quad);
    if (std::abs(gain) > error)
        return gain < 0;
    const double length = std::sqrt(squared_distance(a, c));
    const double flipped_length = std::sqrt(squared_distance(b, d));
    if (std::abs(length - flipped_length) > error * length)
        return flipped_length < length;
    return flipped[0] < kept[0];
}

/// Puts the diagonal of the quad from b to d.
void PolygonSplitter::flip(std::size_t t, std::size_t i) {
    const auto [a, b, c, d] = quad_around(t, i);
    const auto other = neighbors_[t][i];
    const auto across = [&](std::size_t triangle, std::size_t corner) {
        const auto& places = places_[triangle];
        return neighbors_[triangle]
                         [std::find(places.begin(), places.end(), corner) - places.begin()];
    };
    const auto ab = across(t, c), bc = across(t, a), cd = across(other, a), da = across(other, c);
    places_[t] = {a, b, d};
    neighbors_[t] = {other, da, ab};
    places_[other] = {b, c, d};
    neighbors_[other] = {cd, t, bc};
    if (da != no_triangle)
        std::replace(neighbors_[da].begin(), neighbors_[da].end(), other, t);
    if (bc != no_triangle)
        std::replace(neighbors_[bc].begin(), neighbors_[bc].end(), t, other);
}

/// The angle at j, by Kahan's formula, which is accurate for every angle in every R^N.
double PolygonSplitter::angle(std::size_t i, std::size_t j, std::size_t k) const {
    const double u = std::sqrt(squared_distance(i, j)), v = std::sqrt(squared_distance(k, j));
    double difference = 0.0, sum = 0.0;
    for (Eigen::Index axis = 0; axis < points_.cols(); ++axis) {
        const double x = v * (coordinate(i, axis) - coordinate(j, axis));
        const double y = u * (coordinate(k, axis) - coordinate(j, axis));
        difference += (x - y) * (x - y);
        sum += (x + y) * (x + y);
    }
    return 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
}

/// Of the diagonal from a to c.
double PolygonSplitter::margin(const Quad& quad) const {
    const auto [a, b, c, d] = quad;
    return angle(d, a, b) + angle(b, c, d) - angle(a, b, c) - angle(c, d, a);
}

/// Bounds the error of a margin, and the relative error of a length: four angles, each from two
/// edges with ends that are rounded to doubles.
double PolygonSplitter::rounding(const Quad& quad) const {
    double largest = 0.0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < quad.size(); ++i) {
        largest = std::max(largest, scaled_.row(static_cast<Index>(quad[i])).cwiseAbs().maxCoeff());
        shortest = std::min(shortest, squared_distance(quad[i], quad[(i + 1) % quad.size()]));
    }
    return 32 * std::numeric_limits<double>::epsilon() * (1 + largest / std::sqrt(shortest));
}

EdgeEnds PolygonSplitter::ends(std::size_t i, std::size_t j) const {
    return {std::min(corners_[i], corners_[j]), std::max(corners_[i], corners_[j])};
}

void PolygonSplitter::keep_result() {
    triangles_.clear();
    diagonals_.clear();
    for (std::size_t t = 0; t < places_.size(); ++t) {
        const auto [a, b, c] = places_[t];
        triangles_.push_back({corners_[a], corners_[b], corners_[c]});
        for (std::size_t i = 0; i < 3; ++i)
            if (neighbors_[t][i] != no_triangle && neighbors_[t][i] > t) {
                const auto quad = quad_around(t, i);
                diagonals_.push_back({ends(quad[0], quad[2]), margin(quad)});
            }
    }
}

} // namespace polydec
