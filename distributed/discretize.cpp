// SPDX-License-Identifier: MIT
#include "distributed/discretize.h"

#include "dec/mesh_warnings.h"
#include "dec/metric/circumcentric_volumes.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

namespace polydec {

namespace {

double common_unit(const Ranks& ranks, const LocalComplex& local, const Points& of_slice) {
    const int n = local.dimension();
    const double longest =
        ranks.largest(half_of_longest_edge(local.points, local.complex.simplices(n)));
    const double farthest =
        ranks.largest(of_slice.size() > 0 ? of_slice.cwiseAbs().maxCoeff() : 0.0);
    return unit_of_length(longest, farthest, n);
}

GlobalIndex branching_facets(const Ranks& ranks, const LocalComplex& local) {
    const int facets = local.dimension() - 1;
    GlobalIndex count = 0;
    for (Index f = 0; f < local.degree(facets).size(); ++f)
        if (local.owns(ranks, facets, f) && local.complex.coface_counts(facets)[f] > 2)
            ++count;
    return ranks.sum(count);
}

std::vector<std::string> warnings_of(const Ranks& ranks, const MeshSlice& slice,
                                     const LocalComplex& local, double unit) {
    std::vector<std::string> list = slice.warnings;
    const GlobalIndex unused = slice.vertices - local.degree(0).count;
    if (list.empty() && unused > 0) // else the reader has told which
        list.push_back(fmt::format("{} to no cell, left out of all counts",
                                   unused == 1 ? "1 vertex belongs"
                                               : fmt::format("{} vertices belong", unused)));
    warn_of_unit(unit, list);
    warn_of_orientation(local.turned, local.degrees.back().count, local.orientable, list);
    warn_of_branching(branching_facets(ranks, local), list);
    return list;
}

} // namespace

DistributedMesh discretize(const Ranks& ranks, MeshSlice slice, const std::vector<int>& owners,
                           const MergeOptions& options,
                           const std::function<void(std::string_view)>& stage) {
    const auto begin = [&](std::string_view what) {
        if (stage)
            stage(what);
    };
    begin("complex");
    DistributedMesh mesh{local_complex(ranks, slice, owners), {}, {}, options};
    LocalComplex& local = mesh.local;
    mesh.unit = common_unit(ranks, local, slice.points);
    if (mesh.unit != 1)
        local.points = in_units(std::move(local.points), mesh.unit);
    mesh.warnings = warnings_of(ranks, slice, local, mesh.unit);
    slice = {};
    begin("volumes");
    const CellVolumes volumes = ranks.together(
        "volumes", [&] { return circumcentric_volumes(local.complex, local.points); });
    begin("merge");
    mesh.merged = merge_cospherical(ranks, local, volumes, options);
    begin("cells");
    mesh.cells = distributed_cells(ranks, local, mesh.merged);
    return mesh;
}

} // namespace polydec
