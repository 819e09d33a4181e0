// SPDX-License-Identifier: MIT
#include "dec/merging/merged_tags.h"

#include "base/checks.h"
#include "base/listed.h"
#include "base/lists.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace polydec {

namespace {

std::string list_facets(const TaggedSimplices& facets, const std::vector<Index>& rows) {
    return listed(rows, [&](Index row) {
        const auto vertices = facets.simplices.row(row);
        return fmt::format("({})", fmt::join(vertices.begin(), vertices.end(), " "));
    });
}

} // namespace

std::vector<Index> tags_of_cells(const SimplicialComplex& complex, const std::vector<Index>& tags) {
    if (tags.empty())
        return {};
    const Index size = complex.size(complex.dimension());
    check_as_many("tags of cells", std::ssize(tags), size);
    std::vector<Index> result;
    for (Index t = 0; t < size; ++t)
        result.push_back(tags[complex.input_row(t)]);
    return result;
}

FacetTags tags_of_facets(const SimplicialComplex& complex, const TaggedSimplices& facets,
                         std::vector<std::string>& warnings) {
    check_as_many("tags of facets", std::ssize(facets.tags), facets.simplices.rows());
    if (facets.tags.empty())
        return {};
    FacetTags result{std::vector<Index>(complex.size(complex.dimension() - 1), 0)};
    std::vector<std::pair<Index, Index>> found; // facet and tag
    std::vector<Index> strays, numbers;
    for (Index row = 0; row < facets.simplices.rows(); ++row) {
        const auto vertices = facets.simplices.row(row);
        numbers.assign(vertices.begin(), vertices.end());
        std::sort(numbers.begin(), numbers.end());
        const Index facet = complex.find(complex.dimension() - 1, numbers);
        if (facet < 0)
            strays.push_back(row);
        else if (facets.tags[row] != 0)
            found.emplace_back(facet, facets.tags[row]);
    }
    sort_unique(found);
    for (const auto& [facet, tag] : found)
        result.groups.push_back(tag);
    sort_unique(result.groups);
    std::map<std::vector<Index>, std::vector<Index>> together; // facets of several groups
    for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
        std::vector<Index> groups;
        for (; end < found.size() && found[end].first == found[begin].first; ++end)
            groups.push_back(found[end].second);
        result.tags[found[begin].first] = groups.front();
        if (groups.size() > 1)
            together[groups].push_back(found[begin].first);
    }
    const std::set<Index> used(facets.tags.begin(), facets.tags.end());
    Index next = *used.rbegin();
    for (const auto& [groups, cells] : together) {
        do
            next = next == std::numeric_limits<Index>::max() ? 1 : next + 1;
        while (used.count(next) > 0 || next == 0);
        result.joint.push_back({next, groups});
        for (const Index facet : cells)
            result.tags[facet] = next;
        warnings.push_back(fmt::format("{} facet{} in each of the groups {}: the tag is {}, and "
                                       "conditions by group apply to all of them",
                                       cells.size(), cells.size() == 1 ? " is" : "s are",
                                       fmt::join(groups, ", "), next));
    }
    if (!strays.empty())
        warnings.push_back(fmt::format("left out {} facet{} with a group but without a cell: {}",
                                       strays.size(), strays.size() == 1 ? "" : "s",
                                       list_facets(facets, strays)));
    return result;
}

std::vector<Index> merged_tags(const Merging& merging, int k, const std::vector<Index>& tags,
                               std::vector<std::string>& warnings) {
    if (tags.empty())
        return {};
    check_as_many("tags", std::ssize(tags), merging.diamond(k).cols());
    std::vector<Index> result;
    Index different = 0;
    for (Index cell = 0; cell < merging.merged().size(k); ++cell) {
        const auto pieces = merging.pieces_of(k, cell);
        const Index first = tags[pieces.front()];
        const bool are_alike =
            std::all_of(pieces.begin(), pieces.end(), [&](Index s) { return tags[s] == first; });
        result.push_back(are_alike ? first : 0);
        different += are_alike ? 0 : 1;
    }
    if (different > 0) {
        const bool are_facets = k < merging.merged().dimension();
        warnings.push_back(fmt::format(
            "{} merged {}{} {} of different groups; {} tag is 0, also in data that depend on "
            "groups: to keep groups apart, use Materials::keep_apart",
            different, are_facets ? "facet" : "cell", different == 1 ? " joins" : "s join",
            are_facets ? "facets" : "simplices", different == 1 ? "its" : "their"));
    }
    return result;
}

} // namespace polydec
