// SPDX-License-Identifier: MIT
#include "distributed/tidy_slice.h"

#include "base/errors.h"
#include "base/listed.h"
#include "distributed/number_places.h"
#include "meshes/flat_cells.h"
#include "meshes/tidy.h"

#include <algorithm>
#include <vector>

namespace polydec {

namespace {

using Corners = std::vector<GlobalIndex>;

Corners sorted_corners(const GlobalSimplices& cells, Eigen::Index cell) {
    Corners corners(cells.row(cell).begin(), cells.row(cell).end());
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Cells meet on the rank in whose slice their first vertex is.
void check_double_cells(const Ranks& ranks, const MeshSlice& slice) {
    const EqualStretches vertices(slice.vertices, ranks.size());
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    ranks.together("double cells", [&] {
        for (Eigen::Index t = 0; t < slice.simplices.rows(); ++t) {
            const Corners corners = sorted_corners(slice.simplices, t);
            if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
                throw InvalidInput("some cells have a repeated corner");
            auto& parcel = parcels[vertices.rank_of(corners[0])];
            parcel.insert(parcel.end(), corners.begin(), corners.end());
        }
    });
    const auto arrived = ranks.deliver(std::move(parcels));
    ranks.together("double cells", [&] {
        const auto width = slice.simplices.cols();
        std::vector<const GlobalIndex*> cells;
        for (const auto& parcel : arrived)
            for (std::size_t at = 0; at < parcel.size(); at += static_cast<std::size_t>(width))
                cells.push_back(parcel.data() + at);
        std::sort(cells.begin(), cells.end(), [=](const GlobalIndex* a, const GlobalIndex* b) {
            return std::lexicographical_compare(a, a + width, b, b + width);
        });
        const auto is_same = [=](const GlobalIndex* a, const GlobalIndex* b) {
            return std::equal(a, a + width, b);
        };
        if (std::adjacent_find(cells.begin(), cells.end(), is_same) != cells.end())
            throw InvalidInput("some cells have the same vertices");
    });
}

/// Whether a cell is flat depends on its own vertices alone.
void check_flat_cells(const Ranks& ranks, const MeshSlice& slice, const NumberPlaces& here) {
    Mesh own;
    own.points = points_of(ranks, slice, here.numbers());
    ranks.together("flat cells", [&] {
        own.simplices = slice.simplices.unaryExpr([&](GlobalIndex vertex) { return here(vertex); });
        const FlatCells flat = find_flat_cells(own);
        if (!flat.removable.empty() || !flat.stuck.empty())
            throw InvalidInput("some cells have no volume");
    });
}

/// Of the vertices of slices those that belong to no cell: how many, and the first ones.
void warn_of_isolated(const Ranks& ranks, MeshSlice& slice, const NumberPlaces& here) {
    const EqualStretches vertices(slice.vertices, ranks.size());
    const GlobalIndex first = vertices.begin(ranks.rank());
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    ranks.together("vertices", [&] {
        for (const GlobalIndex vertex : here.numbers())
            parcels[vertices.rank_of(vertex)].push_back(vertex);
    });
    const auto arrived = ranks.deliver(std::move(parcels));
    std::vector<Index> isolated;
    const GlobalIndex here_isolated = ranks.together("vertices", [&] {
        std::vector<bool> used(slice.points.rows(), false);
        for (const auto& parcel : arrived)
            for (const GlobalIndex vertex : parcel)
                used[vertex - first] = true;
        for (std::size_t v = 0; v < used.size() && isolated.size() < most_listed; ++v)
            if (!used[v])
                isolated.push_back(static_cast<Index>(first + static_cast<GlobalIndex>(v)));
        return GlobalIndex{std::count(used.begin(), used.end(), false)};
    });
    const GlobalIndex count = ranks.sum(here_isolated);
    isolated = ranks.of_all(isolated);
    if (count > 0 && ranks.rank() == 0)
        slice.warnings.push_back(isolated_vertices(isolated, static_cast<std::size_t>(count)));
}

} // namespace

void check_tidy(const Ranks& ranks, MeshSlice& slice) {
    check_double_cells(ranks, slice);
    const NumberPlaces here = ranks.together("vertices", [&] {
        return NumberPlaces(
            {slice.simplices.data(), static_cast<std::size_t>(slice.simplices.size())});
    });
    check_flat_cells(ranks, slice, here);
    warn_of_isolated(ranks, slice, here);
}

} // namespace polydec
