// SPDX-License-Identifier: MIT
#include "solvers/surfaces/geodesic_distance.h"

#include "base/errors.h"
#include "base/lists.h"
#include "dec/discretization/advice.h"
#include "dec/metric/side_lengths.h"
#include "meshes/unit_of_length.h"
#include "shape/geodesics.h"
#include "shape/sources.h"
#include "solvers/sources/constrained_system.h"
#include "solvers/surfaces/heat_step.h"
#include "solvers/surfaces/surface_metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace polydec {

namespace {

/// The cotangent Laplacian with the pins at 0.
ConstrainedSystem poisson_system(const SurfaceMetric& metric, std::span<const Index> pins) {
    return {.A = surface_laplacian(metric, Vector::Ones(metric.mean_lengths.size())),
            .fixed = marks_at(pins, metric.surface.vertices()),
            .tied = std::vector<bool>(metric.surface.vertices(), false),
            .weights = metric.vertex_areas,
            .definiteness = Definiteness::semidefinite,
            .domain_dimension = 2};
}

/// The values that determine the direction of the heat gradient in a triangle: logarithms, nearly
/// linear where heat decays exponentially; or the heat itself if a logarithm is undefined.
Eigen::Vector3d levels(const Eigen::Vector3d& u) {
    if (u.minCoeff() > 0)
        return Eigen::Vector3d(std::log(u[0] / u.maxCoeff()), std::log(u[1] / u.maxCoeff()),
                               std::log(u[2] / u.maxCoeff()));
    return u / u.cwiseAbs().maxCoeff();
}

/// The corners of a triangle in the plane, the first at 0 and the second on the first axis.
std::array<Eigen::Vector2d, 3> layout(const SurfaceMetric& metric, Index t) {
    const double length = metric.lengths[metric.surface.edge(3 * t)];
    const double height = 2 * metric.areas[t] / length;
    return {Eigen::Vector2d(0, 0), Eigen::Vector2d(length, 0),
            Eigen::Vector2d(metric.cotangents[3 * t + 1] * height, height)};
}

/// For every vertex, the integral of X . grad(hat function), with unit vectors X against grad u.
Vector against_gradient(const SurfaceMetric& metric, const Vector& u) {
    const Triangles& surface = metric.surface;
    Vector b = Vector::Zero(surface.vertices());
    for (Index t = 0; t < surface.triangles(); ++t) {
        const auto corners = layout(metric, t);
        std::array<Eigen::Vector2d, 3> hats; // gradients, times twice the area
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector2d opposite = corners[(i + 2) % 3] - corners[(i + 1) % 3];
            hats[i] = {-opposite.y(), opposite.x()};
        }
        const Eigen::Vector3d f = levels(
            {u[surface.tail(3 * t)], u[surface.tail(3 * t + 1)], u[surface.tail(3 * t + 2)]});
        const Eigen::Vector2d gradient = (f[1] - f[0]) * hats[1] + (f[2] - f[0]) * hats[2];
        // a difference at rounding level has no direction
        const double size = std::max(hats[1].norm(), hats[2].norm());
        if (!(gradient.norm() > 1e-12 * size))
            continue;
        for (int i = 0; i < 3; ++i)
            b[surface.tail(3 * t + i)] -= gradient.dot(hats[i]) / (2 * gradient.norm());
    }
    return b;
}

/// Marks the vertices opposite to an edge between two sources: the distance grows evenly away from
/// such an edge.
std::vector<bool> beside_source_edges(const Triangles& surface,
                                      const std::vector<bool>& is_source) {
    std::vector<bool> marks(is_source.size(), false);
    for (Index h = 0; h < 3 * surface.triangles(); ++h)
        if (is_source[surface.tail(h)] && is_source[surface.head(h)])
            marks[surface.tail(surface.previous(h))] = true;
    return marks;
}

/// The constant to subtract on each component from a function that is 0 at the sources. Around an
/// isolated source the distance has a kink that piecewise linear functions miss, so all other
/// values have the same offset. Its neighbors determine the offset: their distances are the lengths
/// of their edges to it.
Vector shifts(const SurfaceMetric& metric, std::span<const Index> sources, const Vector& distance) {
    const Triangles& surface = metric.surface;
    constexpr double far = std::numeric_limits<double>::infinity();
    const auto is_source = marks_at(sources, surface.vertices());
    Vector known = Vector::Constant(surface.vertices(), far);
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        const Index a = surface.tail(h), b = surface.head(h);
        const double length = metric.lengths[surface.edge(h)];
        if (is_source[a])
            known[b] = std::min(known[b], length);
        if (is_source[b])
            known[a] = std::min(known[a], length);
    }
    const auto beside = beside_source_edges(surface, is_source);
    Vector sum = Vector::Zero(metric.mean_lengths.size()), count = sum;
    for (Index v = 0; v < surface.vertices(); ++v)
        if (const Index c = metric.component[v]; known[v] < far && !is_source[v]) {
            sum[c] += beside[v] ? 0 : distance[v] - known[v];
            count[c] += 1;
        }
    return sum.cwiseQuotient(count.cwiseMax(1));
}

/// Distance by the heat method. The surface may branch: each triangle has its own plane, so any
/// number of triangles may meet at an edge. If heat far away is too faint for trusted digits, the
/// time is extended on that component for that call. With a direct engine this begins some 500
/// edges from the sources; with an iterative one, at 18 edges.
/// Source: Crane, Weischedel, Wardetzky, Geodesics in Heat, ACM Trans. Graph. 32(5), 2013; the
/// logarithm is new here.
class HeatDistance {
public:
    HeatDistance(const Triangles& surface, const Vector& lengths, const GeodesicOptions& options)
        : metric_((check_time_scale(options.time_scale), surface_metric(surface, lengths))),
          engine_(options.linear_solver),
          step_(metric_, options.time_scale * metric_.mean_lengths.cwiseAbs2(), engine_) {}

    /// In the unit of the lengths; 0 at the sources. Triangles far from Delaunay can cause negative
    /// values.
    Vector to(std::span<const Index> sources) {
        check_sources(metric_.surface, sources);
        std::vector<Index> pins(sources.begin(), sources.end());
        sort_unique(pins);
        Vector distance = explaining_failure(
            metric_, [&] { return fit(against_gradient(metric_, heat(pins)), pins); });
        distance -= shifts(metric_, pins, distance)(metric_.component);
        for (const Index v : pins)
            distance[v] = 0;
        return metric_.unit * distance;
    }

private:
    bool is_single(std::span<const Index> pins) const {
        return Eigen::Index(pins.size()) == metric_.mean_lengths.size();
    }

    /// Heat with one value at the pins of a component. A single pin emits heat, which gives it some
    /// constant value, so one factorization serves all pins. Several pins are held at 1: else a pin
    /// with little area around it would get hotter than the others and heat them.
    Vector heat(std::span<const Index> pins) const {
        Vector b = Vector::Zero(metric_.surface.vertices());
        if (!is_single(pins))
            return HeatStep(metric_, step_.times(), engine_, pins).from(metric_, b).u;
        for (const Index v : pins)
            b[v] = 1;
        return step_.from(metric_, b).u;
    }

    /// The function that is 0 at the pins and fits b elsewhere. With one pin per component, pins
    /// change it only by a constant, so one factorization serves them all.
    Vector fit(const Vector& b, std::span<const Index> pins) {
        const bool single = is_single(pins);
        if (!(single && poisson_ && is_for_single_sources_)) {
            poisson_.emplace(poisson_system(metric_, pins), engine_);
            is_for_single_sources_ = single;
        }
        Vector u = poisson_->solve(b, Vector::Zero(b.size())).values;
        if (!single)
            return u;
        Vector at_source(metric_.mean_lengths.size());
        for (const Index v : pins)
            at_source[metric_.component[v]] = u[v];
        return u - at_source(metric_.component);
    }

    SurfaceMetric metric_;
    std::string engine_;
    HeatStep step_;
    std::optional<ConstrainedSolver> poisson_;
    bool is_for_single_sources_ = false; // the pins of the factorization
};

} // namespace

const char* name(DistanceMethod method) {
    constexpr std::array names{"exact", "heat"};
    return names[static_cast<std::size_t>(method)];
}

struct GeodesicDistance::Parts {
    Triangles surface;
    Vector lengths;
    Progress progress;
    std::optional<HeatDistance> heat = {};
};

GeodesicDistance::GeodesicDistance(const Triangles& surface, const Vector& lengths,
                                   const GeodesicOptions& options)
    : parts_(std::make_shared<Parts>(Parts{surface, lengths, options.progress})) {
    check_lengths(surface, lengths);
    if (options.method == DistanceMethod::heat) {
        parts_->heat.emplace(surface, lengths, options);
        return;
    }
    const GeodesicOptions defaults;
    if (!(options.time_scale == defaults.time_scale) ||
        options.linear_solver != defaults.linear_solver)
        throw InvalidInput("GeodesicOptions::time_scale and GeodesicOptions::linear_solver apply "
                           "only to the heat method: omit them, or use DistanceMethod::heat");
}

GeodesicDistance::GeodesicDistance(const Discretization& discretization,
                                   const GeodesicOptions& options)
    : GeodesicDistance(Triangles(discretization.pieces()),
                       discretization.geometry().volumes().primal(1), options) {
    unit_ = discretization.unit();
    if (options.method != DistanceMethod::heat)
        return;
    const auto by_duals =
        discretization.with_stars(ChosenStars(discretization.volumes(), StarKind::circumcentric));
    advice_ = flip_advice(by_duals);
    warnings_ = warning_of_negative_duals(by_duals, 1, "distances may be far off" + advice_);
}

Distance GeodesicDistance::to(std::span<const Index> sources) const {
    const Vector distance =
        parts_->heat ? parts_->heat->to(sources)
                     : exact_distance(parts_->surface, parts_->lengths, sources, parts_->progress);
    const auto raised = static_cast<Index>((distance.array() < 0).count());
    Distance result{form_in_input_units(distance.cwiseMax(0), unit_, 1, "distances"), raised,
                    warnings_};
    if (raised > 0)
        result.warnings.push_back(fmt::format("{} of the distances fell below 0 and were raised to "
                                              "0: triangles there are far from Delaunay{}",
                                              raised, advice_));
    return result;
}

Vector geodesic_distance(const Triangles& surface, const Vector& lengths,
                         std::span<const Index> sources, const GeodesicOptions& options) {
    return GeodesicDistance(surface, lengths, options).to(sources).values;
}

Vector geodesic_distance(const Discretization& discretization, std::span<const Index> sources,
                         const GeodesicOptions& options) {
    return GeodesicDistance(discretization, options).to(sources).values;
}

} // namespace polydec
