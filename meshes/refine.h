// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/periodic.h"

namespace polydec {

/// The same shape without edges longer than `longest`, up to rounding (a share of 1e-12). Bisects
/// each simplex with a longer edge at the midpoint of its longest edge, and then the parts; among
/// edges of equal length, first the edge with the lower vertex numbers. Time linear in the parts.
///
/// Parts follow the order of the simplices and keep their orientation, tags and input cells; facets
/// keep their tags. Vertices keep their numbers; new vertices follow, at midpoints.
///
/// Each simplex is divided without regard to its neighbors, and still they fit: a simplex is
/// divided only at its longest edge, if that is longer than `longest`, so each face is divided as
/// if it were alone. Source: Rivara 1984, for the bisection.
///
/// Throws InvalidInput, naming the number of simplices, for a length that is not positive or would
/// make more than 1e8 simplices; and like the check of a mesh.
Mesh refined(Mesh mesh, double longest);

/// The same by lengths alone: the median of a triangle is l^2 = (2 b^2 + 2 c^2 - a^2) / 4.
LengthMesh refined(const LengthMesh& mesh, double longest);

/// The same for box and quotient together; lengths are those of the quotient.
PeriodicMesh refined(PeriodicMesh mesh, double longest);

} // namespace polydec
