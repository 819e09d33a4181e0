// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "distributed/petsc_calls.h"
#include "distributed/slices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace polydec {

namespace {

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

/// A vertex and one beside it.
struct Neighbors {
    GlobalIndex vertex, other;
    auto operator<=>(const Neighbors&) const = default;
};

/// Rows of the graph of vertices and edges, as PETSc frees them.
struct Rows {
    PetscInt* begins;
    PetscInt* columns;
};

std::vector<Neighbors> neighbors_of(const Ranks& ranks, const MeshSlice& slice) {
    const EqualStretches stretches(slice.vertices, ranks.size());
    auto parcels = ranks.empty_parcels<Neighbors>();
    ranks.together("graph", [&] {
        for (Eigen::Index t = 0; t < slice.simplices.rows(); ++t)
            for (const GlobalIndex v : slice.simplices.row(t)) {
                if (v < 0 || v >= slice.vertices)
                    throw InvalidInput(fmt::format("a cell has vertex {}: {}", v,
                                                   expected_numbers(0, slice.vertices - 1)));
                for (const GlobalIndex w : slice.simplices.row(t))
                    if (w != v)
                        parcels[stretches.rank_of(v)].push_back({v, w});
            }
        for (auto& parcel : parcels)
            sort_unique(parcel);
    });
    auto list = unpacked(ranks.deliver(std::move(parcels)));
    sort_unique(list);
    return list;
}

Rows rows_of(const std::vector<Neighbors>& list, GlobalIndex first, std::size_t vertices) {
    Rows rows{};
    require(PetscMalloc1(vertices + 1, &rows.begins), "making a graph");
    require(PetscMalloc1(list.size(), &rows.columns), "making a graph");
    std::size_t next = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        rows.begins[v] = static_cast<PetscInt>(next);
        for (; next < list.size() && list[next].vertex == first + static_cast<GlobalIndex>(v);
             ++next)
            rows.columns[next] = static_cast<PetscInt>(list[next].other);
    }
    rows.begins[vertices] = static_cast<PetscInt>(next);
    return rows;
}

/// The threads of PTScotch 7.0 race: ranks come to see different graphs and wait for each other for
/// ever. With one thread on each rank they do not. Whoever has set this variable is obeyed.
void leave_threads_out_of_ptscotch() {
    setenv("SCOTCH_PTHREAD_NUMBER", "1", 0);
}

std::vector<int> owners_by_graph(const Ranks& ranks, const MeshSlice& slice) {
#ifdef PETSC_HAVE_PTSCOTCH
    const auto count = static_cast<std::size_t>(slice.points.rows());
    if (ranks.size() == 1)
        return std::vector<int>(count, 0);
    ranks.together("graph", [&] { petsc_number(slice.vertices); });
    const auto list = neighbors_of(ranks, slice);
    const GlobalIndex first = EqualStretches(slice.vertices, ranks.size()).begin(ranks.rank());
    const Rows rows = rows_of(list, first, count);
    const OwnedMat graph = made("making a graph", [&](Mat* matrix) {
        return MatCreateMPIAdj(communicator(ranks), static_cast<PetscInt>(count),
                               static_cast<PetscInt>(slice.vertices), rows.begins, rows.columns,
                               nullptr, matrix);
    });
    MatPartitioning partitioning = nullptr;
    IS owners = nullptr;
    const PetscInt* found = nullptr;
    leave_threads_out_of_ptscotch();
    require(MatPartitioningCreate(communicator(ranks), &partitioning), "dividing a graph");
    require(MatPartitioningSetAdjacency(partitioning, graph.get()), "dividing a graph");
    require(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH), "dividing a graph");
    require(MatPartitioningApply(partitioning, &owners), "dividing a graph");
    require(ISGetIndices(owners, &found), "dividing a graph");
    std::vector<int> result(found, found + count);
    require(ISRestoreIndices(owners, &found), "dividing a graph");
    ISDestroy(&owners);
    MatPartitioningDestroy(&partitioning);
    return result;
#else
    throw BackendUnavailable("this PETSc does not contain PTScotch: use another distribution of "
                             "vertices, such as morton");
#endif
}

} // namespace

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
