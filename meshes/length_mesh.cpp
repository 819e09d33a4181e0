// SPDX-License-Identifier: MIT
#include "meshes/length_mesh.h"

#include "base/errors.h"
#include "base/lists.h"
#include "meshes/edges.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

Edge edge(const Simplices& edges, Index row) {
    return std::minmax(Index{edges(row, 0)}, Index{edges(row, 1)});
}

} // namespace

LengthMesh length_mesh(const Mesh& mesh) {
    const auto edges = edges_of(mesh.simplices);
    LengthMesh result{mesh.simplices, static_cast<Index>(mesh.points.rows()),
                      Simplices(edges.size(), 2), Vector(edges.size())};
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [a, b] = edges[e];
        result.edges.row(static_cast<Index>(e)) << a, b;
        result.lengths[static_cast<Index>(e)] = distance(mesh.points, a, b);
    }
    return result;
}

std::vector<Index> edges_in_order(const LengthMesh& mesh) {
    std::vector<Index> order = numbers_below(mesh.edges.rows());
    std::stable_sort(order.begin(), order.end(),
                     [&](Index e, Index f) { return edge(mesh.edges, e) < edge(mesh.edges, f); });
    return order;
}

std::optional<EdgeFault> edge_fault(const LengthMesh& mesh) {
    using Kind = EdgeFault::Kind;
    const auto needed = edges_of(mesh.simplices);
    const auto order = edges_in_order(mesh);
    auto next = needed.begin();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Edge here = edge(mesh.edges, order[i]);
        const auto [a, b] = here;
        if (i > 0 && here == edge(mesh.edges, order[i - 1]))
            return EdgeFault{Kind::repeated, a, b, order[i], order[i - 1]};
        if (next == needed.end() || here < *next)
            return EdgeFault{Kind::surplus, a, b, order[i], -1};
        if (*next < here)
            break;
        ++next;
    }
    if (next != needed.end())
        return EdgeFault{Kind::missing, next->first, next->second, -1, -1};
    return std::nullopt;
}

void check(const LengthMesh& mesh) {
    constexpr Eigen::Index ends = 2;
    if (mesh.edges.cols() != ends || mesh.edges.rows() != mesh.lengths.size())
        throw InvalidInput(fmt::format("{} lengths and a {} x {} table of the edges' vertices are "
                                       "given: expected a row of two vertices for each length",
                                       mesh.lengths.size(), mesh.edges.rows(), mesh.edges.cols()));
    if (mesh.simplices.rows() == 0 || mesh.dimension() < 1)
        throw InvalidInput(fmt::format("{} simplices of {} vertices are given: expected at least "
                                       "one simplex of two or more vertices",
                                       mesh.simplices.rows(), mesh.simplices.cols()));
    check_vertices("simplex", mesh.simplices, mesh.vertices);
    check_vertices("edge", mesh.edges, mesh.vertices);
    const auto fault = edge_fault(mesh);
    if (!fault)
        return;
    const auto name = fmt::format("with vertices {} and {}", fault->a, fault->b);
    switch (fault->kind) {
    case EdgeFault::Kind::repeated:
        throw InvalidInput(
            fmt::format("edges {} and {} are the same edge, {}: give its length once",
                        fault->previous, fault->row, name),
            {.degree = 1,
             .cells = {fault->previous, fault->row},
             .vertices = {fault->a, fault->b}});
    case EdgeFault::Kind::surplus:
        throw InvalidInput(
            fmt::format("edge {} {} belongs to no simplex: remove it", fault->row, name),
            {.degree = 1, .cells = {fault->row}, .vertices = {fault->a, fault->b}});
    case EdgeFault::Kind::missing:
        throw InvalidInput(fmt::format("the edge {} has no length: add it", name),
                           {.degree = 1, .vertices = {fault->a, fault->b}});
    }
}

} // namespace polydec
