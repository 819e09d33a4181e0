// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/boundary/boundary_conditions.h"
#include "dec/discretization/cell_data.h"
#include "dec/discretization/discretization.h"

#include <vector>

namespace polydec {

/// The functions that define the spectrum of a shape: ordinary ones, or densities of twisted
/// n-forms, which change sign with the orientation: on a Klein bottle none is constant.
enum class ShapeFunctions { ordinary, twisted };

/// Flat n-simplices glued along facets, given by edge lengths: a plane domain, a polyhedral
/// surface, a solid. Any number of simplices may meet at a facet, a simplex may meet itself, and
/// angles around a vertex may have any sum. H^1 consists of the functions in H^1 of each simplex
/// with equal traces on glued facets, and 0 on essential ones. The Laplacian belongs to a(u,v) =
/// sum kappa (grad u, grad v) + sum alpha (u,v) over Robin facets, and b(u,v) = sum rho (u,v): its
/// eigenfunctions are bounded at cone points (Friedrichs). The eigenvalues are properties of this
/// shape, not of a mesh of it.
struct Shape {
    Pieces pieces;
    Vector lengths; ///< of the edges: size(1)
    /// One for all facets, or one per facet; Robin coefficients alpha are kappa over length.
    BoundaryConditions conditions = {BoundaryCondition::natural};
    Vector conductivity = {}; ///< kappa of each n-simplex, positive; empty: 1
    Vector density = {};      ///< rho of each n-simplex, positive; empty: 1
    ShapeFunctions functions = ShapeFunctions::ordinary;
    /// Relative error of every length, from rounding of points or from flips.
    double length_error = 0;
    /// Additional relative error of squared lengths within simplices, from bisection and from flips
    /// of bisected triangles, whose errors accumulate.
    double metric_error = 0;
};

/// The shape of a mesh, from its simplices, or from the flipped ones, which form the same surface;
/// never from merged cells. Lengths are in the units of the input. Throws InvalidInput like
/// CellData and check.
Shape shape_of(const Discretization& mesh,
               const BoundaryConditions& conditions = {BoundaryCondition::natural},
               const CellData& conductivity = {}, const CellData& density = {});

/// The shape whose functions have the spectrum of n-forms (densities): twisted functions, free
/// where n-forms are essential and 0 where n-forms are natural.
Shape top_forms(const Shape& shape);

/// Throws InvalidInput, naming the fault and the edge, simplex or facet, unless there is one
/// positive length per edge, one positive weight per simplex, one condition for all facets or one
/// per facet, no mark or one mark per vertex, and every Robin coefficient is positive. Also throws
/// for twisted functions if more than two simplices meet at a facet, and if a vertex is fixed: in
/// dimension 2 and above, points have no capacity.
void check(const Shape& shape);

/// The number of zero eigenvalues: components, connected through facets, without essential or Robin
/// facet; for twisted functions only the orientable ones.
Index zero_eigenvalues(const Shape& shape);

/// A shape with Delaunay triangles, and the number of edges flipped to make them.
struct FlippedShape {
    Shape shape;
    Index flips = 0;
};

/// The intrinsic Delaunay triangulation of a surface. Its larger angles make eigenvalue enclosures
/// narrower. Vertices and edges of the boundary keep their numbers and conditions. Returns a shape
/// unchanged if its dimension is not 2, edges branch, or weights are not uniform. Throws like
/// intrinsic_delaunay.
FlippedShape flipped(const Shape& shape);

/// The same shape, in any dimension n >= 1, with these n-simplices bisected twice at the midpoints
/// of longest edges, and neighbors bisected as far as conformity requires. On surfaces, angles stay
/// above half of the smallest initial angle. Vertices keep their numbers; new ones follow. Facets
/// and simplices inherit conditions and weights. Branching facets and simplices glued to themselves
/// are allowed. Uses lengths alone: the median of a triangle is l^2 = (2 b^2 + 2 c^2 - a^2) / 4.
/// Throws InvalidInput like check, and naming the simplex if it does not exist, has no volume, or
/// is so flat that errors of lengths hide its shape. Source: Rivara 1984.
Shape bisected(const Shape& shape, const std::vector<Index>& simplices);

} // namespace polydec
