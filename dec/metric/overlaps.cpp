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

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 31, 31>;

/// The sign of the determinant of an n-simplex, 0 if within rounding.
std::int8_t sign_of(const Points& points, std::span<const Index> corners) {
    const auto n = static_cast<Eigen::Index>(corners.size()) - 1;
    Square edges(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        edges.row(j) = points.row(corners[j + 1]) - points.row(corners[0]);
        edges.row(j) /= edges.row(j).lpNorm<Eigen::Infinity>(); // independent of scale
    }
    const double determinant = edges.determinant();
    const double rounding = 64 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
    return std::abs(determinant) > rounding ? (determinant > 0 ? 1 : -1) : 0;
}

std::vector<std::int8_t> signs_of_all(const Pieces& complex, const Points& points) {
    const int n = complex.dimension();
    std::vector<std::int8_t> signs(static_cast<std::size_t>(complex.size(n)));
    constexpr Index part_size = 1 << 12;
    for_each_part(complex.size(n), part_size, [&](Index begin, Index end) {
        for (Index t = begin; t < end; ++t)
            signs[t] = sign_of(points, vertices(complex.simplices(n), t));
    });
    return signs;
}

/// An n-simplex at a facet, and the side of the facet on which it lies.
struct Half {
    Index cell;
    int side;
};

/// Connects cells across facets with two cofaces by whether they lie on different sides, and marks
/// cells that share a side of a branching facet with an earlier cell.
void compare_sides(const Pieces& complex, const std::vector<std::int8_t>& signs,
                   DisjointSets& parts, std::vector<bool>& folded) {
    const int n = complex.dimension();
    const IncidenceMatrix cofaces = complex.boundary(n);
    std::vector<Half> around;
    for (Index f = 0; f < cofaces.rows(); ++f) {
        around.clear();
        for (Row t(cofaces, f); t; ++t) {
            const auto cell = static_cast<Index>(t.col());
            if (signs[cell] != 0)
                around.push_back({cell, t.value() * complex.orientation(cell) * signs[cell]});
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

/// The smaller half of each part that lies on two sides (of equal halves, the half without the
/// part's first cell), and the surplus cells at branching facets.
std::vector<Index> find_folded(const Pieces& complex, const std::vector<std::int8_t>& signs) {
    const auto cells = static_cast<Index>(signs.size());
    DisjointSets parts(cells);
    std::vector<bool> folded(signs.size(), false);
    compare_sides(complex, signs, parts, folded);

    // at the root of each part: how many lie as its first cell does, and how many do not
    std::vector<std::int8_t> first(signs.size(), 0);
    std::vector<std::array<Index, 2>> halves(signs.size(), {0, 0});
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
    std::vector<Index> result;
    for (Index t = 0; t < cells; ++t) {
        const auto& [as_first, against] = halves[parts.find(t).element];
        if (folded[t] || half(t) == (against > as_first ? 0 : 1))
            result.push_back(t);
    }
    return result;
}

/// Vertices of (n-2)-simplices with more than a full turn of unfolded cells around them.
std::vector<Index> find_wound(const Pieces& complex, const Points& points,
                              const std::vector<Index>& folded) {
    const int n = complex.dimension();
    if (n < 2)
        return {};
    constexpr double turn = 2 * std::numbers::pi + 1e-6;
    const Vector angles = angle_sums(complex, points);
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

Overlaps find_overlaps(const Pieces& complex, const Points& all) {
    check_as_many("points", all.rows(), complex.size(0));
    const auto axes = varying_coordinates(all);
    if (static_cast<int>(axes.size()) != complex.dimension())
        return {};
    const Points points = all(Eigen::indexing::all, axes);
    Overlaps result;
    result.folded = find_folded(complex, signs_of_all(complex, points));
    result.wound = find_wound(complex, points, result.folded);
    return result;
}

} // namespace polydec
