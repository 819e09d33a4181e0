// SPDX-License-Identifier: MIT
#include "dec/fields/chosen_vertices.h"

#include "base/errors.h"
#include "complex/components.h"
#include "dec/fields/cell_centers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polydec {

namespace {

std::vector<Index> numbers_of(const std::vector<bool>& marks) {
    std::vector<Index> numbers;
    for (std::size_t v = 0; v < marks.size(); ++v)
        if (marks[v])
            numbers.push_back(static_cast<Index>(v));
    return numbers;
}

/// The vertices of the k-cells with this tag.
std::vector<Index> with_tag(const CellComplex& complex, int k, const std::vector<Index>& of_cells,
                            Index tag) {
    CellMarks marks;
    for (int j = 0; j <= complex.dimension(); ++j)
        marks.emplace_back(complex.size(j), false);
    for (std::size_t cell = 0; cell < of_cells.size(); ++cell)
        marks[k][cell] = of_cells[cell] == tag;
    mark_faces(complex, marks);
    return numbers_of(marks[0]);
}

std::string names_of(const std::vector<GroupName>& groups) {
    std::vector<std::string> names;
    for (const GroupName& each : groups)
        names.push_back(each.name);
    return names.empty() ? "" : fmt::format(": there are {}", fmt::join(names, ", "));
}

} // namespace

std::vector<Index> boundary_vertices(const Discretization& mesh) {
    auto numbers = numbers_of(boundary_cells(mesh.complex())[0]);
    if (numbers.empty())
        throw InvalidInput("vertices of the boundary are asked for: the mesh has none");
    return numbers;
}

std::vector<Index> vertices_where(const Discretization& mesh,
                                  const std::function<bool(const Vector& point)>& predicate) {
    const Points points = mesh.unit() * cell_centers(mesh, 0);
    std::vector<bool> marks;
    for (Index v = 0; v < points.rows(); ++v)
        marks.push_back(predicate(points.row(v).transpose()));
    auto numbers = numbers_of(marks);
    if (numbers.empty())
        throw InvalidInput(fmt::format("none of the {} vertices is where some are asked for",
                                       points.rows()));
    return numbers;
}

std::vector<Index> vertices_on(const Discretization& mesh, const std::vector<std::string>& groups) {
    const int n = mesh.dimension();
    std::vector<Index> numbers;
    for (const auto& group : groups) {
        std::vector<Index> found;
        if (const auto tag = group_tag(mesh.groups(), n - 1, group))
            found = with_tag(mesh.complex(), n - 1, mesh.facet_tags(), *tag);
        if (const auto tag = group_tag(mesh.groups(), n, group); tag && found.empty())
            found = with_tag(mesh.complex(), n, mesh.tags(), *tag);
        if (found.empty())
            throw InvalidInput(fmt::format("no facet and no cell is in a group {}{}", group,
                                           names_of(mesh.groups())));
        numbers.insert(numbers.end(), found.begin(), found.end());
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

} // namespace polydec
