// SPDX-License-Identifier: MIT
#include "distributed/slices.h"

#include "base/errors.h"
#include "distributed/graph_owners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
    if (rank == 0)
        slice.warnings = mesh.warnings;
    return slice;
}

/// Least and largest coordinates of all points.
struct Box {
    std::vector<double> least, largest;
};

Box bounding_box(const Ranks& ranks, const Points& points) {
    Box box;
    for (Eigen::Index c = 0; c < points.cols(); ++c) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        double least = infinity, largest = -infinity;
        for (const double x : points.col(c))
            if (std::isfinite(x)) {
                least = std::min(least, x);
                largest = std::max(largest, x);
            }
        box.least.push_back(ranks.least(least));
        box.largest.push_back(ranks.largest(largest));
    }
    return box;
}

/// The places of points along Morton's curve: the bits of all coordinates in turn.
std::vector<std::uint64_t> morton_keys(const Points& points, const Box& box) {
    constexpr int all_bits = 62;
    const auto N = static_cast<int>(points.cols());
    const int bits = N == 0 ? 0 : std::min(31, all_bits / N);
    std::vector<std::uint64_t> keys(points.rows(), 0);
    for (std::size_t v = 0; v < keys.size(); ++v)
        for (int c = 0; c < N; ++c) {
            const double extent = box.largest[c] - box.least[c];
            const double x = points(static_cast<Eigen::Index>(v), c) - box.least[c];
            const double part = extent > 0 && x > 0 ? std::min(1.0, x / extent) : 0;
            const auto place = static_cast<std::uint64_t>(std::ldexp(part, bits) * (1 - 1e-12));
            for (int bit = 0; bit < bits; ++bit)
                keys[v] |= (place >> bit & 1) << (bit * N + c);
        }
    return keys;
}

/// Where the stretches of ranks begin, from samples of the keys.
std::vector<std::uint64_t> splitters(const Ranks& ranks, std::vector<std::uint64_t> keys) {
    constexpr std::size_t most_samples = 256;
    std::sort(keys.begin(), keys.end());
    const std::size_t count = std::min(keys.size(), most_samples);
    std::vector<std::uint64_t> samples;
    for (std::size_t i = 0; i < count; ++i)
        samples.push_back(keys[(2 * i + 1) * keys.size() / (2 * count)]);
    samples = ranks.of_all(samples);
    std::sort(samples.begin(), samples.end());
    std::vector<std::uint64_t> result;
    for (int r = 1; r < ranks.size() && !samples.empty(); ++r)
        result.push_back(samples[r * samples.size() / ranks.size()]);
    return result;
}

std::uint64_t scrambled(std::uint64_t number) {
    number = (number + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
    return (number ^ number >> 31) * 0x94d049bb133111eb >> 17;
}

} // namespace

MeshSlice slice_of(const Ranks& ranks, const Mesh& mesh) {
    return slice_for(mesh, ranks.rank(), ranks.size());
}

MeshSlice scatter(const Ranks& ranks, const std::optional<Mesh>& mesh) {
    auto sizes = ranks.empty_parcels<std::array<GlobalIndex, 4>>();
    auto points = ranks.empty_parcels<double>();
    auto cells = ranks.empty_parcels<GlobalIndex>();
    ranks.together("scatter", [&] {
        if (ranks.rank() != 0)
            return;
        if (!mesh)
            throw InvalidInput("rank 0 has no mesh to scatter: give it one");
        for (int r = 0; r < ranks.size(); ++r) {
            const MeshSlice slice = slice_for(*mesh, r, ranks.size());
            sizes[r].push_back(
                {slice.vertices, slice.cells, slice.points.cols(), slice.simplices.cols()});
            points[r].assign(slice.points.data(), slice.points.data() + slice.points.size());
            cells[r].assign(slice.simplices.data(),
                            slice.simplices.data() + slice.simplices.size());
        }
    });
    const auto [vertices, all_cells, N, corners] = ranks.deliver(std::move(sizes))[0][0];
    const auto own_points = ranks.deliver(std::move(points))[0];
    const auto own_cells = ranks.deliver(std::move(cells))[0];
    MeshSlice slice{vertices, all_cells, {}, {}};
    const auto rows = [](const auto& entries, GlobalIndex width) {
        return static_cast<Eigen::Index>(entries.size()) / std::max<GlobalIndex>(width, 1);
    };
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

std::vector<int> vertex_owners(const Ranks& ranks, const MeshSlice& slice, Ownership by) {
    std::vector<int> owners(slice.points.rows(), ranks.rank());
    if (by == Ownership::graph)
        return owners_by_graph(ranks, slice);
    if (by == Ownership::morton) {
        const auto keys = morton_keys(slice.points, bounding_box(ranks, slice.points));
        const auto begins = splitters(ranks, keys);
        for (std::size_t v = 0; v < owners.size(); ++v)
            owners[v] = static_cast<int>(std::upper_bound(begins.begin(), begins.end(), keys[v]) -
                                         begins.begin());
    } else if (by == Ownership::random) {
        const GlobalIndex first = EqualStretches(slice.vertices, ranks.size()).begin(ranks.rank());
        for (std::size_t v = 0; v < owners.size(); ++v)
            owners[v] = static_cast<int>(scrambled(static_cast<std::uint64_t>(first) + v) %
                                         static_cast<std::uint64_t>(ranks.size()));
    }
    return owners;
}

} // namespace polydec
