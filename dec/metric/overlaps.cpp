// SPDX-License-Identifier: MIT
#include "dec/metric/overlaps.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/parallel.h"
#include "base/random.h"
#include "complex/disjoint_sets.h"
#include "dec/metric/simplex_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 31, 31>;

/// Lines through every vertex; each makes two rays.
constexpr int lines = 2;
constexpr int rays = 2 * lines;

/// What one n-simplex says.
struct Sight {
    std::int8_t sign = 0;         ///< of its determinant; 0 if that is rounding
    std::array<Index, rays> from; ///< of which vertex each ray begins in it, or -1
};

/// The coordinates that are not the same everywhere.
std::vector<Eigen::Index> varying_coordinates(const Points& points) {
    std::vector<Eigen::Index> axes;
    for (Eigen::Index c = 0; c < points.cols(); ++c)
        if ((points.col(c).array() != points(0, c)).any())
            axes.push_back(c);
    return axes;
}

DenseMatrix some_directions(Index n) {
    DenseMatrix directions(n, Index{lines});
    Noise(7).fill(directions.reshaped());
    return directions;
}

/// With the edges e_j from corner 0 and sum_j w_j e_j = d, w_0 = -sum_j w_j, the ray along d from
/// a corner begins in the simplex iff the weight of that corner alone is negative.
Sight look(const Points& points, std::span<const Index> corners, const DenseMatrix& directions) {
    const auto n = static_cast<Eigen::Index>(corners.size()) - 1;
    Square edges(n, n);
    Eigen::Array<double, Eigen::Dynamic, 1, 0, 31, 1> lengths(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        edges.col(j) = (points.row(corners[j + 1]) - points.row(corners[0])).transpose();
        lengths[j] = edges.col(j).lpNorm<Eigen::Infinity>();
        edges.col(j) /= lengths[j]; // so that no scale matters
    }
    Sight sight;
    sight.from.fill(-1);
    const Eigen::PartialPivLU<Square> factors(edges);
    const double determinant = factors.determinant();
    const double rounding = 64 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
    if (!(std::abs(determinant) > rounding))
        return sight;
    sight.sign = determinant > 0 ? 1 : -1;

    const double shortest = lengths.minCoeff();
    for (int line = 0; line < lines; ++line) {
        Eigen::Array<double, Eigen::Dynamic, 1, 0, 32, 1> weights(n + 1);
        weights.tail(n) = factors.solve(directions.col(line)).array();
        // by Cramer's rule the error of a weight is that of a determinant, over the determinant
        const double error = rounding / std::abs(determinant) * weights.tail(n).abs().maxCoeff();
        weights.tail(n) *= shortest / lengths;
        weights[0] = -weights.tail(n).sum();
        const auto negative = (weights < -error).count(), positive = (weights > error).count();
        Eigen::Index corner = 0;
        if (negative == 1 && positive == n) {
            weights.minCoeff(&corner);
            sight.from[2 * line] = corners[corner];
        }
        if (positive == 1 && negative == n) {
            weights.maxCoeff(&corner);
            sight.from[2 * line + 1] = corners[corner];
        }
    }
    return sight;
}

std::vector<Sight> look_at_all(const Pieces& complex, const Points& points) {
    const int n = complex.dimension();
    const DenseMatrix directions = some_directions(n);
    std::vector<Sight> sights(static_cast<std::size_t>(complex.size(n)));
    constexpr Index part_size = 1 << 12;
    for_each_part(complex.size(n), part_size, [&](Index begin, Index end) {
        for (Index t = begin; t < end; ++t)
            sights[t] = look(points, vertices(complex.simplices(n), t), directions);
    });
    return sights;
}

/// An n-simplex at a facet, and on which of its sides it lies.
struct Half {
    Index cell;
    int side;
};

/// Connects cells across facets with two cofaces by whether they lie on different sides, and marks
/// those that share a side of a branching facet with an earlier one.
void compare_sides(const Pieces& complex, const std::vector<Sight>& sights, DisjointSets& parts,
                   std::vector<bool>& folded) {
    const int n = complex.dimension();
    const IncidenceMatrix cofaces = complex.boundary(n);
    std::vector<Half> around;
    for (Index f = 0; f < cofaces.rows(); ++f) {
        around.clear();
        for (Row t(cofaces, f); t; ++t) {
            const auto cell = static_cast<Index>(t.col());
            if (sights[cell].sign != 0)
                around.push_back({cell, t.value() * complex.orientation(cell) * sights[cell].sign});
        }
        if (complex.coface_counts(n - 1)[f] == 2 && around.size() == 2) {
            const bool agree =
                parts.join(around[0].cell, around[1].cell, -around[0].side * around[1].side);
            // in a one-sided part no two halves are told apart, so a fold is told at its facet
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

/// The smaller half of each part that lies on two sides, of equal ones that without the part's
/// first cell; and those too many at branching facets.
std::vector<Index> find_folded(const Pieces& complex, const std::vector<Sight>& sights) {
    const auto cells = static_cast<Index>(sights.size());
    DisjointSets parts(cells);
    std::vector<bool> folded(sights.size(), false);
    compare_sides(complex, sights, parts, folded);

    // at the root of each part: how many lie as its first cell does, and how many do not
    std::vector<std::int8_t> first(sights.size(), 0);
    std::vector<std::array<Index, 2>> halves(sights.size(), {0, 0});
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

/// Vertices from which a ray begins in two cells, none of those around folded.
std::vector<Index> find_wound(const Pieces& complex, const std::vector<Sight>& sights,
                              const std::vector<Index>& folded, Index points) {
    const Simplices& cells = complex.simplices(complex.dimension());
    std::vector<bool> left_out(static_cast<std::size_t>(points), false), found = left_out;
    for (const Index t : folded)
        for (const Index v : cells.row(t))
            left_out[v] = true;
    for (int ray = 0; ray < rays; ++ray) {
        std::vector<bool> seen(static_cast<std::size_t>(points), false);
        for (const Sight& sight : sights)
            if (const Index v = sight.from[ray]; v >= 0) {
                if (seen[v] && !left_out[v])
                    found[v] = true;
                seen[v] = true;
            }
    }
    std::vector<Index> result;
    for (Index v = 0; v < points; ++v)
        if (found[v])
            result.push_back(v);
    return result;
}

} // namespace

Overlaps find_overlaps(const Pieces& complex, const Points& all) {
    check_as_many("points", all.rows(), complex.size(0));
    const auto axes = varying_coordinates(all);
    if (static_cast<int>(axes.size()) != complex.dimension())
        return {};
    const Points points = all(Eigen::all, axes);
    const auto sights = look_at_all(complex, points);
    Overlaps result;
    result.folded = find_folded(complex, sights);
    result.wound = find_wound(complex, sights, result.folded, static_cast<Index>(points.rows()));
    return result;
}

} // namespace polydec
