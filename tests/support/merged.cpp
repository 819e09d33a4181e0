// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test {

Merged make_merged(const Mesh& mesh, const MergeOptions& options) {
    const SimplicialComplex complex(mesh.simplices);
    const Points points = vertex_points(complex, mesh.points);
    const auto volumes = dual_volumes(complex, points, {}, FlatSimplices::passed_over);
    auto result = merge_cospherical({complex, points, volumes}, options);
    auto merged = merged_volumes(result.merging, volumes);
    return {points, complex, volumes, std::move(result), std::move(merged)};
}

const Merged& merged(const std::string& name) {
    static std::map<std::string, std::unique_ptr<Merged>> made;
    auto& entry = made[name];
    if (!entry)
        entry = std::make_unique<Merged>(make_merged(mesh_named(name)));
    return *entry;
}

std::vector<Metric> both(const Merged& merged) {
    return {{"simplices", merged.K(), merged.input_volumes},
            {"merged", merged.P(), merged.volumes}};
}

} // namespace polydec::test
