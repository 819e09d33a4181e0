// SPDX-License-Identifier: MIT
#include "dec/discretization.h"

#include "meshes/tidy.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

void warn_of_orientation(const SimplicialComplex& complex, std::vector<std::string>& warnings) {
    if (complex.turned() > 0)
        warnings.push_back(fmt::format("{} of {} cells {} turned to be oriented like {} neighbors",
                                       complex.turned(), complex.size(complex.dimension()),
                                       complex.turned() == 1 ? "was" : "were",
                                       complex.turned() == 1 ? "its" : "their"));
    if (!complex.orientable())
        warnings.emplace_back("the mesh is non-orientable: its cells keep the orientation of the "
                              "input, and operators on dual 0-forms see jumps of sign");
}

void warn_of_branching(const SimplicialComplex& complex, std::vector<std::string>& warnings) {
    const auto& counts = complex.coface_counts(complex.dimension() - 1);
    const auto branching =
        std::count_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
    if (branching > 0)
        warnings.push_back(fmt::format("not a manifold: {} facet{} with three or more cells",
                                       branching, branching == 1 ? "" : "s"));
}

} // namespace

Discretization discretize(Mesh mesh, const MergeOptions& options,
                          const std::function<void(std::string_view)>& stage) {
    const auto begin = [&](std::string_view what) {
        if (stage)
            stage(what);
    };
    begin("complex");
    mesh = tidy(std::move(mesh));
    SimplicialComplex complex(mesh.simplices);
    warn_of_orientation(complex, mesh.warnings);
    warn_of_branching(complex, mesh.warnings);
    begin("volumes");
    auto input_volumes = circumcentric_volumes(complex, mesh.points);
    begin("merge");
    auto merged = merge_cospherical(std::move(complex), mesh.points, input_volumes, options);
    auto volumes = merged_volumes(merged.merging, input_volumes);
    return {std::move(mesh.points),
            std::move(merged.merging),
            std::move(input_volumes),
            std::move(volumes),
            options,
            merged.degenerate,
            std::move(mesh.warnings)};
}

} // namespace polydec
