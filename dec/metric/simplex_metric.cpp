// SPDX-License-Identifier: MIT
#include "dec/metric/simplex_metric.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/triangle.h"
#include "meshes/edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace polydec {

namespace {

/// Rounding error of a squared height, relative to its squared edge.
constexpr double few_last_digits = 16 * std::numeric_limits<double>::epsilon();

/// Squares of lengths, and products of a few of them, must neither overflow nor underflow.
constexpr double largest_length = 1e100;

/// The largest power of two up to a positive normal number: dividing by it loses no digit.
double power_of_two(double number) {
    constexpr auto exponent = std::uint64_t{0x7ff} << 52;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) & exponent);
}

} // namespace

SimplexMetric::SimplexMetric(const Pieces& complex, Vector of_edges)
    : lengths_(std::make_shared<const Vector>(std::move(of_edges))) {
    const Vector& lengths = *lengths_;
    if (lengths.size() != complex.size(1))
        throw InvalidInput(fmt::format("{} lengths are given: expected one for each of the {} "
                                       "edges of the complex",
                                       lengths.size(), complex.size(1)));
    for (Index e = 0; e < complex.size(1); ++e) {
        const double length = lengths[e];
        if (length >= 1 / largest_length && length <= largest_length)
            continue;
        const auto ends = complex.vertex_numbers(1, e);
        if (!(length > 0) || !std::isfinite(length))
            throw InvalidInput(fmt::format("edge {} with vertices {} and {} has length {}: "
                                           "expected a finite number above 0",
                                           e, ends[0], ends[1], length),
                               {.degree = 1, .cells = {e}, .vertices = ends});
        throw InvalidInput(fmt::format("edge {} with vertices {} and {} has length {:.3g}: "
                                       "scale the mesh to a size nearer to 1",
                                       e, ends[0], ends[1], length),
                           {.degree = 1, .cells = {e}, .vertices = ends});
    }
}

SimplexLayout::SimplexLayout(const Pieces& complex, const SimplexMetric& metric)
    : complex_(complex), metric_(metric) {
    if (metric.points() != nullptr)
        return;
    const int corners = complex.dimension() + 1;
    rows_.resize(corners);
    std::iota(rows_.begin(), rows_.end(), 0);
    lengths_.resize(rows_.size() * rows_.size());
    for (int k = 0; k < corners; ++k)
        tables_.emplace_back(k + 1, k);
    for (int k = 1; k < corners; ++k)
        faces_.push_back(complex.faces(k));
}

[[gnu::always_inline]] inline void SimplexLayout::measure_edges(int k, Index s) {
    for (int i = 0; i <= k; ++i)
        for (int j = i + 1; j <= k; ++j) {
            Index edge = s; // without all other corners, the last one first
            for (int m = k, corner = k; m > 1; --corner)
                if (corner != i && corner != j)
                    edge = faces_[--m](edge, corner);
            const double between = (*metric_.lengths())[edge];
            lengths_[i * rows_.size() + j] = lengths_[j * rows_.size() + i] = between;
        }
}

/// An end of the shortest edge: products of edges from there lose the fewest digits.
[[gnu::always_inline]] inline int SimplexLayout::base(int k) const {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= k; ++i)
        for (int j = i + 1; j <= k; ++j)
            if (length(i, j) < least) {
                least = length(i, j);
                best = i;
            }
    return best;
}

/// Inner product of the edges from the origin to i and to j.
double SimplexLayout::product(int origin, int i, int j) const {
    return twice_scalar_product(length(i, j), length(origin, i), length(origin, j)) / 2;
}

/// The height of corner a over the previous corners, whose first coordinates are known. 0 if only
/// rounding is left.
template <class Corner>
[[gnu::always_inline]] inline double SimplexLayout::height(int origin, Corner corner, int a,
                                                           const double* known) const {
    // an edge's height is its length; a triangle's follows from its area without loss
    const double own = length(origin, corner(a));
    if (a == 0)
        return own;
    if (a == 1) {
        const double base = length(origin, corner(0)), opposite = length(corner(0), corner(1));
        // products of four lengths stay finite
        const double unit = power_of_two(std::max({base, own, opposite}));
        return 2 * unit * triangle_area(base / unit, own / unit, opposite / unit) / (base / unit);
    }
    double squared = own * own;
    for (int b = 0; b < a; ++b)
        squared -= known[b] * known[b];
    return squared > few_last_digits * own * own ? std::sqrt(squared) : 0;
}

/// Returns false for a simplex that does not exist.
template <int k_fixed>
bool SimplexLayout::place(int k_given, Index s, double* table) {
    const int k = k_fixed >= 0 ? k_fixed : k_given;
    measure_edges(k, s);
    const int origin = base(k);
    const auto corner = [origin](int a) { return a < origin ? a : a + 1; };
    for (int a = 0; a < k; ++a) {
        double* const row = table + corner(a) * k;
        for (int b = 0; b < a; ++b) {
            const double* const other = table + corner(b) * k;
            double rest = product(origin, corner(a), corner(b));
            for (int c = 0; c < b; ++c)
                rest -= row[c] * other[c];
            row[b] = rest / other[b];
        }
        row[a] = height(origin, corner, a, row);
        if (!(row[a] > 0))
            return false;
    }
    return true;
}

Corners SimplexLayout::lay_out(int k, Index s) {
    Points& table = tables_[k];
    table.setZero();
    sphere_kernel::for_dimensions(k, k, [&]<int k_fixed, int N_fixed> {
        if (!place<k_fixed>(k, s, table.data()))
            table.setZero();
    });
    return {table, {rows_.data(), static_cast<std::size_t>(k) + 1}, true};
}

Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k) {
    check_number("circumradii in degree", k, 0, complex.dimension());
    constexpr Index part_size = 1 << 13;
    Vector radii(complex.size(k));
    for_each_part(complex.size(k), part_size, [&](Index begin, Index end) {
        SimplexLayout layout(complex, metric);
        Circumsphere sphere;
        for (Index s = begin; s < end; ++s) {
            sphere.look_at(layout, k, s);
            radii[s] = sphere.radius();
        }
    });
    return radii;
}

Vector edge_lengths(const Pieces& complex, const Points& points) {
    require_straight(complex, points, "a length");
    const auto& edges = complex.simplices(1);
    Vector lengths(edges.rows());
    for (Index e = 0; e < edges.rows(); ++e)
        lengths[e] = distance(points, edges(e, 0), edges(e, 1));
    return lengths;
}

Points vertex_points(const Pieces& complex, const Points& by_number) {
    const Index largest = complex.vertex_number(complex.size(0) - 1);
    if (largest >= by_number.rows())
        throw InvalidInput(fmt::format("a cell uses vertex {} but there are only {} points",
                                       largest, by_number.rows()),
                           {.vertices = {largest}});
    Points result(complex.size(0), by_number.cols());
    for (Index v = 0; v < result.rows(); ++v)
        result.row(v) = by_number.row(complex.vertex_number(v));
    return result;
}

Points isolated_points(const Pieces& complex, const Points& by_number) {
    Points result(by_number.rows() - complex.size(0), by_number.cols());
    for (Index i = 0, v = 0, row = 0; i < by_number.rows(); ++i)
        if (v < complex.size(0) && complex.vertex_number(v) == i)
            ++v;
        else
            result.row(row++) = by_number.row(i);
    return result;
}

void require_points(Eigen::Index coordinates, std::string_view what) {
    if (coordinates == 0)
        throw InvalidInput(fmt::format(
            "only lengths are known, but {} needs points: give a mesh with points", what));
}

void require_points(const Pieces& complex, const Points& points, std::string_view what) {
    require_points(points.cols(), what);
    if (points.rows() != complex.size(0))
        throw InvalidInput(
            fmt::format("{} points are given for {} vertices: expected a row for each vertex of "
                        "the complex, in their order (vertex_points omits vertices without a cell)",
                        points.rows(), complex.size(0)));
}

void require_straight(const Pieces& complex, const Points& points, std::string_view what) {
    require_points(complex, points, what);
    if (!complex.is_simplicial())
        throw InvalidInput(fmt::format("the pieces are glued by lengths, as after intrinsic flips, "
                                       "but {} needs straight simplices between points; give the "
                                       "simplices of the input, or the whole discretization",
                                       what));
}

} // namespace polydec
