// SPDX-License-Identifier: MIT
#include "solvers/geodesic_distance.h"

#include "solvers/constrained_system.h"
#include "solvers/surface_metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

ConstrainedSystem poisson_system(const GluedSurface& surface, const SurfaceMetric& metric) {
    const auto n = static_cast<std::size_t>(surface.vertices());
    return {.A = surface_laplacian(surface, metric, Vector::Ones(metric.mean_lengths.size())),
            .fixed = std::vector<bool>(n, false),
            .tied = std::vector<bool>(n, false),
            .weights = metric.vertex_areas,
            .definiteness = Definiteness::semidefinite,
            .domain_dimension = 2};
}

/// What decides on the direction of the gradient of the heat in a triangle: its logarithms, which
/// are nearly linear where the heat fades exponentially; or, where some are none, the values.
Eigen::Vector3d levels(const Eigen::Vector3d& u) {
    if (u.minCoeff() > 0)
        return Eigen::Vector3d(std::log(u[0] / u.maxCoeff()), std::log(u[1] / u.maxCoeff()),
                               std::log(u[2] / u.maxCoeff()));
    return u / u.cwiseAbs().maxCoeff();
}

/// The corners of a triangle in the plane, the first at 0 and the second on the first axis.
std::array<Eigen::Vector2d, 3> layout(const GluedSurface& surface, const SurfaceMetric& metric,
                                      Index t) {
    const double length = metric.lengths[surface.edge(3 * t)];
    const double height = 2 * metric.areas[t] / length;
    return {Eigen::Vector2d(0, 0), Eigen::Vector2d(length, 0),
            Eigen::Vector2d(metric.cotangents[3 * t + 1] * height, height)};
}

/// For every vertex, the integral of X . grad(hat function), X the unit vectors against grad u.
Vector against_gradient(const GluedSurface& surface, const SurfaceMetric& metric, const Vector& u) {
    Vector b = Vector::Zero(surface.vertices());
    for (Index t = 0; t < surface.triangles(); ++t) {
        const auto corners = layout(surface, metric, t);
        std::array<Eigen::Vector2d, 3> hats; // gradients, times twice the area
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector2d opposite = corners[(i + 2) % 3] - corners[(i + 1) % 3];
            hats[i] = {-opposite.y(), opposite.x()};
        }
        const Eigen::Vector3d f = levels(
            {u[surface.tail(3 * t)], u[surface.tail(3 * t + 1)], u[surface.tail(3 * t + 2)]});
        const Eigen::Vector2d gradient = (f[1] - f[0]) * hats[1] + (f[2] - f[0]) * hats[2];
        // a difference that is rounding has no direction
        const double size = std::max(hats[1].norm(), hats[2].norm());
        if (!(gradient.norm() > 1e-12 * size))
            continue;
        for (int i = 0; i < 3; ++i)
            b[surface.tail(3 * t + i)] -= gradient.dot(hats[i]) / (2 * gradient.norm());
    }
    return b;
}

/// What to subtract on each component from a function that is known up to a constant: the sources
/// are known to be at 0, and their neighbors at the lengths of the edges to them. The neighbors
/// decide, because the function has a kink at the sources, which spoils its value there.
Vector shifts(const GluedSurface& surface, const SurfaceMetric& metric,
              std::span<const Index> sources, const Vector& distance) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vector known = Vector::Constant(surface.vertices(), far);
    for (const Index v : sources)
        known[v] = 0;
    const Vector at_sources = known;
    for (Index e = 0; e < surface.edges(); ++e) {
        const Index a = surface.first_vertex(e), b = surface.last_vertex(e);
        known[a] = std::min(known[a], at_sources[b] + metric.lengths[e]);
        known[b] = std::min(known[b], at_sources[a] + metric.lengths[e]);
    }
    Vector near = Vector::Zero(metric.mean_lengths.size());
    Vector near_count = near, sum = near, count = near;
    for (Index v = 0; v < surface.vertices(); ++v) {
        const Index c = metric.component[v];
        if (known[v] == 0)
            sum[c] += distance[v], count[c] += 1;
        else if (known[v] < far)
            near[c] += distance[v] - known[v], near_count[c] += 1;
    }
    for (Eigen::Index c = 0; c < near.size(); ++c)
        sum[c] = near_count[c] > 0 ? near[c] / near_count[c] : sum[c] / count[c];
    return sum;
}

} // namespace

struct GeodesicDistance::Parts {
    GluedSurface surface;
    SurfaceMetric metric;
    std::string engine;
    HeatStep step;
    ConstrainedSolver poisson;

    Parts(const GluedSurface& surface_, const Vector& lengths, const GeodesicOptions& options)
        : surface(surface_),
          metric(surface_metric(surface, lengths)),
          engine(options.linear_solver),
          step(surface, metric, options.time_scale * metric.mean_lengths.cwiseAbs2(), engine),
          poisson(poisson_system(surface, metric), engine) {}

    Vector heat(std::span<const Index> sources) {
        Vector b = Vector::Zero(surface.vertices());
        for (const Index v : sources)
            b[v] = 1;
        Vector u = step(b);
        Vector times = step.longer(metric, u);
        for (Vector last = step.times(); times != last;) {
            HeatStep longer(surface, metric, times, engine);
            u = longer(b);
            last = times;
            times = longer.longer(metric, u);
        }
        return u;
    }
};

GeodesicDistance::GeodesicDistance(const GluedSurface& surface, const Vector& lengths,
                                   const GeodesicOptions& options) {
    check_time_scale(options.time_scale);
    parts_ = std::make_unique<Parts>(surface, lengths, options);
}

GeodesicDistance::GeodesicDistance(GeodesicDistance&&) noexcept = default;
GeodesicDistance::~GeodesicDistance() = default;

Vector GeodesicDistance::to(std::span<const Index> sources) {
    const SurfaceMetric& metric = parts_->metric;
    check_sources(parts_->surface, metric, sources);
    Vector distance = explaining_failure(parts_->surface, metric, [&] {
        const Vector b = against_gradient(parts_->surface, metric, parts_->heat(sources));
        return parts_->poisson.solve(b, Vector::Zero(b.size()));
    });

    // known up to a constant on every component
    const Vector shift = shifts(parts_->surface, metric, sources, distance);
    for (Eigen::Index v = 0; v < distance.size(); ++v) {
        const Index c = metric.component[v];
        distance[v] = metric.unit * std::max(0.0, distance[v] - shift[c]);
    }
    for (const Index v : sources)
        distance[v] = 0;
    return distance;
}

Vector geodesic_distance(const GluedSurface& surface, const Vector& lengths,
                         std::span<const Index> sources, const GeodesicOptions& options) {
    return GeodesicDistance(surface, lengths, options).to(sources);
}

Vector geodesic_distance(const Discretization& discretization, std::span<const Index> sources,
                         const GeodesicOptions& options) {
    if (discretization.intrinsic)
        return geodesic_distance(discretization.intrinsic->surface(),
                                 discretization.intrinsic->delaunay.lengths, sources, options);
    return geodesic_distance(GluedSurface(discretization.input()),
                             discretization.input_volumes.primal(1), sources, options);
}

} // namespace polydec
