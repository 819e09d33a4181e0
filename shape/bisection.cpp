// SPDX-License-Identifier: MIT
#include "shape/bisection.h"

#include "base/errors.h"
#include "shape/measured_simplex.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// Triangles with ordered corners, and what their parts take over.
class Bisection {
public:
    explicit Bisection(const Shape& shape);

    void bisect(Index triangle);
    bool is_new(Index triangle, int times) const { return generations_[triangle] >= times; }
    Shape result(const Shape& shape) const;

private:
    struct Triangle {
        std::array<Index, 3> corners; // in order
        std::array<Index, 3> edges;   // lacking that corner
        std::int8_t orientation;
        Index parent;
    };
    struct Edge {
        std::array<Index, 2> ends; // in order
        double length;
        Index parent; // of the input, -1 inside a triangle of it
        std::vector<Index> triangles;
        bool is_divided = false;
    };

    Index longest(Index triangle) const;
    void divide(Index edge);
    Index add_edge(Index a, Index b, double length, Index parent);
    double median(const Triangle& triangle, int omitted) const;
    void leave(Index edge, Index triangle);

    std::vector<Triangle> triangles_;
    std::vector<Edge> edges_;
    std::vector<int> generations_;
    Index vertices_, first_vertices_;
};

Bisection::Bisection(const Shape& shape)
    : vertices_(shape.pieces.size(0)), first_vertices_(vertices_) {
    const Pieces& pieces = shape.pieces;
    for (Index e = 0; e < pieces.size(1); ++e)
        edges_.push_back(
            {{pieces.simplices(1)(e, 0), pieces.simplices(1)(e, 1)}, shape.lengths[e], e, {}});
    for (Index t = 0; t < pieces.size(2); ++t) {
        Triangle triangle{{}, {}, static_cast<std::int8_t>(pieces.orientation(t)), t};
        for (int i = 0; i < 3; ++i) {
            triangle.corners[i] = pieces.simplices(2)(t, i);
            triangle.edges[i] = pieces.face(2, t, i);
            edges_[triangle.edges[i]].triangles.push_back(t); // twice if it is glued to itself
        }
        triangles_.push_back(triangle);
    }
    generations_.assign(triangles_.size(), 0);
}

/// Of equally long ones the first, so that all triangles agree.
Index Bisection::longest(Index triangle) const {
    const auto& edges = triangles_[triangle].edges;
    return *std::max_element(edges.begin(), edges.end(), [&](Index a, Index b) {
        return edges_[a].length < edges_[b].length ||
               (edges_[a].length == edges_[b].length && a > b);
    });
}

/// Until the triangle is divided: first the last of those to which longer and longer edges lead.
void Bisection::bisect(Index triangle) {
    const int generation = generations_[triangle];
    while (generations_[triangle] == generation) {
        Index edge = longest(triangle);
        for (bool is_longest = false; !is_longest;) {
            is_longest = true;
            for (const Index other : edges_[edge].triangles)
                if (const Index next = longest(other); next != edge) {
                    edge = next;
                    is_longest = false;
                    break;
                }
        }
        divide(edge);
    }
}

Index Bisection::add_edge(Index a, Index b, double length, Index parent) {
    edges_.push_back({{a, b}, length, parent, {}});
    return static_cast<Index>(edges_.size() - 1);
}

double Bisection::median(const Triangle& triangle, int omitted) const {
    long double square = 0;
    for (int i = 0; i < 3; ++i) {
        const long double length = edges_[triangle.edges[i]].length;
        square += length * length * (i == omitted ? -0.25L : 0.5L);
    }
    return static_cast<double>(std::sqrt(square));
}

void Bisection::leave(Index edge, Index triangle) {
    auto& around = edges_[edge].triangles;
    around.erase(std::find(around.begin(), around.end(), triangle));
}

/// Divides an edge, and the triangles around it, of which it is the longest edge. The new vertex is
/// the last corner of all.
void Bisection::divide(Index edge) {
    const Index middle = vertices_++;
    const auto [first, last] = edges_[edge].ends;
    std::array<Index, 2> halves{};
    for (int end = 0; end < 2; ++end)
        halves[end] =
            add_edge(end == 0 ? first : last, middle, edges_[edge].length / 2, edges_[edge].parent);
    edges_[edge].is_divided = true;
    while (!edges_[edge].triangles.empty()) { // a triangle glued to itself is there twice
        const Index t = edges_[edge].triangles.back();
        edges_[edge].triangles.pop_back();
        const Triangle whole = triangles_[t];
        const auto omitted = static_cast<int>(
            std::find(whole.edges.begin(), whole.edges.end(), edge) - whole.edges.begin());
        const Index across = add_edge(whole.corners[omitted], middle, median(whole, omitted), -1);
        const auto part = static_cast<Index>(triangles_.size());
        triangles_.push_back(whole);
        generations_.push_back(++generations_[t]);

        // each part has one end of the edge replaced by the middle, which moves to the last place
        std::array<int, 2> ends{};
        for (int i = 0, end = 0; i < 3; ++i)
            if (i != omitted)
                ends[end++] = i;
        for (int kept = 0; kept < 2; ++kept) {
            const Index at = kept == 0 ? t : part;
            const int replaced = ends[1 - kept];
            Triangle& triangle = triangles_[at];
            const bool omitted_first = omitted < ends[kept];
            const std::array<int, 2> order{omitted_first ? omitted : ends[kept],
                                           omitted_first ? ends[kept] : omitted};
            triangle.corners = {whole.corners[order[0]], whole.corners[order[1]], middle};
            triangle.orientation =
                static_cast<std::int8_t>(replaced == 1 ? -whole.orientation : whole.orientation);
            // lacking the kept end: across; lacking the omitted corner: a half; lacking the middle
            for (int i = 0; i < 2; ++i)
                triangle.edges[i] = order[i] == omitted ? halves[kept] : across;
            triangle.edges[2] = whole.edges[replaced];
            edges_[halves[kept]].triangles.push_back(at);
            edges_[across].triangles.push_back(at);
        }
        leave(whole.edges[ends[0]], t); // the edge lacking the first end is the second part's
        edges_[whole.edges[ends[0]]].triangles.push_back(part);
    }
}

Shape Bisection::result(const Shape& shape) const {
    std::vector<Index> numbers(edges_.size(), -1);
    Index count = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e)
        if (!edges_[e].is_divided)
            numbers[e] = count++;
    Simplices ends(count, 2), sides(static_cast<Index>(triangles_.size()), 3);
    Shape result = shape;
    result.lengths.resize(count);
    const auto& given = shape.conditions;
    result.conditions.facets.clear();
    if (std::ssize(given.coefficients) == shape.pieces.size(1))
        result.conditions.coefficients.clear();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const Edge& edge = edges_[e];
        if (edge.is_divided)
            continue;
        ends.row(numbers[e]) << edge.ends[1], edge.ends[0]; // lacking the first, the last
        result.lengths[numbers[e]] = edge.length;
        if (!given.facets.empty())
            result.conditions.facets.push_back(edge.parent < 0 ? BoundaryCondition::natural
                                                               : given.facets[edge.parent]);
        if (std::ssize(given.coefficients) == shape.pieces.size(1))
            result.conditions.coefficients.push_back(
                edge.parent < 0 ? 1.0 : given.coefficients[edge.parent]);
    }
    std::vector<std::int8_t> orientations;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        for (int i = 0; i < 3; ++i)
            sides(static_cast<Index>(t), i) = numbers[triangles_[t].edges[i]];
        orientations.push_back(triangles_[t].orientation);
    }
    std::vector<Index> names;
    for (Index v = 0; v < first_vertices_; ++v)
        names.push_back(shape.pieces.vertex_number(v));
    for (Index next = first_vertices_ == 0 ? 0 : names.back() + 1; std::ssize(names) < vertices_;)
        names.push_back(next++);
    result.pieces = Pieces({ends, sides}, std::move(orientations), std::move(names));
    const auto of_parents = [&](const Vector& weights) {
        Vector parts(weights.size() == 0 ? 0 : static_cast<Index>(triangles_.size()));
        for (Index t = 0; t < parts.size(); ++t)
            parts[t] = weights[triangles_[t].parent];
        return parts;
    };
    result.conductivity = of_parents(shape.conductivity);
    result.density = of_parents(shape.density);

    // halves are exact, and a median is known as well as its triangle is, but for its rounding
    const int generations = *std::max_element(generations_.begin(), generations_.end());
    result.length_error = 0;
    result.metric_error = metric_share(shape) + generations *
                                                    std::numeric_limits<double>::epsilon() *
                                                    most_sensitivity(result);
    return result;
}

} // namespace

Shape bisected(const Shape& shape, const std::vector<Index>& triangles) {
    if (shape.pieces.dimension() != 2)
        throw InvalidInput(fmt::format("triangles of a shape of dimension {} cannot be bisected: "
                                       "expected a surface",
                                       shape.pieces.dimension()));
    Bisection bisection(shape);
    for (int times = 1; times <= 2; ++times)
        for (const Index t : triangles)
            if (!bisection.is_new(t, times))
                bisection.bisect(t);
    return bisection.result(shape);
}

} // namespace polydec
