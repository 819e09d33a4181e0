// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Centers of the merged k-cells, where dual (n-k)-forms of degree 0 have their values: one row of
/// N coordinates per cell, in the units of the input. The center of a cell of several pieces is the
/// mean of their centers by volume; the centers differ if the cell is bent. For k = 0, the
/// vertices. If only lengths are known, the rows have no coordinates.
///
/// After intrinsic flips, the centers of the flipped triangles are located on the surface: they are
/// places on the triangles of the input. Centers beyond its boundary lie in the plane of the last
/// triangle. On a glued mesh, the center of a cell lies in the box with one of the n-cells around
/// it; a vertex is at its first place in the box.
Points cell_centers(const Discretization& discretization, int k);

/// Centroids (centers of mass) of the merged k-cells: means of the pieces' centroids by volume,
/// with rows as above. Attach vector fields made from forms here: the mean of a linear function
/// over a cell is its value at the centroid. Throws InvalidInput if only lengths are known.
Points cell_centroids(const Discretization& discretization, int k);

/// Sites of the values of dual 0-forms, by the stars of a mesh: the centroid of each n-cell whose
/// facets star_(n-1) couples, as Galerkin stars do, and the center of every other n-cell. A linear
/// function sampled there has exactly the fluxes that the stars give. Throws like cell_centroids.
Points dual_sites(const Discretization& discretization);

/// These sites, or the centers, of the n-pieces: a row for each, in unit().
Points sites_of_pieces(const Discretization& discretization);

/// Sites of boundary values and of fluxes through the boundary: the centroids of the (n-1)-cells if
/// star_(n-1) is a matrix, else their centers.
Points facet_sites(const Discretization& discretization);

/// Sites of 0-forms, one row each: vertices for primal forms, dual_sites for dual forms. Sites of
/// their boundary values: vertices, or facet_sites.
Points sites(const Discretization& discretization, Side side);
Points boundary_sites(const Discretization& discretization, Side side);

} // namespace polydec
