// SPDX-License-Identifier: MIT
#include "meshes/tidy.h"

#include "base/errors.h"
#include "base/listed.h"
#include "base/lists.h"
#include "complex/faces.h"
#include "meshes/edges.h"
#include "meshes/flat_cells.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// A mesh that loses cells; numbers[i] is what its cell i was called in the input.
struct Sieve {
    Mesh mesh;
    std::vector<Index> numbers;
};

std::string vertices_of(const Mesh& mesh, Index cell) {
    const auto vertices = mesh.simplices.row(cell);
    return fmt::format("{}", fmt::join(vertices.begin(), vertices.end(), " "));
}

std::string place(const Mesh& mesh, Index vertex) {
    const auto point = mesh.points.row(vertex);
    return fmt::format("({})", fmt::join(point.begin(), point.end(), ", "));
}

/// What the cells have: "length", "area" or "volume".
std::string_view measure(const Mesh& mesh) {
    const int n = mesh.dimension();
    return n == 1 ? "length" : n == 2 ? "area" : "volume";
}

/// Takes cells out, given by ascending row numbers, and tells so in a warning.
void leave_out(Sieve& sieve, const std::vector<Index>& cells, std::string_view flaw) {
    if (cells.empty())
        return;
    Mesh& mesh = sieve.mesh;
    const auto name = [&](Index cell) {
        return fmt::format("{} ({})", sieve.numbers[cell], vertices_of(mesh, cell));
    };
    mesh.warnings.push_back(fmt::format(
        "left out {} {}: {}", counted(cells.size(), "cell", "cells"), flaw, listed(cells, name)));

    const auto rows = keep_rows(mesh, marks_at(cells, mesh.simplices.rows()));
    for (std::size_t to = 0; to < rows.size(); ++to)
        sieve.numbers[to] = sieve.numbers[rows[to]];
    sieve.numbers.resize(rows.size());
}

std::vector<Index> with_repeated_corner(const Simplices& cells) {
    std::vector<Index> result, corners;
    for (Index cell = 0; cell < cells.rows(); ++cell) {
        corners.assign(cells.row(cell).begin(), cells.row(cell).end());
        std::sort(corners.begin(), corners.end());
        if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
            result.push_back(cell);
    }
    return result;
}

/// All but the first of the cells on the same vertices.
std::vector<Index> duplicates(const Simplices& cells, Index vertices) {
    const SortedRows sorted = sorted_rows(cells, vertices);
    const Simplices& rows = *sorted.simplices.rows;
    std::vector<Index> result, same;
    for (Index begin = 0, end = 0; begin < rows.rows(); begin = end) {
        while (end < rows.rows() && rows.row(end) == rows.row(begin))
            ++end;
        same.assign(sorted.order.begin() + begin, sorted.order.begin() + end);
        std::sort(same.begin(), same.end());
        result.insert(result.end(), same.begin() + 1, same.end());
    }
    std::sort(result.begin(), result.end());
    return result;
}

struct MeasuredEdge {
    Index a, b; // vertices, a < b
    double length;
};

/// All edges of a cell by ascending length.
std::vector<MeasuredEdge> edges_of(const Mesh& mesh, Index cell) {
    std::vector<MeasuredEdge> result;
    const auto vertices = mesh.simplices.row(cell);
    for (Index i = 0; i < vertices.size(); ++i)
        for (Index j = i + 1; j < vertices.size(); ++j) {
            const Index a = vertices[i], b = vertices[j];
            const double half = (0.5 * mesh.points.row(a) - 0.5 * mesh.points.row(b)).stableNorm();
            result.push_back({std::min(a, b), std::max(a, b), half});
        }
    std::stable_sort(
        result.begin(), result.end(),
        [](const MeasuredEdge& e, const MeasuredEdge& f) { return e.length < f.length; });
    return result;
}

/// Why a cell is flat, and what to do about it.
std::string remedy(const Mesh& mesh, Index cell) {
    const std::vector<MeasuredEdge> edges = edges_of(mesh, cell);
    const MeasuredEdge &shortest = edges.front(), &longest = edges.back();
    if (shortest.length <= 1e-12 * longest.length)
        return fmt::format("Its vertices {} and {} are at the same point {}: join them, that is, "
                           "use one number for both.",
                           shortest.a, shortest.b, place(mesh, shortest.a));
    if (mesh.dimension() > 2)
        return fmt::format(
            "Its vertices lie in one {}: move one of them, or replace the cell and its neighbors.",
            mesh.dimension() == 3 ? "plane" : "hyperplane");

    const Index middle = mesh.simplices.row(cell).sum() - longest.a - longest.b;
    return fmt::format("Its vertex {} at {} lies on its edge from {} to {}: flip that edge, or "
                       "remove the cell and split the neighbor across that edge at the vertex.",
                       middle, place(mesh, middle), longest.a, longest.b);
}

/// What else there is for cells without volume.
const char* other_remedy(const Mesh& mesh) {
    if (mesh.dimension() == 2)
        return " Intrinsic flips can handle such cells (DiscretizeOptions::delaunay).";
    return mesh.ambient_dimension() == mesh.dimension()
               ? " Flat cells on the boundary can be peeled off (peeled(mesh))."
               : "";
}

/// Leaves out those that bind no neighbors together; the others are returned.
FlatCellsKept leave_out_flat_cells(Sieve& sieve) {
    const FlatCells flat = find_flat_cells(sieve.mesh);
    FlatCellsKept kept;
    for (const Index row : flat.stuck) {
        kept.rows.push_back(row - place_in(flat.removable, row));
        kept.numbers.push_back(sieve.numbers[row]);
    }
    leave_out(sieve, flat.removable, fmt::format("without {}", measure(sieve.mesh)));
    return kept;
}

FlatCellsKept sift(Sieve& sieve) {
    check_mesh(sieve.mesh);
    sieve.numbers = numbers_below(sieve.mesh.simplices.rows());
    const auto vertices = static_cast<Index>(sieve.mesh.points.rows());
    if (const Simplices& cells = sieve.mesh.simplices;
        !sorted_rows(cells, vertices).are_simplices) {
        leave_out(sieve, with_repeated_corner(cells), "with a repeated corner");
        leave_out(sieve, duplicates(cells, vertices), "with the same vertices as an earlier cell");
    }
    return leave_out_flat_cells(sieve);
}

} // namespace

void check_mesh(const Mesh& mesh) {
    const int n = mesh.dimension(), N = mesh.ambient_dimension();
    if (n > N)
        throw InvalidInput(fmt::format("cells of dimension {} need points with at least {} "
                                       "coordinates, these have {}",
                                       n, n, N));
    const auto cells = static_cast<std::size_t>(mesh.simplices.rows());
    if (!mesh.tags.empty() && mesh.tags.size() != cells)
        throw InvalidInput(
            fmt::format("{} tags are given for {} cells; expected one for each cell, or none",
                        mesh.tags.size(), cells));
    check_facet_tags(mesh);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (const double* const point = mesh.points.data() + Eigen::Index{v} * N;
            !std::all_of(point, point + N, [](double x) { return std::isfinite(x); }))
            throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite: {}\n"
                                           "Give it finite coordinates.",
                                           v, place(mesh, v)),
                               {.vertices = {v}});
    check_vertices("cell", mesh.simplices, mesh.points.rows());
}

std::string isolated_vertices(const std::vector<std::int64_t>& first, std::size_t count) {
    return fmt::format("{} to no cell, left out of all counts: {}",
                       counted(count, "vertex belongs", "vertices belong"),
                       listed(numbers_below(first.size()), count,
                              [&](Index i) { return fmt::format("{}", first[i]); }));
}

void warn_of_isolated_vertices(Mesh& mesh) {
    const auto used = marks_at(mesh.simplices.reshaped(), mesh.points.rows());
    std::vector<std::int64_t> isolated;
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (!used[v])
            isolated.push_back(v);
    if (isolated.empty())
        return;
    auto warning = isolated_vertices(isolated, isolated.size());
    auto& warnings = mesh.warnings; // which tell so already if the mesh was tidied before
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
        warnings.push_back(std::move(warning));
}

void refuse(const Mesh& mesh, const FlatCellsKept& cells) {
    const Index first = cells.rows.front();
    const auto& numbers = cells.numbers;
    std::vector<Index> places = numbers_below(numbers.size());
    std::string others;
    if (numbers.size() > 1)
        others = fmt::format("\n{} more like it: {}.", numbers.size() - 1,
                             listed({places.begin() + 1, places.end()}, [&](Index i) {
                                 return fmt::format("{} ({})", numbers[i],
                                                    vertices_of(mesh, cells.rows[i]));
                             }));
    const auto corners = mesh.simplices.row(first);
    throw InvalidInput(
        fmt::format(
            "cell {} (vertices {}) has no {}, and its neighbors would come apart without it.\n"
            "{}{}{}",
            numbers.front(), vertices_of(mesh, first), measure(mesh), remedy(mesh, first),
            other_remedy(mesh), others),
        {.degree = mesh.dimension(),
         .cells = numbers,
         .vertices = {corners.begin(), corners.end()}});
}

Mesh tidy(Mesh mesh, CellsWithoutVolume flat) {
    FlatCellsKept kept;
    mesh = tidy(std::move(mesh), kept);
    if (!kept.rows.empty() && flat == CellsWithoutVolume::leave_out)
        refuse(mesh, kept);
    return mesh;
}

Mesh tidy(Mesh mesh, FlatCellsKept& kept) {
    if (mesh.simplices.size() == 0)
        throw InvalidInput("no cells of positive volume are left");
    const auto warnings_before = static_cast<std::ptrdiff_t>(mesh.warnings.size());
    Sieve sieve{std::move(mesh), {}};
    kept = sift(sieve);
    if (sieve.mesh.simplices.rows() == 0) {
        const auto& warnings = sieve.mesh.warnings;
        throw InvalidInput(
            fmt::format("no cells of positive volume are left{}{}",
                        warnings_before < static_cast<std::ptrdiff_t>(warnings.size()) ? "\n" : "",
                        fmt::join(warnings.begin() + warnings_before, warnings.end(), "; ")));
    }
    warn_of_isolated_vertices(sieve.mesh);
    return std::move(sieve.mesh);
}

SimplicialComplex tidied_complex(Mesh& mesh, FlatCellsKept& kept) {
    if (mesh.simplices.size() > 0)
        check_mesh(mesh);
    if (flat_cells(mesh).empty())
        try {
            const SimplicialComplex complex(mesh.simplices);
            if (complex.size(0) < mesh.points.rows())
                warn_of_isolated_vertices(mesh);
            return complex;
        } catch (const InvalidInput&) { // for cells that tidy leaves out, or refuses with advice
        }
    mesh = tidy(std::move(mesh), kept);
    return SimplicialComplex(mesh.simplices);
}

} // namespace polydec
