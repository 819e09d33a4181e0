// SPDX-License-Identifier: MIT
#include "dec/metric/overlaps.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/lists.h"
#include "base/parallel.h"
#include "complex/disjoint_sets.h"
#include "dec/metric/angle_sums.h"
#include "dec/metric/plane.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/sphere_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;
using AnySquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                most_vertices - 1, most_vertices - 1>;

/// An n-simplex seen in one direction, which is the same for all simplices.
struct View {
    std::int8_t sign = 0;    // of the determinant; 0 if within rounding
    std::uint32_t ahead = 0; // bit i: the direction leads from facet i towards corner i. No bit is
                             // set if the simplex is thin or has a facet along the direction.
};

/// n_fixed is n, or -1 for any n.
template <int n_fixed>
View look(const Points& points, std::span<const Index> corners, const Vector& direction) {
    constexpr int most = n_fixed > 0 ? n_fixed : most_vertices - 1;
    using Square = Eigen::Matrix<double, n_fixed, n_fixed, Eigen::ColMajor, most, most>;
    using Column = Eigen::Matrix<double, n_fixed, 1, Eigen::ColMajor, most, 1>;
    const auto n = direction.size();
    Square edges(n, n);
    Column sizes(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        edges.row(j) = points.row(corners[j + 1]) - points.row(corners[0]);
        sizes[j] = edges.row(j).template lpNorm<Eigen::Infinity>();
        edges.row(j) /= sizes[j]; // independent of scale
    }
    constexpr double thin = 1e-6; // far above rounding
    double determinant = edges.determinant();
    const bool is_thick = std::abs(determinant) > thin;
    if (!is_thick)
        determinant = AnySquare(edges).determinant();
    const double rounding = 64 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
    View view;
    if (std::abs(determinant) > rounding)
        view.sign = determinant > 0 ? 1 : -1;
    if (!is_thick)
        return view;

    // slopes of the barycentric coordinates along the direction; the sum of all is zero
    const Column slopes = (edges.inverse().transpose() * direction).cwiseQuotient(sizes);
    const double least = thin * slopes.cwiseAbs().dot(sizes) / sizes.minCoeff();
    const double first = -slopes.sum();
    bool is_clear = std::abs(first) > least;
    std::uint32_t ahead = first > 0 ? 1 : 0;
    for (Eigen::Index j = 0; j < n; ++j) {
        is_clear = is_clear && std::abs(slopes[j]) > least;
        ahead |= std::uint32_t{slopes[j] > 0} << (j + 1);
    }
    view.ahead = is_clear ? ahead : 0;
    return view;
}

std::vector<View> look_at_all(const Pieces& complex, const Points& points) {
    const int n = complex.dimension();
    const Vector direction = Vector::LinSpaced(n, 2, n + 1).cwiseSqrt(); // in no lattice plane
    std::vector<View> views(static_cast<std::size_t>(complex.size(n)));
    constexpr Index part_size = 1 << 12;
    sphere_kernel::for_dimensions(n, n, [&]<int n_fixed, int> {
        constexpr int n_here = n_fixed > 1 ? n_fixed : -1;
        for_each_part(complex.size(n), part_size, [&](Index begin, Index end) {
            for (Index t = begin; t < end; ++t)
                views[t] = look<n_here>(points, vertices(complex.simplices(n), t), direction);
        });
    });
    return views;
}

/// An n-simplex at a facet, and the side of the facet on which it lies.
struct Half {
    Index cell;
    int side;
};

/// Connects cells across facets with two cofaces by whether they lie on different sides, and marks
/// cells that share a side of a branching facet with an earlier cell.
void compare_sides(const Pieces& complex, const std::vector<View>& views, DisjointSets& parts,
                   std::vector<bool>& folded) {
    const int n = complex.dimension();
    const IncidenceMatrix cofaces = complex.boundary(n);
    std::vector<Half> around;
    for (Index f = 0; f < cofaces.rows(); ++f) {
        around.clear();
        for (Row t(cofaces, f); t; ++t) {
            const auto cell = static_cast<Index>(t.col());
            if (const int sign = views[cell].sign; sign != 0)
                around.push_back({cell, t.value() * complex.orientation(cell) * sign});
        }
        if (complex.coface_counts(n - 1)[f] == 2 && around.size() == 2) {
            const bool agree =
                parts.join(around[0].cell, around[1].cell, -around[0].side * around[1].side);
            // in a one-sided part halves are indistinguishable, so a fold is recorded at its facet
            if (!agree && around[0].side == around[1].side)
                folded[around[1].cell] = true;
            continue;
        }
        std::array<bool, 2> taken{};
        for (const Half& coface : around) {
            bool& side = taken[coface.side > 0 ? 1 : 0];
            folded[coface.cell] = folded[coface.cell] || side;
            side = true;
        }
    }
}

/// Marks the smaller half of each part that lies on two sides: of equal halves, the half without
/// the part's first cell.
std::vector<bool> smaller_halves(DisjointSets& parts) {
    // at the root of each part: how many lie as its first cell does, and how many do not
    const auto cells = static_cast<Index>(parts.size());
    std::vector<std::int8_t> first(parts.size(), 0);
    std::vector<std::array<Index, 2>> halves(parts.size(), {0, 0});
    const auto half = [&](Index t) {
        const auto root = parts.find(t);
        return root.sign == first[root.element] ? 0 : 1;
    };
    for (Index t = 0; t < cells; ++t) {
        const auto root = parts.find(t);
        if (first[root.element] == 0)
            first[root.element] = root.sign;
        ++halves[root.element][half(t)];
    }
    std::vector<bool> result(parts.size());
    for (Index t = 0; t < cells; ++t) {
        const auto& [as_first, against] = halves[parts.find(t).element];
        result[t] = half(t) == (against > as_first ? 0 : 1);
    }
    return result;
}

/// The smaller half of each part, or what is known of it, and the surplus cells at branching
/// facets.
std::vector<Index> find_folded(const Pieces& complex, const std::vector<View>& views,
                               const std::vector<bool>& against) {
    const auto cells = static_cast<Index>(views.size());
    const auto& counts = complex.coface_counts(complex.dimension() - 1);
    std::array<bool, 2> any{}; // cells with each sign
    for (Index t = 0; t < cells; ++t)
        if (views[t].sign != 0)
            any[views[t].sign == complex.orientation(t) ? 1 : 0] = true;
    if (against.empty() && complex.orientable() && !(any[0] && any[1]) &&
        std::none_of(counts.begin(), counts.end(), [](Index count) { return count > 2; }))
        return {};

    DisjointSets parts(cells);
    std::vector<bool> folded(views.size(), false);
    compare_sides(complex, views, parts, folded);
    const auto halves = against.empty() ? smaller_halves(parts) : against;
    std::transform(halves.begin(), halves.end(), folded.begin(), folded.begin(), std::logical_or());
    return marked(folded);
}

/// Marks the (n-2)-simplices that unfolded cells may surround by more than one turn. They make
/// exactly one turn if every facet there has two cofaces and the direction passes through one cell.
std::vector<bool> where_turns_are_unknown(const Pieces& complex, const std::vector<View>& views) {
    const int n = complex.dimension();
    const FaceTable facets = complex.faces(n), ridges = complex.faces(n - 1);
    constexpr Index unknown = 2;
    std::vector<Index> turns(static_cast<std::size_t>(complex.size(n - 2)), 0);
    for (Index t = 0; t < complex.size(n); ++t)
        for (int i = 1; i <= n; ++i)
            for (int j = 0; j < i; ++j) {
                const std::uint32_t ahead = views[t].ahead;
                const bool has_both = (ahead >> i & ahead >> j & 1) != 0;
                turns[ridges(facets(t, i), j)] += ahead == 0 ? unknown : has_both ? 1 : 0;
            }
    for (Index f = 0; f < complex.size(n - 1); ++f)
        for (int i = 0; i < n && complex.coface_counts(n - 1)[f] != 2; ++i)
            turns[ridges(f, i)] += unknown;
    std::vector<bool> result(turns.size());
    std::transform(turns.begin(), turns.end(), result.begin(),
                   [](Index count) { return count != 1; });
    return result;
}

/// Vertices of (n-2)-simplices with more than a full turn of unfolded cells around them.
std::vector<Index> find_wound(const Pieces& complex, const Points& points,
                              const std::vector<View>& views, const std::vector<Index>& folded) {
    const int n = complex.dimension();
    if (n < 2)
        return {};
    constexpr double turn = 2 * std::numbers::pi + 1e-6;
    const Vector angles =
        angle_sums(complex, points,
                   folded.empty() ? where_turns_are_unknown(complex, views) : std::vector<bool>());
    std::vector<bool> left_out(static_cast<std::size_t>(points.rows()), false), found = left_out;
    for (const Index t : folded)
        for (const Index v : complex.simplices(n).row(t))
            left_out[v] = true;
    for (Index s = 0; s < angles.size(); ++s)
        if (angles[s] > turn)
            for (const Index v : complex.simplices(n - 2).row(s))
                found[v] = !left_out[v];
    return marked(found);
}

} // namespace

std::vector<std::int8_t> sides(const Pieces& complex, const Points& points) {
    std::vector<std::int8_t> signs;
    for (const View& view : look_at_all(complex, points))
        signs.push_back(view.sign);
    return signs;
}

Overlaps find_overlaps(const Pieces& complex, const Points& all, const std::vector<bool>& against) {
    check_as_many("points", all.rows(), complex.size(0));
    const auto axes = varying_coordinates(all);
    if (static_cast<int>(axes.size()) != complex.dimension())
        return {};
    const Points points = all(Eigen::indexing::all, axes);
    Overlaps result;
    const auto views = look_at_all(complex, points);
    result.folded = find_folded(complex, views, against);
    result.wound = find_wound(complex, points, views, result.folded);
    return result;
}

} // namespace polydec
