// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstddef>

namespace polydec {

/// Whether TetGen may add points on the surface. If not, quality and volume bounds are weaker near
/// the surface, but its triangles stay unchanged.
enum class BoundarySplitting { allowed, forbidden };

struct MesherOptions {
    double quality = 0.0;        ///< largest circumradius over shortest edge; 0: no bound
    double largest_volume = 0.0; ///< of a tetrahedron, length^3; 0: no bound
    BoundarySplitting boundary = BoundarySplitting::allowed;
    double seconds = 300.0;                   ///< time limit of the mesher
    std::size_t bytes = std::size_t{8} << 30; ///< memory limit of the mesher
};

/// Fills a closed surface in R^3 with positively oriented tetrahedra by the program TetGen; the
/// orientation of the surface does not matter. The surface's vertices come first, in their order,
/// then new ones; vertices of no triangle are omitted, with a warning. A warning also counts the
/// tetrahedra that miss the requested quality; if the surface has sharp corners, bounds below 1.4
/// cannot always be met. Parts within others are filled, and their surfaces remain as interfaces.
/// `holes` has three columns and a point in each part that is to stay empty.
///
/// Throws InvalidInput, naming vertices, triangles or edges by the numbers of the surface, unless
/// it consists of triangles in R^3; for coordinates that are not finite, coincident vertices, only
/// coplanar vertices, a triangle without area, an edge without exactly two triangles, crossing
/// triangles, a one-sided surface, a hole on a triangle or outside all surfaces, and invalid
/// options; BackendUnavailable if TetGen is not on PATH; SolverFailure, naming the probable cause,
/// if it fails, exceeds time or memory, or if its volumes, faces or boundary are not as described
/// here; IoError if it cannot run.
/// Source: Si, TetGen, ACM Trans. Math. Softw. 41 (2015) 11.
Mesh tetrahedralize(const Mesh& surface, const MesherOptions& options = {},
                    const Points& holes = Points(0, 3));

} // namespace polydec
