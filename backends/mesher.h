// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace polydec {

/// What is to be filled with tetrahedra: the inside of closed surfaces in R^3, or, without facets,
/// the convex hull of points. Surfaces may lie within one another; every part of their inside is
/// filled, and they stay as interfaces, unless a hole says otherwise.
struct MesherInput {
    Points points = {};              ///< three columns; one that is on no facet is left out
    std::vector<Index> corners = {}; ///< vertices around the facets, one facet after the other
    std::vector<Index> offsets = {}; ///< facet f has the corners offsets[f] to offsets[f + 1] - 1
    Points holes = Points(0, 3);     ///< a point in each part that is to stay empty
};

/// Whether new points may be put on the surface. Where they may not, the bounds of quality and
/// volume hold less near it, but the triangles of the surface are those of the mesh.
enum class BoundarySplitting { allowed, forbidden };

struct MesherOptions {
    double quality = 0.0;        ///< most circumradius over shortest edge; 0: no bound
    double largest_volume = 0.0; ///< of a tetrahedron, length^3; 0: no bound
    BoundarySplitting boundary = BoundarySplitting::allowed;
    double seconds = 300.0;                   ///< then the mesher is stopped
    std::size_t bytes = std::size_t{8} << 30; ///< of memory the mesher may ask for
};

struct MesherOutput {
    Points points = {}; ///< those of the input that were not left out, in order; then new ones
    Simplices tetrahedra = {}; ///< four columns; determinants of the edge vectors are positive
    Simplices faces = Simplices(0, 3); ///< the faces of tetrahedra that facets are unions of
    std::vector<Index> facets = {};    ///< the facet that each of them is on
};

/// What makes tetrahedra: an engine of kind `mesher`. It may rely on a checked input; what it makes
/// is checked.
using Mesher = std::function<MesherOutput(const MesherInput&, const MesherOptions&)>;

/// Fills with tetrahedra, by the engine of that name. Delaunay, if there are no facets; else the
/// facets are unions of faces of tetrahedra, and quality is as asked for where sharp corners of the
/// surface allow it (below 1.4 not always).
///
/// Throws InvalidInput, naming points, facets or edges from 0, for coordinates that are not finite,
/// fewer than four points, two equal points, points in one plane, a facet with fewer than three
/// corners, without area or not plane within 1e-8 of its size, an edge in other than two facets,
/// facets that cross, a surface with one side only, a hole on a facet or outside of all surfaces,
/// and options that make no sense; BackendUnavailable if the engine's program is
/// not there; SolverFailure, naming the probable cause, if it fails, or needs too long or too much
/// memory, or
/// if what it makes is not what is said here: volumes, faces and boundary are checked; IoError if
/// it cannot be run.
/// Source: Si, TetGen, ACM Trans. Math. Softw. 41 (2015) 11, for the engine `tetgen`.
MesherOutput tetrahedralize(const MesherInput& input, const MesherOptions& options = {},
                            const std::string& engine = "tetgen");

} // namespace polydec
