// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

struct StreamlineOptions {
    /// How far lines are apart, about, in the units of the input; 0: a fortieth of its extent.
    double spacing = 0;
    /// How long one gets at most, in spacings.
    double longest = 200;
    /// How long at least, in spacings: shorter ones are left out, and their places stay empty.
    double shortest = 2;
};

/// Lines that run along a field of vectors, in any dimension: a mesh of segments, from tail to head
/// as the vectors point, in the units of the input. vectors has a row for each merged n-cell, as
/// sharp_pd and flux_sharp give them. Between the vertices, where the means by volume of the cells
/// around are taken, the field is linear on each n-simplex; what of it sticks out of a bent surface
/// is left out. Steps are of second order, a quarter of a simplex long at most. A line ends at the
/// boundary, at a seam of a glued mesh, at a branch, where the field vanishes or turns back, and
/// where another line, or itself, has been nearer than the spacing. The same input makes the same
/// lines. Time O(simplices log simplices + steps).
///
/// Throws InvalidInput for another number of vectors, one that is not finite, naming its cell, for
/// options that are not positive, and where edges were flipped, or lengths alone are known.
Mesh streamlines(const Discretization& mesh, const DenseMatrix& vectors,
                 StreamlineOptions options = {});

} // namespace polydec
