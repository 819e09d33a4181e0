// SPDX-License-Identifier: MIT
#include "dec/discretization.h"

#include "meshes/tidy.h"

#include <fmt/format.h>

#include <utility>

namespace polydec {

namespace {

void warn_of_orientation(const SimplicialComplex& complex, std::vector<std::string>& warnings) {
    if (complex.turned() > 0)
        warnings.push_back(fmt::format("{} of {} cells were turned to be oriented like their "
                                       "neighbors",
                                       complex.turned(), complex.size(complex.dimension())));
    if (!complex.orientable())
        warnings.emplace_back("the mesh is non-orientable: its cells keep the orientation of the "
                              "input, and operators on dual 0-forms see jumps of sign");
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
    begin("volumes");
    auto input_volumes = circumcentric_volumes(complex, mesh.points);
    begin("merge");
    auto merged = merge_cospherical(std::move(complex), mesh.points, input_volumes, options);
    auto volumes = merged_volumes(merged.merging, input_volumes);
    return {std::move(mesh.points), std::move(merged.merging), std::move(input_volumes),
            std::move(volumes), options, merged.degenerate, std::move(mesh.warnings)};
}

} // namespace polydec
