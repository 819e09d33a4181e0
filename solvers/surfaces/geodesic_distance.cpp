// SPDX-License-Identifier: MIT
#include "solvers/surfaces/geodesic_distance.h"

#include "base/errors.h"
#include "dec/discretization/advice.h"
#include "dec/metric/side_lengths.h"
#include "meshes/unit_of_length.h"
#include "shape/geodesics.h"
#include "solvers/surfaces/heat_distance.h"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace polydec {

const char* name(DistanceMethod method) {
    constexpr std::array names{"exact", "heat"};
    return names[static_cast<std::size_t>(method)];
}

struct GeodesicDistance::Parts {
    Triangles surface;
    Vector lengths;
    std::optional<HeatDistance> heat = {};
};

GeodesicDistance::GeodesicDistance(const Triangles& surface, const Vector& lengths,
                                   const GeodesicOptions& options)
    : parts_(std::make_shared<Parts>(Parts{surface, lengths})) {
    check_lengths(surface, lengths);
    if (options.method == DistanceMethod::heat) {
        parts_->heat.emplace(surface, lengths, options.time_scale, options.linear_solver);
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
    const Vector distance = parts_->heat
                                ? parts_->heat->to(sources)
                                : exact_distance(parts_->surface, parts_->lengths, sources);
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
