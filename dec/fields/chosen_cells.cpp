// SPDX-License-Identifier: MIT
#include "dec/fields/chosen_cells.h"

#include "base/errors.h"
#include "base/lists.h"
#include "complex/components.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace polydec {

namespace {

/// The groups that a tag represents.
std::vector<Index> groups_of(const Discretization& mesh, Index tag) {
    for (const JointTag& joint : mesh.tagged_facets().joint)
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
    if (list.empty())
        return mesh.tagged_facets().groups.empty() ? "the mesh has no facets in groups"
                                                   : "no merged facet is in a group";
    return fmt::format("there are {}", fmt::join(list, ", "));
}

/// Why no facet is in a group, and what helps.
std::string reason_for_none(const Discretization& mesh, Index tag) {
    const auto& before = mesh.tagged_facets().groups;
    if (!std::binary_search(before.begin(), before.end(), tag))
        return groups_with_facets(mesh);
    if (!mesh.passage().is_identity())
        return "its facets lost their groups when edges were flipped; omit "
               "DiscretizeOptions::delaunay";
    return "merging joined each of its facets to facets of other groups, or lost it inside a cell; "
           "use Materials::keep_apart, or MergeCriterion::none";
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
                                           reason_for_none(mesh, tags[i])));
    }
    return marks;
}

BoundaryConditions essential_on(const Discretization& mesh,
                                const std::vector<std::string>& groups) {
    const auto conditions = [&](const std::vector<std::string>& some) {
        return BoundaryConditions(BoundaryCondition::natural).essential(facets_in(mesh, some));
    };
    for (const auto& group : groups) // each of them separately
        require_use(boundary_counts(mesh.complex(), conditions({group})),
                    {.values = fmt::format("the group {} ({})", group, groups_with_facets(mesh))});
    return conditions(groups);
}

std::vector<Index> boundary_vertices(const Discretization& mesh) {
    auto numbers = marked(boundary_cells(mesh.complex())[0]);
    if (numbers.empty())
        throw InvalidInput(
            "the mesh has no boundary, and so no boundary vertices: choose other vertices");
    return numbers;
}

std::vector<Index> vertices_on(const Discretization& mesh, const std::vector<std::string>& groups) {
    const int n = mesh.dimension();
    CellMarks marks = no_marks(mesh.complex());
    for (const auto& group : groups) {
        const auto tag = group_tag(mesh.groups(), n, group);
        bool any = false;
        for (std::size_t t = 0; t < mesh.tags().size(); ++t)
            if (tag && mesh.tags()[t] == *tag)
                marks[n][t] = any = true;
        if (!any)
            for (const Index f : marked(facets_in(mesh, {group})))
                marks[n - 1][f] = true;
    }
    mark_faces(mesh.complex(), marks);
    return marked(marks[0]);
}

} // namespace polydec
