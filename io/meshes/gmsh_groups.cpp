// SPDX-License-Identifier: MIT
#include "io/meshes/gmsh_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace polydec {

void GmshGroups::read(GmshSource& source, bool is_partitioned) {
    if (is_partitioned) {
        source.size("the number of partitions");
        const Index ghosts = source.count("ghost entities", {.integers = 2});
        for (std::int64_t ghost = 0; ghost < 2 * std::int64_t{ghosts}; ++ghost)
            source.integer("a ghost entity");
    }
    std::array<Index, CellLists::most_dimensions> counts{};
    for (auto& count : counts)
        count = source.count("entities", {.integers = 1, .sizes = 1, .reals = 3});
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension) {
        for (Index entity = 0; entity < counts[dimension]; ++entity)
            read_entity(source, dimension, is_partitioned);
        if (const auto twice = lists_[dimension].close())
            source.fail(fmt::format(
                "the entity {} of dimension {} occurs twice; expected it once; export it again",
                *twice, dimension));
    }
}

void GmshGroups::read_entity(GmshSource& source, std::size_t dimension, bool is_partitioned) {
    const auto number = source.integer("the number of an entity");
    if (is_partitioned) {
        source.integer("the dimension of the parent");
        source.integer("the number of the parent");
        source.skip_integers("partitions");
    }
    source.skip_reals(dimension == 0 && !source.format().is_4_0() ? 3 : 6);
    const Index groups = source.count("physical groups", {.integers = 1});
    std::vector<Index> tags;
    for (Index group = 0; group < groups; ++group)
        tags.push_back(group_tag(source.integer("a physical group"), source));
    if (!tags.empty()) {
        lists_[dimension].add(number, static_cast<Index>(tags_.size()));
        tags_.push_back(std::move(tags));
    }
    if (dimension > 0)
        source.skip_integers("entities of a boundary");
}

std::span<const Index> GmshGroups::tags_of(std::size_t dimension, std::int64_t entity) const {
    return tags_[lists_[dimension].find(entity).value_or(0)];
}

namespace {

std::string quoted_name(Scanner& scanner) {
    const auto rest = scanner.rest();
    const auto end = rest.find_first_of("\"\n\r", 1);
    if (rest.front() != '"' || end == std::string_view::npos || rest[end] != '"')
        scanner.fail("a physical name without quotes; expected one such as \"wall\"; correct it or "
                     "remove the section $PhysicalNames");
    return std::string(scanner.bytes(end + 1, "a physical name").substr(1, end - 1));
}

} // namespace

std::vector<GroupName> read_gmsh_names(Scanner& scanner, const GmshFormat& format) {
    std::vector<GroupName> names;
    const Index count = scanner.count("physical names", 4);
    for (Index i = 0; i < count; ++i) {
        GroupName group;
        auto number = scanner.integer("a physical name");
        scanner.stay_on_line("a physical name");
        if (!scanner.rest().starts_with('"')) {
            group.dimension = static_cast<int>(std::clamp<std::int64_t>(number, -1, 4));
            number = scanner.integer("the number of a physical group");
            scanner.stay_on_line("a physical name");
        }
        group.tag = group_tag(number, GmshSource(scanner, format));
        group.name = quoted_name(scanner);
        scanner.next_line(); // other programs write words of their own behind it
        names.push_back(std::move(group));
    }
    return names;
}

Index group_tag(std::int64_t number, const GmshSource& source) {
    constexpr std::int64_t most = std::numeric_limits<Index>::max();
    if (number > most || number < -most)
        source.fail(fmt::format("the physical group {} is out of range; expected a number of 32 "
                                "bits; renumber the groups",
                                number));
    return static_cast<Index>(number < 0 ? -number : number);
}

} // namespace polydec
