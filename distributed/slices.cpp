// SPDX-License-Identifier: MIT
#include "distributed/slices.h"

#include "base/errors.h"

#include <algorithm>
#include <array>

namespace polydec {

namespace {

MeshSlice slice_for(const Mesh& mesh, int rank, int ranks) {
    MeshSlice slice{mesh.points.rows(), mesh.simplices.rows(), {}, {}};
    const EqualStretches vertices(slice.vertices, ranks), cells(slice.cells, ranks);
    const auto rows = [rank](const EqualStretches& stretches) {
        return Eigen::seqN(stretches.begin(rank), stretches.end(rank) - stretches.begin(rank));
    };
    slice.points = mesh.points(rows(vertices), Eigen::indexing::all);
    slice.simplices = mesh.simplices(rows(cells), Eigen::indexing::all).cast<GlobalIndex>();
    slice.has_tags = !mesh.tags.empty();
    if (slice.has_tags)
        slice.tags.assign(mesh.tags.begin() + cells.begin(rank),
                          mesh.tags.begin() + cells.end(rank));
    if (rank == 0)
        slice.warnings = mesh.warnings;
    return slice;
}

} // namespace

MeshSlice slice_of(const Ranks& ranks, const Mesh& mesh) {
    return slice_for(mesh, ranks.rank(), ranks.size());
}

MeshSlice scatter(const Ranks& ranks, const std::optional<Mesh>& mesh) {
    auto sizes = ranks.empty_parcels<std::array<GlobalIndex, 5>>();
    auto points = ranks.empty_parcels<double>();
    auto cells = ranks.empty_parcels<GlobalIndex>();
    auto tags = ranks.empty_parcels<Index>();
    ranks.together("scatter", [&] {
        if (ranks.rank() != 0)
            return;
        if (!mesh)
            throw InvalidInput("rank 0 has no mesh to scatter: give it one");
        for (int r = 0; r < ranks.size(); ++r) {
            MeshSlice slice = slice_for(*mesh, r, ranks.size());
            sizes[r].push_back({slice.vertices, slice.cells, slice.points.cols(),
                                slice.simplices.cols(), slice.has_tags});
            tags[r] = std::move(slice.tags);
            points[r].assign(slice.points.data(), slice.points.data() + slice.points.size());
            cells[r].assign(slice.simplices.data(),
                            slice.simplices.data() + slice.simplices.size());
        }
    });
    const auto [vertices, all_cells, N, corners, has_tags] = ranks.deliver(std::move(sizes))[0][0];
    const auto own_points = ranks.deliver(std::move(points))[0];
    const auto own_cells = ranks.deliver(std::move(cells))[0];
    MeshSlice slice{vertices, all_cells, {}, {}};
    const auto rows = [](const auto& entries, GlobalIndex width) {
        return static_cast<Eigen::Index>(entries.size()) / std::max<GlobalIndex>(width, 1);
    };
    slice.has_tags = has_tags != 0;
    slice.tags = ranks.deliver(std::move(tags))[0];
    slice.points = Eigen::Map<const Points>(own_points.data(), rows(own_points, N), N);
    slice.simplices =
        Eigen::Map<const GlobalSimplices>(own_cells.data(), rows(own_cells, corners), corners);
    if (ranks.rank() == 0)
        slice.warnings = mesh->warnings;
    return slice;
}

Points points_of(const Ranks& ranks, const MeshSlice& slice,
                 const std::vector<GlobalIndex>& vertices) {
    const EqualStretches stretches(slice.vertices, ranks.size());
    const GlobalIndex first = stretches.begin(ranks.rank());
    const auto N = slice.points.cols();
    const auto rows = ranks.ask_rows<double>(
        "points", N, stretches.ranks_of(vertices), vertices, [&](GlobalIndex v, double* row) {
            std::copy_n(slice.points.data() + (v - first) * N, N, row);
        });
    return Eigen::Map<const Points>(rows.data(), std::ssize(vertices), N);
}

} // namespace polydec
