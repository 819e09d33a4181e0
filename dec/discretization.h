// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretize_options.h"
#include "dec/forms/cells.h"
#include "dec/merging/merged_cells.h"
#include "dec/merging/merged_tags.h"
#include "dec/surfaces/passage.h"
#include "meshes/length_mesh.h"
#include "meshes/mesh.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

class GluedBox;
struct PeriodicMesh;

/// The n-simplices of a mesh between points: the corners of each are rows of a table, in the order
/// of its vertices. Keeps references.
struct PlacedSimplices {
    const Points& points;
    const Simplices& corners; ///< n+1 rows of `points` for each n-simplex
};

/// A mesh made ready for calculus: its complex, merged where cells are cospherical, and the metric.
/// Everything here answers for the cells of complex(), or says for what else. A handle on what
/// never changes: copies share it and cost nothing. Accessors of a temporary return copies.
///
/// Where intrinsic Delaunay flips were asked for, the pieces are the flipped triangles, whose edges
/// are geodesics on the input.
class Discretization : public Cells {
public:
    /// What it holds.
    struct Parts {
        Geometry input;     ///< of the simplices given, by themselves unless some are flat
        Passage passage;    ///< from these to the pieces
        MergedCells merged; ///< of the pieces
        /// Of the input's vertices; without columns if only lengths are known.
        std::shared_ptr<const Points> input_points;
        Points points = {}; ///< of the vertices of the pieces, if edges were flipped
        DiscretizeOptions options = {};
        DegenerateFacets degenerate = {}; ///< of the pieces; found anew without marks
        std::vector<std::string> warnings = {};
        std::vector<Index> tags = {};
        double unit = 1;
        Points isolated = {}; ///< in the units of the input
        FacetTags facet_tags = {};
        std::vector<GroupName> groups = {};
        std::shared_ptr<const GluedBox> box = {}; ///< of a glued mesh, which knows lengths
        InputCells input_cells = {};              ///< by rows of the input (see input_row)
    };

    /// Throws InvalidInput unless pieces, tags and points are those of as many cells and vertices,
    /// and points have as many coordinates.
    explicit Discretization(Parts parts);

    // no moves, which would leave a handle on nothing
    Discretization(const Discretization&) = default;
    Discretization& operator=(const Discretization&) = default;

    /// As of all cells; or with the stars of a kind, which throws like choose_stars.
    Discretization with_stars(const ChosenStars& chosen) const;
    Discretization with_stars(const HodgeStars& stars) const {
        return with_stars(ChosenStars(stars));
    }
    Discretization with_stars(StarKind kind) const;
    Discretization with_star(int k, const SparseMatrix& star) const;

    /// The same with other volumes of the cells, and the stars that they make. Throws InvalidInput
    /// unless they fit.
    Discretization with_volumes(const CellVolumes& volumes) const;

    /// The same as a mesh glued from this box.
    Discretization with_box(std::shared_ptr<const GluedBox> box) const;

    /// What the cells are made of, and how.
    const MergedCells& merged() const& { return merged_cells(); }
    const Merging& merging() const& { return merged().merging(); }
    const Pieces& pieces() const& { return merging().pieces(); }
    MergedCells merged() && { return merged(); }
    Merging merging() && { return merging(); }
    Pieces pieces() && { return pieces(); }

    /// The shape of the pieces, with duals between options().centers, but where cells have been
    /// merged in R^n circumcenters in one place for all pieces of a cell. Points count as n
    /// coordinates where they lie in an n-plane; after flips lengths are known.
    const Geometry& geometry() const& { return merged().geometry(); }
    Geometry geometry() && { return geometry(); }

    /// The simplices that were given, the way from them to the pieces, and their shape.
    const Passage& passage() const& { return parts_->passage; }
    const SimplicialComplex& input() const& { return passage().input(); }
    const Geometry& input_geometry() const& { return parts_->input; }
    Passage passage() && { return passage(); }
    SimplicialComplex input() && { return input(); }
    Geometry input_geometry() && { return input_geometry(); }

    /// Of the vertices of complex(), which are those of the input that cells use, and behind them
    /// those that splits have made; without columns if only lengths are known. A field at vertices
    /// and a primal 0-form have the same rows. Those of the input are its first. As they were
    /// given, where measured_points() are in unit().
    const Points& points() const& { return given_ ? given_->points : measured_points(); }
    const Points& input_points() const& {
        return given_ ? given_->input_points : measured_input_points();
    }
    Points points() && { return points(); }
    Points input_points() && { return input_points(); }
    const Points& measured_points() const& {
        return passage().is_identity() ? measured_input_points() : parts_->points;
    }
    const Points& measured_input_points() const& { return *parts_->input_points; }

    /// The box that a glued mesh was made of; null for other meshes.
    const std::shared_ptr<const GluedBox>& box() const& { return parts_->box; }
    std::shared_ptr<const GluedBox> box() && { return box(); }

    /// Where the n-simplices of the input lie: between measured_input_points(), or, if the mesh is
    /// glued, each where it lies in the box, so that simplices across a seam are straight. Without
    /// columns if only lengths are known.
    PlacedSimplices places() const&;
    PlacedSimplices places() const&& = delete;

    /// Number N of coordinates of these points; 0 if only lengths are known.
    int ambient_dimension() const;

    /// The points of the input that no cell uses, in order, as they were given.
    const Points& isolated() const& { return parts_->isolated; }
    Points isolated() && { return isolated(); }

    /// Of the input's edges if only these are known; or empty.
    Vector lengths() const {
        const Vector* known = input_geometry().metric().lengths();
        return known == nullptr ? Vector() : *known;
    }

    /// Of which cells of the input the simplices of input() are parts, by their input_row.
    const InputCells& input_cells() const& { return parts_->input_cells; }
    InputCells input_cells() && { return input_cells(); }

    /// How it was made, and which facets were found degenerate.
    const DiscretizeOptions& options() const& { return parts_->options; }
    DiscretizeOptions options() && { return options(); }
    const DegenerateFacets& degenerate() const& { return parts_->degenerate; }
    DegenerateFacets degenerate() && { return degenerate(); }

    /// What was untidy in the input, and what was done about it.
    const std::vector<std::string>& warnings() const& { return parts_->warnings; }
    std::vector<std::string> warnings() && { return warnings(); }

    /// Of each n-cell the tag of its simplices, 0 where they have different ones; or empty.
    const std::vector<Index>& tags() const& { return parts_->tags; }
    std::vector<Index> tags() && { return tags(); }

    /// Of each (n-1)-cell the tag that its facets have in the input, 0 for none and where they have
    /// different ones; or empty, if the input has no facets with tags or edges were flipped.
    const std::vector<Index>& facet_tags() const& { return parts_->facet_tags.tags; }
    std::vector<Index> facet_tags() && { return facet_tags(); }

    /// Those of these tags that stand for several groups.
    const std::vector<JointTag>& joint_tags() const& { return parts_->facet_tags.joint; }
    std::vector<JointTag> joint_tags() && { return joint_tags(); }

    /// The names of groups of the input.
    const std::vector<GroupName>& groups() const& { return parts_->groups; }
    std::vector<GroupName> groups() && { return groups(); }

private:
    struct Given {
        Points points, input_points; ///< in the units of the input
    };

    std::shared_ptr<const Parts> parts_;
    std::shared_ptr<const Given> given_; // null where unit() is 1
};

/// The whole way from a mesh to its merged complex, volumes and stars. Untidy input is tidied with
/// a warning (see tidy); a mesh far from size 1 is measured in other units, with a warning;
/// warnings tell of cells that overlap (see find_overlaps). Each stage (complex, volumes, merge,
/// stars) is told as it begins, if anyone listens. Throws InvalidInput, naming the cell or vertex,
/// for what cannot be used.
Discretization discretize(Mesh mesh, const DiscretizeOptions& options = {},
                          const std::function<void(std::string_view)>& stage = {});

/// The same from lengths alone; nothing is left out as untidy. What needs points (de Rham maps,
/// flats, sharps, vector fields, centers of cells, drawings) throws InvalidInput for the result;
/// all else is that of any mesh.
/// Throws like check of a LengthMesh, SimplicialComplex, SimplexMetric and circumcentric_volumes.
Discretization discretize(const LengthMesh& mesh, const DiscretizeOptions& options = {},
                          const std::function<void(std::string_view)>& stage = {});

/// The quotient of a glued mesh, measured by lengths and merged across the seams, with the places,
/// tags and groups of its box. Forms, fields and expressions are taken where the simplices lie in
/// the box, and pictures show the box. Flipped edges cross the simplices of the box: after flips
/// only lengths are known, with a warning. Throws like the others.
Discretization discretize(const PeriodicMesh& mesh, const DiscretizeOptions& options = {},
                          const std::function<void(std::string_view)>& stage = {});

/// The vertices of k-cell of complex(), ascending, by the numbers of the input, as messages and
/// files name them; vertices that splits have made are numbered behind the input's.
std::vector<Index> cell_vertices(const Discretization& discretization, int k, Index cell);

} // namespace polydec
