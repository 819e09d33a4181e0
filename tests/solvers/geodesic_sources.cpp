// SPDX-License-Identifier: MIT
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_geodesic_sources {

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
    GeodesicDistance solver(square.surface, square.lengths, by_heat());
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
        heat_distance(square.surface, square.lengths, near_boundary(square, 1.0 / 128));
    EXPECT_EQ((d.array() == 0).count(), 4 * 128 + 4 * 126);
}

TEST(GeodesicSources, in_turn_have_the_distances_of_a_solver_of_their_own) {
    const auto torus = flat(24);
    GeodesicDistance solver(torus.surface, torus.lengths, by_heat());
    const std::vector<std::vector<Index>> calls{{0}, {100}, {5, 7}, {5, 7, 9}, {7, 5}, {301, 301}};
    for (const auto& sources : calls) {
        const Vector own = heat_distance(torus.surface, torus.lengths, sources);
        EXPECT_LT((solver.to(sources).values - own).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_GT(
            (solver.to(sources).values - solver.to(calls.front()).values).cwiseAbs().maxCoeff(),
            sources == calls.front() ? -1 : 0.1);
    }
}

TEST(GeodesicSources, beside_negative_duals_are_told_of_flips_and_not_of_stars) {
    const Mesh mesh = perturbed(grid(4, 4), 0.06, 1);
    const std::vector<Index> source{0};
    for (const StarKind kind :
         {StarKind::circumcentric, StarKind::automatic, StarKind::hybrid, StarKind::galerkin}) {
        const auto told = GeodesicDistance(discretize(mesh, {.star = kind}), by_heat()).to(source);
        ASSERT_FALSE(told.warnings.empty());
        for (const auto& warning : told.warnings) {
            EXPECT_SAYS(warning, "distances", "add", "delaunay");
            EXPECT_EQ(warning.find("tar"), std::string::npos);
        }
        const Discretization mended =
            discretize(mesh, {.delaunay = Delaunay::flips_and_splits, .star = kind});
        EXPECT_TRUE(GeodesicDistance(mended, by_heat()).to(source).warnings.empty());
    }
}

TEST(GeodesicSources, have_the_values_counted_that_are_raised_to_them) {
    // a ribbon of triangles that are long along it and far from Delaunay
    Mesh mesh = perturbed(grid(24, 24), 0.3 / 24, 1);
    mesh.points.col(1) *= 0.05;
    const auto sample = glued(mesh);
    GeodesicDistance solver(sample.surface, sample.lengths, by_heat());
    const std::vector<Index> sources{1, 38, 75, 112};
    const auto [d, raised, warnings] = solver.to(sources);
    EXPECT_GE(d.minCoeff(), 0);
    EXPECT_GT(raised, 0);
    EXPECT_EQ((d.array() == 0).count(), raised + 4);
}

/// Near the corners heat from two sides adds up, and one that was poured out would be worst there.
TEST(GeodesicSources, of_the_heat_method_are_all_as_warm) {
    const auto square = glued(grid(20, 20));
    const auto boundary = near_boundary(square, 0);
    const Vector heat = heat_distance(square.surface, square.lengths, boundary);
    const Vector exact = geodesic_distance(square.surface, square.lengths, boundary);
    double least = 1;
    for (Index v = 0; v < exact.size(); ++v)
        if (exact[v] > 0)
            least = std::min(least, heat[v] / exact[v]);
    EXPECT_GT(least, 0.55);
    EXPECT_LT(least, 0.65); // smoothed even so
}

TEST(GeodesicSources, have_exact_distances_unless_heat_is_asked_for) {
    for (const double size : {1.0, 1e-150, 1e150}) {
        Mesh mesh = perturbed(grid(9, 9), 0.01, 3);
        mesh.points *= size;
        const auto sample = glued(mesh);
        const std::vector<Index> sources{0, 57};
        const Vector exact = exact_distance(sample.surface, sample.lengths, sources) / size;
        for (const Delaunay delaunay : {Delaunay::off, Delaunay::flips}) {
            const auto bundle = discretize(mesh, {.delaunay = delaunay});
            const auto [d, raised, warnings] = GeodesicDistance(bundle).to(sources);
            EXPECT_LT((d / size - exact).cwiseAbs().maxCoeff(), 1e-13);
            EXPECT_EQ(raised, 0);
            EXPECT_TRUE(warnings.empty());
            EXPECT_GT((heat_distance(bundle, sources) / size - exact).cwiseAbs().maxCoeff(), 1e-3);
        }
    }
}

TEST(GeodesicSources, have_no_heat_to_scale_or_solve_for_in_exact_distances) {
    const auto torus = flat(3);
    const auto with = [&](const GeodesicOptions& options) {
        return refusal([&] { GeodesicDistance(torus.surface, torus.lengths, options); });
    };
    for (const auto& options :
         {GeodesicOptions{.time_scale = 2}, GeodesicOptions{.time_scale = NAN},
          GeodesicOptions{.linear_solver = "eigen.ldlt"}}) {
        EXPECT_SAYS(with(options), "time_scale", "linear_solver", "heat");
        EXPECT_EQ(with(by_heat({.linear_solver = "eigen.cg"})), "accepted");
    }
}

} // namespace polydec::test::in_geodesic_sources
