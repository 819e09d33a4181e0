// SPDX-License-Identifier: MIT
#include "dec/advice.h"

#include "complex/surfaces/glued_surface.h"
#include "dec/forms/star.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

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
                                                 : Remedy::stars;
}

std::string in_words(const Advice& advice, int dimension) {
    const int dual = dimension - advice.degree;
    return fmt::format("{} {}dual {}{}{}{}: add {}", advice.cells,
                       advice.negative ? "negative " : "",
                       dual == 1 ? "edge" : fmt::format("{}-cell", dual),
                       advice.cells == 1 ? "" : "s", advice.negative ? "" : " without volume",
                       advice.on_boundary ? " on the boundary" : "", option(advice.remedy));
}

namespace {

/// The k-cells that `find` finds in the star of the highest degree where it finds some.
template <class Find>
std::pair<int, std::vector<Index>> of_highest_degree(const CellVolumes& volumes, Find find) {
    int k = volumes.dimension();
    std::vector<Index> cells;
    while (cells.empty() && k > 0)
        cells = find(star(volumes, --k));
    return {k, cells};
}

} // namespace

std::vector<Advice> advice(const Discretization& discretization) {
    const Remedy next = remedy(discretization);
    if (next == Remedy::none)
        return {};
    const auto& volumes = discretization.volumes();
    const auto [k, negative] =
        of_highest_degree(volumes, [](const HodgeStar& star) { return star.negatives(); });
    if (negative.empty()) {
        const auto [degree, zero] =
            of_highest_degree(volumes, [](const HodgeStar& star) { return star.zeros(); });
        if (zero.empty())
            return {};
        return {{degree, static_cast<Index>(zero.size()), false, false, Remedy::stars}};
    }

    // flips are of edges inside, and splits of those on the boundary
    const auto& cofaces = discretization.complex().coface_counts(k);
    const bool of_facets = k == discretization.dimension() - 1;
    const auto boundary = std::count_if(negative.begin(), negative.end(), [&](Index cell) {
        return next != Remedy::stars && of_facets && cofaces[cell] == 1;
    });
    const auto inside = static_cast<Index>(negative.size()) - static_cast<Index>(boundary);
    std::vector<Advice> list;
    if (inside > 0 && next != Remedy::splits)
        list.push_back({k, inside, true, false, next});
    if (boundary > 0)
        list.push_back({k, static_cast<Index>(boundary), true, true, Remedy::splits});
    return list;
}

std::string flip_advice(const Discretization& mesh) {
    const Remedy next = remedy(mesh);
    return next == Remedy::flips || next == Remedy::splits ? fmt::format("; add {}", option(next))
                                                           : "";
}

std::vector<std::string> warning_of_negative_duals(const Discretization& mesh, int k,
                                                   std::string_view consequence) {
    const auto cells = mesh.stars()[k].negatives().size();
    if (cells == 0)
        return {};
    return {fmt::format("{} of the {}-cells {} a negative dual (the mesh is not Delaunay there): "
                        "{}{}",
                        cells, k, cells == 1 ? "has" : "have", consequence, flip_advice(mesh))};
}

std::string positive_stars(int dimension) {
    const std::string stars =
        fmt::format("stars that are positive on every mesh ({})", option(Remedy::stars));
    if (dimension != GluedSurface::dimension)
        return stars;
    return fmt::format("{}, or on a manifold intrinsic flips ({})", stars, option(Remedy::splits));
}

} // namespace polydec
