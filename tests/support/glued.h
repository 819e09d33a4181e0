// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"
#include "meshes/mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace polydec::test {

/// Triangles with one vertex or few, that no simplicial complex can be.
GluedSurface square_torus();     ///< a square of two triangles with opposite sides glued
GluedSurface square_klein();     ///< the same with one pair of sides turned
GluedSurface two_sided_plane();  ///< a projective plane of two triangles
GluedSurface folded_triangle();  ///< two sides of one triangle glued: a cone
GluedSurface moebius_triangle(); ///< two sides of one triangle glued the other way round

/// Flips edges at random, two for each edge there is as far as they can be flipped; tells each
/// before.
void flip_at_random(
    GluedSurface& surface, unsigned seed, const std::function<void(Index)>& before = [](Index) {});

/// The surface as incidence matrices whose entries are sums of signs: 0 for loops and for a
/// triangle on both sides of an edge; 2 or -2 for such a triangle on a one-sided surface.
CellComplex cell_complex(const GluedSurface& surface);

/// Names of the meshes of the family that are surfaces with at most two triangles at each edge.
std::vector<std::string> names_of_surfaces();

/// The same mesh with every vertex moved at random by up to `amplitude` mean edge lengths.
Mesh shaken(Mesh mesh, double amplitude, unsigned seed);

} // namespace polydec::test
