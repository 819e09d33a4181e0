// SPDX-License-Identifier: MIT
#include "dec/discretization/discretization.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/discretization/advice.h"
#include "dec/discretization/glued_box.h"
#include "dec/discretization/mesh_warnings.h"
#include "dec/merging/facet_defects.h"
#include "dec/merging/flat_simplices.h"
#include "dec/merging/merged_tags.h"
#include "dec/metric/geometry.h"
#include "dec/metric/plane.h"
#include "dec/stars/choose_stars.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "meshes/periodic.h"
#include "meshes/refine.h"
#include "meshes/tidy.h"
#include "meshes/unit_of_length.h"

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

/// Facets between simplices of different tags and with tags of their own stay. Nothing is kept if
/// the mesh has no tags or tags do not matter.
KeptFacets kept_facets(const SimplicialComplex& complex, const std::vector<Index>& tags,
                       const std::vector<Index>& facet_tags, const DiscretizeOptions& options) {
    if (options.materials == Materials::join || (tags.empty() && facet_tags.empty()))
        return {};
    if (options.delaunay != Delaunay::off)
        throw InvalidInput("flips join triangles of different groups, but groups must stay apart "
                           "here: omit the flips, or let materials join");
    const int n = complex.dimension();
    KeptFacets kept{std::vector<bool>(complex.size(n - 1), false), facet_tags};
    const Cofaces cofaces(complex, n);
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        kept.stay[f] = !facet_tags.empty() && facet_tags[f] != 0;
        if (!tags.empty())
            for (const Coface& t : cofaces.of(f))
                if (tags[t.cell] != tags[cofaces.of(f).front().cell])
                    kept.stay[f] = true;
    }
    return kept;
}

/// Flips and splits according to the options; `lengths` of the edges.
IntrinsicDelaunay flipped(const SimplicialComplex& complex, Vector lengths,
                          const DiscretizeOptions& options) {
    if (options.criterion == MergeCriterion::angle)
        throw InvalidInput("intrinsic flips need merging by relative dual length, not by opposite "
                           "angles: omit the angle tolerance");
    const auto boundary =
        options.delaunay == Delaunay::flips_and_splits ? BoundaryEdges::split : BoundaryEdges::keep;
    return intrinsic_delaunay(GluedSurface(complex), std::move(lengths),
                              {.boundary = boundary, .tolerance = options.tolerance});
}

/// `given`: the geometry before merging.
void look_at_flat_cells(const CosphericalMerging& merged, const Geometry& given,
                        const MergeOptions& options, std::vector<std::string>& warnings) {
    auto alone = flat_simplices(given);
    for (std::size_t t = 0; t < alone.size(); ++t)
        alone[t] = alone[t] && !merged.geometry.is_flat(static_cast<Index>(t));
    const auto flat = std::count(alone.begin(), alone.end(), true);
    if (flat == 0 || options.criterion != MergeCriterion::dual_length)
        return;
    const double wider = 10 * options.tolerance;
    const auto at = facet_defects(given, options).degenerate;
    const auto nearly = facet_defects(given, {options.criterion, wider}).degenerate;
    warn_of_jitter(flat, nearly.interior - at.interior, wider, warnings);
}

void begin(const Progress& stage, std::string_view what) {
    if (stage)
        stage(what);
}

/// A mesh after reading and numbering.
struct Given {
    SimplicialComplex complex;
    Mesh mesh;                            // without its points
    std::shared_ptr<const Points> points; // of the complex
    SimplexMetric metric;                 // of these, in an n-plane that has them all, or lengths
    Points isolated;                      // points of no cell
    double unit;
    FlatCellsKept flat = {};
    bool is_glued = false; // from a box

    bool has_points() const { return metric.points() != nullptr; }
};

/// Throws for cells without volume that are not pieces of other cells.
void refuse_flat_cells(const Given& given, const Merging& merging) {
    const auto& [complex, mesh, points, metric, isolated, unit, flat, is_glued] = given;
    if (flat.rows.empty())
        return;
    const int n = complex.dimension();
    std::vector<bool> are_alone(static_cast<std::size_t>(mesh.simplices.rows()), false);
    for (Index t = 0; t < complex.size(n); ++t)
        are_alone[complex.input_row(t)] =
            merging.pieces_of(n, merging.carriers(n)[t].cell).size() == 1;
    FlatCellsKept alone;
    for (std::size_t i = 0; i < flat.rows.size(); ++i)
        if (are_alone[flat.rows[i]]) {
            alone.rows.push_back(flat.rows[i]);
            alone.numbers.push_back(flat.numbers[i]);
        }
    if (alone.rows.empty())
        return;
    Mesh by_number = mesh;
    by_number.points = Points::Zero(complex.vertex_number(complex.size(0) - 1) + 1, points->cols());
    for (Index v = 0; v < complex.size(0); ++v)
        by_number.points.row(complex.vertex_number(v)) = points->row(v);
    refuse(by_number, alone);
}

/// Measured geometry: of the simplices, and of the triangles after flips.
struct Measured {
    Passage passage;
    Geometry input, pieces;
    std::shared_ptr<const Points> points; // of the vertices of the pieces
};

Measured measure(Given& given, const DiscretizeOptions& options) {
    auto& [complex, mesh, places, metric, isolated, unit, flat, is_glued] = given;
    Passage passage(complex);
    Vector sides;
    if (options.delaunay != Delaunay::off) {
        sides = given.has_points() ? edge_lengths(complex, *places) : *metric.lengths();
        passage = Passage(complex, flipped(complex, sides, options),
                          static_cast<Index>(places->rows() + isolated.rows()));
        warn_of_flips(passage.flips().statistics, unit, mesh.warnings);
    }
    if (passage.is_identity()) {
        const Geometry input(complex, metric, options.centers,
                             flat.rows.empty() ? FlatSimplices::refused
                                               : FlatSimplices::passed_over);
        return {std::move(passage), input, input, places};
    }
    if (is_glued)
        mesh.warnings.emplace_back("edges of a glued mesh were flipped: only its lengths are "
                                   "known, no positions in its box");
    const auto& flips = passage.flips();
    const Vector longer = sides.array() + flips.statistics.added_length;
    const Geometry input(complex, metric, circumcentric_volumes(complex, {complex, longer}));
    const Geometry pieces(passage.pieces(), {passage.pieces(), flips.lengths});
    Points points = passage.forth(0, *places);
    points.topRows(places->rows()) = *places;
    return {std::move(passage), input, pieces, std::make_shared<const Points>(std::move(points))};
}

Discretization measured(Given given, DiscretizeOptions options, const Progress& stage) {
    auto& [complex, mesh, places, metric, isolated, unit, flat, is_glued] = given;
    if (!options.centers.are_circumcenters()) {
        options.criterion = MergeCriterion::none;
        if (options.delaunay != Delaunay::off)
            throw InvalidInput("flips need circumcenters, but other centers are given: omit the "
                               "flips or the centers");
    }
    warn_of_orientation(complex.turned(), complex.size(complex.dimension()), complex.orientable(),
                        mesh.warnings);
    warn_of_branching(branching_facets(complex), mesh.warnings);
    if (given.has_points()) {
        warn_of_overlaps(complex, *metric.points(), mesh.warnings);
        warn_of_unjoined(unjoined_boundary(complex, *places), complex.dimension(), mesh.warnings);
    }
    const auto tags = tags_of_cells(complex, mesh.tags);
    FacetTags facet_tags = tags_of_facets(complex, mesh.facet_tags, mesh.warnings);
    const auto kept = kept_facets(complex, tags, facet_tags.tags, options);
    begin(stage, "volumes");
    auto [passage, input, pieces, points] = measure(given, options);
    begin(stage, "merge");
    auto merged = merge_cospherical(pieces, options, kept);
    refuse_flat_cells(given, merged.merging);
    look_at_flat_cells(merged, pieces, options, mesh.warnings);
    const int facets = complex.dimension() - 1;
    const auto volumes = without_duals_beyond_the_boundary(
        merged_volumes(merged.merging, merged.geometry.volumes()),
        merged.merging.merged().coface_counts(facets), [&](Index cell) {
            return std::ranges::all_of(merged.merging.pieces_of(facets, cell),
                                       [&](Index s) { return merged.degenerate.marks[s]; });
        });
    warn_of_hybrid_stars(complex, input.volumes().primal(1), volumes, options, mesh.warnings);
    if (!merged.geometry.flat().empty())
        input = merged.geometry; // on their own, flat simplices have no duals
    std::vector<Index> cell_tags;
    if (passage.is_identity()) {
        const int n = complex.dimension();
        cell_tags = merged_tags(merged.merging, n, tags, mesh.warnings);
        facet_tags.tags = merged_tags(merged.merging, n - 1, facet_tags.tags, mesh.warnings);
    } else {
        facet_tags = {.groups = std::move(facet_tags.groups)};
        if (!mesh.tags.empty())
            mesh.warnings.emplace_back(
                "left out the tags, because flips join triangles of different groups");
    }
    const Discretization result({.input = input,
                                 .passage = std::move(passage),
                                 .merged = {merged.merging, merged.geometry, volumes},
                                 .input_points = places,
                                 .points = points,
                                 .options = options,
                                 .degenerate = std::move(merged.degenerate),
                                 .warnings = std::move(mesh.warnings),
                                 .tags = std::move(cell_tags),
                                 .unit = unit,
                                 .isolated = std::move(isolated),
                                 .facet_tags = std::move(facet_tags),
                                 .groups = std::move(mesh.groups),
                                 .input_cells = std::move(mesh.input_cells),
                                 .bisections = mesh.bisections});
    const bool exist_anyway =
        options.star == StarKind::circumcentric ||
        (options.star == StarKind::automatic && result.geometry().flat().empty());
    if (!exist_anyway) {
        begin(stage, "stars");
        result.chosen_stars(); // or report why there are none
    }
    return result;
}

/// Flips remove flat cells; merging makes them pieces of their neighbors' cells.
bool can_do_with_flat_cells(const Given& given, const DiscretizeOptions& options) {
    return options.delaunay != Delaunay::off ||
           (options.criterion == MergeCriterion::dual_length &&
            options.centers.are_circumcenters() &&
            can_take_flat_simplices(given.complex.dimension(), given.metric.ambient_dimension()));
}

void check_points(const Discretization::Parts& parts) {
    const auto N = parts.input_points->cols();
    check_as_many("points of the input's vertices", parts.input_points->rows(),
                  parts.passage.input().size(0));
    check_as_many("points of the vertices of the pieces", parts.points->rows(),
                  parts.passage.pieces().size(0));
    check_as_many("coordinates of the vertices of the pieces", parts.points->cols(), N);
    if (parts.isolated.rows() > 0)
        check_as_many("coordinates of the points of no cell", parts.isolated.cols(), N);
}

} // namespace

Discretization::Discretization(Parts parts)
    : Cells(
          std::make_shared<MergedCells>(parts.merged),
          [merged = parts.merged, kind = parts.options.star] { return choose_stars(merged, kind); },
          parts.unit) {
    check_fit(parts.passage.input(), parts.input.volumes());
    check_fit(parts.passage.pieces(), parts.merged.geometry().volumes());
    if (!parts.points)
        parts.points = parts.input_points;
    check_points(parts);
    const CellComplex& complex = parts.merged.complex();
    if (!parts.tags.empty())
        check_as_many("tags", Index(parts.tags.size()), complex.size(complex.dimension()));
    if (const auto& tags = parts.facet_tags.tags; !tags.empty())
        check_as_many("tags of facets", Index(tags.size()), complex.size(complex.dimension() - 1));
    const auto made = std::make_shared<Parts>(std::move(parts));
    parts_ = made;
    if (unit() != 1)
        given_ = std::make_shared<Given>(
            Given{unit() * measured_points(), unit() * measured_input_points()});
    if (made->degenerate.marks.empty())
        made->degenerate = facet_defects(geometry(), options()).degenerate;
}

Discretization Discretization::with_volumes(const CellVolumes& volumes) const {
    Parts parts = *parts_;
    parts.merged = {merging(), geometry(), volumes};
    return Discretization(std::move(parts)).with_stars({volumes, StarKind::circumcentric});
}

Discretization Discretization::with_box(std::shared_ptr<const GluedBox> box) const {
    Parts parts = *parts_;
    parts.box = std::move(box);
    Discretization result = *this;
    result.parts_ = std::make_shared<Parts>(std::move(parts));
    return result;
}

PlacedSimplices Discretization::places() const& {
    return box() ? box()->places()
                 : PlacedSimplices{measured_input_points(), input().simplices(input().dimension())};
}

PlacedSimplices Discretization::places_of_pieces() const& {
    return box() ? box()->places()
                 : PlacedSimplices{measured_points(), pieces().simplices(dimension())};
}

int Discretization::ambient_dimension() const {
    return static_cast<int>(places().points.cols());
}

Discretization Discretization::with_stars(const ChosenStars& chosen) const {
    Discretization result = *this;
    static_cast<Cells&>(result) = Cells::with_stars(chosen);
    return result;
}

Discretization Discretization::with_stars(StarKind kind) const {
    return with_stars(choose_stars(merged(), kind));
}

Discretization Discretization::with_star(int k, const SparseMatrix& star) const {
    return with_stars(Cells::with_star(k, star).chosen_stars());
}

Discretization discretize(Mesh mesh, const DiscretizeOptions& options, const Progress& stage) {
    begin(stage, "complex");
    if (options.refine)
        mesh = refined(tidy(std::move(mesh)), *options.refine);
    FlatCellsKept flat;
    const SimplicialComplex complex = tidied_complex(mesh, flat);
    const double unit = unit_of_length(mesh);
    warn_of_unit(unit, mesh.warnings);
    if (unit != 1)
        mesh = in_units(std::move(mesh), unit);
    Points isolated = unit * isolated_points(complex, mesh.points);
    const auto points = std::make_shared<const Points>(vertex_points(complex, mesh.points));
    mesh.points = {};
    Given given{
        complex, std::move(mesh), points, metric_in_plane(complex, points), std::move(isolated),
        unit,    std::move(flat)};
    if (!can_do_with_flat_cells(given, options))
        refuse_flat_cells(given, Merging(complex));
    if (options.delaunay != Delaunay::off)
        given.flat = {};
    return measured(std::move(given), options, stage);
}

namespace {

/// `about`: other data of the simplices (tags, groups, warnings).
Given of_lengths(const LengthMesh& mesh, Mesh about) {
    check(mesh);
    const SimplicialComplex complex(mesh.simplices);
    about.points.resize(mesh.vertices, 0);
    about.simplices = mesh.simplices;
    warn_of_isolated_vertices(about);
    const auto points = std::make_shared<const Points>(complex.size(0), 0);
    const Points isolated(mesh.vertices - complex.size(0), 0);
    const double unit = unit_of_length(mesh);
    warn_of_unit(unit, about.warnings);
    // the complex numbers its edges in lexicographic order
    const SimplexMetric metric(complex, mesh.lengths(edges_in_order(mesh)) / unit);
    return {complex, std::move(about), points, metric, isolated, unit};
}

} // namespace

Discretization discretize(const LengthMesh& mesh, const DiscretizeOptions& options,
                          const Progress& stage) {
    begin(stage, "complex");
    const LengthMesh parts = options.refine ? refined(mesh, *options.refine) : mesh;
    Mesh about;
    about.input_cells = parts.input_cells;
    about.bisections = parts.bisections;
    return measured(of_lengths(parts, std::move(about)), options, stage);
}

Discretization discretize(const PeriodicMesh& given, const DiscretizeOptions& options,
                          const Progress& stage) {
    begin(stage, "complex");
    check_facet_tags(given.box);
    check_as_many("numbers of the vertices of a box", std::ssize(given.vertices),
                  given.box.points.rows());
    const PeriodicMesh mesh = options.refine ? refined(given, *options.refine) : given;
    Mesh about{{}, {}, mesh.box.warnings, mesh.box.tags, mesh.box.facet_tags, mesh.box.groups};
    about.input_cells = mesh.box.input_cells;
    about.bisections = mesh.quotient.bisections;
    for (Index& v : about.facet_tags.simplices.reshaped())
        v = mesh.vertices[v];
    Given parts = of_lengths(mesh.quotient, std::move(about));
    parts.is_glued = true;
    const Discretization result = measured(std::move(parts), options, stage);
    return result.passage().is_identity()
               ? result.with_box(std::make_shared<const GluedBox>(mesh, result))
               : result;
}

std::vector<Index> cell_vertices(const Discretization& discretization, int k, Index cell) {
    return discretization.pieces().vertex_numbers(discretization.merging().vertices(k, cell));
}

} // namespace polydec
