// SPDX-License-Identifier: MIT
#include "distributed/graph_owners.h"

#include "base/errors.h"
#include "base/lists.h"
#include "distributed/petsc_calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace polydec {

namespace {

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
                    throw InvalidInput(fmt::format("a cell has vertex {}: expected a number from "
                                                   "0 to {}",
                                                   v, slice.vertices - 1));
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

} // namespace

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

} // namespace polydec
