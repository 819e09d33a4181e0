// SPDX-License-Identifier: MIT
#include "backends/mesher/closed_surfaces.h"
#include "backends/mesher/mesher_input.h"
#include "backends/mesher/mesher_output.h"
#include "base/errors.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

using Place = Eigen::Vector3d;

// Facets may be bent by that much, and all that follows is exact but for rounding.
constexpr double tolerance = 10 * bending_tolerance;

/// Polygons on the points of the mesh.
struct Polygons {
    std::vector<Index> corners, offsets{0};
    ClosedSurfaces surfaces;
};

Polygons facets_of(const MesherResult& result) {
    Polygons facets;
    facets.offsets = result.input.offsets;
    for (const Index corner : result.input.corners) {
        const auto place = std::lower_bound(result.used.begin(), result.used.end(), corner);
        facets.corners.push_back(static_cast<Index>(place - result.used.begin()));
    }
    facets.surfaces = closed_surfaces(result.output.points, facets.corners, facets.offsets);
    return facets;
}

Polygons pieces_of(const MesherResult& result) {
    Polygons pieces;
    const auto& faces = result.output.faces;
    for (Eigen::Index i = 0; i < faces.rows(); ++i) {
        pieces.corners.insert(pieces.corners.end(), {faces(i, 0), faces(i, 1), faces(i, 2)});
        pieces.offsets.push_back(static_cast<Index>(pieces.corners.size()));
    }
    pieces.surfaces = closed_surfaces(result.output.points, pieces.corners, pieces.offsets);
    const auto& [part, outward, volumes, reach, odd_edge, twisted] = pieces.surfaces;
    if (odd_edge >= 0 || twisted >= 0) {
        result.fail(fmt::format("the faces on the facets do not close at point {}",
                                odd_edge >= 0 ? odd_edge : faces(twisted, 0)));
    }
    return pieces;
}

/// Twice the area vector of a polygon.
Place area(const Points& points, const Polygons& polygons, std::size_t f) {
    const auto first = static_cast<std::size_t>(polygons.offsets[f]);
    const auto corner = [&](std::size_t i) -> Place { return points.row(polygons.corners[i]); };
    Place sum = Place::Zero();
    for (auto i = first + 1; i + 1 < static_cast<std::size_t>(polygons.offsets[f + 1]); ++i)
        sum += (corner(i) - corner(first)).cross(corner(i + 1) - corner(first));
    return sum;
}

/// Facets in one plane, and what is found of them.
struct Patch {
    double area = 0.0, found = 0.0;
};

/// Each face lies in the plane of its facet, and together they have its area.
void check_planes(const MesherResult& result, const Polygons& facets, const Polygons& pieces) {
    const auto planes = facet_planes(result.input);
    const auto numbers = plane_patches(result.input);
    const auto& points = result.output.points;
    std::vector<Patch> patches(numbers.size());
    const auto patch_of = [&](std::size_t f) { return static_cast<std::size_t>(numbers[f]); };
    for (std::size_t f = 0; f < numbers.size(); ++f)
        patches[patch_of(f)].area += area(points, facets, f).norm() / 2.0;
    for (std::size_t i = 0; i < result.output.facets.size(); ++i) {
        const Index facet = result.output.facets[i];
        const auto number = patch_of(static_cast<std::size_t>(facet));
        const FacetPlane& plane = planes[number];
        patches[number].found += area(points, pieces, i).norm() / 2.0;
        for (std::size_t j = 3 * i; j < 3 * i + 3; ++j) {
            if (plane.height(points.row(pieces.corners[j])) > tolerance * plane.size) {
                result.fail(fmt::format("point {} is said to be on facet {}, but is off its plane",
                                        pieces.corners[j], facet_name(result.input, facet)));
            }
        }
    }
    for (std::size_t f = 0; f < patches.size(); ++f) {
        const auto& patch = patches[f];
        if (std::abs(patch.found - patch.area) > tolerance * patch.area) {
            result.fail(fmt::format("facet {} is covered {:.9g} times",
                                    facet_name(result.input, static_cast<Index>(f)),
                                    patch.found / patch.area));
        }
    }
}

/// A hole empties the innermost part around it, up to the parts within that one.
std::vector<bool> filled_parts(const MesherResult& result, const Polygons& facets) {
    const auto& volumes = facets.surfaces.volumes;
    std::vector<bool> filled(volumes.size(), true);
    for (Eigen::Index hole = 0; hole < result.input.holes.rows(); ++hole) {
        const Place place = result.input.holes.row(hole);
        const auto turns =
            windings(result.output.points, facets.corners, facets.offsets, facets.surfaces, place);
        std::size_t innermost = filled.size();
        for (std::size_t part = 0; part < filled.size(); ++part) {
            const bool is_around = turns[part] > 0.5;
            if (is_around && (innermost == filled.size() || volumes[part] < volumes[innermost]))
                innermost = part;
        }
        if (innermost < filled.size())
            filled[innermost] = false;
    }
    return filled;
}

/// For each part of the pieces the part of the facets, by the points that both have.
std::vector<Index> matching_parts(const MesherResult& result, const Polygons& facets,
                                  const Polygons& pieces) {
    std::vector<std::pair<Index, Index>> given, found;
    const auto list = [](const Polygons& polygons, auto& all) {
        for (std::size_t f = 0; f + 1 < polygons.offsets.size(); ++f)
            for (Index i = polygons.offsets[f]; i < polygons.offsets[f + 1]; ++i)
                all.emplace_back(polygons.corners[static_cast<std::size_t>(i)],
                                 polygons.surfaces.part[f]);
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
    };
    list(facets, given);
    list(pieces, found);

    // a point where parts meet tells nothing; each part has others, or its edges would be shared
    std::vector<Index> match(pieces.surfaces.volumes.size(), -1);
    const auto is_alone = [](const auto& all, auto at) {
        return (at == all.begin() || std::prev(at)->first != at->first) &&
               (std::next(at) == all.end() || std::next(at)->first != at->first);
    };
    for (auto at = given.begin(); at != given.end(); ++at) {
        const auto there = std::lower_bound(found.begin(), found.end(), std::pair{at->first, -1});
        if (there == found.end() || there->first != at->first)
            result.fail(fmt::format("point {} is on no face of the facets", at->first));
        if (is_alone(given, at) && is_alone(found, there))
            match[static_cast<std::size_t>(there->second)] = at->second;
    }
    if (std::find(match.begin(), match.end(), -1) != match.end() ||
        match.size() != facets.surfaces.volumes.size())
        result.fail("the faces on the facets make other surfaces than the facets");
    return match;
}

/// Which sides of a face have tetrahedra: inside and outside of the surface that it is on.
struct Sides {
    bool inner = false, outer = false;
};

Sides sides_of(const MesherResult& result, const Polygons& pieces, std::size_t piece) {
    OutwardFace wanted{
        {pieces.corners[3 * piece], pieces.corners[3 * piece + 1], pieces.corners[3 * piece + 2]},
        -1,
        pieces.surfaces.outward[piece]};
    sort_corners(wanted);
    const auto range =
        std::equal_range(result.faces.begin(), result.faces.end(), wanted,
                         [](const auto& a, const auto& b) { return a.corners < b.corners; });
    Sides sides;
    for (auto face = range.first; face != range.second; ++face)
        (face->is_ascending == wanted.is_ascending ? sides.inner : sides.outer) = true;
    return sides;
}

/// Compares what is filled with what should be, and returns the volume that it then has.
double check_filled(const MesherResult& result, const Polygons& facets, const Polygons& pieces) {
    const auto filled = filled_parts(result, facets);
    const auto match = matching_parts(result, facets, pieces);
    std::vector<int> shares(filled.size(), 0); // of the enclosed volume, by the last piece
    std::size_t single = 0;
    for (std::size_t i = 0; i < result.output.facets.size(); ++i) {
        const auto part =
            static_cast<std::size_t>(match[static_cast<std::size_t>(pieces.surfaces.part[i])]);
        const auto [inner, outer] = sides_of(result, pieces, i);
        if (inner != filled[part]) {
            result.fail(fmt::format("the inside at facet {} is {}",
                                    facet_name(result.input, result.output.facets[i]),
                                    inner ? "filled in spite of a hole" : "left empty"));
        }
        shares[part] = static_cast<int>(inner) - static_cast<int>(outer);
        single += inner != outer ? 1 : 0;
    }
    if (single != boundary_size(result.faces))
        result.fail("there are faces on the boundary that are on no facet");
    double volume = 0.0;
    for (std::size_t part = 0; part < shares.size(); ++part)
        volume += shares[part] * facets.surfaces.volumes[part];
    return volume;
}

} // namespace

void check_facets_filled(const MesherResult& result) {
    const auto facets = facets_of(result);
    const auto pieces = pieces_of(result);
    check_planes(result, facets, pieces);
    const double volume = check_filled(result, facets, pieces);
    if (!(std::abs(volume - result.volume) <= tolerance * facets.surfaces.reach)) {
        result.fail(fmt::format("the tetrahedra have the volume {:.12g}, and {:.12g} is enclosed, "
                                "in units of a power of two near the size of the whole",
                                result.volume, volume));
    }
}

} // namespace polydec
