// SPDX-License-Identifier: MIT
#include "meshes/generate_parts.h"

#include "base/checks.h"
#include "base/errors.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace polydec {

void check_count(std::string_view generator, std::string_view name, std::int64_t value,
                 std::int64_t least, std::int64_t most) {
    if (value < least || value > most)
        throw InvalidInput(
            fmt::format("{}: {} = {} is outside {} .. {}", generator, name, value, least, most));
}

void check_length(std::string_view generator, std::string_view name, double value) {
    check_positive(fmt::format("{}: {}", generator, name), value);
}

void check_sizes(std::string_view generator, double vertices, double cells, int n) {
    constexpr double most = std::numeric_limits<Index>::max();
    for (const auto& [count, noun] : {std::pair{vertices, "vertices"}, std::pair{cells, "cells"}})
        if (count > most)
            throw InvalidInput(fmt::format("{}: {:.10g} {} are too many: expected at most 2^31 - 1",
                                           generator, count, noun));
    // what is being made, and the mesh
    constexpr double copies = 2;
    const double row_bytes = (n + 1.0) * sizeof(Index), point_bytes = n * sizeof(double);
    check_memory(copies * (cells * row_bytes + vertices * point_bytes),
                 fmt::format("{}: a mesh of {:.10g} vertices and {:.10g} cells", generator,
                             vertices, cells));
}

double check_cubes(std::string_view generator, const std::vector<int>& counts, int n, double edge) {
    if (counts.size() != static_cast<std::size_t>(n))
        throw InvalidInput(
            fmt::format("{}: {} counts of cubes are given: expected one for each of the {} axes",
                        generator, counts.size(), n));
    double result = 1.0;
    for (int k = 0; k < n; ++k) {
        check_count(generator, fmt::format("cells[{}]", k), counts[k], 1);
        result *= counts[k];
    }
    check_length(generator, "edge", edge);
    for (int k = 0; k < n; ++k)
        check_length(generator, fmt::format("cells[{}] * edge", k), counts[k] * edge);
    return result;
}

Eigen::Vector2d circle_point(std::int64_t i, std::int64_t n) {
    // The angle is so many quarter turns and the fraction rest / n of another.
    const std::int64_t quarters = 4 * i / n;
    const std::int64_t rest = 4 * i - quarters * n;
    const auto angle = [n](std::int64_t part) {
        return 0.5 * std::numbers::pi * static_cast<double>(part) / static_cast<double>(n);
    };

    Eigen::Vector2d point(std::cos(angle(rest)), std::sin(angle(rest)));
    if (2 * rest == n)
        point.setConstant(std::sqrt(0.5));
    else if (2 * rest > n)
        point = {std::sin(angle(n - rest)), std::cos(angle(n - rest))};

    for (std::int64_t turn = 0; turn < quarters % 4; ++turn)
        point = {0.0 - point.y(), point.x()};
    return point;
}

} // namespace polydec
