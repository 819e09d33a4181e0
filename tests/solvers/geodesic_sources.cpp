// SPDX-License-Identifier: MIT
#include "meshes/generate.h"
#include "meshes/rearrange.h"
#include "solvers/surfaces/geodesic_distance.h"
#include "tests/solvers/glued_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polydec::test::in_geodesic_sources {
namespace {

/// Vertices of an n x n grid of the unit square, by how far from the boundary they are at most.
std::vector<Index> near_boundary(const GluedSample& square, double distance) {
    std::vector<Index> result;
    for (Index v = 0; v < square.surface.vertices(); ++v)
        if (std::min(square.points.row(v).minCoeff(), 1 - square.points.row(v).maxCoeff()) <=
            distance)
            result.push_back(v);
    return result;
}

double error_from_the_boundary(int n) {
    const auto square = glued(grid(n, n));
    GeodesicDistance solver(square.surface, square.lengths);
    const auto [d, raised, warnings] = solver.to(near_boundary(square, 0));
    EXPECT_EQ((d.array() == 0).count(), 4 * n);
    EXPECT_EQ(raised, 0);
    double sum = 0;
    for (Index v = 0; v < d.size(); ++v)
        sum += std::abs(
            d[v] - std::min(square.points.row(v).minCoeff(), 1 - square.points.row(v).maxCoeff()));
    return sum / static_cast<double>(d.size());
}

TEST(GeodesicSources, on_the_boundary_are_0_and_no_other_vertex) {
    const double coarse = error_from_the_boundary(64), fine = error_from_the_boundary(128);
    EXPECT_LT(fine, 0.0035);
    EXPECT_GT(std::log2(coarse / fine), 0.8);
    // one row more as sources is another distance
    const auto square = glued(grid(128, 128));
    const Vector d =
        geodesic_distance(square.surface, square.lengths, near_boundary(square, 1.0 / 128));
    EXPECT_EQ((d.array() == 0).count(), 4 * 128 + 4 * 126);
}

TEST(GeodesicSources, in_turn_have_the_distances_of_a_solver_of_their_own) {
    const auto torus = flat(24);
    GeodesicDistance solver(torus.surface, torus.lengths);
    const std::vector<std::vector<Index>> calls{{0}, {100}, {5, 7}, {5, 7, 9}, {7, 5}, {301, 301}};
    for (const auto& sources : calls) {
        const Vector own = geodesic_distance(torus.surface, torus.lengths, sources);
        EXPECT_LT((solver.to(sources).values - own).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_GT(
            (solver.to(sources).values - solver.to(calls.front()).values).cwiseAbs().maxCoeff(),
            sources == calls.front() ? -1 : 0.1);
    }
}

TEST(GeodesicSources, have_the_values_counted_that_are_raised_to_them) {
    // a ribbon of triangles that are long along it and far from Delaunay
    Mesh mesh = perturbed(grid(24, 24), 0.3 / 24, 1);
    mesh.points.col(1) *= 0.05;
    const auto sample = glued(mesh);
    GeodesicDistance solver(sample.surface, sample.lengths);
    const std::vector<Index> sources{1, 38, 75, 112};
    const auto [d, raised, warnings] = solver.to(sources);
    EXPECT_GE(d.minCoeff(), 0);
    EXPECT_GT(raised, 0);
    EXPECT_EQ((d.array() == 0).count(), raised + 4);
}

} // namespace
} // namespace polydec::test::in_geodesic_sources
