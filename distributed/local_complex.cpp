// SPDX-License-Identifier: MIT
#include "distributed/local_complex.h"

#include "base/errors.h"
#include "distributed/in_order.h"
#include "distributed/number_places.h"
#include "distributed/orientation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

/// The complex of the cells; errors tell of cells by their numbers in the file.
SimplicialComplex complex_of(const Stars& stars) {
    try {
        return {by_local_vertex(stars), names_of(stars.vertices)};
    } catch (const InvalidInput& error) {
        const Error::Place& place = error.place();
        std::vector<GlobalIndex> cells;
        for (const Index row : place.cells)
            cells.push_back(stars.file_places[row]);
        if (cells.size() == 1)
            throw InvalidInput(fmt::format("cell {} has a repeated corner: its vertices are {}",
                                           cells[0], fmt::join(place.vertices, ", ")));
        if (cells.size() == 2)
            throw InvalidInput(
                fmt::format("cells {} and {} have the same vertices {}: remove one of them",
                            cells[0], cells[1], fmt::join(place.vertices, ", ")));
        throw;
    }
}

/// Owners and completeness of the k-simplices.
LocalComplex::Degree degree_of(const Ranks& ranks, const SimplicialComplex& complex,
                               const std::vector<int>& owners, int k) {
    LocalComplex::Degree degree;
    const Simplices& simplices = complex.simplices(k);
    degree.owner.reserve(simplices.rows());
    degree.complete.reserve(simplices.rows());
    for (Eigen::Index s = 0; s < simplices.rows(); ++s) {
        const auto corners = simplices.row(s);
        degree.owner.push_back(owners[corners[0]]);
        degree.complete.push_back(std::any_of(corners.begin(), corners.end(),
                                              [&](Index v) { return owners[v] == ranks.rank(); }));
    }
    return degree;
}

/// Row s of simplices with the file's numbers of vertices.
void append_vertices(std::vector<GlobalIndex>& list, const Simplices& simplices, Index s,
                     const std::vector<GlobalIndex>& vertices) {
    for (const Index v : simplices.row(s))
        list.push_back(vertices[v]);
}

/// The simplex with these vertices, which is there.
Index place_of(const Simplices& simplices, const std::vector<GlobalIndex>& vertices,
               const GlobalIndex* list) {
    const auto width = simplices.cols();
    Index low = 0, high = static_cast<Index>(simplices.rows());
    while (low < high) {
        const Index middle = low + (high - low) / 2;
        bool is_less = false;
        for (Eigen::Index i = 0; i < width; ++i)
            if (const GlobalIndex v = vertices[simplices(middle, i)]; v != list[i]) {
                is_less = v < list[i];
                break;
            }
        is_less ? low = middle + 1 : high = middle;
    }
    const auto is_it = [&] {
        for (Eigen::Index i = 0; i < width; ++i)
            if (vertices[simplices(low, i)] != list[i])
                return false;
        return true;
    };
    if (low == simplices.rows() || !is_it())
        throw InvalidInput(fmt::format("a {}-simplex is missing on the rank that owns its first "
                                       "vertex {}: each rank needs all cells around its vertices",
                                       width - 1, list[0]));
    return low;
}

void find_copies(const Ranks& ranks, const SimplicialComplex& complex,
                 const std::vector<GlobalIndex>& vertices, int k, LocalComplex::Degree& degree) {
    const Simplices& simplices = complex.simplices(k);
    auto wanted = ranks.empty_parcels<GlobalIndex>();
    degree.copies.in = ranks.empty_parcels<Index>();
    for (Index s = 0; s < static_cast<Index>(simplices.rows()); ++s)
        if (const int r = degree.owner[s]; r != ranks.rank()) {
            append_vertices(wanted[r], simplices, s, vertices);
            degree.copies.in[r].push_back(s);
        }
    const auto asked = ranks.deliver(std::move(wanted));
    degree.copies.out = ranks.empty_parcels<Index>();
    ranks.together("copies", [&] {
        for (std::size_t r = 0; r < asked.size(); ++r)
            for (auto list = asked[r].data(); list != asked[r].data() + asked[r].size();
                 list += k + 1)
                degree.copies.out[r].push_back(place_of(simplices, vertices, list));
    });
}

void number(const Ranks& ranks, const SimplicialComplex& complex,
            const std::vector<GlobalIndex>& vertices, GlobalIndex below, int k,
            LocalComplex::Degree& degree) {
    const Simplices& simplices = complex.simplices(k);
    std::vector<GlobalIndex> lists;
    ranks.together("numbers", [&] {
        lists.reserve(degree.owner.size() * static_cast<std::size_t>(k + 1));
        for (Index s = 0; s < static_cast<Index>(simplices.rows()); ++s)
            if (degree.owner[s] == ranks.rank())
                append_vertices(lists, simplices, s, vertices);
    });
    const auto [places, count] = places_in_order(ranks, lists, k + 1, below);
    degree.count = count;
    degree.number.assign(degree.owner.size(), -1);
    auto next = places.begin();
    for (std::size_t s = 0; s < degree.owner.size(); ++s)
        if (degree.owner[s] == ranks.rank())
            degree.number[s] = *next++;
    refresh(ranks, degree.copies, degree.number);
}

} // namespace

std::vector<Index> names_of(const std::vector<GlobalIndex>& vertices) {
    std::vector<Index> names;
    const bool fit = vertices.empty() || vertices.back() <= std::numeric_limits<Index>::max();
    for (std::size_t v = 0; v < vertices.size(); ++v)
        names.push_back(static_cast<Index>(fit ? vertices[v] : static_cast<GlobalIndex>(v)));
    return names;
}

Simplices by_local_vertex(const Stars& stars) {
    const NumberPlaces place(stars.vertices);
    return stars.cells.unaryExpr([&](GlobalIndex vertex) { return place(vertex); });
}

Index LocalComplex::Degree::find(GlobalIndex of_number) const {
    const auto place = std::lower_bound(number.begin(), number.end(), of_number);
    return place != number.end() && *place == of_number ? static_cast<Index>(place - number.begin())
                                                        : -1;
}

LocalComplex local_complex(const Ranks& ranks, const Stars& stars, GlobalIndex vertices) {
    const SimplicialComplex complex = ranks.together("complex", [&] { return complex_of(stars); });
    LocalComplex local{complex, stars.points, stars.vertices, {}};
    for (int k = 0; k <= complex.dimension(); ++k) {
        local.degrees.push_back(ranks.together(
            "ownership", [&] { return degree_of(ranks, complex, stars.owners, k); }));
        find_copies(ranks, complex, stars.vertices, k, local.degrees.back());
        number(ranks, complex, stars.vertices, vertices, k, local.degrees.back());
    }
    orient(ranks, stars, local);
    return local;
}

} // namespace polydec
