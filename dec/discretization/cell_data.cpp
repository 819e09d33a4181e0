// SPDX-License-Identifier: MIT
#include "dec/discretization/cell_data.h"

#include "base/checks.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

Index count_vertices(const Discretization& mesh) {
    return mesh.complex().size(0) + static_cast<Index>(mesh.isolated().rows());
}

std::vector<Index> vertices_of_cells(const Discretization& mesh) {
    const SimplicialComplex& input = mesh.input();
    const auto unused = static_cast<Index>(mesh.isolated().rows());
    std::vector<Index> result(static_cast<std::size_t>(mesh.complex().size(0)));
    for (Index v = 0; v < std::ssize(result); ++v)
        result[v] = v < input.size(0) ? input.vertex_number(v) : v + unused;
    return result;
}

std::vector<Index> cells_of_vertices(const Discretization& mesh, std::string_view what,
                                     const std::vector<Index>& vertices) {
    const std::vector<Index> known = vertices_of_cells(mesh);
    std::vector<Index> cells;
    for (const Index vertex : vertices) {
        const auto found = std::lower_bound(known.begin(), known.end(), vertex);
        if (found != known.end() && *found == vertex) {
            cells.push_back(static_cast<Index>(found - known.begin()));
            continue;
        }
        const Index count = count_vertices(mesh);
        const auto flaw =
            vertex < 0 || vertex >= count
                ? fmt::format("there is no such vertex; vertices are numbered from 0 to {}",
                              count - 1)
                : "no cell uses this vertex; choose a vertex of a cell";
        throw InvalidInput(fmt::format("{} {}: {}", what, vertex, flaw), {.vertices = {vertex}});
    }
    return cells;
}

namespace {

/// Relative difference between two computations of the same number.
constexpr double rounding = 1e-12;

void check_range(std::string_view what, const Vector& values, std::string_view cells, Range range,
                 int n) {
    for (Index cell = 0; cell < values.size(); ++cell)
        if (!std::isfinite(values[cell]) || values[cell] < 0 ||
            (range == Range::positive && values[cell] == 0))
            throw InvalidInput(fmt::format("the {} of {} {} is {}: expected {}", what, cells, cell,
                                           values[cell],
                                           range == Range::positive ? "a positive number"
                                                                    : "a number of at least 0"),
                               {.degree = n, .cells = {cell}});
}

/// For each simplex of the input, the number of its cell.
std::vector<Index> numbers_of_simplices(const Discretization& mesh) {
    const SimplicialComplex& input = mesh.input();
    const auto& numbers = mesh.input_cells().of_simplices;
    std::vector<Index> result(static_cast<std::size_t>(input.size(input.dimension())));
    for (Index t = 0; t < std::ssize(result); ++t) {
        const Index row = input.input_row(t);
        result[t] = numbers.empty() ? row : numbers[row];
    }
    return result;
}

[[noreturn]] void refuse_joined(const Discretization& mesh, std::string_view what, Index first,
                                Index other) {
    const bool flips = !mesh.passage().is_identity();
    throw InvalidInput(
        fmt::format("the {} of the input's {}-cells {} and {} differ, but {}: {}", what,
                    mesh.dimension(), first, other,
                    flips ? "flipped triangles join parts of different cells"
                          : "they are parts of one merged cell",
                    flips ? "omit the flips, or give a number for each n-cell (CellData::on_cells)"
                          : "keep them apart by their tags (Materials::keep_apart), merge no cells "
                            "(MergeCriterion::none), or give a number for each merged cell "
                            "(CellData::on_cells)"),
        {.degree = mesh.dimension(), .cells = {first, other}});
}

} // namespace

Index count_input_cells(const Discretization& mesh) {
    const auto& [numbers, count] = mesh.input_cells();
    return numbers.empty() ? mesh.input().size(mesh.dimension()) : count;
}

std::vector<Index> cells_of_input(const Discretization& mesh, std::string_view what,
                                  const std::function<bool(Index, Index)>& differ) {
    const int n = mesh.dimension();
    const std::vector<Index> numbers = numbers_of_simplices(mesh);
    const auto first_of = [&](const std::vector<Index>& cells) {
        const Index first = *std::min_element(cells.begin(), cells.end());
        for (const Index cell : cells)
            if (differ(first, cell))
                refuse_joined(mesh, what, first, cell);
        return first;
    };
    const Index size = mesh.complex().size(n);
    if (!mesh.passage().is_identity())
        return std::vector<Index>(static_cast<std::size_t>(size), first_of(numbers));
    std::vector<Index> result, joined;
    for (Index cell = 0; cell < size; ++cell) {
        joined.clear();
        const auto pieces = mesh.merging().pieces_of(n, cell);
        for (const Index piece : pieces) // flat ones have no share in a cell with others
            if (!mesh.geometry().is_flat(piece))
                joined.push_back(numbers[piece]);
        if (joined.empty())
            joined.push_back(numbers[pieces.front()]);
        result.push_back(first_of(joined));
    }
    return result;
}

CellData CellData::on_cells(Vector values) {
    CellData result;
    result.values_ = std::move(values);
    result.are_on_cells_ = true;
    return result;
}

Vector CellData::on(const Discretization& mesh, std::string_view what, Range range) const {
    const int n = mesh.dimension();
    const auto cells = fmt::format("{}{}-cell", are_on_cells_ ? "" : "the input's ", n);
    const Index size = mesh.complex().size(n), expected = count_input_cells(mesh);
    if (!are_on_cells_ && values_.size() == size && size != expected)
        throw InvalidInput(fmt::format("{} values ({}) are given, one for each {}-cell after "
                                       "merging: expected one for each of the input's {}, or, for "
                                       "merged cells, CellData::on_cells",
                                       size, what, n, expected));
    check_as_many(fmt::format("values ({}) of {}s", what, cells), values_.size(),
                  are_on_cells_ ? size : expected);
    check_range(what, values_, cells, range, n);
    if (are_on_cells_)
        return values_;
    const auto differ = [this](Index a, Index b) {
        return std::abs(values_[a] - values_[b]) > rounding * std::max(values_[a], values_[b]);
    };
    const auto numbers = cells_of_input(mesh, what, differ);
    return values_(numbers);
}

} // namespace polydec
