// SPDX-License-Identifier: MIT
#include "meshes/periodic.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/disjoint_sets.h"
#include "meshes/edges.h"
#include "meshes/point_tree.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace polydec {

namespace {

/// Vertices by where they are, within a tolerance.
class Places {
public:
    explicit Places(const Points& points)
        : least_(points.colwise().minCoeff()),
          unit_(std::max((points.colwise().maxCoeff() - least_).norm(),
                         std::numeric_limits<double>::min())),
          tree_((points.rowwise() - least_) / unit_) {}

    /// The first vertex at a point, or -1.
    Index at(const Eigen::RowVectorXd& point) const {
        const auto found = tree_.near((point - least_) / unit_, 1e-9);
        return found.empty() ? -1 : found.front();
    }

private:
    Eigen::RowVectorXd least_;
    double unit_;
    PointTree tree_;
};

/// Of each vertex the one where it is taken to, or -1.
std::vector<Index> numbers(const Places& places, const Points& points, const Points& images,
                           const std::string& name) {
    std::vector<Index> result(points.rows(), -1);
    bool moves = false;
    if (images.rows() == points.rows() && images.cols() == points.cols())
        for (Index v = 0; v < points.rows(); ++v) {
            if (images.row(v).allFinite())
                result[v] = places.at(images.row(v));
            moves = moves || (result[v] >= 0 && result[v] != v);
        }
    if (!moves)
        throw InvalidInput(fmt::format("the {} maps no vertex to another: expected {} coordinates, "
                                       "and the same vertices at both ends of the box",
                                       name, points.cols()));
    return result;
}

[[noreturn]] void refuse(Index cell, const char* what) {
    throw InvalidInput(fmt::format("cell {} {} after gluing: expected a simplicial complex; use at "
                                   "least three cells along every translation",
                                   cell, what));
}

void check_simplices(const Simplices& simplices) {
    std::set<std::vector<Index>> seen;
    for (Index t = 0; t < simplices.rows(); ++t) {
        std::vector<Index> corners(simplices.row(t).begin(), simplices.row(t).end());
        std::sort(corners.begin(), corners.end());
        if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
            refuse(t, "has a vertex twice");
        if (!seen.insert(corners).second)
            refuse(t, "has the same corners as another cell");
    }
}

/// The vertices and edges of a box that are glued, and the edges of the quotient with their
/// lengths, which are those of one class each.
class Gluing {
public:
    explicit Gluing(Mesh box)
        : box_(std::move(box)),
          places_(box_.points),
          edges_(edges_of(box_.simplices)),
          vertex_classes_(static_cast<Index>(box_.points.rows())),
          edge_classes_(static_cast<Index>(edges_.size())) {}

    const Mesh& box() const { return box_; }

    void add(const Points& images, const std::string& name) {
        const auto to = numbers(places_, box_.points, images, name);
        for (Index v = 0; v < std::ssize(to); ++v)
            if (to[v] >= 0)
                vertex_classes_.join(v, to[v]);
        for (Index e = 0; e < std::ssize(edges_); ++e) {
            const auto [v, w] = edges_[e];
            if (to[v] < 0 || to[w] < 0)
                continue;
            const Edge image = std::minmax(to[v], to[w]);
            if (std::abs(length(image) - length({v, w})) > 1e-8 * length({v, w}))
                throw InvalidInput(
                    fmt::format("the {} maps the edge between vertices {} and {} to vertices {} "
                                "and {}, which are not as far apart: expected an isometry",
                                name, v, w, to[v], to[w]));
            const auto found = std::lower_bound(edges_.begin(), edges_.end(), image);
            if (found == edges_.end() || *found != image)
                throw InvalidInput(fmt::format(
                    "the {} maps the edge between vertices {} and {} to vertices {} and {}, which "
                    "no edge joins: expected matching cells on both sides",
                    name, v, w, to[v], to[w]));
            const auto other = static_cast<Index>(found - edges_.begin());
            edge_classes_.join(e, other);
        }
        check_distances(to, name);
    }

    PeriodicMesh made() {
        PeriodicMesh result;
        std::vector<Index> kept;
        const auto leaders = vertex_classes_.firsts();
        for (Index v = 0; v < box_.points.rows(); ++v) {
            const Index leader = leaders[v]; // which comes before
            if (leader == v)
                kept.push_back(v);
            result.vertices.push_back(leader == v ? static_cast<Index>(kept.size()) - 1
                                                  : result.vertices[leader]);
        }
        result.points = box_.points(kept, Eigen::indexing::all);
        result.quotient.vertices = static_cast<Index>(kept.size());
        result.quotient.simplices =
            box_.simplices.unaryExpr([&](Index v) { return result.vertices[v]; });
        check_simplices(result.quotient.simplices);
        set_edges(result);
        result.box = std::move(box_);
        return result;
    }

private:
    /// Throws unless vertices are as far apart as their images. Those that are glued are looked at
    /// from some of them which span all their places, each the farthest from what is spanned so
    /// far.
    void check_distances(const std::vector<Index>& to, const std::string& name) const {
        std::vector<Index> glued;
        for (Index v = 0; v < std::ssize(to); ++v)
            if (to[v] >= 0)
                glued.push_back(v);
        if (glued.empty())
            return;
        const double tolerance =
            1e-8 * (box_.points.colwise().maxCoeff() - box_.points.colwise().minCoeff()).norm();
        Points rest = box_.points(glued, Eigen::indexing::all);
        for (Index from = glued.front(), rank = 0; rank <= rest.cols(); ++rank) {
            for (const Index v : glued)
                if (std::abs(length({v, from}) - length({to[v], to[from]})) > tolerance)
                    throw InvalidInput(
                        fmt::format("the {} maps vertices {} and {} to vertices {} and {}, which "
                                    "are not as far apart: expected an isometry",
                                    name, v, from, to[v], to[from]));
            if (rank == 0)
                rest.rowwise() -= box_.points.row(from).eval();
            Index farthest = 0;
            const double distance = rest.rowwise().norm().maxCoeff(&farthest);
            if (distance <= tolerance)
                return;
            from = glued[farthest];
            const Eigen::RowVectorXd along = rest.row(farthest) / distance;
            rest -= (rest * along.transpose()) * along;
        }
    }

    double length(const Edge& edge) const {
        return (box_.points.row(edge.first) - box_.points.row(edge.second)).norm();
    }

    void set_edges(PeriodicMesh& mesh) {
        std::vector<std::pair<Edge, Index>> of; // by ends in the quotient, each with its class
        const auto leaders = edge_classes_.firsts();
        for (Index e = 0; e < std::ssize(edges_); ++e)
            if (leaders[e] == e)
                of.emplace_back(
                    std::minmax(mesh.vertices[edges_[e].first], mesh.vertices[edges_[e].second]),
                    e);
        std::sort(of.begin(), of.end());
        LengthMesh& quotient = mesh.quotient;
        quotient.edges.resize(std::ssize(of), 2);
        quotient.lengths.resize(std::ssize(of));
        for (Index row = 0; row < std::ssize(of); ++row) {
            const auto& [pair, edge] = of[row];
            if (row > 0 && pair == of[row - 1].first)
                throw InvalidInput(
                    fmt::format("the edge between vertices {} and {} and the edge between {} and "
                                "{} have the same ends after gluing: expected a simplicial "
                                "complex; use at least three cells along every translation",
                                edges_[of[row - 1].second].first, edges_[of[row - 1].second].second,
                                edges_[edge].first, edges_[edge].second));
            quotient.edges.row(row) << pair.first, pair.second;
            quotient.lengths[row] = length(edges_[edge]);
        }
    }

    Mesh box_;
    Places places_;
    std::vector<Edge> edges_;
    DisjointSets vertex_classes_, edge_classes_;
};

} // namespace

PeriodicMesh periodic(Mesh box, const std::vector<Vector>& translations) {
    Gluing parts(std::move(box));
    const Points& points = parts.box().points;
    for (const Vector& by : translations) {
        Points images; // none if it has other coordinates, which is told
        if (by.size() == points.cols())
            images = points.rowwise() + by.transpose();
        parts.add(images, fmt::format("translation ({})", fmt::join(by, ", ")));
    }
    return parts.made();
}

PeriodicMesh glue_by_images(Mesh box, const std::vector<Points>& images) {
    Gluing parts(std::move(box));
    for (std::size_t i = 0; i < images.size(); ++i)
        parts.add(images[i], fmt::format("isometry {}", i));
    return parts.made();
}

PeriodicMesh glue(Mesh box, const std::vector<Isometry>& isometries) {
    std::vector<Points> images;
    for (const Isometry& isometry : isometries) {
        check_callable(fmt::format("isometry {}", images.size()), isometry);
        Points image(box.points.rows(), box.points.cols());
        for (Index v = 0; v < image.rows(); ++v) {
            const Vector to = isometry(box.points.row(v).transpose());
            check_as_many("coordinates of an image", to.size(), image.cols());
            image.row(v) = to.transpose();
        }
        images.push_back(std::move(image));
    }
    return glue_by_images(std::move(box), images);
}

} // namespace polydec
