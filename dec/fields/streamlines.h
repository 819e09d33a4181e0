// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

namespace polydec {

struct StreamlineOptions {
    /// Approximate distance between lines, in the units of the input; 0: 1/40 of the mesh's extent.
    double spacing = 0;
    /// Maximal length of a line, in spacings: first along the vectors, then back from its start.
    double longest = 200;
    /// Minimal length, in spacings: shorter lines are left out, and their places stay empty. 0:
    /// none is too short.
    double shortest = 2;
};

/// Streamlines of a vector field, in any dimension: a mesh of segments, from tail to head along the
/// vectors, in the units of the input. `vectors` has a row per merged n-cell, as returned by
/// sharp_pd and flux_sharp. Vectors at vertices are means by volume over the cells around; between
/// vertices the field is linear on each n-simplex. On a bent surface the normal part is dropped.
/// Steps are of second order, at most a quarter of a simplex long. A line ends at the boundary, at
/// a seam of a glued mesh, at a branch, where the field vanishes or reverses, and where it comes
/// closer than the spacing to another line or to itself. The same input gives the same lines. Time
/// O(simplices log simplices + steps).
///
/// Throws InvalidInput for a wrong number of vectors, one that is not finite or whose cell a seam
/// that turns cuts (naming the cell), a negative spacing, a longest line of no positive length or
/// shorter than the shortest, a negative shortest one, options that are not finite, flipped edges,
/// and if only lengths are known.
Mesh streamlines(const Discretization& mesh, const DenseMatrix& vectors,
                 StreamlineOptions options = {});

} // namespace polydec
