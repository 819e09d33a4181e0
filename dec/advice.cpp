// SPDX-License-Identifier: MIT
#include "dec/advice.h"

#include "complex/surfaces/glued_surface.h"
#include "dec/forms/star.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace polydec {

const char* option(Remedy remedy) {
    constexpr std::array options{"", "DiscretizeOptions::delaunay", "Delaunay::flips_and_splits",
                                 "StarKind::automatic"};
    return options[static_cast<std::size_t>(remedy)];
}

DiscretizeOptions with(Remedy remedy, DiscretizeOptions options) {
    if (remedy == Remedy::stars)
        options.star = StarKind::automatic;
    if (remedy != Remedy::flips && remedy != Remedy::splits)
        return options;
    if (options.criterion == MergeCriterion::angle)
        options = {};
    return {.criterion = options.criterion,
            .tolerance = options.tolerance,
            .delaunay = remedy == Remedy::flips ? Delaunay::flips : Delaunay::flips_and_splits};
}

Remedy remedy(const Discretization& discretization) {
    const auto& options = discretization.options();
    if (discretization.chosen_stars().kind != StarKind::circumcentric ||
        !options.centers.are_circumcenters())
        return Remedy::none;
    if (!GluedSurface::accepts(discretization.input()))
        return Remedy::stars;
    return options.delaunay == Delaunay::off     ? Remedy::flips
           : options.delaunay == Delaunay::flips ? Remedy::splits
                                                 : Remedy::none;
}

std::string in_words(const Advice& advice, int dimension) {
    const int dual = dimension - advice.degree;
    return fmt::format("{} negative dual {}{}{}: add {}", advice.cells,
                       dual == 1 ? "edge" : fmt::format("{}-cell", dual),
                       advice.cells == 1 ? "" : "s", advice.on_boundary ? " on the boundary" : "",
                       option(advice.remedy));
}

std::vector<Advice> advice(const Discretization& discretization) {
    const Remedy next = remedy(discretization);
    const int facets = discretization.dimension() - 1;
    int k = facets;
    auto negative = star(discretization.volumes(), k).negatives();
    while (negative.empty() && k > 0)
        negative = star(discretization.volumes(), --k).negatives();

    // flips are of edges inside, and splits of those on the boundary
    const auto& cofaces = discretization.complex().coface_counts(k);
    const auto boundary = std::count_if(negative.begin(), negative.end(), [&](Index cell) {
        return next != Remedy::stars && k == facets && cofaces[cell] == 1;
    });
    const auto inside = static_cast<Index>(negative.size()) - static_cast<Index>(boundary);
    std::vector<Advice> list;
    if (inside > 0 && next != Remedy::splits && next != Remedy::none)
        list.push_back({k, inside, false, next});
    if (boundary > 0 && next != Remedy::none)
        list.push_back({k, static_cast<Index>(boundary), true, Remedy::splits});
    return list;
}

std::string positive_stars(int dimension) {
    const std::string stars =
        fmt::format("stars that are positive on every mesh ({})", option(Remedy::stars));
    if (dimension != GluedSurface::dimension)
        return stars;
    return fmt::format("{}, or on a manifold intrinsic flips ({})", stars, option(Remedy::splits));
}

} // namespace polydec
