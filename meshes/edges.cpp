// SPDX-License-Identifier: MIT
#include "meshes/edges.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polydec {

std::vector<Edge> edges_of(const Simplices& simplices) {
    std::vector<Edge> result;
    for (Index s = 0; s < simplices.rows(); ++s)
        for (Index i = 0; i < simplices.cols(); ++i)
            for (Index j = i + 1; j < simplices.cols(); ++j)
                if (simplices(s, i) != simplices(s, j)) // a repeated corner is the complex's matter
                    result.emplace_back(
                        std::minmax(Index{simplices(s, i)}, Index{simplices(s, j)}));
    sort_unique(result);
    return result;
}

std::vector<Index> used_vertices(const Simplices& simplices) {
    std::vector<Index> result(simplices.data(), simplices.data() + simplices.size());
    sort_unique(result);
    return result;
}

void check_vertices(std::string_view name, const Simplices& rows, Eigen::Index vertices,
                    std::string_view addition) {
    for (Index row = 0; row < rows.rows(); ++row) {
        const auto corners = rows.row(row);
        const auto wrong = std::find_if(corners.begin(), corners.end(),
                                        [&](Index v) { return v < 0 || v >= vertices; });
        if (wrong != corners.end())
            throw InvalidInput(
                fmt::format("{} {}{} (vertices {}) has the vertex {}: {}, since there are {} "
                            "vertices",
                            name, row, addition, fmt::join(corners.begin(), corners.end(), " "),
                            *wrong, expected_numbers(0, vertices - 1), vertices),
                {.degree = static_cast<int>(rows.cols()) - 1,
                 .cells = {row},
                 .vertices = {corners.begin(), corners.end()}});
    }
}

double distance(const Points& points, Index a, Index b) {
    // near 1 by a power of two, squares lose nothing that others keep
    const Vector side = (points.row(b) - points.row(a)).transpose();
    const double largest = side.size() > 0 ? side.cwiseAbs().maxCoeff() : 0;
    if (largest == 0)
        return 0;
    const int exponent = std::isfinite(largest) ? std::ilogb(largest) : 0;
    double squares = 0;
    for (const double x : side)
        squares += std::pow(std::ldexp(x, -exponent), 2);
    const double length = std::ldexp(std::sqrt(squares), exponent);
    if (!std::isfinite(length))
        throw InvalidInput(
            fmt::format("the distance between vertices {} and {} is {}: expected a finite number; "
                        "move them or scale the mesh to a size nearer to 1",
                        a, b, length),
            {.vertices = {a, b}});
    return length;
}

} // namespace polydec
