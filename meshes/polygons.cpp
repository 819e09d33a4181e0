// SPDX-License-Identifier: MIT
#include "meshes/polygons.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace polydec {

namespace {

constexpr double least_relative_area = 1e-6;
constexpr std::size_t most_corners_without_fan = 5000;

using Corners = std::span<const Index>;

/// Splits one polygon after the other. Areas are signed: positive like the polygon's area vector,
/// the sum of p_i wedge p_(i+1), which in R^3 is Newell's normal and exists in every R^N.
class PolygonSplitter {
public:
    PolygonSplitter(const Points& points, std::vector<Index>& triangles)
        : points_(points), triangles_(triangles) {}

    /// False if the polygon has no fan and is too large for cutting ears.
    bool split(Corners corners) {
        corners_ = corners;
        measure();
        for (std::size_t apex = 0; apex < corners_.size(); ++apex) {
            if (fan_fits(apex)) {
                add_fan(apex);
                return true;
            }
            if (corners_.size() > most_corners_without_fan)
                return false;
        }
        cut_ears();
        return true;
    }

private:
    double coordinate(std::size_t corner, Eigen::Index axis) const {
        return points_(corners_[corner], axis);
    }

    /// The area vector, by pairs of axes; relative to the first corner, for accuracy.
    void measure() {
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

    double wedge(std::size_t i, std::size_t j, std::size_t k, Eigen::Index a,
                 Eigen::Index b) const {
        const double ua = coordinate(j, a) - coordinate(i, a);
        const double ub = coordinate(j, b) - coordinate(i, b);
        const double va = coordinate(k, a) - coordinate(i, a);
        const double vb = coordinate(k, b) - coordinate(i, b);
        return ua * vb - ub * va;
    }

    /// Twice the area of a triangle of corners, as seen along the polygon's area vector.
    double area(std::size_t i, std::size_t j, std::size_t k) const {
        double product = 0.0;
        std::size_t pair = 0;
        for (Eigen::Index a = 0; a < points_.cols(); ++a)
            for (Eigen::Index b = a + 1; b < points_.cols(); ++b)
                product += area_vector_[pair++] * wedge(i, j, k, a, b);
        return product / length_;
    }

    double squared_distance(std::size_t i, std::size_t j) const {
        return (points_.row(corners_[i]) - points_.row(corners_[j])).squaredNorm();
    }

    /// False also where the polygon has no area at all, and `area` gives NaN.
    bool has_area(std::size_t i, std::size_t j, std::size_t k) const {
        const double longest =
            std::max({squared_distance(i, j), squared_distance(j, k), squared_distance(k, i)});
        return area(i, j, k) > 2.0 * least_relative_area * longest;
    }

    bool fan_fits(std::size_t apex) const {
        const auto size = corners_.size();
        for (std::size_t step = 1; step + 1 < size; ++step)
            if (!has_area(apex, (apex + step) % size, (apex + step + 1) % size))
                return false;
        return true;
    }

    void add_fan(std::size_t apex) {
        const auto size = corners_.size();
        for (std::size_t step = 1; step + 1 < size; ++step)
            add(apex, (apex + step) % size, (apex + step + 1) % size);
    }

    void add(std::size_t i, std::size_t j, std::size_t k) {
        triangles_.insert(triangles_.end(), {corners_[i], corners_[j], corners_[k]});
    }

    /// Cuts off, again and again, a convex corner whose triangle holds no other corner. Where there
    /// is none, because the polygon crosses itself, the rest becomes a fan for later checks to
    /// judge.
    void cut_ears() {
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

    void cut(std::size_t ear) {
        const auto before = previous_[ear];
        const auto after = next_[ear];
        add(before, ear, after);
        next_[before] = after;
        previous_[after] = before;
        is_ear_[before] = is_ear(before);
        is_ear_[after] = is_ear(after);
    }

    void link_all() {
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

    bool is_ear(std::size_t j) const {
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
    bool is_inside(std::size_t other, std::size_t i, std::size_t j, std::size_t k) const {
        if (area(i, j, other) < 0.0 || area(j, k, other) < 0.0 || area(k, i, other) < 0.0)
            return false;
        return squared_distance(other, i) > 0.0 && squared_distance(other, j) > 0.0 &&
               squared_distance(other, k) > 0.0;
    }

    const Points& points_;
    std::vector<Index>& triangles_;
    Corners corners_;
    std::vector<double> area_vector_;
    double length_ = 0.0;
    std::vector<std::size_t> next_;
    std::vector<std::size_t> previous_;
    std::vector<char> is_ear_;
};

/// How often something untidy was met, and where first.
struct Tally {
    std::size_t count = 0;
    std::size_t first_face = 0;

    void add(std::size_t face, std::size_t times = 1) {
        first_face = count == 0 ? face : first_face;
        count += times;
    }
};

struct Tallies {
    Tally split;
    Tally too_small;
    Tally repeats;
};

Corners without_repeats(Corners corners, std::vector<Index>& kept) {
    kept.clear();
    for (const Index corner : corners)
        if (kept.empty() || kept.back() != corner)
            kept.push_back(corner);
    while (kept.size() > 1 && kept.back() == kept.front())
        kept.pop_back();
    return kept;
}

/// The corners of the triangles; appends to `tags` one for each of them if the faces have tags.
std::vector<Index> triangles_of(const PolygonMesh& polygons, Tallies& tallies,
                                std::vector<Index>& tags) {
    std::vector<Index> triangles;
    triangles.reserve(polygons.corners.size());
    PolygonSplitter splitter(polygons.points, triangles);
    std::vector<Index> kept;

    const Corners all = polygons.corners;
    for (std::size_t face = 0; face + 1 < polygons.offsets.size(); ++face) {
        const auto begin = static_cast<std::size_t>(polygons.offsets[face]);
        const auto end = static_cast<std::size_t>(polygons.offsets[face + 1]);
        auto corners = all.subspan(begin, end - begin);
        if (corners.size() > 3) {
            corners = without_repeats(corners, kept);
            if (corners.size() < end - begin)
                tallies.repeats.add(face, end - begin - corners.size());
        }
        if (corners.size() < 3) {
            tallies.too_small.add(face);
        } else if (corners.size() == 3) {
            triangles.insert(triangles.end(), corners.begin(), corners.end());
        } else if (splitter.split(corners)) {
            tallies.split.add(face);
        } else {
            throw InvalidInput(
                fmt::format("face {} has {} corners and no fan of triangles from its first; "
                            "expected at most {} corners then; split it before",
                            face, corners.size(), most_corners_without_fan),
                {.degree = 2, .cells = {static_cast<Index>(face)}});
        }
        if (!polygons.tags.empty())
            tags.resize(triangles.size() / 3, polygons.tags[face]);
    }
    return triangles;
}

std::string counted(std::size_t count, const char* singular, const char* plural) {
    return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

std::vector<std::string> warnings_of(const Tallies& tallies) {
    std::vector<std::string> warnings;
    if (tallies.too_small.count > 0) {
        warnings.push_back(fmt::format(
            "{} with fewer than three corners left out, the first is face {}",
            counted(tallies.too_small.count, "face", "faces"), tallies.too_small.first_face));
    }
    if (tallies.repeats.count > 0) {
        warnings.push_back(
            fmt::format("{} removed from polygons, the first from face {}",
                        counted(tallies.repeats.count, "repeated corner", "repeated corners"),
                        tallies.repeats.first_face));
    }
    if (tallies.split.count > 0) {
        warnings.push_back(fmt::format(
            "{} with more than three corners split into triangles, the first is face {}",
            counted(tallies.split.count, "polygon", "polygons"), tallies.split.first_face));
    }
    return warnings;
}

bool are_triangles(const PolygonMesh& polygons) {
    for (std::size_t face = 0; face < polygons.offsets.size(); ++face)
        if (static_cast<std::size_t>(polygons.offsets[face]) != 3 * face)
            return false;
    return true;
}

Simplices simplices_from(const std::vector<Index>& corners) {
    const auto rows = static_cast<Eigen::Index>(corners.size() / 3);
    return Eigen::Map<const Simplices>(corners.data(), rows, 3);
}

} // namespace

void check_polygons(const PolygonMesh& polygons) {
    const auto& offsets = polygons.offsets;
    if (offsets.empty() || offsets.front() != 0 ||
        static_cast<std::size_t>(offsets.back()) != polygons.corners.size() ||
        !std::is_sorted(offsets.begin(), offsets.end())) {
        throw InvalidInput(fmt::format("the offsets of the polygons must ascend from 0 to the "
                                       "number of corners, {}",
                                       polygons.corners.size()));
    }
    for (std::size_t i = 0; i < polygons.corners.size(); ++i) {
        const Index corner = polygons.corners[i];
        if (corner < 0 || corner >= polygons.points.rows()) {
            const auto behind =
                std::upper_bound(offsets.begin(), offsets.end(), static_cast<Index>(i));
            throw InvalidInput(fmt::format("face {} has the vertex {}; expected 0 to {}",
                                           behind - offsets.begin() - 1, corner,
                                           polygons.points.rows() - 1),
                               {.degree = 2,
                                .cells = {static_cast<Index>(behind - offsets.begin() - 1)},
                                .vertices = {corner}});
        }
    }
}

Mesh split_polygons(PolygonMesh polygons) {
    check_polygons(polygons);
    if (!polygons.tags.empty() && polygons.tags.size() + 1 != polygons.offsets.size()) {
        throw InvalidInput(fmt::format("there are {} tags for {} faces; give every face one, or "
                                       "none at all",
                                       polygons.tags.size(), polygons.offsets.size() - 1));
    }
    Mesh mesh;
    if (are_triangles(polygons)) {
        mesh.simplices = simplices_from(polygons.corners);
        mesh.tags = std::move(polygons.tags);
    } else {
        Tallies tallies;
        mesh.simplices = simplices_from(triangles_of(polygons, tallies, mesh.tags));
        mesh.warnings = warnings_of(tallies);
    }
    mesh.points = std::move(polygons.points);
    return mesh;
}

} // namespace polydec
