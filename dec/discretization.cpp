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

/// Tags of the merged n-cells; one that joins simplices with different tags has none.
std::vector<Index> merged_tags(const Merging& merging, const Mesh& mesh,
                               std::vector<std::string>& warnings) {
    if (mesh.tags.empty())
        return {};
    const int n = merging.merged().dimension();
    std::vector<Index> result(static_cast<std::size_t>(merging.merged().size(n)), 0);
    std::vector<char> state(result.size(), 'n'); // new, tagged, or of different tags
    for (Index t = 0; t < merging.input().size(n); ++t) {
        const Index cell = merging.carriers(n)[t].cell;
        const Index tag = mesh.tags[merging.input().input_row(t)];
        if (state[cell] == 'n')
            state[cell] = 't', result[cell] = tag;
        else if (result[cell] != tag)
            state[cell] = 'd', result[cell] = 0;
    }
    const auto different = std::count(state.begin(), state.end(), 'd');
    if (different > 0)
        warnings.push_back(
            fmt::format("{} merged cell{} simplices of different groups; {} tag is 0", different,
                        different == 1 ? " joins" : "s join", different == 1 ? "its" : "their"));
    return result;
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
    auto tags = merged_tags(merged.merging, mesh, mesh.warnings);
    return {std::move(mesh.points),
            std::move(merged.merging),
            std::move(input_volumes),
            std::move(volumes),
            options,
            merged.degenerate,
            std::move(mesh.warnings),
            std::move(tags)};
}

} // namespace polydec
