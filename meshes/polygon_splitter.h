// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace polydec {

/// Two vertices, ascending.
using EdgeEnds = std::array<Index, 2>;

/// A diagonal that divides a polygon.
struct PolygonDiagonal {
    EdgeEnds ends;
    double margin = 0; ///< the opposite angles sum to this much less than at the diagonal that
                       ///< could replace it, in radians
};

/// Reorders the corners of a polygon to the lexicographically first order, independent of the
/// starting corner and direction. Returns true if the direction changes.
bool make_canonical(std::span<Index> corners);

/// Splits polygons into triangles, one at a time.
///
/// A fan, or ears if no fan fits, becomes Delaunay by flips of diagonals. The first criterion that
/// decides makes the flip: both triangles have area and are not inverted relative to the polygon's
/// area vector, the sum of p_i wedge p_(i+1), which is Newell's normal in R^3 and exists in every
/// R^N; the diagonal is not in `avoided`; the opposite angles have the smaller sum; the diagonal is
/// shorter; it has the smallest vertex number. Angles and lengths within rounding of the
/// coordinates are equal.
///
/// Source: Lawson, Software for C1 surface interpolation, 1977.
class PolygonSplitter {
public:
    explicit PolygonSplitter(const Points& points) : points_(points) {}

    /// A larger polygon becomes a fan from its first corner.
    static constexpr std::size_t most_corners_without_fan = 5000;

    /// Splits a polygon with canonical corners; `avoided` is sorted. Returns false if the polygon
    /// exceeds that limit and the fan does not fit.
    bool split(std::span<const Index> corners, std::span<const EdgeEnds> avoided);

    /// Results for the last polygon, by vertex numbers: n - 2 triangles, oriented like it, and n -
    /// 3 diagonals.
    const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
    const std::vector<PolygonDiagonal>& diagonals() const { return diagonals_; }

private:
    using Places = std::array<std::size_t, 3>; ///< of a triangle's corners in the polygon

    double coordinate(std::size_t corner, Eigen::Index axis) const {
        return scaled_(static_cast<Index>(corner), axis);
    }
    void scale();
    void measure();
    double wedge(std::size_t i, std::size_t j, std::size_t k, Eigen::Index a, Eigen::Index b) const;
    double area(std::size_t i, std::size_t j, std::size_t k) const;
    double squared_distance(std::size_t i, std::size_t j) const;
    bool has_area(std::size_t i, std::size_t j, std::size_t k) const;
    bool fan_fits(std::size_t apex) const;
    bool make_fan();
    void add(std::size_t i, std::size_t j, std::size_t k) { places_.push_back({i, j, k}); }

    void cut_ears();
    void cut(std::size_t ear);
    void link_all();
    bool is_ear(std::size_t j) const;
    bool is_inside(std::size_t other, std::size_t i, std::size_t j, std::size_t k) const;

    void find_neighbors();
    void flip_to_delaunay();
    bool flip_is_better(const std::array<std::size_t, 4>& quad) const;
    void flip(std::size_t t, std::size_t i);
    std::array<std::size_t, 4> quad_around(std::size_t t, std::size_t i) const;
    double angle(std::size_t i, std::size_t j, std::size_t k) const;
    double margin(const std::array<std::size_t, 4>& quad) const;
    double rounding(const std::array<std::size_t, 4>& quad) const;
    EdgeEnds ends(std::size_t i, std::size_t j) const;
    void keep_result();

    const Points& points_;
    std::span<const Index> corners_;
    std::span<const EdgeEnds> avoided_;
    Points scaled_; ///< corners times a power of 2: the largest coordinate is near 1
    std::vector<double> area_vector_;
    double length_ = 0.0;
    std::vector<std::size_t> next_, previous_;
    std::vector<char> is_ear_;
    std::vector<Places> places_;
    std::vector<Places> neighbors_; ///< the triangle opposite to each corner, or none
    std::vector<std::array<Index, 3>> triangles_;
    std::vector<PolygonDiagonal> diagonals_;
};

} // namespace polydec
