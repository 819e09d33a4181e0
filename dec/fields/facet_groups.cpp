// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/fields/chosen_cells.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace polydec {

namespace {

/// The groups that a tag represents.
std::vector<Index> groups_of(const Discretization& mesh, Index tag) {
    for (const JointTag& joint : mesh.joint_tags())
        if (joint.tag == tag)
            return joint.groups;
    return {tag};
}

/// "wall (12 facets), 7 (3 facets)": the groups with facets.
std::string groups_with_facets(const Discretization& mesh) {
    std::map<Index, Index> counts;
    for (const Index tag : mesh.facet_tags())
        for (const Index group : groups_of(mesh, tag))
            if (group != 0)
                ++counts[group];
    std::vector<std::string> list;
    for (const auto& [tag, count] : counts) {
        const auto named = std::find_if(
            mesh.groups().begin(), mesh.groups().end(), [&, t = tag](const GroupName& group) {
                return group.tag == t &&
                       (group.dimension == mesh.dimension() - 1 || group.dimension == -1);
            });
        list.push_back(fmt::format("{} ({} facets)",
                                   named == mesh.groups().end() ? fmt::to_string(tag) : named->name,
                                   count));
    }
    return list.empty() ? "the mesh has no facets in groups"
                        : fmt::format("there are {}", fmt::join(list, ", "));
}

} // namespace

std::vector<bool> facets_in(const Discretization& mesh, const std::vector<std::string>& groups) {
    std::vector<bool> marks(mesh.complex().size(mesh.dimension() - 1), false);
    const auto tags = group_tags(mesh.groups(), mesh.dimension() - 1, groups);
    for (std::size_t i = 0; i < tags.size(); ++i) {
        bool any = false;
        for (std::size_t f = 0; f < mesh.facet_tags().size(); ++f) {
            const auto all = groups_of(mesh, mesh.facet_tags()[f]);
            if (std::find(all.begin(), all.end(), tags[i]) != all.end())
                marks[f] = any = true;
        }
        if (!any)
            throw InvalidInput(fmt::format("no facet is in the group {}: {}", groups[i],
                                           groups_with_facets(mesh)));
    }
    return marks;
}

BoundaryConditions essential_on(const Discretization& mesh,
                                const std::vector<std::string>& groups) {
    const auto conditions = [&](const std::vector<std::string>& some) {
        return BoundaryConditions(BoundaryCondition::natural).essential(facets_in(mesh, some));
    };
    for (const auto& group : groups) // each of them separately
        require_essential(mesh.complex(), conditions({group}),
                          fmt::format("the group {} ({})", group, groups_with_facets(mesh)));
    return conditions(groups);
}

} // namespace polydec
