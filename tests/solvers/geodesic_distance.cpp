// SPDX-License-Identifier: MIT
#include "solvers/surfaces/heat_step.h"
#include "solvers/surfaces/surface_metric.h"
#include "tests/solvers/glued_samples.h"

namespace polydec::test::in_geodesic_distance {

constexpr Index from_0[] = {0};

using Distance = std::function<double(const GluedSample&, Index)>;

double on_the_sphere(const GluedSample& sphere, Index v) {
    const Eigen::Vector3d a = sphere.points.row(0), b = sphere.points.row(v);
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double in_the_plane(const GluedSample& sample, Index v) {
    return (sample.points.row(v) - sample.points.row(0)).norm();
}

double on_the_torus(const GluedSample& torus, Index v) {
    const double x = torus.points(v, 0), y = torus.points(v, 1);
    return std::hypot(std::min(x, 1 - x), std::min(y, 1 - y));
}

/// From vertex 0, at the origin, whose copies in the plane are all whole numbers: they are those of
/// the torus. From elsewhere they are not.
double on_the_bottle(const GluedSample& bottle, Index source, Index v) {
    const double x = bottle.points(source, 0), y = bottle.points(source, 1);
    double least = 2;
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            least = std::min(least, std::hypot(bottle.points(v, 0) - x - i,
                                               bottle.points(v, 1) - (i % 2 == 0 ? y : -y) - j));
    return least;
}

double mean_error(const GluedSample& sample, const Distance& exact, double time_scale) {
    const Vector d =
        heat_distance(sample.surface, sample.lengths, from_0, {.time_scale = time_scale});
    double sum = 0;
    for (Index v = 0; v < sample.surface.vertices(); ++v)
        sum += std::abs(d[v] - exact(sample, v));
    return sum / sample.surface.vertices();
}

double order(double coarse, double fine) {
    return std::log2(coarse / fine);
}

TEST(GeodesicDistance, on_the_sphere_converges_to_the_arc) {
    const double coarse = mean_error(glued(icosphere(24)), on_the_sphere, 4);
    const double fine = mean_error(glued(icosphere(48)), on_the_sphere, 4);
    EXPECT_LT(fine, 0.0009);
    EXPECT_GT(order(coarse, fine), 0.8);
}

TEST(GeodesicDistance, on_the_flat_torus_converges_to_the_shortest_of_all_ways) {
    const double coarse = mean_error(flat(48), on_the_torus, 4);
    const double fine = mean_error(flat(96), on_the_torus, 4);
    EXPECT_LT(fine, 0.004);
    EXPECT_GT(order(coarse, fine), 0.8);
}

TEST(GeodesicDistance, with_the_shortest_time_falls_below_half_a_percent_of_the_size) {
    EXPECT_LT(mean_error(flat(96), on_the_torus, 1), 0.004);
    EXPECT_LT(mean_error(glued(icosphere(48)), on_the_sphere, 1), 0.001);
}

/// Varadhan's formula, sqrt(t) times minus the logarithm of the heat: the method without the unit
/// vectors.
double error_without_unit_vectors(const GluedSample& torus) {
    const SurfaceMetric metric = surface_metric(torus.surface, torus.lengths);
    const Vector times = metric.mean_lengths.cwiseAbs2();
    Vector b = Vector::Zero(torus.surface.vertices());
    b[0] = 1;
    const Vector u = HeatStep(metric, times, "auto")(b);
    double sum = 0;
    for (Index v = 0; v < u.size(); ++v)
        sum += std::abs(-metric.unit * std::sqrt(times[0]) * std::log(u[v] / u[0]) -
                        on_the_torus(torus, v));
    return sum / static_cast<double>(u.size());
}

TEST(GeodesicDistance, is_far_worse_without_unit_vectors) {
    EXPECT_GT(error_without_unit_vectors(flat(96)), 4 * mean_error(flat(96), on_the_torus, 1));
}

TEST(GeodesicDistance, does_not_converge_for_one_time_on_all_meshes) {
    const double coarse = mean_error(flat(48), on_the_torus, 16);
    const double fine = mean_error(flat(96), on_the_torus, 4 * 16);
    EXPECT_LT(order(coarse, fine), 0.3);
}

TEST(GeodesicDistance, on_the_klein_bottle_is_that_of_the_copies_in_the_plane) {
    const auto bottle = flat(64, Closing::klein_bottle);
    const Index source[] = {bottle.surface.tail(6 * (20 * 64 + 9))};
    const Vector d = heat_distance(bottle.surface, bottle.lengths, source);
    double error = 0, as_on_the_torus = 0;
    for (Index v = 0; v < d.size(); ++v) {
        error += std::abs(d[v] - on_the_bottle(bottle, source[0], v)) / d.size();
        const double dx = std::abs(bottle.points(v, 0) - bottle.points(source[0], 0));
        const double dy = std::abs(bottle.points(v, 1) - bottle.points(source[0], 1));
        as_on_the_torus +=
            std::abs(d[v] - std::hypot(std::min(dx, 1 - dx), std::min(dy, 1 - dy))) / d.size();
    }
    EXPECT_LT(error, 0.006);
    EXPECT_GT(as_on_the_torus, 3 * error);
}

TEST(GeodesicDistance, of_irregular_triangles_in_the_plane_is_that_of_the_plane) {
    const auto error = [](int n) {
        return mean_error(glued(perturbed(grid(n, n), 0.3 / n, 5)), in_the_plane, 4);
    };
    const double coarse = error(64), fine = error(128);
    EXPECT_LT(fine, 0.004);
    EXPECT_GT(order(coarse, fine), 0.8);
}

constexpr DistanceMethod methods[] = {DistanceMethod::heat, DistanceMethod::exact};

Vector distance(const GluedSample& sample, std::span<const Index> sources, DistanceMethod method) {
    return geodesic_distance(sample.surface, sample.lengths, sources, {.method = method});
}

/// By which another order of vertices, for example, may change distances.
double rounding(DistanceMethod method) {
    return method == DistanceMethod::heat ? 1e-12 : 1e-13;
}

TEST(GeodesicDistance, scales_with_the_lengths) {
    const auto sphere = glued(icosphere(12));
    for (const double scale : {1e-150, 1e-8, 3.0, 1e8, 1e150}) {
        GluedSample scaled = sphere;
        scaled.lengths *= scale;
        for (const auto method : methods)
            EXPECT_WITHIN(distance(scaled, from_0, method) / scale,
                          distance(sphere, from_0, method),
                          method == DistanceMethod::heat ? 1e-12 : 1e-14);
        // the time must scale, too: another one gives another error
        const Vector other =
            heat_distance(scaled.surface, scaled.lengths, from_0, {.time_scale = 2}) / scale;
        EXPECT_GT((other - distance(sphere, from_0, DistanceMethod::heat)).cwiseAbs().maxCoeff(),
                  1e-5);
    }
}

TEST(GeodesicDistance, does_not_depend_on_the_order_of_vertices) {
    for (const Mesh& mesh :
         {torus(24, 12), perturbed(torus(14, 8), 0.1, 3), perturbed(torus(14, 8), 0.1, 4)})
        for (const auto method : methods) {
            const Renumbered other = shuffled(mesh, 7);
            const auto place = std::find(other.vertices.begin(), other.vertices.end(), 0);
            const Index source[] = {static_cast<Index>(place - other.vertices.begin())};
            const Vector d = distance(glued(mesh), from_0, method);
            const Vector e = distance(glued(other.mesh), source, method);
            EXPECT_WITHIN(e, d(other.vertices), rounding(method));
            EXPECT_GT((e - d).cwiseAbs().maxCoeff(), 0.1);
        }
}

/// How much the distance changes by the reflection x -> -x, which maps the sphere to itself.
double asymmetry(const GluedSample& sphere, Index source) {
    const Index sources[] = {source};
    const Vector d = heat_distance(sphere.surface, sphere.lengths, sources);
    std::map<std::array<double, 3>, double> at;
    const auto key = [&](Index v, double sign) {
        return std::array{sign * sphere.points(v, 0) + 0.0, sphere.points(v, 1),
                          sphere.points(v, 2)};
    };
    for (Index v = 0; v < d.size(); ++v)
        at[key(v, 1)] = d[v];
    double worst = 0;
    for (Index v = 0; v < d.size(); ++v)
        worst = std::max(worst, std::abs(at.at(key(v, -1)) - d[v]));
    return worst;
}

TEST(GeodesicDistance, is_as_symmetric_as_the_mesh) {
    const auto sphere = glued(icosphere(9));
    Index on_the_plane = 0, off_the_plane = 0;
    for (Index v = 0; v < sphere.surface.vertices(); ++v)
        (sphere.points(v, 0) == 0 ? on_the_plane : off_the_plane) = v;
    EXPECT_LT(asymmetry(sphere, on_the_plane), 1e-12);
    EXPECT_GT(asymmetry(sphere, off_the_plane), 0.1);
}

/// From two places, against the least of the distances on the torus from both.
double error_from_two(Index n) {
    const auto torus = flat(n);
    const Index a = torus.surface.tail(0), b = torus.surface.tail(6 * (n / 2 * n + n / 8));
    const Index both[] = {a, b, a};
    const Vector d = heat_distance(torus.surface, torus.lengths, both, {.time_scale = 1});
    EXPECT_EQ(d[a], 0);
    EXPECT_EQ(d[b], 0);
    EXPECT_GE(d.minCoeff(), 0);
    GluedSample moved = torus;
    for (Index v = 0; v < d.size(); ++v)
        for (int i = 0; i < 2; ++i)
            moved.points(v, i) = std::abs(torus.points(v, i) - torus.points(b, i));
    double sum = 0;
    for (Index v = 0; v < d.size(); ++v)
        sum += std::abs(d[v] - std::min(on_the_torus(torus, v), on_the_torus(moved, v)));
    return sum / static_cast<double>(d.size());
}

TEST(GeodesicDistance, from_several_sources_converges_to_that_from_the_nearest) {
    const double coarse = error_from_two(32), fine = error_from_two(64);
    EXPECT_LT(fine, 0.005);
    EXPECT_GT(order(coarse, fine), 0.8);
    // the distance from one of them is another
    EXPECT_GT(mean_error(
                  flat(64), [](const auto&, Index) { return 0.25; }, 1),
              0.05);
}

TEST(GeodesicDistance, is_0_everywhere_if_all_vertices_are_sources) {
    const auto torus = flat(3);
    std::vector<Index> all(9);
    for (Index v = 0; v < 9; ++v)
        all[v] = v;
    EXPECT_EQ(heat_distance(torus.surface, torus.lengths, all), Vector::Zero(9));
    const auto one = flat(1);
    EXPECT_EQ(heat_distance(one.surface, one.lengths, from_0), Vector::Zero(1));
}

TEST(GeodesicDistance, is_right_where_the_heat_is_too_faint_for_numbers) {
    // 2000 squares in a row: exp(-2000) is no number of double precision
    const auto strip = glued(grid(2000, 1, 2000.0, 1.0));
    const Vector d = heat_distance(strip.surface, strip.lengths, from_0);
    ASSERT_TRUE(d.allFinite());
    for (Index v = 0; v < d.size(); ++v)
        EXPECT_NEAR(d[v], in_the_plane(strip, v), 1);

    const SurfaceMetric metric = surface_metric(strip.surface, strip.lengths);
    const HeatStep step(metric, metric.mean_lengths.cwiseAbs2(), "auto");
    Vector b = Vector::Zero(d.size());
    b[0] = 1;
    EXPECT_EQ(step(b).cwiseAbs().minCoeff(), 0);
    EXPECT_GT(step.from(metric, b).times[0], step.times()[0]);
}

TEST(GeodesicDistance, by_an_engine_that_iterates_is_less_sharp_but_right) {
    const auto torus = flat(64);
    const Vector exact = heat_distance(torus.surface, torus.lengths, from_0);
    const Vector d =
        heat_distance(torus.surface, torus.lengths, from_0, {.linear_solver = "eigen.cg"});
    EXPECT_LT((d - exact).cwiseAbs().mean(), 0.01);
}

TEST(GeodesicDistance, of_each_component_is_its_own) {
    const Mesh one = grid(8, 8);
    const Index n = static_cast<Index>(one.points.rows());
    GluedSample both = glued(united(one, one));
    const Vector lengths = both.lengths;
    const Index sources[] = {0, n};
    for (const auto method : methods)
        for (const double size : {1.0, 1e-5, 1e-200}) {
            if (method == DistanceMethod::heat && size < 1e-100)
                continue; // no number is as small as an area
            both.lengths << lengths.head(lengths.size() / 2),
                size * lengths.tail(lengths.size() / 2);
            const Vector d = distance(glued(one), from_0, method);
            const Vector e = distance(both, sources, method);
            EXPECT_WITHIN(e.head(n), d, rounding(method));
            EXPECT_WITHIN(e.tail(n) / size, d, rounding(method));
            EXPECT_REFUSED(distance(both, from_0, method), "source", "vertex 81");
        }
}

TEST(GeodesicDistance, hardly_depends_on_how_thin_needles_are) {
    const auto wide = glued(with_needle(1e-2));
    const Vector exact = heat_distance(wide.surface, wide.lengths, from_0);
    for (const double width : {1e-3, 1e-6, 1e-9}) {
        const auto thin = glued(with_needle(width));
        const Vector d = heat_distance(thin.surface, thin.lengths, from_0);
        EXPECT_LT((d - exact).cwiseAbs().maxCoeff(), 0.1 / 16) << width;
    }
}

TEST(GeodesicDistance, is_refused_where_needles_leave_no_digits) {
    const auto sample = glued(with_needle(1e-13));
    EXPECT_ERROR(SolverFailure, heat_distance(sample.surface, sample.lengths, from_0), "cotangent",
                 "2e+13", "vertex 145", "triangle 241", "Delaunay");
}

TEST(GeodesicDistance, refuses_lengths_of_no_triangles) {
    for (const auto method : methods) {
        const auto with = [&](Index e, double length) {
            GluedSample torus = flat(2);
            torus.lengths[e] = length;
            return refusal([&] { distance(torus, from_0, method); });
        };
        EXPECT_SAYS(with(4, 0), "edge 4", "vertex 3", "0", "length", "0");
        EXPECT_SAYS(with(4, -1), "edge 4", "vertex 3", "0", "length", "-1");
        EXPECT_SAYS(with(4, NAN), "edge 4", "vertex 3", "0", "length", "nan");
        EXPECT_SAYS(with(4, 1.5), "triangle 3", "vertices 3, 1, 0", "0.7071067811865476", "0.5",
                    "1.5");
        EXPECT_EQ(with(4, 0.5), "accepted");
        GluedSample torus = flat(2);
        torus.lengths = Vector::Ones(3);
        EXPECT_REFUSED(distance(torus, from_0, method), "3 lengths", "12 edges");
    }
    GluedSample square = glued(grid(5, 5));
    square.lengths.setConstant(std::numeric_limits<double>::max() / 2);
    EXPECT_REFUSED(distance(square, from_0, DistanceMethod::exact), "vertex", "range");
}

TEST(GeodesicDistance, refuses_sources_and_times_that_make_no_sense) {
    const auto torus = flat(3);
    for (const auto method : methods) {
        const auto from = [&](const std::vector<Index>& sources) {
            return refusal([&] { distance(torus, sources, method); });
        };
        EXPECT_SAYS(from({9}), "vertex 9", "source", "0", "8");
        EXPECT_SAYS(from({-1}), "vertex -1", "source", "0", "8");
        EXPECT_SAYS(from({}), "source", "vertex 0");
        EXPECT_EQ(from({8}), "accepted");
    }
    const auto with = [&](double time_scale) {
        return refusal([&] {
            heat_distance(torus.surface, torus.lengths, from_0, {.time_scale = time_scale});
        });
    };
    EXPECT_SAYS(with(0), "time scale", "0", "1e-6", "1e6");
    EXPECT_SAYS(with(NAN), "time scale", "nan", "1e-6", "1e6");
    EXPECT_EQ(with(1e6), "accepted");
}

} // namespace polydec::test::in_geodesic_distance
