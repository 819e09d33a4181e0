// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/shared.h"
#include "dec/forms/cells.h"
#include "dec/merging/merge.h"
#include "dec/merging/merged_cells.h"
#include "dec/metric/centers.h"
#include "dec/stars/star.h"
#include "dec/surfaces/passage.h"
#include "meshes/length_mesh.h"
#include "meshes/mesh.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Whether the edges of a surface are flipped before merging, so that no dual edge is negative. The
/// surface and its vertices do not change. Source: see intrinsic_delaunay.
enum class Delaunay {
    off,
    flips,           ///< flips interior edges; boundary edges keep negative duals
    flips_and_splits ///< also splits boundary edges, until every dual is positive
};

/// Whether simplices of different materials (tags of the mesh) may become pieces of one cell.
enum class Materials {
    join,      ///< cospherical simplices merge; a cell of several materials has tag 0
    keep_apart ///< facets between different tags stay, and so do facets that have a tag of their
               ///< own, so that every cell and every (n-1)-cell has the tag of its pieces
};

/// How discretize prepares a mesh: the criterion of merging, as in MergeOptions, and other choices.
struct DiscretizeOptions {
    MergeCriterion criterion = MergeOptions{}.criterion;
    double tolerance = MergeOptions{}.tolerance;
    Delaunay delaunay = Delaunay::off;
    Materials materials = Materials::join;
    /// With centers other than circumcenters, nothing is merged: no merging is needed.
    Centers centers = {};
    StarKind star = StarKind::automatic; ///< see choose_stars
    /// No edge longer than this, in the units of the input: simplices are bisected before anything
    /// else is done (see refined).
    std::optional<double> refine = {};

    operator MergeOptions() const { return {criterion, tolerance}; }
};

class GluedBox;
struct PeriodicMesh;

/// The n-simplices of a mesh, placed by points: the corners of each simplex are rows of a table, in
/// the order of its vertices. Keeps references.
struct PlacedSimplices {
    const Points& points;
    const Simplices& corners; ///< n+1 rows of `points` for each n-simplex
};

/// A mesh prepared for calculus: its complex, merged where cells are cospherical, and its metric.
/// Every member refers to the cells of complex() unless it says otherwise. An immutable handle:
/// copies share the data and cost nothing. Accessors of a temporary return copies.
///
/// With intrinsic Delaunay flips, the pieces are the flipped triangles, whose edges are geodesics
/// on the input.
class Discretization : public Cells {
public:
    /// The data of a discretization.
    struct Parts {
        Geometry input;     ///< of the given simplices, each on its own unless some are flat
        Passage passage;    ///< from the given simplices to the pieces
        MergedCells merged; ///< of the pieces
        /// One row per vertex of the input; without columns if only lengths are known.
        std::shared_ptr<const Points> input_points;
        /// Of the vertices of the pieces; null: the points of the input.
        std::shared_ptr<const Points> points = {};
        DiscretizeOptions options = {};
        DegenerateFacets degenerate = {}; ///< of the pieces; computed anew if it has no marks
        std::vector<std::string> warnings = {};
        std::vector<Index> tags = {};
        double unit = 1;
        Points isolated = {}; ///< in the units of the input
        FacetTags facet_tags = {};
        std::vector<GroupName> groups = {};
        std::shared_ptr<const GluedBox> box = {}; ///< of a glued mesh, which knows only lengths
        InputCells input_cells = {};              ///< by row of the input (see input_row)
        int bisections = 0;                       ///< see Mesh::bisections
    };

    /// Throws InvalidInput unless the numbers of pieces, tags and points fit the cells and
    /// vertices, and all points have the same number of coordinates.
    explicit Discretization(Parts parts);

    /// The same with other stars (see Cells), or with stars of this kind, without the materials and
    /// stars of before; throws like choose_stars.
    Discretization with_stars(const ChosenStars& chosen) const;
    Discretization with_stars(StarKind kind) const;
    Discretization with_star(int k, const SparseMatrix& star) const;

    /// The same with other volumes of the cells, and the stars made from them. Throws InvalidInput
    /// unless the volumes fit.
    Discretization with_volumes(const CellVolumes& volumes) const;

    /// The same, marked as glued from this box.
    Discretization with_box(std::shared_ptr<const GluedBox> box) const;

    /// The merged cells, the merging that made them, and the pieces that were merged.
    const MergedCells& merged() const& { return merged_cells(); }
    const Merging& merging() const& { return merged().merging(); }
    const Pieces& pieces() const& { return merging().pieces(); }
    MergedCells merged() && { return merged(); }
    Merging merging() && { return merging(); }
    Pieces pieces() && { return pieces(); }

    /// Geometry of the pieces. Duals lie between options().centers; where cells were merged in R^n,
    /// all pieces of a cell share one circumcenter. Points have n coordinates if they lie in an
    /// n-plane. After flips the metric consists of lengths.
    const Geometry& geometry() const& { return merged().geometry(); }
    Geometry geometry() && { return geometry(); }

    /// The given simplices, the passage from them to the pieces, and their geometry.
    const Passage& passage() const& { return parts_->passage; }
    const SimplicialComplex& input() const& { return passage().input(); }
    const Geometry& input_geometry() const& { return parts_->input; }
    Passage passage() && { return passage(); }
    SimplicialComplex input() && { return input(); }
    Geometry input_geometry() && { return input_geometry(); }

    /// Points of the vertices of complex(): first the vertices of the input that cells use, then
    /// the vertices that splits have added; without columns if only lengths are known. A field at
    /// vertices and a primal 0-form have the same rows. points() are in the units of the input,
    /// measured_points() in unit().
    const Points& points() const& { return given_ ? given_->points : measured_points(); }
    const Points& input_points() const& {
        return given_ ? given_->input_points : measured_input_points();
    }
    Points points() && { return points(); }
    Points input_points() && { return input_points(); }
    const Points& measured_points() const& { return *parts_->points; }
    const Points& measured_input_points() const& { return *parts_->input_points; }
    Points measured_points() && { return measured_points(); }
    Points measured_input_points() && { return measured_input_points(); }

    /// The box from which a glued mesh was made; null for other meshes.
    const std::shared_ptr<const GluedBox>& box() const& { return parts_->box; }
    std::shared_ptr<const GluedBox> box() && { return box(); }

    /// Places of the n-simplices of the input: between measured_input_points(), or on a glued mesh
    /// the position of each simplex in the box, so that simplices across a seam are straight.
    /// Without columns if only lengths are known.
    PlacedSimplices places() const&;
    PlacedSimplices places() const&& = delete;
    /// Places of the n-pieces. Pieces between flipped edges are not straight, but have corners.
    PlacedSimplices places_of_pieces() const&;
    PlacedSimplices places_of_pieces() const&& = delete;

    /// Number N of coordinates of the points; 0 if only lengths are known.
    int ambient_dimension() const;

    /// Points of the input that no cell uses, in order, in the units of the input.
    const Points& isolated() const& { return parts_->isolated; }
    Points isolated() && { return isolated(); }

    /// Lengths of the input's edges if only lengths are known; else empty.
    Vector lengths() const {
        const Vector* known = input_geometry().metric().lengths();
        return known == nullptr ? Vector() : *known;
    }

    /// The cells of the input that the simplices of input() are parts of, by input_row.
    const InputCells& input_cells() const& { return parts_->input_cells; }
    InputCells input_cells() && { return input_cells(); }

    /// How often refinement has bisected the simplex that it divided most often.
    int bisections() const { return parts_->bisections; }

    /// The options of discretize, and the facets found degenerate.
    const DiscretizeOptions& options() const& { return parts_->options; }
    DiscretizeOptions options() && { return options(); }
    const DegenerateFacets& degenerate() const& { return parts_->degenerate; }
    DegenerateFacets degenerate() && { return degenerate(); }

    /// Defects of the input, and how each was handled.
    const std::vector<std::string>& warnings() const& { return parts_->warnings; }
    std::vector<std::string> warnings() && { return warnings(); }

    /// For each n-cell the tag of its simplices, 0 if they differ; or empty.
    const std::vector<Index>& tags() const& { return parts_->tags; }
    std::vector<Index> tags() && { return tags(); }

    /// For each (n-1)-cell the tag of its facets in the input; 0 if they have none or differ. Empty
    /// if the input has no tagged facets or edges were flipped.
    const std::vector<Index>& facet_tags() const& { return parts_->facet_tags.tags; }
    std::vector<Index> facet_tags() && { return facet_tags(); }

    /// The same with the tags that stand for several groups, and the groups with facets in the
    /// input, of which merging and flips may leave none.
    const FacetTags& tagged_facets() const& { return parts_->facet_tags; }
    FacetTags tagged_facets() && { return tagged_facets(); }

    /// Names of the groups of the input.
    const std::vector<GroupName>& groups() const& { return parts_->groups; }
    std::vector<GroupName> groups() && { return groups(); }

private:
    struct Given {
        Points points, input_points; ///< in the units of the input
    };

    Shared<const Parts> parts_;
    Shared<const Given> given_; // null where unit() is 1
};

/// Computes the merged complex, volumes and stars of a mesh. Untidy input is tidied with a warning
/// (see tidy); a mesh far from size 1 is measured in other units, with a warning; overlapping cells
/// give a warning (see find_overlaps). Calls `stage`, if given, as each stage (complex, volumes,
/// merge, stars) begins. Throws InvalidInput, naming the cell or vertex, for unusable input.
Discretization discretize(Mesh mesh, const DiscretizeOptions& options = {},
                          const Progress& stage = {});

/// The same from lengths alone; nothing is left out as untidy. Functions that need points (de Rham
/// maps, flats, sharps, vector fields, centers of cells, drawings) throw InvalidInput for the
/// result, and so does to_input for dual 0-forms after flips; everything else works as on any mesh.
/// Throws like check of a LengthMesh, SimplicialComplex, SimplexMetric and circumcentric_volumes.
Discretization discretize(const LengthMesh& mesh, const DiscretizeOptions& options = {},
                          const Progress& stage = {});

/// The quotient of a glued mesh, measured by lengths and merged across the seams, with the places,
/// tags and groups of its box. Forms, fields and expressions are evaluated where the simplices lie
/// in the box, and pictures show the box. Flipped edges cross the simplices of the box: after flips
/// only lengths are known, with a warning. Throws like the other overloads.
Discretization discretize(const PeriodicMesh& given, const DiscretizeOptions& options = {},
                          const Progress& stage = {});

/// Vertices of a k-cell of complex(), ascending, by their numbers in the input, as in messages and
/// files; vertices added by splits are numbered after the input's.
std::vector<Index> cell_vertices(const Discretization& discretization, int k, Index cell);

} // namespace polydec
