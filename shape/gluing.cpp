// SPDX-License-Identifier: MIT
#include "shape/gluing.h"

#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

/// The corner of a simplex that is corner `place` of the facet lacking corner `omitted`.
int corner_of(int place, int omitted) {
    return place < omitted ? place : place + 1;
}

int sign_at(const std::vector<FacetSide>& sides, int n, const Coface& coface) {
    return sides[std::size_t(n + 1) * coface.cell + coface.omitted].sign;
}

} // namespace

std::vector<FacetSide> facet_sides(const Shape& shape) {
    const Pieces& pieces = shape.pieces;
    const int n = pieces.dimension();
    const Vector robin = robin_coefficients(pieces, shape.conditions);
    std::vector<FacetSide> sides(std::size_t(n + 1) * pieces.size(n));
    const Cofaces cofaces(pieces, n);
    for (Index facet = 0; facet < pieces.size(n - 1); ++facet) {
        const auto around = cofaces.of(facet);
        const bool is_boundary = around.size() == 1;
        const bool is_twisted = shape.functions == ShapeFunctions::twisted;
        if (is_twisted && around.size() > 2)
            throw InvalidInput(
                fmt::format("{} simplices meet at facet {}: twisted functions need at most two, "
                            "since orientation is not defined across more",
                            around.size(), facet));
        for (std::size_t i = 0; i < around.size(); ++i) {
            const auto [cell, omitted] = around[i];
            // coherent orientations show the facet with opposite signs
            const int sign = !is_twisted || i == 0
                                 ? 1
                                 : -pieces.sign(n, cell, omitted) *
                                       pieces.sign(n, around[0].cell, around[0].omitted);
            sides[std::size_t(n + 1) * cell + omitted] = {
                facet, is_boundary, static_cast<std::int8_t>(sign),
                is_boundary && shape.conditions.at(facet) == BoundaryCondition::essential,
                is_boundary ? robin[facet] : 0.0};
        }
    }
    return sides;
}

Unknowns glued_points(const Shape& shape, const std::vector<FacetSide>& sides,
                      const std::vector<Pair>& pairs) {
    const int n = shape.pieces.dimension();
    const auto width = static_cast<Index>(pairs.size());
    const auto place = [&](int i, int j) {
        const Pair pair{std::min(i, j), std::max(i, j)};
        return static_cast<Index>(std::find(pairs.begin(), pairs.end(), pair) - pairs.begin());
    };
    const Index points = width * shape.pieces.size(n);
    DisjointSets sets(points);
    std::vector<Index> zeros;
    const auto for_points = [&](const auto& visit) { // of a facet, by places of its corners
        for (int a = 0; a < n; ++a)
            for (int b = a; b < n; ++b)
                if (place(a, b) < width)
                    visit(a, b);
    };
    const auto point = [&](const Coface& at, int a, int b) {
        return width * at.cell + place(corner_of(a, at.omitted), corner_of(b, at.omitted));
    };
    const Cofaces cofaces(shape.pieces, n);
    for (Index facet = 0; facet < shape.pieces.size(n - 1); ++facet) {
        const auto around = cofaces.of(facet);
        for (const Coface& other : around)
            for_points([&](int a, int b) {
                const int sign = sign_at(sides, n, around[0]) * sign_at(sides, n, other);
                if (!sets.join(point(around[0], a, b), point(other, a, b), sign))
                    zeros.push_back(point(other, a, b));
            });
        const Coface& first = around[0];
        if (sides[std::size_t(n + 1) * first.cell + first.omitted].is_essential)
            for_points([&](int a, int b) { zeros.push_back(point(first, a, b)); });
    }

    constexpr Index unset = -2;
    std::vector<Index> of_root(points, unset);
    for (const Index zero : zeros)
        of_root[sets.find(zero).element] = -1;
    Unknowns result;
    for (Index p = 0; p < points; ++p) {
        const auto root = sets.find(p);
        Index& unknown = of_root[root.element];
        if (unknown == unset)
            unknown = result.count++;
        result.of_simplices.push_back(unknown);
        result.signs.push_back(root.sign);
    }
    return result;
}

Unknowns facet_unknowns(const Shape& shape, const std::vector<FacetSide>& sides, int each) {
    const int n = shape.pieces.dimension();
    std::vector<Index> first(shape.pieces.size(n - 1), -1);
    for (const FacetSide& side : sides)
        if (!side.is_essential)
            first[side.facet] = 0;
    Unknowns result;
    for (Index& number : first)
        if (number == 0) {
            number = result.count;
            result.count += each;
        }
    for (const FacetSide& side : sides)
        for (int k = 0; k < each; ++k) {
            const Index number = first[side.facet];
            result.of_simplices.push_back(number < 0 ? -1 : number + k);
            result.signs.push_back(side.sign);
        }
    return result;
}

double conductivity_of(const Shape& shape, Index simplex) {
    return shape.conductivity.size() == 0 ? 1.0 : shape.conductivity[simplex];
}

double density_of(const Shape& shape, Index simplex) {
    return shape.density.size() == 0 ? 1.0 : shape.density[simplex];
}

std::vector<Index> free_components(const Shape& shape) {
    const int n = shape.pieces.dimension();
    const Index size = shape.pieces.size(n);
    const auto sides = facet_sides(shape);
    DisjointSets sets(size);
    std::vector<Index> bound; // simplices in whose component no constant is free
    const Cofaces cofaces(shape.pieces, n);
    for (Index facet = 0; facet < shape.pieces.size(n - 1); ++facet) {
        const auto around = cofaces.of(facet);
        for (const Coface& other : around)
            if (!sets.join(around[0].cell, other.cell,
                           sign_at(sides, n, around[0]) * sign_at(sides, n, other)))
                bound.push_back(other.cell);
    }
    for (Index s = 0; s < size; ++s)
        for (int i = 0; i <= n; ++i) {
            const FacetSide& side = sides[std::size_t(n + 1) * s + i];
            if (side.is_essential || side.robin > 0)
                bound.push_back(s);
        }
    const auto firsts = sets.firsts();
    std::vector<bool> is_bound(size, false);
    for (const Index s : bound)
        is_bound[firsts[s]] = true;
    std::vector<Index> numbers;
    Index count = 0;
    for (Index s = 0; s < size; ++s)
        numbers.push_back(firsts[s] < s ? numbers[firsts[s]] : is_bound[s] ? -1 : count++);
    return numbers;
}

Index zero_eigenvalues(const Shape& shape) {
    Index most = -1;
    for (const Index component : free_components(shape))
        most = std::max(most, component);
    return most + 1;
}

} // namespace polydec
