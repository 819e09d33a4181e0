// SPDX-License-Identifier: MIT
#include "meshes/generate_boxes.h"

#include "base/decompositions.h"
#include "base/errors.h"
#include "base/random.h"
#include "meshes/generate_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>

namespace polydec {

namespace {

/// Vertex number steps along the axes of a box of vertices numbered lexicographically.
std::vector<Index> strides(const std::vector<int>& cells) {
    std::vector<Index> result(cells.size(), 1);
    for (std::size_t k = cells.size(); k-- > 1;)
        result[k - 1] = result[k] * (cells[k] + 1);
    return result;
}

void check_box(std::string_view generator, const std::vector<int>& cells,
               const std::vector<double>& lengths) {
    check_count(generator, "n", static_cast<std::int64_t>(cells.size()), 1, 12);
    double vertices = 1.0, simplices = 1.0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        check_count(generator, fmt::format("cells[{}]", k), cells[k], 1);
        vertices *= cells[k] + 1.0;
        simplices *= (k + 1.0) * cells[k];
    }
    if (!lengths.empty() && lengths.size() != cells.size())
        throw InvalidInput(
            fmt::format("{}: {} lengths for {} axes; give one for each axis, or none", generator,
                        lengths.size(), cells.size()));
    for (std::size_t k = 0; k < lengths.size(); ++k)
        check_length(generator, fmt::format("lengths[{}]", k), lengths[k]);
    check_sizes(generator, vertices, simplices, static_cast<int>(cells.size()));
}

bool is_odd(const std::vector<int>& permutation) {
    int inversions = 0;
    for (std::size_t i = 0; i < permutation.size(); ++i)
        for (std::size_t j = i + 1; j < permutation.size(); ++j)
            inversions += permutation[i] > permutation[j];
    return inversions % 2 == 1;
}

/// A grid of boxes: points in lexicographic order, still without simplices.
struct Boxes {
    std::vector<Index> stride;
    std::vector<Index> origins; ///< lowest vertices of the boxes
    Mesh mesh;
};

Boxes boxes(const std::vector<int>& cells, const std::vector<double>& lengths) {
    const auto n = static_cast<Index>(cells.size());
    Boxes result{strides(cells), {}, {}};
    Points& points = result.mesh.points;
    points.resize(result.stride[0] * (static_cast<Eigen::Index>(cells[0]) + 1), n);
    for (Index v = 0; v < points.rows(); ++v) {
        bool is_origin = true;
        for (Index k = 0, rest = v; k < n; rest %= result.stride[k++]) {
            const Index i = rest / result.stride[k];
            const double length = lengths.empty() ? 1.0 : lengths[k];
            points(v, k) = static_cast<double>(i) / cells[k] * length;
            is_origin = is_origin && i < cells[k];
        }
        if (is_origin)
            result.origins.push_back(v);
    }
    Eigen::Index in_a_box = 1;
    for (Index k = 2; k <= n; ++k)
        in_a_box *= k;
    result.mesh.simplices.resize(in_a_box * static_cast<Eigen::Index>(result.origins.size()),
                                 n + 1);
    return result;
}

/// Splits boxes one after the other into cones.
class Splitting {
public:
    /// rank[v]: place of vertex v in the order that tells apexes.
    Splitting(Boxes& boxes, const std::vector<Index>& rank)
        : boxes_(boxes),
          rank_(rank),
          n_(static_cast<Index>(boxes.stride.size())),
          corners_(n_ + 1),
          sides_(n_, free) {}

    void split(Index origin) {
        origin_ = origin;
        add_cones(0);
    }

private:
    static constexpr int free = -1;

    Index corner(const std::vector<int>& sides) const {
        Index result = origin_;
        for (Index k = 0; k < n_; ++k)
            result += sides[k] * boxes_.stride[k];
        return result;
    }

    /// Of the face's corners the first in order; the face is where the axes are free.
    std::vector<int> apex() const {
        std::vector<Index> axes;
        for (Index k = 0; k < n_; ++k)
            if (sides_[k] == free)
                axes.push_back(k);
        std::vector<int> best, sides = sides_;
        for (unsigned bits = 0; bits < 1U << axes.size(); ++bits) {
            for (std::size_t i = 0; i < axes.size(); ++i)
                sides[axes[i]] = static_cast<int>(bits >> i & 1U);
            if (best.empty() || rank_[corner(sides)] < rank_[corner(best)])
                best = sides;
        }
        return best;
    }

    /// Cones with the apex of the face over its facets that miss it, and so on down to a vertex.
    void add_cones(Index depth) {
        const std::vector<int> top = apex();
        corners_[depth] = corner(top);
        if (depth == n_) {
            add_simplex();
            return;
        }
        for (Index k = 0; k < n_; ++k) {
            if (sides_[k] != free)
                continue;
            sides_[k] = 1 - top[k];
            add_cones(depth + 1);
            sides_[k] = free;
        }
    }

    void add_simplex() {
        auto simplex = boxes_.mesh.simplices.row(next_++);
        DenseMatrix edges(n_, n_);
        for (Index c = 0; c <= n_; ++c)
            simplex[c] = corners_[c];
        for (Index c = 0; c < n_; ++c)
            edges.row(c) =
                boxes_.mesh.points.row(corners_[c + 1]) - boxes_.mesh.points.row(corners_[0]);
        if (edges.determinant() < 0.0)
            std::swap(simplex[0], simplex[1]);
    }

    Boxes& boxes_;
    const std::vector<Index>& rank_;
    Index n_;
    std::vector<Index> corners_; // apexes so far
    std::vector<int> sides_;     // of each axis 0, 1 or free
    Index origin_ = 0;
    Eigen::Index next_ = 0;
};

} // namespace

Mesh kuhn(const std::vector<int>& cells, const std::vector<double>& lengths) {
    check_box("kuhn", cells, lengths);
    Boxes grid = boxes(cells, lengths);
    const auto n = static_cast<Index>(cells.size());

    // Every order of the axes is a path along the edges of a cube from its origin to the opposite
    // corner; the vertices of the path span a simplex.
    std::vector<int> axes(n);
    std::iota(axes.begin(), axes.end(), 0);
    Eigen::Index simplex = 0;
    do {
        Eigen::Matrix<Index, 1, Eigen::Dynamic> path(n + 1);
        path[0] = 0;
        for (Index k = 0; k < n; ++k)
            path[k + 1] = path[k] + grid.stride[axes[k]];
        if (is_odd(axes))
            std::swap(path[0], path[1]);
        for (const Index origin : grid.origins)
            grid.mesh.simplices.row(simplex++) = path.array() + origin;
    } while (std::next_permutation(axes.begin(), axes.end()));
    return std::move(grid.mesh);
}

Mesh kuhn(int n, int cells_per_side) {
    check_count("kuhn", "n", n, 1, 12);
    check_count("kuhn", "cells_per_side", cells_per_side, 1);
    return kuhn(std::vector<int>(n, cells_per_side));
}

Mesh split_boxes(const std::vector<int>& cells, const std::vector<double>& lengths,
                 std::uint64_t seed) {
    check_box("split_boxes", cells, lengths);
    Boxes grid = boxes(cells, lengths);
    const std::vector<Index> rank = Random(seed).order(grid.mesh.points.rows());
    Splitting splitting(grid, rank);
    for (const Index origin : grid.origins)
        splitting.split(origin);
    return std::move(grid.mesh);
}

} // namespace polydec
