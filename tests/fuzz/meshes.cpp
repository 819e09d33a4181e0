// SPDX-License-Identifier: MIT
#include "tests/fuzz/decoder.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/targets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace polydec::fuzz {

namespace {

DiscretizeOptions options_of(int byte) {
    constexpr std::array tolerances{1e-4, 0.0, 1e-12, 0.1};
    constexpr std::array criteria{MergeCriterion::dual_length, MergeCriterion::angle,
                                  MergeCriterion::none};
    constexpr std::array flips{Delaunay::off, Delaunay::flips, Delaunay::flips_and_splits};
    DiscretizeOptions options;
    options.tolerance = tolerances[byte % 4];
    options.criterion = criteria[byte / 4 % 3];
    options.delaunay = flips[byte / 12 % 3];
    return options;
}

/// A power of two, up to 2^512; mostly 1.
double scale_of(int byte) {
    return byte < 192 ? 1.0 : std::ldexp(1.0, 16 * (byte - 224));
}

template <class Mesh>
void require_laws_if_accepted(const Mesh& mesh, const DiscretizeOptions& options) {
    std::optional<Discretization> discretization;
    accepts<SolverFailure>([&] { // of splits of boundary edges, which may have no end
        accepts([&] { discretization.emplace(discretize(mesh, options)); });
    });
    if (discretization) {
        require_laws(*discretization);
        require_poisson(*discretization);
    }
}

/// The edges of these simplices, each once.
Simplices edges_of(const Simplices& simplices) {
    std::vector<std::array<Index, 2>> pairs;
    for (const auto& row : simplices.rowwise())
        for (Eigen::Index i = 0; i < row.size(); ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                pairs.push_back({std::min(row[i], row[j]), std::max(row[i], row[j])});
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Simplices edges(static_cast<Eigen::Index>(pairs.size()), 2);
    for (std::size_t e = 0; e < pairs.size(); ++e)
        edges.row(static_cast<Eigen::Index>(e)) << pairs[e][0], pairs[e][1];
    return edges;
}

} // namespace

/// Dimension, coordinates of a point, options, size, number of points, points, simplices.
void mesh(std::string_view bytes) {
    Decoder decoder(bytes);
    const int n = 1 + decoder.below(4);
    const int ambient = std::max(1, n + decoder.below(4) - 1);
    const auto options = options_of(decoder.byte());
    const double scale = scale_of(decoder.byte());
    const int vertices = 1 + decoder.below(12);
    Mesh mesh;
    mesh.points.resize(vertices, ambient);
    for (double& coordinate : mesh.points.reshaped<Eigen::RowMajor>())
        coordinate = scale * decoder.real();
    mesh.simplices = decoder.simplices(n + 1, vertices);
    require_laws_if_accepted(mesh, options);
}

/// Dimension, options, size, number of lengths that take turns, lengths, simplices.
void lengths(std::string_view bytes) {
    Decoder decoder(bytes);
    const int n = 1 + decoder.below(4);
    const auto options = options_of(decoder.byte());
    const double scale = scale_of(decoder.byte());
    std::vector<double> choices(static_cast<std::size_t>(1 + decoder.below(12)));
    for (double& length : choices)
        length = scale * (5.0 + decoder.real());
    LengthMesh mesh;
    mesh.vertices = 12;
    mesh.simplices = decoder.simplices(n + 1, mesh.vertices);
    mesh.edges = edges_of(mesh.simplices);
    mesh.lengths.resize(mesh.edges.rows());
    for (Eigen::Index e = 0; e < mesh.lengths.size(); ++e)
        mesh.lengths[e] = choices[static_cast<std::size_t>(e) % choices.size()];
    require_laws_if_accepted(mesh, options);
}

} // namespace polydec::fuzz
