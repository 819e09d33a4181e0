// SPDX-License-Identifier: MIT
#include "meshes/refine.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "meshes/edges.h"
#include "meshes/tidy.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace polydec {

namespace {

constexpr double most_simplices = 1e8, rounding = 1e-12;

std::uint64_t key(Index a, Index b) {
    const auto [least, most] = std::minmax(a, b);
    return std::uint64_t(least) << 32 | std::uint64_t(most);
}

/// The middles of edges, which are new vertices.
class Middles {
public:
    explicit Middles(Index vertices) : vertices_(vertices) {}

    Index add(Index a, Index b) {
        const auto [entry, is_new] = numbers_.emplace(key(a, b), end());
        if (is_new)
            ends_.push_back({a, b});
        return entry->second;
    }
    Index end() const { return vertices_ + static_cast<Index>(ends_.size()); }
    bool contains(Index a, Index b) const { return numbers_.contains(key(a, b)); }

    /// Between which vertices each one is.
    const std::vector<std::array<Index, 2>>& ends() const { return ends_; }

private:
    Index vertices_;
    std::unordered_map<std::uint64_t, Index> numbers_;
    std::vector<std::array<Index, 2>> ends_;
};

/// A simplex or a part of one: its corners, the vertices by which edges are known, and the squares
/// of their lengths.
struct Part {
    std::vector<Index> corners, vertices;
    DenseMatrix squares;
};

/// The part in which the middle of an edge replaces one of its ends.
Part half(const Part& whole, int kept, int replaced, Index corner, Index vertex) {
    Part result = whole;
    result.corners[replaced] = corner;
    result.vertices[replaced] = vertex;
    const DenseMatrix& squares = whole.squares;
    const double quarter = squares(kept, replaced) / 4;
    for (int v = 0; v < squares.rows(); ++v)
        if (v != replaced) // the same number in all simplices around, in whatever order
            result.squares(v, replaced) = result.squares(replaced, v) =
                v == kept ? quarter
                          : std::max(0.0, (squares(kept, v) + squares(replaced, v)) / 2 - quarter);
    return result;
}

/// At least so many parts without a longer edge a simplex has: by volume, of which the regular
/// simplex has the most, and by its longest edge.
double least_parts(const DenseMatrix& squares, double limit) {
    const auto n = squares.rows() - 1;
    if (n < 1)
        return 1;
    DenseMatrix products(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            products(i, j) =
                (squares(0, i + 1) + squares(0, j + 1) - squares(i + 1, j + 1)) / limit;
    const double ratio = std::max(0.0, products.determinant() / double(n + 1));
    return std::max({1.0, std::sqrt(ratio), std::sqrt(squares.maxCoeff() / limit)});
}

[[noreturn]] void refuse(double longest, const char* relation, double simplices) {
    throw InvalidInput(fmt::format("edges of at most {:g} would give {} {:.3g} simplices; expected "
                                   "at most {:.3g}: choose a greater length",
                                   longest, relation, simplices, most_simplices));
}

/// The parts of the simplices of a mesh. Corners in `rows` stand for its vertices[corner], or, if
/// that is empty, for themselves.
class Refining {
public:
    Refining(const LengthMesh& mesh, const Simplices& rows, std::vector<Index> vertices,
             double longest)
        : unit_(std::exp2(std::ilogb(longest))), // so that square roots of squares are exact
          limit_(std::pow(longest / unit_ * (1 + rounding), 2)),
          whole_(rows),
          of_vertices_(mesh.vertices),
          of_corners_(static_cast<Index>(vertices.size())),
          vertices_(std::move(vertices)) {
        check_positive("the largest length of edges", longest);
        for (Index e = 0; e < mesh.edges.rows(); ++e)
            squares_[key(mesh.edges(e, 0), mesh.edges(e, 1))] =
                std::pow(mesh.lengths[e] / unit_, 2);
        double least = 0;
        for (Index row = 0; row < rows.rows(); ++row)
            least += least_parts(part_of(rows, row).squares, limit_);
        if (!(least <= most_simplices))
            refuse(longest, "at least", least);
        for (Index row = 0; row < rows.rows(); ++row)
            divide(part_of(rows, row), [&](const Part& part) {
                if (std::ssize(parents_) >= most_simplices)
                    refuse(longest, "more than", most_simplices);
                corners_.insert(corners_.end(), part.corners.begin(), part.corners.end());
                parents_.push_back(row);
            });
        is_done_ = true;
    }

    Simplices rows() const { return simplices_of(corners_, whole_.cols()); }
    const std::vector<Index>& parents() const { return parents_; } ///< of the parts
    const std::vector<Index>& vertices() const { return vertices_; }
    int bisections() const { return bisections_; } ///< of one simplex, at most

    /// With the middles of edges between corners.
    Points points(Points points) const {
        const auto& ends = (vertices_.empty() ? of_vertices_ : of_corners_).ends();
        Eigen::Index v = points.rows();
        points.conservativeResize(v + std::ssize(ends), Eigen::NoChange);
        for (const auto& [a, b] : ends)
            points.row(v++) = points.row(a) / 2 + points.row(b) / 2;
        return points;
    }

    /// Facets are divided as the simplices around them; others stay.
    TaggedSimplices facets(const TaggedSimplices& whole) {
        std::vector<Index> corners;
        TaggedSimplices result;
        for (Index row = 0; row < whole.simplices.rows(); ++row)
            divide(part_of(whole.simplices, row), [&](const Part& part) {
                corners.insert(corners.end(), part.corners.begin(), part.corners.end());
                result.tags.push_back(whole.tags[row]);
            });
        result.simplices = simplices_of(corners, whole.simplices.cols());
        return result;
    }

    LengthMesh lengths() {
        std::vector<std::pair<Edge, double>> edges;
        for (Index row = 0; row < whole_.rows(); ++row)
            divide(part_of(whole_, row), [&](const Part& part) {
                for (int j = 1; j < part.squares.rows(); ++j)
                    for (int i = 0; i < j; ++i)
                        edges.emplace_back(std::minmax(part.vertices[i], part.vertices[j]),
                                           unit_ * std::sqrt(part.squares(i, j)));
            });
        sort_unique(edges);
        LengthMesh result{
            rows(), of_vertices_.end(), Simplices(std::ssize(edges), 2), Vector(std::ssize(edges)),
            {},     bisections_};
        if (!vertices_.empty())
            for (Index& corner : result.simplices.reshaped())
                corner = vertices_[corner];
        for (std::size_t e = 0; e < edges.size(); ++e) {
            result.edges.row(Index(e)) << edges[e].first.first, edges[e].first.second;
            result.lengths[Index(e)] = edges[e].second;
        }
        return result;
    }

private:
    /// Without squares if these are no edges of the mesh.
    Part part_of(const Simplices& rows, Index row) const {
        Part result{{rows.row(row).begin(), rows.row(row).end()}, {}, {}};
        for (const Index corner : result.corners)
            result.vertices.push_back(vertices_.empty() ? corner : vertices_[corner]);
        const int count = static_cast<int>(rows.cols());
        result.squares = DenseMatrix::Zero(count, count);
        for (int j = 1; j < count; ++j)
            for (int i = 0; i < j; ++i) {
                const auto found = squares_.find(key(result.vertices[i], result.vertices[j]));
                if (found == squares_.end())
                    return {std::move(result.corners), {}, {}};
                result.squares(i, j) = result.squares(j, i) = found->second;
            }
        return result;
    }

    /// Calls emit(part) for the parts in order. Once all simplices are divided, no middle is new.
    template <class Emit>
    void divide(const Part& whole, const Emit& emit, int bisections = 0) {
        bisections_ = std::max(bisections_, bisections);
        int a = 0, b = 0;
        const auto& v = whole.vertices;
        for (int j = 1; j < whole.squares.rows(); ++j)
            for (int i = 0; i < j; ++i)
                if (whole.squares(i, j) > whole.squares(a, b) ||
                    (whole.squares(i, j) == whole.squares(a, b) &&
                     std::minmax(v[i], v[j]) < std::minmax(v[a], v[b])))
                    a = i, b = j;
        if (a == b || !(whole.squares(a, b) > limit_) ||
            (is_done_ && !of_vertices_.contains(v[a], v[b]))) {
            emit(whole);
            return;
        }
        const Index vertex = of_vertices_.add(v[a], v[b]);
        Index corner = vertex;
        if (!vertices_.empty()) {
            corner = of_corners_.add(whole.corners[a], whole.corners[b]);
            if (corner == std::ssize(vertices_))
                vertices_.push_back(vertex);
        }
        divide(half(whole, a, b, corner, vertex), emit, bisections + 1);
        divide(half(whole, b, a, corner, vertex), emit, bisections + 1);
    }

    double unit_, limit_;                               // of lengths, and of their squares in units
    std::unordered_map<std::uint64_t, double> squares_; // of the lengths of the mesh's edges
    Simplices whole_;
    Middles of_vertices_, of_corners_;
    std::vector<Index> vertices_, corners_, parents_;
    int bisections_ = 0;
    bool is_done_ = false;
};

/// The mesh with the parts of its simplices.
Mesh of_parts(Mesh mesh, Refining& refining) {
    mesh.points = refining.points(std::move(mesh.points));
    follow_rows(mesh, refining.parents(), static_cast<Index>(mesh.simplices.rows()));
    mesh.facet_tags = refining.facets(mesh.facet_tags);
    mesh.simplices = refining.rows();
    mesh.bisections += refining.bisections();
    return mesh;
}

} // namespace

Mesh refined(Mesh mesh, double longest) {
    check_mesh(mesh);
    Refining refining(length_mesh(mesh), mesh.simplices, {}, longest);
    return of_parts(std::move(mesh), refining);
}

LengthMesh refined(const LengthMesh& mesh, double longest) {
    check(mesh);
    Refining refining(mesh, mesh.simplices, {}, longest);
    LengthMesh result = refining.lengths();
    result.input_cells =
        followed(mesh.input_cells, refining.parents(), static_cast<Index>(mesh.simplices.rows()));
    result.bisections += mesh.bisections;
    return result;
}

PeriodicMesh refined(PeriodicMesh mesh, double longest) {
    check_facet_tags(mesh.box);
    Refining refining(mesh.quotient, mesh.box.simplices, mesh.vertices, longest);
    const int before = mesh.quotient.bisections;
    mesh.quotient = refining.lengths();
    mesh.quotient.bisections += before;
    mesh.box = of_parts(std::move(mesh.box), refining);
    mesh.vertices = refining.vertices();
    Index count = static_cast<Index>(mesh.points.rows());
    mesh.points.conservativeResize(mesh.quotient.vertices, Eigen::NoChange);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (mesh.vertices[v] == count)
            mesh.points.row(count++) = mesh.box.points.row(Index(v));
    return mesh;
}

} // namespace polydec
