// SPDX-License-Identifier: MIT
#include "dec/surfaces/intrinsic_tessellation.h"

#include "base/errors.h"
#include "dec/surfaces/glued_volumes.h"

#include <fmt/format.h>

#include <utility>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// Triangles' shares of their polygons, with signs: S_2.
SparseMatrix shares_of_area(const MergedSurface& merging, const Vector& areas) {
    const SparseMatrix pieces = merging.diamonds[2].cast<double>();
    const Vector polygons = pieces.cwiseAbs() * areas;
    const SparseMatrix shares = polygons.cwiseInverse().asDiagonal() * pieces * areas.asDiagonal();
    return shares.transpose();
}

/// Entries of one row of S_1, as they come.
using Entries = std::vector<std::pair<Index, double>>;

/// Fills removed edges one after the other, from the triangles that lack the value of a single
/// side: within a polygon, they are the leaves of a tree.
class EdgeLift {
public:
    EdgeLift(const IntrinsicTessellation& tessellation, const SparseMatrix& areas)
        : surface_(tessellation.surface()),
          merging_(tessellation.merging),
          areas_(areas),
          rows_(static_cast<std::size_t>(surface_.edges())),
          unknown_(static_cast<std::size_t>(surface_.triangles()), 3) {
        for (Index cell = 0; cell < merging_.diamonds[1].rows(); ++cell) {
            const auto e = static_cast<Index>(Row(merging_.diamonds[1], cell).col());
            rows_[e] = {{cell, 1.0}};
            for (const Index h : surface_.halfedges(e))
                if (h >= 0)
                    --unknown_[GluedSurface::triangle(h)];
        }
    }

    SparseMatrix solve() {
        std::vector<Index> leaves;
        for (Index t = 0; t < surface_.triangles(); ++t)
            if (unknown_[t] == 1)
                leaves.push_back(t);
        while (!leaves.empty()) {
            const Index t = leaves.back();
            leaves.pop_back();
            if (unknown_[t] != 1)
                continue; // its last side came from the neighbor
            const Index e = fill(t);
            for (const Index h : surface_.halfedges(e))
                if (--unknown_[GluedSurface::triangle(h)] == 1)
                    leaves.push_back(GluedSurface::triangle(h));
        }
        return matrix();
    }

private:
    /// The unknown side of a triangle, from (d x)(t) = (S_2 d^P)(t).
    Index fill(Index triangle) {
        Index unknown = -1;
        Entries row;
        for (SparseMatrix::InnerIterator cell(areas_, triangle); cell; ++cell)
            for (Row side(merging_.merged.coboundary(1), cell.col()); side; ++side)
                row.emplace_back(static_cast<Index>(side.col()), cell.value() * side.value());
        for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
            const auto& known = rows_[surface_.edge(h)];
            if (known.empty())
                unknown = h;
            for (const auto& [column, value] : known)
                row.emplace_back(column, -surface_.sign(h) * value);
        }
        for (auto& entry : row)
            entry.second *= surface_.sign(unknown);
        rows_[surface_.edge(unknown)] = std::move(row);
        return surface_.edge(unknown);
    }

    SparseMatrix matrix() {
        std::vector<Eigen::Triplet<double, Index>> entries;
        for (std::size_t e = 0; e < rows_.size(); ++e)
            for (const auto& [column, value] : rows_[e])
                entries.emplace_back(static_cast<Index>(e), column, value);
        SparseMatrix S(surface_.edges(), merging_.merged.size(1));
        S.setFromTriplets(entries.begin(), entries.end());
        S.prune([](Index, Index, double value) { return value != 0; });
        return S;
    }

    const GluedSurface& surface_;
    const MergedSurface& merging_;
    const SparseMatrix& areas_;
    std::vector<Entries> rows_;
    std::vector<int> unknown_; // sides of each triangle
};

} // namespace

IntrinsicTessellation intrinsic_tessellation(GluedSurface surface, Vector lengths,
                                             const MergeOptions& options) {
    if (options.criterion == MergeCriterion::angle)
        throw InvalidInput("intrinsic flips go with the relative dual length, not with the test of "
                           "opposite angles: leave out the angle tolerance");
    const auto boundary =
        options.delaunay == Delaunay::flips_and_splits ? BoundaryEdges::split : BoundaryEdges::keep;
    auto delaunay = intrinsic_delaunay(std::move(surface), std::move(lengths),
                                       {.boundary = boundary, .tolerance = options.tolerance});
    auto volumes = circumcentric_volumes(delaunay.surface, delaunay.lengths);
    std::vector<Index> removed;
    if (options.criterion != MergeCriterion::none)
        removed = concyclic_edges(delaunay.surface, volumes, options.tolerance);
    auto merging = merge_triangles(delaunay.surface, removed);
    return {std::move(delaunay), std::move(volumes), std::move(merging)};
}

Vector carry(const IntrinsicTessellation& tessellation, int k, const Vector& values) {
    const Vector on_triangles = tessellation.delaunay.history.carry(k, values); // checks k
    return tessellation.merging.diamonds[k].cast<double>() * on_triangles;
}

Vector carry_back(const IntrinsicTessellation& tessellation, int k, const Vector& values) {
    const auto lift = commuting_lift(tessellation);
    if (k < 0 || k > 2 || values.size() != lift[k].cols())
        throw InvalidInput(fmt::format("{} values are given for a {}-form: the tessellation has {} "
                                       "vertices, {} edges and {} polygons",
                                       values.size(), k, lift[0].cols(), lift[1].cols(),
                                       lift[2].cols()));
    return tessellation.delaunay.history.carry_back(k, lift[k] * values);
}

std::vector<SparseMatrix> commuting_lift(const IntrinsicTessellation& tessellation) {
    std::vector<SparseMatrix> lift(3);
    lift[0].resize(tessellation.surface().vertices(), tessellation.surface().vertices());
    lift[0].setIdentity();
    lift[2] = shares_of_area(tessellation.merging, tessellation.triangle_volumes.primal(2));
    lift[1] = EdgeLift(tessellation, lift[2]).solve();
    return lift;
}

} // namespace polydec
