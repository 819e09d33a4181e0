// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/side.h"

namespace polydec {

/// Centers of the merged k-cells, where dual (n-k)-forms of degree 0 have their values, in the
/// units of the input: one row of N coordinates per cell. Over a cell of several pieces, whose
/// centers differ if it is bent, their mean by volume. For k = 0 the vertices themselves; where
/// only lengths are known as many rows without coordinates.
///
/// After intrinsic flips they are places on the triangles of the input, where centers of the
/// flipped ones are found on the surface; centers beyond its boundary go on as the corners of the
/// last triangle lie. Cells of a glued mesh are where one of the n-cells around them lies in the
/// box, vertices at their first place there.
Points cell_centers(const Discretization& discretization, int k);

/// Centroids (centers of mass) of the merged k-cells, the means by volume of those of their pieces,
/// likewise. Where vector fields made from forms belong: the mean of a linear function over a cell
/// is its value there. Throws InvalidInput where only lengths are known.
Points cell_centroids(const Discretization& discretization, int k);

/// Where values of dual 0-forms are, by the stars of a bundle: the centroids of the n-cells whose
/// facets star_(n-1) couples, as Galerkin's does, and the centers of all others; so that a linear
/// function, taken there, has the fluxes that the stars make of it. Throws like the above.
Points dual_sites(const Discretization& discretization);

/// The barycentric coordinates of these sites, or of the centers, in each n-piece: n + 1 in a row;
/// and where these places of the pieces are, in unit().
Points site_coordinates(const Discretization& discretization);
Points sites_of_pieces(const Discretization& discretization);

/// Where values on the boundary and through it are: the centroids of the (n-1)-cells where
/// star_(n-1) is a matrix, else their centers.
Points facet_sites(const Discretization& discretization);

/// Where functions of a side have their values, a row each: primal 0-forms at vertices, dual ones
/// at dual_sites; and where they have values on the boundary: at vertices, or at facet_sites.
Points sites(const Discretization& discretization, Side side);
Points boundary_sites(const Discretization& discretization, Side side);

} // namespace polydec
