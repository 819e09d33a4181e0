// SPDX-License-Identifier: MIT
#include "meshes/level_sets.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "base/permutation_sign.h"
#include "meshes/edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Where a level meets an edge, or one of its ends: then both are that vertex.
struct Crossing {
    Index level, low, high;
    auto operator<=>(const Crossing&) const = default;
};

/// The ways through a lattice of p by q steps, each step along the first axis (0) or the second.
std::vector<std::vector<int>> lattice_paths(int p, int q) {
    std::vector<int> path(p, 0);
    path.insert(path.end(), static_cast<std::size_t>(q), 1);
    std::vector<std::vector<int>> paths;
    do
        paths.push_back(path);
    while (std::next_permutation(path.begin(), path.end()));
    return paths;
}

class Cutter {
public:
    Cutter(const Mesh& mesh, const Vector& values, const Vector& levels)
        : mesh_(mesh), values_(values), levels_(levels), n_(mesh.dimension()) {
        constexpr double rounding = 1e-12;
        if (values.size() > 0)
            tie_ = rounding * values.maxCoeff() - rounding * values.minCoeff();
        for (int p = 0; p < n_; ++p)
            paths_.push_back(lattice_paths(p, n_ - 1 - p));
    }

    LevelSets cut() {
        for (Index s = 0; s < mesh_.simplices.rows(); ++s) {
            double least = std::numeric_limits<double>::infinity(), most = -least;
            for (const Index v : mesh_.simplices.row(s)) {
                least = std::min(least, values_[v]);
                most = std::max(most, values_[v]);
            }
            auto begin = std::upper_bound(levels_.begin(), levels_.end(), least + tie_);
            for (; begin != levels_.end() && *begin <= most + tie_; ++begin)
                cut(s, static_cast<Index>(begin - levels_.begin()));
        }
        return result();
    }

private:
    /// The corners that reach a level are above it. By vertex number on both sides, so that
    /// neighbors cut what they share in the same way.
    void cut(Index s, Index level) {
        std::vector<Index> places = numbers_below(n_ + 1);
        const auto corner = [&](Index place) { return mesh_.simplices(s, place); };
        const auto below = std::partition(places.begin(), places.end(), [&](Index place) {
            return levels_[level] <= values_[corner(place)] + tie_;
        });
        std::sort(places.begin(), below, [&](Index a, Index b) { return corner(a) < corner(b); });
        std::sort(below, places.end(), [&](Index a, Index b) { return corner(a) < corner(b); });

        const auto p = below - places.begin() - 1;
        for (const auto& path : paths_[p]) {
            auto a = places.begin(), b = below;
            std::vector<Crossing> cell{crossing(level, corner(*a), corner(*b))};
            for (const int step : path) {
                ++(step == 0 ? a : b);
                cell.push_back(crossing(level, corner(*a), corner(*b)));
            }
            if (std::adjacent_find(cell.begin(), cell.end()) != cell.end())
                continue; // of no volume, at a corner that has the level
            // the way up, then the cell, make a positive simplex
            const double sign = permutation_sign(places) * permutation_sign(path);
            if (n_ > 1 && sign == (p % 2 == 0 ? 1 : -1))
                std::swap(cell[cell.size() - 2], cell.back());
            add(cell, s, level);
        }
    }

    Crossing crossing(Index level, Index above, Index below) const {
        if (values_[above] - tie_ <= levels_[level])
            return {level, above, above};
        return {level, std::min(above, below), std::max(above, below)};
    }

    void add(const std::vector<Crossing>& cell, Index s, Index level) {
        corners_.insert(corners_.end(), cell.begin(), cell.end());
        sets_.owners.push_back(s);
        sets_.levels.push_back(level);
        check_number("corners of level sets", static_cast<std::int64_t>(corners_.size()), 0,
                     std::numeric_limits<Index>::max());
    }

    /// In extended precision, in which no difference of two numbers is infinite.
    Eigen::RowVectorXd place(const Crossing& at) const {
        using Wide = long double;
        const Wide from = values_[at.low], to = values_[at.high];
        const auto t =
            at.low == at.high ? 0.0 : static_cast<double>((levels_[at.level] - from) / (to - from));
        return (1 - t) * mesh_.points.row(at.low) + t * mesh_.points.row(at.high);
    }

    LevelSets result() {
        auto points = corners_;
        sort_unique(points);
        Mesh& mesh = sets_.mesh;
        mesh.points.resize(std::ssize(points), mesh_.points.cols());
        for (Index i = 0; i < mesh.points.rows(); ++i)
            mesh.points.row(i) = place(points[i]);
        mesh.simplices.resize(std::ssize(sets_.owners), n_);
        for (std::size_t i = 0; i < corners_.size(); ++i)
            mesh.simplices.data()[i] = place_in(points, corners_[i]);
        return std::move(sets_);
    }

    const Mesh& mesh_;
    const Vector &values_, &levels_;
    double tie_ = 0; ///< values this near to a level have it, so that no cells are smaller
    int n_;
    std::vector<std::vector<std::vector<int>>> paths_; ///< by their steps along the first axis
    std::vector<Crossing> corners_;                    ///< of the cells, one after the other
    LevelSets sets_;
};

} // namespace

LevelSets level_sets(const Mesh& mesh, const Vector& values, const Vector& levels) {
    check_number("the dimension of a mesh with level sets", mesh.dimension(), 1,
                 std::numeric_limits<Index>::max());
    check_values("values of a function on vertices", values, mesh.points.rows());
    check_values("levels", levels, levels.size());
    for (Index i = 0; i + 1 < levels.size(); ++i)
        if (!(levels[i] < levels[i + 1]))
            throw InvalidInput(fmt::format("level sets: level {} is {}, but the previous level is "
                                           "{}; expected ascending levels",
                                           i + 1, levels[i + 1], levels[i]));
    check_vertices("simplex", mesh.simplices, mesh.points.rows());
    return Cutter(mesh, values, levels).cut();
}

Vector equal_levels(const Vector& values, Index count) {
    check_number("the number of levels", count, 0, std::numeric_limits<Index>::max());
    check_number("the number of values", values.size(), 1, std::numeric_limits<Index>::max());
    check_values("values", values, values.size());
    const double least = values.minCoeff(), most = values.maxCoeff();
    constexpr double rounding = 1e-14;
    if (most - least <= rounding * values.lpNorm<Eigen::Infinity>() && count > 0)
        throw InvalidInput(fmt::format("all {} values are {:.12g}, so there are no level sets "
                                       "between them: ask for none",
                                       values.size(), least));
    Vector levels(count);
    for (Index i = 0; i < count; ++i) {
        const double t = (i + 1.0) / (count + 1.0);
        levels[i] = (1 - t) * least + t * most;
    }
    return levels;
}

} // namespace polydec
