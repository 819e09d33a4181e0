// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "distributed/local_complex.h"
#include "distributed/number_places.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

void check_slice(const Ranks& ranks, const MeshSlice& slice) {
    const GlobalIndex first_vertex =
        EqualStretches(slice.vertices, ranks.size()).begin(ranks.rank());
    const GlobalIndex first_cell = EqualStretches(slice.cells, ranks.size()).begin(ranks.rank());
    if (slice.cells == 0 || slice.dimension() < 1)
        throw InvalidInput(
            "a simplicial complex needs at least one simplex of dimension 1 or more");
    if (slice.dimension() > slice.ambient_dimension())
        throw InvalidInput(fmt::format("simplices of dimension {} do not fit into {} coordinates",
                                       slice.dimension(), slice.ambient_dimension()));
    for (Eigen::Index v = 0; v < slice.points.rows(); ++v)
        if (!slice.points.row(v).allFinite())
            throw InvalidInput(
                fmt::format("vertex {} has a coordinate that is not finite", first_vertex + v));
    for (Eigen::Index t = 0; t < slice.simplices.rows(); ++t)
        for (const GlobalIndex v : slice.simplices.row(t))
            if (v < 0 || v >= slice.vertices)
                throw InvalidInput(fmt::format("cell {} has vertex {}: {}", first_cell + t, v,
                                               expected_numbers(0, slice.vertices - 1)));
}

NumberPlaces vertices_of(const GlobalSimplices& cells) {
    return NumberPlaces({cells.data(), static_cast<std::size_t>(cells.size())});
}

/// The owners of vertices, which the ranks of their slices know.
std::vector<int> owners_of(const Ranks& ranks, const MeshSlice& slice,
                           const std::vector<int>& owners,
                           const std::vector<GlobalIndex>& vertices) {
    const EqualStretches stretches(slice.vertices, ranks.size());
    const GlobalIndex first = stretches.begin(ranks.rank());
    return ranks.ask<int>("owners", stretches.ranks_of(vertices), vertices,
                          [&](GlobalIndex v) { return owners[v - first]; });
}

} // namespace

Stars own_stars(const Ranks& ranks, const MeshSlice& slice, const std::vector<int>& owners) {
    ranks.together("slice", [&] { check_slice(ranks, slice); });
    const NumberPlaces here =
        ranks.together("vertices", [&] { return vertices_of(slice.simplices); });
    const std::vector<int> owners_here = owners_of(ranks, slice, owners, here.numbers());

    // each cell to every rank that owns one of its vertices: its number, then the vertices
    const GlobalIndex first = EqualStretches(slice.cells, ranks.size()).begin(ranks.rank());
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    ranks.together("cells", [&] {
        std::vector<int> takers;
        for (Eigen::Index t = 0; t < slice.simplices.rows(); ++t) {
            const auto cell = slice.simplices.row(t);
            takers.clear();
            for (const GlobalIndex v : cell)
                if (const int r = owners_here[here(v)];
                    std::find(takers.begin(), takers.end(), r) == takers.end())
                    takers.push_back(r);
            for (const int r : takers) {
                parcels[r].push_back(first + t);
                parcels[r].insert(parcels[r].end(), cell.begin(), cell.end());
            }
        }
    });
    const auto arrived = ranks.deliver(std::move(parcels));
    Stars stars;
    ranks.together("stars", [&] {
        const auto corners = slice.simplices.cols();
        std::size_t entries = 0;
        for (const auto& parcel : arrived)
            entries += parcel.size();
        stars.cells.resize(static_cast<Eigen::Index>(entries) / (corners + 1), corners);
        stars.file_places.reserve(stars.cells.rows());
        GlobalIndex* vertex = stars.cells.data();
        for (const auto& parcel : arrived)
            for (auto entry = parcel.begin(); entry != parcel.end(); entry += corners + 1) {
                stars.file_places.push_back(*entry);
                vertex = std::copy(entry + 1, entry + 1 + corners, vertex);
            }
        stars.vertices = vertices_of(stars.cells).numbers();
    });
    stars.owners = owners_of(ranks, slice, owners, stars.vertices);
    stars.points = points_of(ranks, slice, stars.vertices);
    return stars;
}

LocalComplex local_complex(const Ranks& ranks, const MeshSlice& slice,
                           const std::vector<int>& owners) {
    return local_complex(ranks, own_stars(ranks, slice, owners), slice.vertices);
}

} // namespace polydec
