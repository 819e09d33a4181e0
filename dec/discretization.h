// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merge.h"
#include "dec/metric/simplex_metric.h"
#include "dec/surfaces/passage.h"
#include "meshes/length_mesh.h"
#include "meshes/mesh.h"

#include <functional>
#include <string>
#include <string_view>

namespace polydec {

/// A mesh made ready for calculus: its complex, merged where cells are cospherical, and the metric.
/// Each member can be made by itself; this bundle only holds them together.
///
/// Where intrinsic Delaunay flips were asked for, the pieces are the flipped triangles, whose edges
/// are geodesics on the input.
struct Discretization {
    Points points;   ///< a row per vertex number of the input, and behind them of the vertices that
                     ///< splits have made; without columns if only lengths are known
    Passage passage; ///< from the simplices of the input to the pieces
    Merging merging; ///< of the pieces
    CellVolumes input_volumes; ///< of the simplices
    CellVolumes piece_volumes; ///< of the pieces: the same, unless edges were flipped
    CellVolumes volumes;       ///< of the cells of complex()
    MergeOptions options;
    DegenerateFacets degenerate;
    std::vector<std::string> warnings; ///< what was untidy in the input, and what was done about it
    std::vector<Index> tags = {};      ///< of each merged n-cell the tag of its simplices, 0 where
                                       ///< they have different ones; or empty
    Vector lengths = {};               ///< of the input's edges if only these are known; or empty
    /// What points, lengths and volumes are measured in, as a length of the input: 1, or a power of
    /// 4 where the input is so large or small that products of its lengths would be no numbers. So
    /// distances are to be multiplied by it, solutions of Delta u = f by its square, eigenvalues
    /// of Delta to be divided by its square (in_input_units).
    double unit = 1;

    const SimplicialComplex& input() const& { return passage.input(); }
    const Pieces& pieces() const& { return merging.pieces(); }
    const CellComplex& complex() const& { return merging.merged(); }
    SimplicialComplex input() && { return input(); }
    Pieces pieces() && { return pieces(); }
    CellComplex complex() && { return complex(); }
    int dimension() const { return complex().dimension(); }

    /// The metric of the pieces: the points, or lengths if only these are known or edges were
    /// flipped. Refers to this bundle, so there is none of a temporary.
    SimplexMetric metric() const& {
        return passage.is_identity() ? input_metric()
                                     : SimplexMetric(pieces(), passage.flips().lengths);
    }
    SimplexMetric metric() const&& = delete;

    /// The metric of the simplices of the input.
    SimplexMetric input_metric() const& {
        return points.cols() > 0 ? SimplexMetric(points) : SimplexMetric(input(), lengths);
    }
    SimplexMetric input_metric() const&& = delete;
};

/// The whole way from a mesh to its merged complex and volumes. Untidy input is tidied with a
/// warning (see tidy); a mesh far from size 1 is measured in other units, with a warning; warnings
/// tell of cells that overlap (see find_overlaps). Each stage (complex, volumes, merge) is told as
/// it begins, if anyone listens. Throws InvalidInput, naming the cell or vertex, for what cannot be
/// used.
Discretization discretize(Mesh mesh, const MergeOptions& options = {},
                          const std::function<void(std::string_view)>& stage = {});

/// The same from lengths alone; nothing is left out as untidy. What needs points (de Rham maps,
/// flats, sharps, vector fields, centers of cells, drawings) throws InvalidInput for the result;
/// all else is that of any mesh.
/// Throws like check of a LengthMesh, SimplicialComplex, SimplexMetric and circumcentric_volumes.
Discretization discretize(const LengthMesh& mesh, const MergeOptions& options = {},
                          const std::function<void(std::string_view)>& stage = {});

/// Coordinates of the vertices of complex(), a row each: those of the input and, behind them, of
/// vertices that splits have put on boundary edges.
Points vertex_points(const Discretization& discretization);

/// The vertices of k-cell of complex(), ascending, by the input's numbers; vertices that splits
/// have made are numbered behind the input's.
std::vector<Index> cell_vertices(const Discretization& discretization, int k, Index cell);

/// Throws InvalidInput, naming what was asked for, if edges were flipped, so that the cells are not
/// made of simplices of the input.
void check_not_flipped(const Discretization& discretization, std::string_view what);

/// Throws InvalidInput, naming what was asked for, if the cells do not lie in space as simplices of
/// the input: because only lengths are known, or edges were flipped.
void check_cells_in_space(const Discretization& discretization, std::string_view what);

} // namespace polydec
