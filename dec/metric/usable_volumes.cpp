// SPDX-License-Identifier: MIT
#include "dec/metric/usable_volumes.h"

#include "base/errors.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_metric.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>

namespace polydec {

namespace {

void check_points(const Pieces& complex, const Points& points) {
    require_straight(complex, points, "a volume");
    if (points.cols() < complex.dimension())
        throw InvalidInput(fmt::format("simplices of dimension {} do not fit into {} coordinates",
                                       complex.dimension(), points.cols()));
    if (points.allFinite())
        return;
    for (Index v = 0; v < points.rows(); ++v)
        if (!points.row(v).allFinite())
            throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite",
                                           complex.vertex_number(v)),
                               {.vertices = {complex.vertex_number(v)}});
}

/// The lengths of the edges of a triangle, the largest last.
std::array<double, 3> sorted_lengths(const Pieces& complex, const Vector& lengths, Index s) {
    std::array<double, 3> sides{};
    for (int i = 0; i < 3; ++i)
        sides[i] = lengths[complex.face(2, s, i)];
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// Explains why k-simplex s, whose faces all exist, cannot have its given lengths.
std::string flaw_of_lengths(const Pieces& complex, const SimplexMetric& metric, int k, Index s) {
    const auto list = complex.vertex_numbers(k, s);
    const auto name = fmt::format("{}-simplex {} with vertices {}", k, s, fmt::join(list, ", "));
    if (constexpr int triangle = 2; k == triangle) {
        const auto [a, b, c] = sorted_lengths(complex, *metric.lengths(), s);
        if (c > a + b)
            return fmt::format("the lengths of {} violate the triangle inequality: {} is more than "
                               "{} + {}; correct the lengths",
                               name, c, a, b);
        return fmt::format(
            "the lengths of {}, {}, {} and {}, leave it no area; correct the lengths", name, a, b,
            c);
    }
    return fmt::format("the lengths of {} leave it no volume: the products of its edges are not "
                       "positive definite; correct the lengths",
                       name);
}

} // namespace

void check_metric(const Pieces& complex, const SimplexMetric& metric) {
    if (metric.points() != nullptr)
        check_points(complex, *metric.points());
    else if (metric.lengths()->size() != complex.size(1))
        throw InvalidInput(fmt::format("a metric of {} lengths is given: expected one for each of "
                                       "the {} edges of the complex",
                                       metric.lengths()->size(), complex.size(1)));
}

double largest_extent(const Corners& corners) {
    double extent = 0;
    for (Eigen::Index c = 0; c < corners.points.cols(); ++c) {
        double least = corners.points(corners.vertices[0], c), most = least;
        for (const Index v : corners.vertices) {
            least = std::min(least, corners.points(v, c));
            most = std::max(most, corners.points(v, c));
        }
        extent = std::max(extent, most - least);
    }
    return extent;
}

void refuse_volume(const Pieces& complex, const SimplexMetric& metric, int k, Index t) {
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (int m = 1; m < k; ++m)
        for (Index s = 0; s < complex.size(m); ++s)
            if (!sphere.look_at(layout.at(m, s)) || !is_moderate(sphere.volume()))
                refuse_volume(complex, metric, m, s);
    const auto list = complex.vertex_numbers(k, t);
    const Error::Place place{.degree = k, .cells = {t}, .vertices = list};
    const bool has_volume = sphere.look_at(layout.at(k, t));
    const double length = k > 0 ? largest_extent(layout.at(k, t)) : 1;
    if (has_volume || (length > 0 && !is_moderate(length)))
        throw InvalidInput(
            fmt::format("the {}-simplex with vertices {} has edges of about {:.3g} and volume "
                        "{:.3g}: products of such numbers overflow or underflow; scale the mesh to "
                        "a size nearer to 1, or remove its extremely small cells",
                        k, fmt::join(list, ", "), length, sphere.volume()),
            place);
    if (metric.lengths() != nullptr)
        throw InvalidInput(flaw_of_lengths(complex, metric, k, t), place);
    throw InvalidInput(
        fmt::format("the {}-simplex with vertices {} has no volume: remove it or move a vertex", k,
                    fmt::join(list, ", ")),
        place);
}

} // namespace polydec
