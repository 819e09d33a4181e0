// SPDX-License-Identifier: MIT
#include "complex/simplicial_complex.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "complex/blocks.h"
#include "complex/faces.h"
#include "complex/size_estimate.h"
#include "system/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace polydec {

namespace {

std::span<const Index> row(const Simplices& table, Index i) {
    return {table.data() + i * table.cols(), static_cast<std::size_t>(table.cols())};
}

/// Vertices that simplices use.
struct Used {
    Index count;
    std::vector<Index> numbers; // of each by which it is named; empty: their own
};

Used used_vertices(const Simplices& tops) {
    const std::span all(tops.data(), static_cast<std::size_t>(tops.size()));
    std::uint32_t largest = 0; // negative numbers are larger than others
    for (const Index vertex : all)
        largest = std::max(largest, static_cast<std::uint32_t>(vertex));
    if (largest >= std::uint32_t(std::numeric_limits<Index>::max())) {
        const Index least = tops.minCoeff(), vertex = least < 0 ? least : tops.maxCoeff();
        throw InvalidInput(fmt::format("vertex number {} is out of range: expected {}", vertex,
                                       vertex < 0 ? "0 or more" : "0 to 2^31 - 2"),
                           {.vertices = {vertex}});
    }
    std::vector<std::uint8_t> marks(std::size_t{largest} + 1, 0);
    for (const Index vertex : all)
        marks[vertex] = 1;
    Used used{static_cast<Index>(std::count(marks.begin(), marks.end(), 1)), {}};
    if (std::size_t(used.count) < marks.size())
        used.numbers = marked(marks);
    return used;
}

/// The simplices with the places of their vertices among those that are used.
Simplices by_place(Simplices tops, const std::vector<Index>& numbers) {
    std::vector<Index> places(static_cast<std::size_t>(numbers.back()) + 1);
    for (std::size_t v = 0; v < numbers.size(); ++v)
        places[numbers[v]] = static_cast<Index>(v);
    for (Index& vertex : tops.reshaped<Eigen::RowMajor>())
        vertex = places[vertex];
    return tops;
}

/// Says which rows are no simplices, or the same.
void refuse_rows(const SortedRows& tops, const std::vector<Index>& numbers) {
    const Simplices& rows = *tops.simplices.rows;
    for (Index s = 0; s < rows.rows(); ++s) {
        const auto list = row(rows, s);
        std::vector<Index> named(list.begin(), list.end());
        for (Index& vertex : named)
            vertex = numbers.empty() ? vertex : numbers[vertex];
        const auto n = static_cast<int>(rows.cols()) - 1;
        if (std::adjacent_find(list.begin(), list.end()) != list.end())
            throw InvalidInput(fmt::format("cell {} has a repeated corner: its vertices are {}",
                                           tops.order[s], fmt::join(named, ", ")),
                               {.degree = n, .cells = {tops.order[s]}, .vertices = named});
        if (s > 0 && std::ranges::equal(row(rows, s - 1), list))
            throw InvalidInput(
                fmt::format("cells {} and {} have the same vertices {}: remove one of them",
                            tops.order[s - 1], tops.order[s], fmt::join(named, ", ")),
                {.degree = n, .cells = {tops.order[s - 1], tops.order[s]}, .vertices = named});
    }
}

/// A simplex has 2^(n+1) faces: a short file can ask for more than any machine has.
void check_cost(const SortedSimplices& tops) {
    const auto n = static_cast<int>(tops.rows->cols()) - 1;
    const auto simplices = static_cast<Index>(tops.rows->rows());
    const auto size = estimate_size(n, simplices, tops.vertices);
    check_memory(size.bytes(),
                 fmt::format("a complex of {} simpl{} of dimension {}, of about "
                             "{:.2g} cells of all degrees,",
                             simplices, simplices == 1 ? "ex" : "ices", n, size.cells));
}

/// Which of the n-simplices to turn.
struct Turns {
    std::vector<std::int8_t> orientations; // afterwards
    bool are_coherent;
    Index count = 0;
};

/// Makes orientations coherent across facets with exactly two cofaces wherever that is possible: of
/// each part connected by such facets, turns the simplices unlike the first one or all others,
/// whichever are fewer. A part that cannot be oriented keeps what was given.
Turns coherent_turns(const Pieces& complex) {
    const int n = complex.dimension();
    auto [parts, clashes] = join_tops(complex, std::vector<bool>(complex.size(n - 1), true));
    const Index tops = complex.size(n);
    std::vector<Index> balance(tops, 0); // at first simplices: number of those alike minus others
    for (Index t = 0; t < tops; ++t) {
        const auto [first, sign] = parts.find(t);
        balance[first] += sign;
    }
    std::vector<bool> one_sided(tops, false);
    for (const Index t : clashes)
        one_sided[parts.find(t).element] = true;

    Turns result{{}, clashes.empty()};
    for (Index t = 0; t < tops; ++t) {
        const auto [first, sign] = parts.find(t);
        const int kept = balance[first] < 0 ? -1 : 1;
        const bool turns = !one_sided[first] && sign != kept;
        result.count += turns ? 1 : 0;
        result.orientations.push_back(
            static_cast<std::int8_t>(turns ? -complex.orientation(t) : complex.orientation(t)));
    }
    return result;
}

} // namespace

SimplicialComplex SimplicialComplex::sorted(const Simplices& tops) {
    if (tops.rows() == 0 || tops.cols() < 2)
        throw InvalidInput(
            "a simplicial complex needs at least one simplex of dimension 1 or more");
    auto [vertices, numbers] = used_vertices(tops);
    auto sorted = numbers.empty() ? sorted_rows(tops, vertices)
                                  : sorted_rows(by_place(tops, numbers), vertices);
    return with_faces(std::move(sorted), std::move(numbers));
}

SimplicialComplex SimplicialComplex::with_faces(SortedRows sorted, std::vector<Index> numbers) {
    if (!sorted.are_simplices)
        refuse_rows(sorted, numbers);
    check_cost(sorted.simplices);

    const auto n = static_cast<int>(sorted.simplices.rows->cols()) - 1;
    const auto signs = std::make_shared<const Incidences::Signs>(std::move(sorted.signs));
    std::vector<std::shared_ptr<const Simplices>> simplices(n + 1);
    std::vector<Coboundary> coboundaries;
    SortedSimplices cells = std::move(sorted.simplices);
    bool are_coherent = false;
    for (int k = n - 1; k >= 0; --k) {
        const bool is_top = k == n - 1;
        auto lower = is_top ? faces_of(cells, *signs) : faces_of(cells);
        are_coherent = are_coherent || lower.are_coherent;
        const auto faces = static_cast<Index>(lower.simplices.rows->rows());
        coboundaries.insert(coboundaries.begin(),
                            {Incidences(std::move(lower.table), faces, is_top ? signs : nullptr),
                             std::move(lower.counts)});
        simplices[k + 1] = std::exchange(cells, std::move(lower.simplices)).rows;
    }
    simplices[0] = std::move(cells.rows);
    const Pieces pieces(Unchecked{}, CellComplex(Unchecked{}, std::move(coboundaries)),
                        std::move(simplices), signs, are_coherent, std::move(numbers));
    if (are_coherent)
        return {pieces, std::move(sorted.order), 0};
    Turns turns = coherent_turns(pieces);
    return {pieces.with_orientations(std::move(turns.orientations), turns.are_coherent),
            std::move(sorted.order), turns.count};
}

SimplicialComplex::SimplicialComplex(const Simplices& tops) : SimplicialComplex(sorted(tops)) {}

SimplicialComplex::SimplicialComplex(const Simplices& tops, std::vector<Index> names)
    : SimplicialComplex(with_faces(sorted_rows(tops, static_cast<Index>(names.size())), names)) {}

SimplicialComplex SimplicialComplex::oriented(std::vector<std::int8_t> orientations,
                                              bool orientable) const {
    check_as_many("orientations", std::ssize(orientations), size(dimension()));
    SimplicialComplex result = *this;
    static_cast<Pieces&>(result) = with_orientations(std::move(orientations), orientable);
    result.turned_ = 0;
    return result;
}

Index SimplicialComplex::find(int k, std::span<const Index> vertices) const {
    const auto number = [this](Index v) { return vertex_number(v); };
    Index low = 0, high = size(k);
    while (low < high) {
        const Index middle = low + (high - low) / 2;
        if (std::ranges::lexicographical_compare(row(simplices(k), middle), vertices, {}, number))
            low = middle + 1;
        else
            high = middle;
    }
    const bool is_there =
        low < size(k) && std::ranges::equal(row(simplices(k), low), vertices, {}, number);
    return is_there ? low : -1;
}

SimplicialComplex::SimplicialComplex(const Pieces& pieces, std::vector<Index> input_rows,
                                     Index turned)
    : Pieces(pieces),
      input_rows_(std::make_shared<const std::vector<Index>>(std::move(input_rows))),
      turned_(turned) {}

} // namespace polydec
