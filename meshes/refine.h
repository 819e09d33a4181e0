// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/periodic.h"

namespace polydec {

/// The same shape without edges longer than `longest` (but for a share of 1e-12, as rounding makes
/// it): simplices with a longer edge are bisected at the middle of their longest edge, and so are
/// the parts. Of equally long edges the one with the lower vertex numbers is divided first. Linear
/// time in the number of parts.
///
/// Parts follow in the order of the simplices, with their orientation. Vertices keep their numbers,
/// new ones follow; points of new vertices are middles. Simplices and facets have the tags, and
/// simplices the cells of the input, of what they are parts of.
///
/// Neighbors fit without being asked: a simplex is divided at an edge only if that is the longest
/// of all its edges, and as long as it has a longer edge than `longest`. So each of its faces is
/// divided as if it were alone. Source of the bisection: Rivara 1984.
///
/// Throws InvalidInput for a length that is not positive, or for which more than 1e8 simplices
/// would come out, saying how many; like check of a mesh.
Mesh refined(Mesh mesh, double longest);

/// By lengths alone: of the median of a triangle l^2 = (2 b^2 + 2 c^2 - a^2) / 4.
LengthMesh refined(const LengthMesh& mesh, double longest);

/// Box and quotient alike; edges are as long as in the quotient.
PeriodicMesh refined(PeriodicMesh mesh, double longest);

} // namespace polydec
