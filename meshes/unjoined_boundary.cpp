// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/lists.h"
#include "meshes/boundary_contacts.h"
#include "meshes/edges.h"
#include "meshes/point_tree.h"
#include "meshes/tidy.h"
#include "meshes/weld.h"

#include <algorithm>

namespace polydec {

namespace {

/// Of each vertex of the rows the first vertex at its place; of others, themselves.
std::vector<Index> first_at_place(const Simplices& rows, const Points& points, double length) {
    const auto vertices = used_vertices(rows);
    DisjointSets sets(static_cast<Index>(vertices.size()));
    join_near(points(vertices, Eigen::indexing::all), length, sets);
    const auto firsts = sets.firsts();
    std::vector<Index> result = numbers_below(points.rows());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        result[vertices[i]] = vertices[firsts[i]];
    return result;
}

/// Leaves out facets with a corner twice and those on the corners of others; the rest is sorted.
OpenFacets single(const OpenFacets& facets, const std::vector<Index>& first) {
    Simplices corners = facets.corners.unaryExpr([&](Index v) { return first[v]; });
    const auto n = corners.cols();
    const auto row = [&](Index f) { return corners.data() + f * n; };
    std::vector<Index> order, kept;
    for (Index f = 0; f < corners.rows(); ++f) {
        std::sort(row(f), row(f) + n);
        if (std::adjacent_find(row(f), row(f) + n) == row(f) + n)
            order.push_back(f);
    }
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return std::lexicographical_compare(row(a), row(a) + n, row(b), row(b) + n);
    });
    for (auto begin = order.begin(); begin != order.end();) {
        const Index* const one = row(*begin);
        const auto end = std::find_if(begin, order.end(),
                                      [&](Index f) { return !std::equal(one, one + n, row(f)); });
        if (end - begin == 1)
            kept.push_back(*begin);
        begin = end;
    }
    OpenFacets result{corners(kept, Eigen::indexing::all)};
    for (const Index f : kept) {
        result.opposite.push_back(first[facets.opposite[f]]);
        result.cells.push_back(facets.cells[f]);
    }
    return result;
}

} // namespace

OpenFacets open_facets(const SimplicialComplex& complex) {
    const int n = complex.dimension();
    const auto& counts = complex.coface_counts(n - 1);
    OpenFacets result{Simplices(std::count(counts.begin(), counts.end(), 1), n)};
    if (result.corners.rows() > 0)
        result.numbers = complex.vertex_numbers(numbers_below(complex.size(0)));
    const FaceTable faces = complex.faces(n);
    for (Index t = 0; t < complex.size(n) && result.corners.rows() > 0; ++t)
        for (int omitted = 0; omitted <= n; ++omitted) {
            const Index f = faces(t, omitted);
            if (counts[f] != 1)
                continue;
            result.corners.row(std::ssize(result.opposite)) = complex.simplices(n - 1).row(f);
            result.opposite.push_back(complex.simplices(n)(t, omitted));
            result.cells.push_back(t);
        }
    return result;
}

BoundaryContacts boundary_contacts(const OpenFacets& all, const Points& points, double length) {
    if (all.cells.empty())
        return {};
    const OwnUnits own(points);
    const double scaled = own.scaled(length);
    const auto first = first_at_place(all.corners, own.points, scaled);

    BoundaryContacts result;
    for (Index v = 0; v < std::ssize(first); ++v)
        if (first[v] != v)
            result.coincident.push_back(all.numbers[v]);
    const OpenFacets open = single(all, first);
    result.facets = open.corners.unaryExpr([&](Index v) { return all.numbers[v]; });
    result.in_facets.resize(open.opposite.size());
    if (all.corners.cols() < 2)
        return result;
    const auto vertices = used_vertices(open.corners);
    const PointTree tree(own.points(vertices, Eigen::indexing::all));
    Points centroids(open.corners.rows(), own.points.cols());
    for (Index f = 0; f < centroids.rows(); ++f)
        centroids.row(f) =
            own.points(open.corners.row(f).transpose(), Eigen::indexing::all).colwise().mean();
    const PointTree tree_of_centroids(centroids);
    std::vector<Index> misfits;
    for (Index f = 0; f < std::ssize(open.cells); ++f) {
        const auto corners = open.corners.row(f);
        const Points simplex = own.points(corners.transpose(), Eigen::indexing::all);
        std::vector<Index> of_cell; // those vertices of its cell that are on the boundary
        for (const Index v : corners)
            of_cell.push_back(place_in(vertices, v));
        if (const Index i = place_in(vertices, open.opposite[f]);
            i < std::ssize(vertices) && vertices[i] == open.opposite[f])
            of_cell.push_back(i);
        for (const Index i : tree.near(simplex, scaled, of_cell))
            result.in_facets[f].push_back(all.numbers[vertices[i]]);
        result.hanging.insert(result.hanging.end(), result.in_facets[f].begin(),
                              result.in_facets[f].end());
        for (const Index other : tree_of_centroids.near(simplex, scaled, {f}))
            if (open.cells[other] != open.cells[f])
                misfits.push_back(other);
    }
    sort_unique(result.hanging);
    sort_unique(misfits);
    result.misfits = static_cast<Index>(misfits.size());
    return result;
}

UnjoinedBoundary unjoined_boundary(const SimplicialComplex& complex, const Points& points) {
    check_as_many("points", points.rows(), complex.size(0));
    auto contacts = boundary_contacts(open_facets(complex), points, weld_length(points));
    return {std::move(contacts.coincident), std::move(contacts.hanging), contacts.misfits};
}

UnjoinedBoundary unjoined_boundary(const Mesh& mesh) {
    Mesh tidied = mesh;
    FlatCellsKept flat;
    const SimplicialComplex complex = tidied_complex(tidied, flat);
    return unjoined_boundary(complex,
                             tidied.points(complex.vertex_numbers(numbers_below(complex.size(0))),
                                           Eigen::indexing::all));
}

} // namespace polydec
