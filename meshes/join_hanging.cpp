// SPDX-License-Identifier: MIT
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/listed.h"
#include "base/lists.h"
#include "meshes/boundary_contacts.h"
#include "meshes/facet_overlay.h"
#include "meshes/point_tree.h"
#include "meshes/tidy.h"
#include "meshes/weld.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// The vertices that lie on edges of facets, each on the nearest edge of its facet.
std::vector<DividedEdges::Entry> on_edges(const BoundaryContacts& nodes, const Points& points,
                                          double length) {
    std::vector<DividedEdges::Entry> entries;
    for (Index f = 0; f < nodes.facets.rows(); ++f)
        for (const Index v : nodes.in_facets[f]) {
            DividedEdges::Entry nearest{};
            double least = length * length;
            for (Index i = 0; i < nodes.facets.cols(); ++i)
                for (Index j = i + 1; j < nodes.facets.cols(); ++j) {
                    const Index a = nodes.facets(f, i), b = nodes.facets(f, j);
                    const double square =
                        squared_distance(points.row(v), points({a, b}, Eigen::indexing::all));
                    if (square > least)
                        continue;
                    const Eigen::RowVectorXd along = points.row(b) - points.row(a);
                    least = square;
                    nearest = {a, b,
                               (points.row(v) - points.row(a)).dot(along) / along.squaredNorm(), v};
                }
            if (nearest.a < nearest.b)
                entries.push_back(nearest);
        }
    return entries;
}

/// The faces of a tetrahedron; face i lacks corner i.
std::array<Triangle, 4> faces_of(const Simplices& cells, Index cell) {
    const auto c = cells.row(cell);
    return {ascending({c[1], c[2], c[3]}), ascending({c[0], c[2], c[3]}),
            ascending({c[0], c[1], c[3]}), ascending({c[0], c[1], c[2]})};
}

/// Of cells with their edges divided, triangles that are divided too: cells of dimension 2, and
/// faces of others.
std::vector<Triangle> triangles_to_divide(const Simplices& cells,
                                          const DividedTriangles& triangles) {
    std::vector<Triangle> result;
    for (Index cell = 0; cell < cells.rows(); ++cell)
        if (cells.cols() == 3)
            result.push_back({cells(cell, 0), cells(cell, 1), cells(cell, 2)});
        else
            for (const Triangle& face : faces_of(cells, cell))
                if (triangles.is_divided(face))
                    result.push_back(face);
    return result;
}

/// Cells that take the place of others, which are divided along their surface.
class Division {
public:
    /// Points are scaled; triangles are divided at nodes.
    Division(const Mesh& mesh, const Points& points, const DividedTriangles& triangles)
        : mesh_(mesh), points_(points), triangles_(triangles) {
        for (Index cell = 0; cell < mesh.simplices.rows(); ++cell) {
            const auto before = rows_.size();
            corners_.clear();
            if (mesh.dimension() == 2)
                divide_triangle(cell);
            else
                divide_tetrahedron(cell);
            append(cell);
            if (rows_.size() > before + 1)
                divided_.push_back(cell);
        }
    }

    /// Cells that were divided.
    std::size_t count() const { return divided_.size(); }

    Mesh made(std::size_t nodes, std::size_t crossings) const {
        Mesh result = mesh_;
        const auto vertices = mesh_.points.rows();
        result.points.conservativeResize(vertices + std::ssize(centers_), Eigen::NoChange);
        for (Index i = 0; i < std::ssize(centers_); ++i)
            result.points.row(vertices + i) = center(mesh_.points, centers_[i]);
        follow_rows(result, rows_, static_cast<Index>(mesh_.simplices.rows()));
        result.simplices = simplices_of(all_corners_, mesh_.simplices.cols());
        divide_facets(result.facet_tags);
        result.warnings.push_back(
            fmt::format("split {} at {}", counted(divided_.size(), "cell", "cells"),
                        counted(nodes, "hanging vertex", "hanging vertices")));
        if (crossings > 0)
            result.warnings.back() += fmt::format(" and {} crossings of edges", crossings);
        result.warnings.back() +=
            fmt::format(", giving {} in place of {}",
                        std::ssize(rows_) - mesh_.simplices.rows() + std::ssize(divided_),
                        divided_.size() == 1 ? "it" : "them");
        if (!centers_.empty())
            result.warnings.back() += fmt::format(", with a new vertex inside {}", centers_.size());
        return result;
    }

private:
    static Eigen::RowVectorXd center(const Points& points, const std::vector<Index>& corners) {
        return points(corners, Eigen::indexing::all).colwise().sum() /
               static_cast<double>(corners.size());
    }

    void divide_triangle(Index cell) {
        const auto c = mesh_.simplices.row(cell);
        for (const Triangle& part : triangles_.parts({c[0], c[1], c[2]}))
            corners_.insert(corners_.end(), part.begin(), part.end());
    }

    /// A cone over the divided surface: from a corner if what meets it is a fan around it.
    void divide_tetrahedron(Index cell) {
        const auto c = mesh_.simplices.row(cell);
        const auto faces = faces_of(mesh_.simplices, cell);
        std::array<std::vector<Triangle>, 4> parts;
        std::size_t count = 0;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            parts[i] = triangles_.parts(faces[i]);
            count += parts[i].size();
        }
        if (count == faces.size()) {
            corners_.assign(c.begin(), c.end());
            return;
        }
        for (std::size_t i = 0; i < faces.size(); ++i) {
            bool is_fan = true;
            for (std::size_t j = 0; j < faces.size(); ++j)
                for (const Triangle& part : parts[j])
                    is_fan = is_fan &&
                             (j == i || std::find(part.begin(), part.end(), c[i]) != part.end());
            if (is_fan)
                return add_cone(c[i], parts[i]);
        }
        const auto apex = static_cast<Index>(mesh_.points.rows() + std::ssize(centers_));
        centers_.push_back({c.begin(), c.end()});
        for (const auto& each : parts)
            add_cone(apex, each);
    }

    void add_cone(Index apex, const std::vector<Triangle>& base) {
        for (const auto& [a, b, c] : base)
            corners_.insert(corners_.end(), {apex, a, b, c});
    }

    Eigen::RowVectorXd point(Index v) const {
        const auto vertices = static_cast<Index>(points_.rows());
        return v < vertices ? Eigen::RowVectorXd(points_.row(v))
                            : center(points_, centers_[v - vertices]);
    }

    DenseMatrix edges(const Index* corners) const {
        DenseMatrix result(mesh_.dimension(), points_.cols());
        for (Index i = 0; i < result.rows(); ++i)
            result.row(i) = point(corners[i + 1]) - point(corners[0]);
        return result;
    }

    /// The parts of a cell, which must fill it, with its orientation.
    void append(Index cell) {
        const auto width = static_cast<std::size_t>(mesh_.simplices.cols());
        if (corners_.size() > width) {
            const DenseMatrix whole = edges(mesh_.simplices.data() + cell * mesh_.simplices.cols());
            const double square = (whole * whole.transpose()).partialPivLu().determinant();
            double filled = 0, least = 1;
            for (auto corner = corners_.begin(); corner != corners_.end();
                 corner += static_cast<std::ptrdiff_t>(width)) {
                const double share =
                    (edges(&*corner) * whole.transpose()).partialPivLu().determinant() / square;
                if (share < 0)
                    std::swap(corner[0], corner[1]);
                filled += std::abs(share);
                least = std::min(least, std::abs(share));
            }
            constexpr double fits = 1e-3;
            if (!(std::abs(filled - 1) <= fits) || !(least > 0))
                refuse(cell);
        }
        all_corners_.insert(all_corners_.end(), corners_.begin(), corners_.end());
        rows_.resize(all_corners_.size() / width, cell);
    }

    [[noreturn]] void refuse(Index cell) const {
        const auto corners = mesh_.simplices.row(cell);
        throw InvalidInput(
            fmt::format("cell {} (vertices {}) cannot be split at its hanging vertices: it is "
                        "about as thin as the tolerance for their distance from its surface\n"
                        "Reduce the length within which vertices are joined, or remove the cell.",
                        cell, fmt::join(corners.begin(), corners.end(), " ")),
            {.degree = mesh_.dimension(),
             .cells = {cell},
             .vertices = {corners.begin(), corners.end()}});
    }

    void divide_facets(TaggedSimplices& facets) const {
        std::vector<Index> corners, tags;
        const auto width = facets.simplices.cols();
        for (Index f = 0; f < facets.simplices.rows(); ++f) {
            const auto c = facets.simplices.row(f);
            if (width == 2) {
                std::vector<Index> way;
                triangles_.edges().append(c[0], c[1], way);
                way.push_back(c[1]);
                for (std::size_t i = 1; i < way.size(); ++i)
                    corners.insert(corners.end(), {way[i - 1], way[i]});
            } else {
                for (const Triangle& part : triangles_.parts(ascending({c[0], c[1], c[2]})))
                    corners.insert(corners.end(), part.begin(), part.end());
            }
            tags.resize(corners.size() / static_cast<std::size_t>(width), facets.tags[f]);
        }
        if (facets.simplices.rows() > 0)
            facets = {simplices_of(corners, width), tags};
    }

    const Mesh& mesh_;
    const Points& points_;
    const DividedTriangles& triangles_;
    std::vector<Index> corners_;              // of the parts of one cell
    std::vector<Index> all_corners_, rows_;   // of the parts of all, and of which cell each is one
    std::vector<Index> divided_;              // cells
    std::vector<std::vector<Index>> centers_; // of cells with a new vertex, their corners
};

/// Whether any cell was divided.
bool divide(Mesh& mesh, const BoundaryContacts& nodes, double length) {
    const int n = mesh.dimension();
    if (n < 2 || n > 3)
        throw InvalidInput(fmt::format(
            "{} vertices hang on cells of dimension {}, and {} facets lie on others: only cells of "
            "dimension 2 or 3 can be split; mesh both sides so that they fit",
            nodes.hanging.size(), n, nodes.misfits));
    const OwnUnits own(mesh.points);
    const double scaled = own.scaled(length);
    const FacetOverlay overlay(n == 3 ? nodes.facets : Simplices(0, 3),
                               n == 3 ? nodes.in_facets : std::vector<std::vector<Index>>(),
                               own.points, scaled);
    auto entries = on_edges(nodes, own.points, scaled);
    for (const auto& entry : overlay.on_edges())
        entries.push_back(entry);
    DividedEdges edges(std::move(entries));
    DividedTriangles triangles(edges, overlay.parts(edges));
    triangles.divide(triangles_to_divide(mesh.simplices, triangles), overlay.points());

    Mesh whole = mesh;
    whole.points = FacetOverlay::with_crossings(mesh.points, overlay.crossings());
    const Division division(whole, overlay.points(), triangles);
    if (division.count() == 0)
        return false;
    mesh = division.made(nodes.hanging.size(), overlay.crossings().size());
    return true;
}

} // namespace

Joined join_hanging(Mesh mesh, std::optional<double> length) {
    Joined result = weld(std::move(mesh), length);
    result.mesh = tidy(std::move(result.mesh), CellsWithoutVolume::keep);
    constexpr int most_passes = 40; // of which all but the first are for facets with holes
    for (int pass = 0; pass < most_passes; ++pass) {
        const SimplicialComplex complex(result.mesh.simplices);
        const Points points = result.mesh.points(
            complex.vertex_numbers(numbers_below(complex.size(0))), Eigen::indexing::all);
        const double within = length ? *length : weld_length(points);
        const auto nodes = boundary_contacts(open_facets(complex), points, within);
        if ((nodes.hanging.empty() && nodes.misfits == 0) || !divide(result.mesh, nodes, within))
            break;
    }
    return result;
}

} // namespace polydec
