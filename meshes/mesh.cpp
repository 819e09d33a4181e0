// SPDX-License-Identifier: MIT
#include "meshes/mesh.h"

#include "base/did_you_mean.h"
#include "base/errors.h"
#include "meshes/edges.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>

namespace polydec {

namespace {

std::vector<Index> at_rows(const std::vector<Index>& numbers, const std::vector<Index>& rows) {
    std::vector<Index> result;
    result.reserve(rows.size());
    for (const Index row : rows)
        result.push_back(numbers[row]);
    return result;
}

bool fits(const GroupName& group, int dimension) {
    return group.dimension == dimension || group.dimension == -1;
}

} // namespace

Simplices simplices_of(const std::vector<Index>& vertices, Eigen::Index width) {
    const auto rows = width > 0 ? std::ssize(vertices) / width : 0;
    return Eigen::Map<const Simplices>(vertices.data(), rows, width);
}

InputCells followed(const InputCells& cells, const std::vector<Index>& rows, Index count) {
    if (cells.of_simplices.empty())
        return {rows, count};
    return {at_rows(cells.of_simplices, rows), cells.count};
}

void follow_rows(Mesh& mesh, const std::vector<Index>& rows, Index count) {
    if (!mesh.tags.empty())
        mesh.tags = at_rows(mesh.tags, rows);
    mesh.input_cells = followed(mesh.input_cells, rows, count);
}

std::vector<Index> keep_rows(Mesh& mesh, const std::vector<bool>& left_out) {
    std::vector<Index> rows;
    for (Index row = 0; row < mesh.simplices.rows(); ++row)
        if (!left_out[row])
            rows.push_back(row);
    follow_rows(mesh, rows, static_cast<Index>(mesh.simplices.rows()));
    for (std::size_t to = 0; to < rows.size(); ++to)
        mesh.simplices.row(static_cast<Index>(to)) = mesh.simplices.row(rows[to]);
    mesh.simplices.conservativeResize(static_cast<Eigen::Index>(rows.size()), Eigen::NoChange);
    return rows;
}

void check_facet_tags(const Mesh& mesh) {
    const auto& [facets, tags] = mesh.facet_tags;
    if (static_cast<Eigen::Index>(tags.size()) != facets.rows())
        throw InvalidInput(
            fmt::format("{} tags are given for {} facets; expected one for each facet", tags.size(),
                        facets.rows()));
    if (facets.rows() > 0 && facets.cols() != mesh.dimension())
        throw InvalidInput(fmt::format(
            "facets with tags have {} vertices; expected {}, since the cells have dimension {}",
            facets.cols(), mesh.dimension(), mesh.dimension()));
    check_vertices("facet", facets, mesh.points.rows(), " of the facets with tags");
}

std::optional<Index> group_tag(const std::vector<GroupName>& groups, int dimension,
                               const std::string& word) {
    for (const GroupName& group : groups)
        if (fits(group, dimension) && group.name == word)
            return group.tag;
    Index number = 0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, number);
    return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

std::vector<Index> group_tags(const std::vector<GroupName>& groups, int dimension,
                              const std::vector<std::string>& words) {
    std::vector<Index> tags;
    for (const std::string& word : words) {
        if (const auto tag = group_tag(groups, dimension, word)) {
            tags.push_back(*tag);
            continue;
        }
        std::vector<std::string> names;
        for (const GroupName& each : groups)
            if (fits(each, dimension))
                names.push_back(each.name);
        const std::string nearest = did_you_mean(word, names);
        throw InvalidInput(
            fmt::format("no group of {}-cells is called {}{} {}", dimension, word,
                        nearest.empty() ? "." : nearest,
                        names.empty() ? "No group has a name: give its number"
                                      : fmt::format("The file has {}", fmt::join(names, ", "))));
    }
    return tags;
}

} // namespace polydec
