// SPDX-License-Identifier: MIT
#include "distributed/discretize.h"

#include "base/errors.h"
#include "base/listed.h"
#include "dec/discretization/mesh_warnings.h"
#include "dec/merging/flat_simplices.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/geometry.h"
#include "dec/metric/overlaps.h"
#include "dec/metric/plane.h"
#include "dec/stars/star.h"
#include "distributed/facet_classes.h"
#include "distributed/number_places.h"
#include "distributed/orientation.h"
#include "meshes/boundary_contacts.h"
#include "meshes/unit_of_length.h"
#include "meshes/weld.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace polydec {

namespace {

double common_unit(const Ranks& ranks, const LocalComplex& local, const Points& of_slice) {
    const int n = local.dimension();
    const double longest =
        ranks.largest(half_of_longest_edge(local.points, local.complex.simplices(n)));
    const double farthest =
        ranks.largest(of_slice.size() > 0 ? of_slice.cwiseAbs().maxCoeff() : 0.0);
    return unit_of_length(longest, farthest, n);
}

/// Two opposite corners of the box around the points of the whole mesh.
Points box_of(const Ranks& ranks, const Points& points) {
    const auto N = points.cols();
    std::vector<double> ends(2 * N, -std::numeric_limits<double>::infinity());
    for (Eigen::Index c = 0; c < N && points.rows() > 0; ++c) {
        ends[c] = points.col(c).maxCoeff();
        ends[N + c] = (-points.col(c)).maxCoeff();
    }
    ranks.take_largest(ends);
    Points corners(2, N);
    for (Eigen::Index c = 0; c < N; ++c)
        corners.col(c) << ends[c], -ends[N + c];
    return corners;
}

/// The named simplices of all ranks, which name own ones.
NamedSimplices of_all(const Ranks& ranks, const NamedSimplices& own, int k) {
    std::vector<Index> corners;
    for (const auto& simplex : own.first)
        corners.insert(corners.end(), simplex.begin(), simplex.end());
    corners = ranks.of_all(corners);
    NamedSimplices all{ranks.sum(own.count)};
    for (auto at = corners.begin(); at != corners.end(); at += k + 1)
        all.first.emplace_back(at, at + k + 1);
    std::sort(all.first.begin(), all.first.end());
    return all;
}

/// The owner of a facet sees whether it is a fold. Which half of a part is the smaller one is
/// counted over all ranks; in one-sided parts, which have no halves, each rank goes by what it has.
void warn_of_overlaps(const Ranks& ranks, const LocalComplex& local,
                      std::vector<std::string>& list) {
    const int n = local.dimension();
    if (local.points.cols() != n)
        return;
    const auto look = [&](const std::vector<bool>& against) {
        return ranks.together("overlaps",
                              [&] { return find_overlaps(local.complex, local.points, against); });
    };
    Overlaps found = look({});
    if (ranks.any(!found.folded.empty())) {
        const auto given =
            ranks.together("overlaps", [&] { return sides(local.complex, local.points); });
        const auto most = coherent(ranks, local, given);
        auto against = marks_at(found.folded, local.complex.size(n));
        for (std::size_t t = 0; t < given.size(); ++t)
            if (most[t] != 0)
                against[t] = given[t] != most[t];
        found = look(against);
    }
    const auto named_of_all = [&](int k, std::vector<Index> simplices) {
        std::erase_if(simplices, [&](Index s) { return !local.owns(ranks, k, s); });
        return of_all(ranks, named(local.complex, k, simplices), k);
    };
    const auto folded = named_of_all(n, found.folded), wound = named_of_all(0, found.wound);
    warn_of_overlaps(folded, local.degree(n).count, wound, list);
}

/// Facets of the boundary meet on rank 0, each with the vertex across and the number of its cell.
void warn_of_unjoined(const Ranks& ranks, const MeshSlice& slice, const LocalComplex& local,
                      const Points& box, double unit, std::vector<std::string>& list) {
    const int n = local.dimension();
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    ranks.together("boundary", [&] {
        const auto& counts = local.complex.coface_counts(n - 1);
        const auto& tops = local.complex.simplices(n);
        const FaceTable faces = local.complex.faces(n);
        for (Index t = 0; t < tops.rows(); ++t)
            for (int across = 0; across <= n; ++across) {
                const Index f = faces(t, across);
                if (counts[f] != 1 || !local.owns(ranks, n - 1, f))
                    continue;
                for (int i = 0; i <= n; ++i)
                    if (i != across)
                        parcels[0].push_back(local.vertices[tops(t, i)]);
                parcels[0].push_back(local.vertices[tops(t, across)]);
                parcels[0].push_back(local.degree(n).number[t]);
            }
    });
    const auto arrived = unpacked(ranks.deliver(std::move(parcels)));
    const Eigen::Map<const GlobalSimplices> rows(arrived.data(), std::ssize(arrived) / (n + 2),
                                                 n + 2);
    const GlobalSimplices corners = rows.leftCols(n + 1);
    const NumberPlaces place({corners.data(), static_cast<std::size_t>(corners.size())});
    const Points points = points_of(ranks, slice, place.numbers());
    ranks.together("boundary", [&] {
        const Simplices placed = corners.unaryExpr([&](GlobalIndex v) { return place(v); });
        OpenFacets open{placed.leftCols(n)};
        open.opposite.assign(placed.col(n).begin(), placed.col(n).end());
        open.cells.assign(rows.col(n + 1).begin(), rows.col(n + 1).end());
        open.numbers = names_of(place.numbers());
        const auto found = boundary_contacts(open, in_units(points, unit), weld_length(box));
        polydec::warn_of_unjoined({found.coincident, found.hanging, found.misfits}, n, list);
    });
}

GlobalIndex branching_facets(const Ranks& ranks, const LocalComplex& local) {
    const int facets = local.dimension() - 1;
    GlobalIndex count = 0;
    for (Index f = 0; f < local.degree(facets).size(); ++f)
        if (local.owns(ranks, facets, f) && local.complex.coface_counts(facets)[f] > 2)
            ++count;
    return ranks.sum(count);
}

/// The own n-simplices among those marked that are cells by themselves.
std::vector<Index> alone(const Ranks& ranks, const LocalComplex& local,
                         const DistributedMerging& merged, const std::vector<bool>& marks) {
    const int n = local.dimension();
    std::vector<Index> found;
    for (Index t = 0; t < std::ssize(marks); ++t) {
        bool is_alone = marks[t] && local.owns(ranks, n, t);
        for (int i = 0; i <= n && is_alone; ++i)
            is_alone = merged.carriers[n - 1][local.complex.face(n, t, i)].dimension < n;
        if (is_alone)
            found.push_back(t);
    }
    return found;
}

/// Throws for cells without volume that are no pieces of others.
void refuse_flat_cells(const LocalComplex& local, const std::vector<Index>& flat) {
    const int n = local.dimension();
    Circumsphere sphere;
    SimplexLayout layout(local.complex, local.points);
    for (const Index t : flat)
        if (!sphere.look_at(layout.at(n, t)))
            throw InvalidInput(fmt::format(
                "the cell with vertices {} has no volume, and lies on no neighbor's sphere: move "
                "one of its vertices, or replace the cell and its neighbors",
                fmt::join(local.complex.vertex_numbers(n, t), " ")));
}

/// Collective: what becomes of flat cells that have stayed alone.
void look_at_flat_cells(const Ranks& ranks, const CellVolumes& volumes, DistributedMesh& mesh) {
    const LocalComplex& local = mesh.local;
    if (!can_take_flat_simplices(local.dimension(), static_cast<Index>(local.points.cols())))
        return;
    const Vector shortest = shortest_edges(ranks, local, volumes);
    const auto flat = ranks.together("flat cells", [&] {
        const auto own = alone(ranks, local, mesh.merged,
                               flat_simplices({local.complex, local.points, volumes}, shortest));
        refuse_flat_cells(local, own);
        return std::ssize(own);
    });
    const GlobalIndex count = ranks.sum(GlobalIndex{flat});
    if (count == 0 || mesh.options.criterion != MergeCriterion::dual_length)
        return;
    const double wider = 10 * mesh.options.tolerance;
    const auto nearly =
        measure_facets(ranks, local, volumes, {mesh.options.criterion, wider}).degenerate;
    warn_of_jitter(count, ranks.sum(nearly.interior) - mesh.merged.degenerate_interior, wider,
                   mesh.warnings);
}

std::vector<std::string> warnings_of(const Ranks& ranks, const MeshSlice& slice,
                                     const LocalComplex& local, const Points& box, double unit) {
    std::vector<std::string> list = slice.warnings;
    const GlobalIndex unused = slice.vertices - local.degree(0).count;
    if (list.empty() && unused > 0) // else the reader has told which
        list.push_back(fmt::format("{} to no cell, left out of all counts",
                                   counted(unused, "vertex belongs", "vertices belong")));
    warn_of_unit(unit, list);
    warn_of_orientation(local.turned, local.degrees.back().count, local.orientable, list);
    warn_of_branching(branching_facets(ranks, local), list);
    warn_of_overlaps(ranks, local, list);
    warn_of_unjoined(ranks, slice, local, box, unit, list);
    return list;
}

} // namespace

DistributedMesh discretize(const Ranks& ranks, MeshSlice slice, const std::vector<int>& owners,
                           const MergeOptions& options, const Progress& stage) {
    const auto begin = [&](std::string_view what) {
        if (stage)
            stage(what);
    };
    begin("complex");
    DistributedMesh mesh{local_complex(ranks, slice, owners), {}, {}, options};
    LocalComplex& local = mesh.local;
    mesh.unit = common_unit(ranks, local, slice.points);
    if (mesh.unit != 1)
        local.points = in_units(std::move(local.points), mesh.unit);
    mesh.places = local.points;
    const Points box = box_of(ranks, mesh.places);
    if (const auto axes = varying_coordinates(box); std::ssize(axes) == local.dimension())
        local.points = mesh.places(Eigen::indexing::all, axes).eval();
    mesh.warnings = warnings_of(ranks, slice, local, box, mesh.unit);
    slice = {};
    begin("volumes");
    const auto ambient = static_cast<Index>(local.points.cols());
    const CellVolumes volumes = ranks.together("volumes", [&] {
        return dual_volumes(local.complex, local.points, {},
                            can_take_flat_simplices(local.dimension(), ambient)
                                ? FlatSimplices::passed_over
                                : FlatSimplices::refused);
    });
    begin("merge");
    mesh.merged = merge_cospherical(ranks, local, volumes, options);
    look_at_flat_cells(ranks, volumes, mesh);
    begin("cells");
    mesh.cells = distributed_cells(ranks, local, mesh.merged);
    return mesh;
}

std::string facet_name(const DistributedMesh& mesh, Index f) {
    const int k = mesh.dimension() - 1;
    const auto& cells = mesh.cells.degree(k);
    return fmt::format("facet {} (which contains vertices {})", cells.number[f],
                       fmt::join(mesh.local.complex.vertex_numbers(k, cells.first[f]), ", "));
}

void check_not_branching(const DistributedMesh& mesh) {
    const int k = mesh.dimension() - 1;
    const auto& counts = mesh.local.complex.coface_counts(k);
    const auto& pieces = mesh.cells.degree(k).first;
    for (Index f = 0; f < std::ssize(pieces); ++f)
        if (const Index cofaces = counts[pieces[f]]; cofaces > 2)
            throw InvalidInput(
                fmt::format("{} cells meet at {}, so the flux through it is not a difference of "
                            "two values of a dual 0-form: use primal 0-forms",
                            cofaces, facet_name(mesh, f)));
}

void check_stars(const Ranks& ranks, const DistributedMesh& mesh) {
    if (mesh.star == StarKind::circumcentric)
        return;
    std::string why = "are requested";
    if (mesh.star == StarKind::automatic) {
        GlobalIndex found = 0;
        int k = -1;
        while (found == 0 && k < mesh.dimension()) {
            const HodgeStar star(mesh.cells.volumes, ++k);
            found = ranks.sum(std::ssize(star.negatives()) + std::ssize(star.zeros()));
        }
        const StarKind kind = automatic_kind(mesh.dimension(), found == 0);
        if (kind == StarKind::circumcentric)
            return;
        why =
            fmt::format("are {} stars here, since the duals of {} of the {}-cells are not positive",
                        name(kind), found, k);
    }
    throw InvalidInput(fmt::format("{} stars {}, but several ranks support only circumcentric "
                                   "stars: use StarKind::circumcentric, or solve in one process",
                                   name(mesh.star), why));
}

} // namespace polydec
