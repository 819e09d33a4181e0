// SPDX-License-Identifier: MIT
#include "dec/discretization/advice.h"

#include "base/errors.h"
#include "complex/surfaces/glued_surface.h"
#include "dec/metric/triangle.h"
#include "dec/stars/star.h"
#include "dec/surfaces/intrinsic_delaunay.h"

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
    if (remedy == Remedy::flips)
        options.delaunay = Delaunay::flips;
    if (remedy == Remedy::splits)
        options.delaunay = Delaunay::flips_and_splits;
    return options;
}

namespace {

/// Whether the duals of all boundary edges, and of all other edges that merging leaves, are
/// positive.
bool are_positive(const GluedSurface& surface, const Vector& lengths,
                  const DiscretizeOptions& options) {
    Vector stars = Vector::Zero(surface.edges());
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        const double a = lengths[surface.edge(h)];
        const double b = lengths[surface.edge(Triangles::next(h))];
        const double c = lengths[surface.edge(Triangles::previous(h))];
        stars[surface.edge(h)] += corner_cotangent(a, b, c, triangle_area(a, b, c)) / 2;
    }
    for (Index e = 0; e < surface.edges(); ++e)
        if ((surface.is_boundary(e) || options.criterion == MergeCriterion::none) &&
            !(stars[e] > options.tolerance))
            return false;
    return true;
}

/// Whether flips, and splits if the options allow them, make every dual of a surface positive.
/// Flips only increase an angle opposite the boundary. Gives up after many flips: a fan of all
/// triangles around one vertex may need as many as there are pairs of edges.
bool are_cure(const SimplicialComplex& triangles, const Vector& lengths,
              const DiscretizeOptions& options) {
    const bool splits = options.delaunay == Delaunay::flips_and_splits;
    const GluedSurface surface(triangles);
    if (!splits && options.criterion != MergeCriterion::none &&
        !are_positive(surface, lengths, options))
        return false;
    constexpr Index many = 20; // per edge
    try {
        const auto tried = intrinsic_delaunay(
            surface, lengths,
            {splits ? BoundaryEdges::split : BoundaryEdges::keep, options.tolerance, many});
        return are_positive(tried.surface, tried.lengths, options);
    } catch (const Error&) {
        return false; // e.g. at a sharp corner
    }
}

/// Whether discretize flips edges with these options.
bool allow_flips(const DiscretizeOptions& options) {
    return options.criterion != MergeCriterion::angle && options.materials == Materials::join &&
           options.centers.are_circumcenters();
}

} // namespace

Remedy remedy(const SimplicialComplex& input, const Vector& lengths,
              const DiscretizeOptions& options) {
    if (allow_flips(options) && GluedSurface::accepts(input))
        for (const Remedy next : {Remedy::flips, Remedy::splits}) {
            const auto tried = with(next, options);
            if (tried.delaunay > options.delaunay && are_cure(input, lengths, tried))
                return next;
        }
    return Remedy::stars;
}

Remedy remedy(const Discretization& mesh) {
    const StarKind kind = mesh.chosen_stars().kind;
    const bool is_hybrid = kind == StarKind::hybrid;
    const bool is_well =
        is_hybrid ? star(mesh.volumes(), 1).negatives().empty() : all_positive(mesh.volumes());
    if (is_well || !mesh.options().centers.are_circumcenters() ||
        (kind != StarKind::circumcentric && !is_hybrid))
        return Remedy::none;
    const Remedy found =
        remedy(mesh.input(), mesh.input_geometry().volumes().primal(1), mesh.options());
    return found == Remedy::stars && is_hybrid ? Remedy::none : found;
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
    const auto& volumes = discretization.volumes();
    if (discretization.chosen_stars().kind != StarKind::circumcentric)
        return {};
    const auto [k, negative] =
        of_highest_degree(volumes, [](const HodgeStar& star) { return star.negatives(); });
    const auto [degree, zero] =
        of_highest_degree(volumes, [](const HodgeStar& star) { return star.zeros(); });
    if (negative.empty() && !zero.empty())
        return {{degree, static_cast<Index>(zero.size()), false, false, Remedy::stars}};
    const Remedy next = remedy(discretization);
    if (next == Remedy::none)
        return {};
    const auto& cofaces = discretization.complex().coface_counts(k);
    const bool on_boundary =
        k == discretization.dimension() - 1 &&
        std::all_of(negative.begin(), negative.end(), [&](Index f) { return cofaces[f] == 1; });
    return {{k, static_cast<Index>(negative.size()), true, on_boundary, next}};
}

std::string flip_advice(const Discretization& mesh) {
    const Remedy next = remedy(mesh);
    return next == Remedy::flips || next == Remedy::splits ? fmt::format("; add {}", option(next))
                                                           : "";
}

std::vector<std::string> warning_of_negative_duals(const Cells& cells, int k,
                                                   std::string_view consequence) {
    const auto count = cells.stars()[k].negatives().size();
    if (count == 0)
        return {};
    return {fmt::format("{} of the {}-cells {} a negative dual (not Delaunay there, or a center "
                        "beyond the boundary): {}",
                        count, k, count == 1 ? "has" : "have", consequence)};
}

void warn_of_hybrid_stars(const SimplicialComplex& input, const Vector& lengths,
                          const CellVolumes& volumes, const DiscretizeOptions& options,
                          std::vector<std::string>& warnings) {
    const bool is_hybrid =
        (options.star == StarKind::automatic || options.star == StarKind::hybrid) &&
        automatic_kind(volumes.dimension(), false) == StarKind::hybrid && !all_positive(volumes);
    const auto count = is_hybrid ? star(volumes, 1).negatives().size() : 0;
    if (count == 0 || !options.centers.are_circumcenters())
        return;
    if (const Remedy cure = remedy(input, lengths, options); cure != Remedy::stars)
        warnings.push_back(fmt::format("{} dual edge{} negative, so the stars are hybrid and the "
                                       "answers less accurate than possible: add {}",
                                       count, count == 1 ? " is" : "s are", option(cure)));
}

std::string positive_stars(int dimension) {
    const std::string stars =
        fmt::format("stars that are positive on every mesh ({})", option(Remedy::stars));
    if (dimension != GluedSurface::dimension)
        return stars;
    return fmt::format("{}, or on a manifold intrinsic flips ({})", stars, option(Remedy::splits));
}

} // namespace polydec
