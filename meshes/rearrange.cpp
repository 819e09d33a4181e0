// SPDX-License-Identifier: MIT
#include "meshes/rearrange.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/random.h"
#include "meshes/edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace polydec {

Mesh perturbed(Mesh mesh, double amplitude, std::uint64_t seed) {
    check_not_negative("perturbed: the amplitude", amplitude);
    Random random(seed);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        for (Eigen::Index k = 0; k < mesh.points.cols(); ++k)
            mesh.points(v, k) += amplitude * (2.0 * random.fraction() - 1.0);
    return mesh;
}

namespace {

void check(const Mesh& mesh, const std::string& what) {
    const auto cells = static_cast<std::size_t>(mesh.simplices.rows());
    if (!mesh.tags.empty() && mesh.tags.size() != cells)
        throw InvalidInput(
            fmt::format("{}: {} tags are given for {} cells: expected one for each, or none", what,
                        mesh.tags.size(), cells));
    check_facet_tags(mesh);
    check_vertices(what + ": cell", mesh.simplices, mesh.points.rows());
}

/// Cells with new vertex numbers, in the old order.
Simplices with_new_numbers(const Simplices& cells, const std::vector<Index>& vertices) {
    std::vector<Index> new_number(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        new_number[vertices[i]] = static_cast<Index>(i);
    return cells.unaryExpr([&](Index vertex) { return new_number[vertex]; });
}

/// The mesh in the order of the lists; `renumbered` are the cells in the old one.
Renumbered arranged(const Mesh& mesh, const Simplices& renumbered, std::vector<Index> vertices,
                    std::vector<Index> cells) {
    Renumbered result{mesh, std::move(vertices), std::move(cells)};
    result.mesh.points = mesh.points(result.vertices, Eigen::indexing::all);
    result.mesh.simplices = renumbered(result.cells, Eigen::indexing::all);
    follow_rows(result.mesh, result.cells, static_cast<Index>(mesh.simplices.rows()));
    if (mesh.input_cells.of_simplices.empty())
        result.mesh.input_cells = {}; // the simplices have new numbers
    auto& facets = result.mesh.facet_tags.simplices;
    facets = with_new_numbers(facets, result.vertices);
    return result;
}

/// Sorts by the bits from this one on, a digit at a time, the last first (Knuth 1973, 5.2.5).
void sort_by_digits(std::vector<std::uint64_t>& words, int first_bit) {
    constexpr int word_bits = 64, digit_bits = 11;
    constexpr std::size_t digits = std::size_t{1} << digit_bits;
    std::vector<std::uint64_t> sorted(words.size());
    for (int bit = first_bit; bit < word_bits; bit += digit_bits) {
        const auto digit = [&](std::uint64_t word) { return word >> bit & (digits - 1); };
        std::array<std::size_t, digits + 1> ends{}; // of the words of each digit, then begins
        for (const std::uint64_t word : words)
            ++ends[digit(word) + 1];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        for (const std::uint64_t word : words)
            sorted[ends[digit(word)]++] = word;
        words.swap(sorted);
    }
}

} // namespace

KeyGroups groups_of(const std::vector<std::uint64_t>& keys) {
    std::uint64_t all = 0;
    for (const std::uint64_t key : keys)
        all |= key;
    const int unused = all > 0 ? std::countl_zero(all) : 0,
              number_bits = std::bit_width(keys.size());
    const std::uint64_t numbers = (std::uint64_t{1} << number_bits) - 1;
    std::vector<std::uint64_t> words(keys.size());
    for (std::size_t number = 0; number < keys.size(); ++number)
        words[number] = (keys[number] << unused & ~numbers) | number;
    sort_by_digits(words, number_bits);

    KeyGroups groups;
    groups.order.reserve(words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
        groups.order.push_back(static_cast<Index>(words[i] & numbers));
        if (i + 1 == words.size() || (words[i] ^ words[i + 1]) > numbers)
            groups.ends.push_back(static_cast<Index>(i) + 1);
    }
    return groups;
}

std::vector<Index> ascending_order(const std::vector<std::uint64_t>& keys) {
    auto [order, ends] = groups_of(keys);
    auto begin = order.begin();
    for (const Index end : ends) {
        std::sort(begin, order.begin() + end,
                  [&](Index a, Index b) { return std::pair(keys[a], a) < std::pair(keys[b], b); });
        begin = order.begin() + end;
    }
    return order;
}

std::vector<std::uint64_t> morton_keys(const Points& points) {
    std::vector<std::uint64_t> keys(points.rows(), 0);
    if (points.size() == 0)
        return keys;
    // halves, whose differences do not overflow
    const Eigen::RowVectorXd least = points.colwise().minCoeff() / 2;
    const double extent = (points.colwise().maxCoeff() / 2 - least).maxCoeff();
    const auto axes = std::min<Eigen::Index>(points.cols(), 63);
    const int digits = static_cast<int>(std::min<Eigen::Index>(63 / axes, 31));
    const double largest = std::ldexp(1.0, digits) - 1;
    // of each byte its digits with room for those of the other axes
    constexpr int byte = 8;
    std::array<std::uint64_t, 1 << byte> spread{};
    for (std::uint64_t number = 0; number < spread.size(); ++number)
        for (int digit = 0; digit < byte && digit * axes < 64; ++digit)
            spread[number] |= (number >> digit & 1U) << (digit * axes);
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
        auto& key = keys[v];
        for (Eigen::Index axis = 0; axis < axes; ++axis) {
            const double share = extent > 0 ? (points(v, axis) / 2 - least[axis]) / extent : 0;
            const auto place = static_cast<std::uint64_t>(share * largest);
            for (int digit = 0; digit < digits; digit += byte)
                key |= spread[place >> digit & (spread.size() - 1)] << (digit * axes + axis);
        }
    }
    return keys;
}

Renumbered shuffled(const Mesh& mesh, std::uint64_t seed) {
    check(mesh, "shuffled");
    Random random(seed);
    auto vertices = random.order(mesh.points.rows());
    auto cells = random.order(mesh.simplices.rows());
    const Simplices renumbered = with_new_numbers(mesh.simplices, vertices);
    return arranged(mesh, renumbered, std::move(vertices), std::move(cells));
}

Renumbered along_morton_curve(const Mesh& mesh) {
    check(mesh, "along_morton_curve");
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        if (!mesh.points.row(v).allFinite())
            throw InvalidInput(
                fmt::format("along_morton_curve: vertex {} has a coordinate that is not finite", v),
                {.vertices = {static_cast<Index>(v)}});
    auto vertices = ascending_order(morton_keys(mesh.points));
    const Simplices renumbered = with_new_numbers(mesh.simplices, vertices);
    std::vector<std::uint64_t> first_vertices;
    first_vertices.reserve(renumbered.rows());
    for (Eigen::Index s = 0; s < renumbered.rows(); ++s)
        first_vertices.push_back(static_cast<std::uint64_t>(renumbered.row(s).minCoeff()));
    return arranged(mesh, renumbered, std::move(vertices), ascending_order(first_vertices));
}

} // namespace polydec
