// SPDX-License-Identifier: MIT
#include "meshes/weld.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/listed.h"
#include "base/lists.h"
#include "meshes/edges.h"
#include "meshes/point_tree.h"
#include "meshes/rearrange.h"
#include "meshes/tidy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace polydec {

namespace {

/// Where vertices of cells are: those with equal coordinates are at one place. Places are numbered
/// by their cells along Morton's curve, so that their numbers do not depend on the order of
/// vertices.
struct DistinctPlaces {
    std::vector<Index> of_vertex; // -1 for vertices of no cell
    std::vector<Index> order;     // vertices of cells, those at one place behind each other
    std::vector<Index> begins;    // of places in the order, and the end

    Index size() const { return static_cast<Index>(begins.size()) - 1; }
    std::span<const Index> at(Index place) const {
        return {order.begin() + begins[place], order.begin() + begins[place + 1]};
    }

    /// One of each place.
    std::vector<Index> vertices() const {
        std::vector<Index> result;
        for (Index place = 0; place < size(); ++place)
            result.push_back(order[begins[place]]);
        return result;
    }
};

DistinctPlaces places_of(const Mesh& mesh) {
    const auto used = marks_at(mesh.simplices.reshaped<Eigen::RowMajor>(), mesh.points.rows());
    DistinctPlaces places{std::vector<Index>(used.size(), -1), {}, {}};
    const auto N = mesh.points.cols();
    const auto row = [&](Index v) { return mesh.points.data() + v * N; };
    auto [order, ends] = groups_of(morton_keys(mesh.points));
    constexpr std::ptrdiff_t ahead = 32;
    auto begin = order.begin();
    for (const Index group_end : ends) {
        const auto end = order.begin() + group_end;
        for (auto next = begin; next != end && order.end() - next > ahead; ++next)
            __builtin_prefetch(row(next[ahead])); // vertices at one place are anywhere in memory
        std::sort(begin, end, [&](Index a, Index b) {
            return std::lexicographical_compare(row(a), row(a) + N, row(b), row(b) + N);
        });
        for (; begin != end; ++begin) {
            if (!used[*begin])
                continue;
            auto& kept = places.order;
            if (kept.empty() || !std::equal(row(*begin), row(*begin) + N, row(kept.back())))
                places.begins.push_back(static_cast<Index>(kept.size()));
            places.of_vertex[*begin] = static_cast<Index>(places.begins.size()) - 1;
            kept.push_back(*begin);
        }
    }
    places.begins.push_back(static_cast<Index>(places.order.size()));
    return places;
}

/// At most the least height of a cell: n! times its volume over the longest edge to the n-1.
double thickness(const DenseMatrix& edges) {
    const auto n = edges.rows();
    const double longest = squared_longest_edge(edges);
    const double gram = (edges * edges.transpose()).partialPivLu().determinant();
    return longest > 0 ? std::sqrt(std::max(gram, 0.0) / std::pow(longest, n - 1)) : 0;
}

/// DistinctPlaces of a mesh in classes that become one vertex each, led by their least place.
class Welding {
public:
    /// In `own` units are the points of places.
    Welding(const Mesh& mesh, const DistinctPlaces& places, OwnUnits own, double length)
        : mesh_(mesh),
          places_(places),
          scaled_(std::move(own.points)),
          cells_(mesh.simplices.unaryExpr([&](Index v) { return places.of_vertex[v]; })) {
        find_classes(own.scaled(length));
    }

    Index leader(Index place) const { return leaders_[place]; }
    bool is_joined(Index place) const { return sizes_[leaders_[place]] > 1; }

    /// Where each class goes: a vertex of it has that coordinate, for each axis.
    double coordinate(Index place, Index axis) const {
        return mesh_.points(sources_(leaders_[place], axis), axis);
    }

private:
    /// Again and again, with half the length where the length before joins what must stay apart.
    void find_classes(double length) {
        std::vector<Index> open = numbers_below(places_.size());
        leaders_ = open;
        lengths_.resize(open.size());
        for (int halvings = 0; !open.empty(); ++halvings, length /= 2) {
            constexpr int most_halvings = 40;
            DisjointSets sets(static_cast<Index>(open.size()));
            if (length > 0 && halvings < most_halvings) // scaled, different places may coincide
                join_near(scaled_(open, Eigen::indexing::all), length, sets);
            const auto firsts = sets.firsts();
            for (std::size_t i = 0; i < open.size(); ++i) {
                leaders_[open[i]] = open[firsts[i]];
                lengths_[open[i]] = length;
            }
            sizes_.assign(leaders_.size(), 0);
            for (const Index place : leaders_)
                ++sizes_[place];
            find_targets();
            open = in_conflict();
        }
    }

    /// The lower median of each coordinate over the vertices of each class.
    void find_targets() {
        std::vector<Index> joined; // places, by classes
        sources_.resize(places_.size(), mesh_.points.cols());
        for (Index place = 0; place < places_.size(); ++place) {
            sources_.row(place).setConstant(places_.at(place).front());
            if (is_joined(place))
                joined.push_back(place);
        }
        std::sort(joined.begin(), joined.end(), [&](Index p, Index q) {
            return std::pair(leaders_[p], p) < std::pair(leaders_[q], q);
        });
        for (auto place = joined.begin(); place != joined.end();) {
            const Index leader = leaders_[*place];
            std::vector<Index> members; // vertices
            for (; place != joined.end() && leaders_[*place] == leader; ++place)
                members.insert(members.end(), places_.at(*place).begin(), places_.at(*place).end());
            const auto middle = members.begin() + (std::ssize(members) - 1) / 2;
            for (Index axis = 0; axis < sources_.cols(); ++axis) {
                std::nth_element(members.begin(), middle, members.end(), [&](Index a, Index b) {
                    return mesh_.points(a, axis) < mesh_.points(b, axis);
                });
                sources_(leader, axis) = *middle;
            }
        }
    }

    double scaled_target(Index place, Index axis) const {
        return scaled_(places_.of_vertex[sources_(leaders_[place], axis)], axis);
    }

    /// The places in classes that must not become one vertex, ascending.
    std::vector<Index> in_conflict() const {
        std::vector<bool> marks(leaders_.size(), false); // of leaders
        std::vector<Index> whole;                        // cells that move and stay cells
        for (Index cell = 0; cell < cells_.rows(); ++cell) {
            const auto corners = cells_.row(cell);
            if (std::none_of(corners.begin(), corners.end(), [&](Index p) { return is_joined(p); }))
                continue;
            if (!loses_an_edge(cell, marks))
                whole.push_back(cell);
        }
        for (const Index cell : whole)
            if (is_turned(cell))
                mark(cell, marks);
        mark_laid_on_others(whole, marks);

        std::vector<Index> result;
        for (Index place = 0; place < std::ssize(leaders_); ++place)
            if (marks[leaders_[place]] && is_joined(place))
                result.push_back(place);
        return result;
    }

    void mark(Index cell, std::vector<bool>& marks) const {
        for (const Index place : cells_.row(cell))
            marks[leaders_[place]] = true;
    }

    bool loses_an_edge(Index cell, std::vector<bool>& marks) const {
        bool loses = false;
        for (Index i = 0; i < cells_.cols(); ++i)
            for (Index j = 0; j < i; ++j) {
                const Index p = cells_(cell, i), q = cells_(cell, j);
                if (leaders_[p] != leaders_[q])
                    continue;
                loses = true;
                if ((scaled_.row(p) - scaled_.row(q)).norm() > lengths_[p])
                    marks[leaders_[p]] = true;
            }
        return loses;
    }

    bool is_turned(Index cell) const {
        const Index n = static_cast<Index>(cells_.cols()) - 1;
        const auto corners = cells_.row(cell);
        Points moved(n + 1, scaled_.cols());
        double length = 0;
        bool moves = false;
        for (Index i = 0; i <= n; ++i) {
            length = std::max(length, lengths_[corners[i]]);
            for (Index axis = 0; axis < scaled_.cols(); ++axis) {
                moved(i, axis) = scaled_target(corners[i], axis);
                moves = moves || moved(i, axis) != scaled_(corners[i], axis);
            }
        }
        if (!moves || n == 0)
            return false;
        const DenseMatrix before = edges_at_first(scaled_, corners);
        const DenseMatrix after = moved.bottomRows(n).rowwise() - moved.row(0);
        return !((before * after.transpose()).partialPivLu().determinant() > 0) &&
               thickness(before) > length;
    }

    /// A cell's places by ascending classes, and the sign of that order.
    std::int8_t arranged(Index cell, std::vector<Index>& places) const {
        places.assign(cells_.row(cell).begin(), cells_.row(cell).end());
        std::int8_t sign = 1;
        for (std::size_t i = 1; i < places.size(); ++i)
            for (std::size_t j = i; j > 0 && leaders_[places[j]] < leaders_[places[j - 1]]; --j) {
                std::swap(places[j], places[j - 1]);
                sign = static_cast<std::int8_t>(-sign);
            }
        return sign;
    }

    /// Cells of both orientations on the vertices of one, unless they were at the same places.
    void mark_laid_on_others(const std::vector<Index>& cells, std::vector<bool>& marks) const {
        const auto n = cells_.cols();
        Simplices rows(std::ssize(cells), 2 * n); // classes, then places
        std::vector<std::int8_t> signs;
        std::vector<Index> order = numbers_below(std::ssize(cells)), places;
        for (Index i = 0; i < std::ssize(cells); ++i) {
            signs.push_back(arranged(cells[i], places));
            for (Index k = 0; k < n; ++k) {
                rows(i, k) = leaders_[places[k]];
                rows(i, n + k) = places[k];
            }
        }
        const auto row = [&](Index i) { return rows.data() + 2 * n * i; };
        std::sort(order.begin(), order.end(), [&](Index a, Index b) {
            return std::lexicographical_compare(row(a), row(a) + 2 * n, row(b), row(b) + 2 * n);
        });
        for (auto begin = order.begin(); begin != order.end();) {
            const Index* const first = row(*begin);
            const auto end = std::find_if(
                begin, order.end(), [&](Index i) { return !std::equal(first, first + n, row(i)); });
            const bool one_place = std::equal(first, first + 2 * n, row(*(end - 1)));
            const bool one_sign =
                std::all_of(begin, end, [&](Index i) { return signs[i] == signs[*begin]; });
            if (!one_place && !one_sign)
                mark(cells[*begin], marks);
            begin = end;
        }
    }

    const Mesh& mesh_;
    const DistinctPlaces& places_;
    Points scaled_;               // of places
    Simplices cells_;             // by places
    std::vector<Index> leaders_;  // the least place of each one's class
    std::vector<Index> sizes_;    // of classes, under their leaders
    std::vector<double> lengths_; // scaled, by which each place's class was found
    Simplices sources_;           // of leaders, the vertex that gives each coordinate
};

} // namespace

double weld_length(const Points& points) {
    if (points.size() == 0)
        return 0;
    const Eigen::RowVectorXd least = points.colwise().minCoeff() / 2;
    return 2e-9 * (points.colwise().maxCoeff() / 2 - least).stableNorm();
}

Joined weld(Mesh mesh, std::optional<double> length) {
    check_mesh(mesh);
    if (length)
        check_not_negative("the length within which vertices are joined", *length);
    Joined result{std::move(mesh), {}};
    Mesh& made = result.mesh;
    const auto vertices = static_cast<Index>(made.points.rows());
    const DistinctPlaces places = places_of(made);
    if (places.size() == 0) {
        result.vertices = numbers_below(vertices);
        return result;
    }
    const double used =
        length ? *length : weld_length(made.points(places.vertices(), Eigen::indexing::all));
    const Welding welding(made, places,
                          OwnUnits(made.points(places.vertices(), Eigen::indexing::all)), used);

    // numbers in the order of the first vertex of each class
    std::vector<Index> number_of(places.size(), -1), kept;
    Index classes = 0, used_vertices = 0;
    for (Index v = 0; v < vertices; ++v) {
        const Index place = places.of_vertex[v];
        Index& number =
            place < 0 ? result.vertices.emplace_back(-1) : number_of[welding.leader(place)];
        if (number < 0) {
            number = static_cast<Index>(kept.size());
            kept.push_back(v);
            classes += place >= 0 ? 1 : 0;
        }
        if (place >= 0) {
            ++used_vertices;
            result.vertices.push_back(number);
        }
    }
    Points points = made.points(kept, Eigen::indexing::all);
    for (Index i = 0; i < points.rows(); ++i)
        if (const Index place = places.of_vertex[kept[i]]; place >= 0 && welding.is_joined(place))
            for (Index axis = 0; axis < points.cols(); ++axis)
                points(i, axis) = welding.coordinate(place, axis);
    made.points = std::move(points);
    for (auto* rows : {&made.simplices, &made.facet_tags.simplices})
        *rows = rows->unaryExpr([&](Index v) { return result.vertices[v]; }).eval();
    result.joined = used_vertices - classes;
    result.apart = places.size() - classes;
    if (result.joined > 0)
        made.warnings.push_back(fmt::format(
            "joined {} at most {:.3g} away",
            counted(result.joined, "vertex with another", "vertices with others"), used));
    return result;
}

} // namespace polydec
