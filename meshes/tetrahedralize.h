// SPDX-License-Identifier: MIT
#pragma once

#include "backends/mesher.h"
#include "meshes/mesh.h"

#include <string>

namespace polydec {

/// The inside of a closed surface in R^3 as tetrahedra, all of positive orientation; how the
/// surface is oriented does not matter. The surface's vertices come first, in their order, new ones
/// after them; vertices that belong to no triangle are left out, with a warning. A warning counts
/// the tetrahedra that miss the quality asked for, too. Parts within others are filled, and their
/// surfaces stay as interfaces; `holes` has three columns and a point in each part that is to stay
/// empty.
///
/// Throws InvalidInput unless the surface consists of triangles in R^3, and as tetrahedralize in
/// backends/mesher.h, with the vertex and triangle numbers of the surface.
Mesh tetrahedralize(const Mesh& surface, const MesherOptions& options = {},
                    const Points& holes = Points(0, 3), const std::string& engine = "tetgen");

} // namespace polydec
