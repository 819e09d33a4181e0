// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstddef>

namespace polydec {

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

/// The inside of a closed surface in R^3 as tetrahedra, all of positive orientation, by the program
/// TetGen; how the surface is oriented does not matter. The surface's vertices come first, in their
/// order, new ones after them; vertices that belong to no triangle are left out, with a warning. A
/// warning counts the tetrahedra that miss the quality asked for, too; where corners of the surface
/// are sharp, bounds below 1.4 cannot always be kept. Parts within others are filled, and their
/// surfaces stay as interfaces; `holes` has three columns and a point in each part that is to stay
/// empty.
///
/// Throws InvalidInput, naming vertices, triangles or edges by the numbers of the surface, unless
/// it consists of triangles in R^3; for coordinates that are not finite, two vertices in one place,
/// vertices in one plane, a triangle without area, an edge in other than two triangles, triangles
/// that cross, a surface with one side only, a hole on a triangle or outside of all surfaces, and
/// options that make no sense; BackendUnavailable if TetGen is not on PATH; SolverFailure, naming
/// the probable cause, if it fails, or needs too long or too much memory, or if volumes, faces or
/// boundary of what it makes are not as said here; IoError if it cannot be run.
/// Source: Si, TetGen, ACM Trans. Math. Softw. 41 (2015) 11.
Mesh tetrahedralize(const Mesh& surface, const MesherOptions& options = {},
                    const Points& holes = Points(0, 3));

} // namespace polydec
