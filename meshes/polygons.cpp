// SPDX-License-Identifier: MIT
#include "meshes/polygons.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/groups.h"
#include "base/listed.h"
#include "base/lists.h"
#include "meshes/polygon_splitter.h"
#include "meshes/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace polydec {

namespace {

using Corners = std::span<const Index>;

struct Tallies {
    Tally split;
    Tally too_small;
    Tally repeats;
};

Corners without_repeats(Corners corners, std::vector<Index>& kept) {
    kept.clear();
    for (const Index corner : corners)
        if (kept.empty() || kept.back() != corner)
            kept.push_back(corner);
    while (kept.size() > 1 && kept.back() == kept.front())
        kept.pop_back();
    return kept;
}

/// The polygons of a mesh, tidied and in canonical order, and what they are split into.
class PolygonSplitting {
public:
    PolygonSplitting(const PolygonMesh& polygons, Tallies& tallies)
        : points_(polygons.points), splitter_(polygons.points) {
        std::vector<Index> kept;
        for (Index face = 0; face < polygons.size(); ++face)
            add_face(polygons.face(face), kept, tallies);
    }

    /// Splits all, and those again whose diagonals others have: these few are done in some rounds.
    void split() {
        for (std::size_t face = 0; face < faces(); ++face)
            split(face);
        constexpr int most_rounds = 20;
        for (int round = 0; round < most_rounds; ++round) {
            const auto faces = find_conflicts();
            if (faces.empty())
                break;
            for (const std::size_t face : faces)
                split(face);
        }
    }

    /// The corners of the triangles; appends to `faces_of` the face of each of them.
    std::vector<Index> triangles(std::vector<Index>& faces_of) const {
        std::vector<Index> result;
        result.reserve(3 * triangles_.size());
        for (std::size_t face = 0; face < faces(); ++face) {
            const auto [begin, end] = range(face, 2);
            for (std::size_t t = begin; t < end; ++t) {
                const auto [a, b, c] = triangles_[t];
                result.insert(result.end(), {a, turned_[face] ? c : b, turned_[face] ? b : c});
            }
            faces_of.resize(result.size() / 3, static_cast<Index>(face));
        }
        return result;
    }

private:
    struct Claim {
        std::size_t face;
        PolygonDiagonal diagonal;
    };

    void add_face(Corners corners, std::vector<Index>& kept, Tallies& tallies) {
        const auto face = faces();
        const auto before = corners.size();
        if (before > 3) {
            corners = without_repeats(corners, kept);
            if (corners.size() < before)
                tallies.repeats.add(face, before - corners.size());
        }
        if (corners.size() < 3) {
            tallies.too_small.add(face);
            corners = {};
        } else if (corners.size() > 3) {
            tallies.split.add(face);
        }
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        const auto own = std::span(corners_).last(corners.size());
        turned_.push_back(own.size() > 3 && make_canonical(own));
        offsets_.push_back(corners_.size());
        small_.push_back(small_.back() + (own.empty() ? 1 : 0));
        triangles_.resize(range(face, 2).second);
        diagonals_.resize(range(face, 3).second);
        if (own.size() == 3)
            triangles_.back() = {own[0], own[1], own[2]};
    }

    std::size_t faces() const { return offsets_.size() - 1; }

    Corners corners_of(std::size_t face) const {
        return std::span(corners_).subspan(offsets_[face], offsets_[face + 1] - offsets_[face]);
    }

    /// Of each face with n corners n - less things are kept, none of those without corners.
    std::pair<std::size_t, std::size_t> range(std::size_t face, std::size_t less) const {
        const auto before = [&](std::size_t f) { return offsets_[f] - less * (f - small_[f]); };
        return {before(face), before(face + 1)};
    }

    void split(std::size_t face) {
        const auto corners = corners_of(face);
        if (corners.size() <= 3)
            return;
        const auto avoided = avoided_.find(face);
        const bool fits = splitter_.split(
            corners, avoided == avoided_.end() ? std::vector<EdgeEnds>() : avoided->second);
        if (!fits)
            throw InvalidInput(fmt::format("face {} has {} corners, and a fan of triangles from "
                                           "its lowest-numbered corner does not fill it; expected "
                                           "at most {} corners in this case; split the face first",
                                           face, corners.size(),
                                           PolygonSplitter::most_corners_without_fan),
                               {.degree = 2, .cells = {static_cast<Index>(face)}});
        std::copy(splitter_.triangles().begin(), splitter_.triangles().end(),
                  triangles_.begin() + static_cast<std::ptrdiff_t>(range(face, 2).first));
        std::copy(splitter_.diagonals().begin(), splitter_.diagonals().end(),
                  diagonals_.begin() + static_cast<std::ptrdiff_t>(range(face, 3).first));
    }

    /// Adds to the diagonals to avoid, and gives the faces that are to be split again, ascending.
    std::vector<std::size_t> find_conflicts() {
        std::vector<std::size_t> faces;
        const auto claims = sorted_claims();
        const auto sides = sides_among(claims);
        for (std::size_t begin = 0, end = 0; begin < claims.size(); begin = end) {
            const auto& edge = claims[begin].diagonal.ends;
            while (end < claims.size() && claims[end].diagonal.ends == edge)
                ++end;
            const bool is_side = std::binary_search(sides.begin(), sides.end(), edge);
            if (end - begin == 1 && !is_side)
                continue;
            const auto group = std::span(claims).subspan(begin, end - begin);
            const auto keeper = is_side ? Corners() : corners_of(keeper_of(group));
            for (const auto& claim : group)
                if (!std::ranges::equal(corners_of(claim.face), keeper) && avoid(claim.face, edge))
                    faces.push_back(claim.face);
        }
        sort_unique(faces);
        return faces;
    }

    std::vector<Claim> sorted_claims() const {
        std::vector<Claim> claims;
        claims.reserve(diagonals_.size());
        for (std::size_t face = 0; face < faces(); ++face)
            for (auto [d, end] = range(face, 3); d < end; ++d)
                claims.push_back({face, diagonals_[d]});
        std::sort(claims.begin(), claims.end(), [](const Claim& a, const Claim& b) {
            return a.diagonal.ends != b.diagonal.ends ? a.diagonal.ends < b.diagonal.ends
                                                      : a.face < b.face;
        });
        return claims;
    }

    /// The sides of faces that somebody claims as a diagonal, sorted.
    std::vector<EdgeEnds> sides_among(const std::vector<Claim>& claims) const {
        const Groups with_low(static_cast<Index>(claims.size()), static_cast<Index>(points_.rows()),
                              [&](Index c) { return claims[c].diagonal.ends[0]; });
        std::vector<EdgeEnds> sides;
        for (std::size_t face = 0; face < faces(); ++face) {
            const auto corners = corners_of(face);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
                if (std::ranges::binary_search(with_low[low], high, {},
                                               [&](Index c) { return claims[c].diagonal.ends[1]; }))
                    sides.push_back({low, high});
            }
        }
        std::sort(sides.begin(), sides.end());
        return sides;
    }

    /// The polygon that loses most without the diagonal; of equal ones the first by its corners.
    std::size_t keeper_of(std::span<const Claim> group) const {
        constexpr double rounding = 1e-12;
        double largest = group[0].diagonal.margin;
        for (const auto& claim : group)
            largest = std::max(largest, claim.diagonal.margin);
        const Claim* keeper = nullptr;
        for (const auto& claim : group)
            if (claim.diagonal.margin >= largest - rounding &&
                (keeper == nullptr || std::ranges::lexicographical_compare(
                                          corners_of(claim.face), corners_of(keeper->face))))
                keeper = &claim;
        return keeper->face;
    }

    /// False if that was known: then the polygon has no other diagonal.
    bool avoid(std::size_t face, const EdgeEnds& edge) {
        auto& edges = avoided_[face];
        const auto place = std::lower_bound(edges.begin(), edges.end(), edge);
        const bool is_new = place == edges.end() || *place != edge;
        if (is_new)
            edges.insert(place, edge);
        return is_new;
    }

    const Points& points_;
    PolygonSplitter splitter_;
    std::vector<Index> corners_;
    std::vector<std::size_t> offsets_{0}, small_{0}; ///< of corners; faces without any before
    std::vector<char> turned_;
    std::vector<std::array<Index, 3>> triangles_;
    std::vector<PolygonDiagonal> diagonals_;
    std::map<std::size_t, std::vector<EdgeEnds>> avoided_; ///< by face, sorted
};

std::vector<std::string> warnings_of(const Tallies& tallies) {
    std::vector<std::string> warnings;
    if (tallies.too_small.count > 0)
        warnings.push_back(fmt::format(
            "left out {} with fewer than three corners; the first is face {}",
            counted(tallies.too_small.count, "face", "faces"), tallies.too_small.first));
    if (tallies.repeats.count > 0)
        warnings.push_back(
            fmt::format("removed {} from polygons; the first is in face {}",
                        counted(tallies.repeats.count, "repeated corner", "repeated corners"),
                        tallies.repeats.first));
    if (tallies.split.count > 0)
        warnings.push_back(fmt::format(
            "split {} with more than three corners into triangles; the first is face {}",
            counted(tallies.split.count, "polygon", "polygons"), tallies.split.first));
    return warnings;
}

} // namespace

void PolygonMesh::add(std::span<const Index> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<Index>(corners.size()));
}

bool PolygonMesh::all_have(Index number) const {
    const auto differs = [number](Index begin, Index end) { return end - begin != number; };
    return std::adjacent_find(offsets.begin(), offsets.end(), differs) == offsets.end();
}

void check_polygons(const PolygonMesh& polygons) {
    const auto& offsets = polygons.offsets;
    if (offsets.empty() || offsets.front() != 0 ||
        static_cast<std::size_t>(offsets.back()) != polygons.corners.size() ||
        !std::is_sorted(offsets.begin(), offsets.end()))
        throw InvalidInput(fmt::format("the offsets of the polygons must ascend from 0 to the "
                                       "number of corners, {}",
                                       polygons.corners.size()));
    if (!polygons.tags.empty() && polygons.tags.size() + 1 != offsets.size())
        throw InvalidInput(
            fmt::format("{} tags are given for {} faces; expected one for each face, or none",
                        polygons.tags.size(), offsets.size() - 1));
    for (std::size_t i = 0; i < polygons.corners.size(); ++i) {
        const Index corner = polygons.corners[i];
        if (corner < 0 || corner >= polygons.points.rows()) {
            const auto behind =
                std::upper_bound(offsets.begin(), offsets.end(), static_cast<Index>(i));
            throw InvalidInput(fmt::format("face {} has the vertex {}; {}",
                                           behind - offsets.begin() - 1, corner,
                                           expected_numbers(0, polygons.points.rows() - 1)),
                               {.degree = 2,
                                .cells = {static_cast<Index>(behind - offsets.begin() - 1)},
                                .vertices = {corner}});
        }
    }
}

Mesh split_polygons(PolygonMesh polygons) {
    check_polygons(polygons);
    Mesh mesh;
    if (polygons.all_have(3)) {
        mesh.simplices = simplices_of(polygons.corners, 3);
        mesh.tags = std::move(polygons.tags);
    } else {
        Tallies tallies;
        PolygonSplitting splitting(polygons, tallies);
        splitting.split();
        std::vector<Index> faces;
        mesh.simplices = simplices_of(splitting.triangles(faces), 3);
        mesh.tags = std::move(polygons.tags);
        follow_rows(mesh, faces, polygons.size());
        mesh.warnings = warnings_of(tallies);
    }
    mesh.points = std::move(polygons.points);
    return mesh;
}

} // namespace polydec
